//! What compares the operations of a pipeline with another implementation of it.

use golden::Aabb;
use golden::bvh::BoxStep;
use golden::dst::Step;
use golden::ray::PlaneRay;

/// Another implementation of the pipelines, such as their netlists, asked about each operation.
pub trait Checker: Sync {
    /// Whether the dual-split pipeline makes of a node what golden does, bit for bit, in the part `t_min..=t_max` of a ray.
    fn step(&self, words: [u32; 3], ray: &PlaneRay, interval: [f32; 2], golden: &Step) -> bool;

    /// Whether the ray-box pipeline makes of a box what golden does, bit for bit, in the part `0..=t_max` of a ray.
    fn box_test(&self, bounds: &Aabb, ray: &PlaneRay, t_max: f32, golden: &BoxStep) -> bool;
}
