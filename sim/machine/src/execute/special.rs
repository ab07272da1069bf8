//! The machine's own operations.

use golden::Aabb;
use golden::bvh::{BoxStep, box_step};
use golden::dst::{Step, step};
use golden::ray::PlaneRay;
use golden::triangle::{TriangleHit, decided_hit};

/// What the operations that MIPS32 does not have compute. The defaults are golden's functions, the definition of each.
///
/// What an executed program gets from golden, it gets through these.
pub trait Special: Sync {
    /// `RAND`: the sample of item `item` in dimension `dimension`, in 0 to 1.
    fn random(&self, item: u32, dimension: u32) -> f32;

    /// `FPMIN`.
    #[inline(always)]
    fn minimum(&self, a: f32, b: f32) -> f32 {
        fp::minimum_number(a, b)
    }

    /// `FPMAX`.
    #[inline(always)]
    fn maximum(&self, a: f32, b: f32) -> f32 {
        fp::maximum_number(a, b)
    }

    /// `FPINVSQRT`.
    #[inline(always)]
    fn inverse_square_root(&self, a: f32) -> f32 {
        render::shading::inverse_square_root(a)
    }

    /// `SIN`.
    fn sine(&self, a: f32) -> f32 {
        render::shading::sine(a)
    }

    /// `COS`.
    fn cosine(&self, a: f32) -> f32 {
        render::shading::cosine(a)
    }

    /// `DSTSTEP`: the dual-split pipeline on a node's words.
    #[inline(always)]
    fn step(&self, words: [u32; 3], ray: &PlaneRay, [t_min, t_max]: [f32; 2]) -> Step {
        step(words, ray, t_min, t_max)
    }

    /// `BOXTEST` and its parallel forms: the ray-box pipeline on the part of a ray up to `t_max`.
    #[inline(always)]
    fn box_test(&self, bounds: &Aabb, ray: &PlaneRay, t_max: f32) -> BoxStep {
        box_step(bounds, ray, 0.0, t_max)
    }

    /// `EXACT`: the decision of a triangle test that single precision does not make directly.
    fn exact(&self, origin: [f32; 3], direction: [f32; 3], corners: &[[f32; 3]; 3]) -> Option<TriangleHit> {
        decided_hit(origin, direction, corners)
    }
}
