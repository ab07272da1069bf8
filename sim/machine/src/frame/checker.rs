//! What compares the operations of a pipeline with another implementation of it.

use golden::bvh::BoxStep;
use golden::dst::{Child, Step};
use golden::{Aabb, TraversalRay};

/// Another implementation of the pipelines, such as their netlists, asked about each operation.
pub trait Checker: Sync {
    /// Whether the dual-split pipeline makes of a node what golden does, bit for bit.
    fn step(&self, words: [u32; 3], ray: &TraversalRay, here: &Child, golden: &Step) -> bool;

    /// Whether the ray-box pipeline makes of a box what golden does, bit for bit.
    fn box_test(&self, bounds: &Aabb, ray: &TraversalRay, t_max: f32, golden: &BoxStep) -> bool;
}
