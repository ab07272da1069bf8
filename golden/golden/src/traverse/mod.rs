//! Closest hit and any hit in every structure, with the arithmetic that the hardware has.
//!
//! All kernels test the same planes with the same rounding (see [`crate::ray`]) and the same triangle test, so all
//! structures over one mesh return the same [`Hit`], bit for bit, and so does [`brute_force`]. Of several
//! hits at one distance, the triangle with the lowest index is returned; a stacked node is therefore discarded
//! only if it begins beyond the hit, not at it.
//!
//! The kernels fold planes with the processor's minimum and maximum, whose results differ from
//! [`minimum_number`](fp::minimum_number) in the sign of a zero at most: `t_min` is never NaN nor -0, and
//! comparisons do not see the sign of `t_max`. [`Leaves`] steps through the specification itself.

mod box_test;
mod brute_force;
mod bvh;
mod dst;
mod dst_rows;
pub(crate) mod dst_steps;
mod leaves;
mod observer;
pub(crate) mod query;
pub(crate) mod stack;

pub use brute_force::brute_force;
pub use leaves::{Leaf, Leaves};
pub use observer::{Counters, NoObserver, Tests, Traversal};

use crate::bvh::box_step;
use crate::dst::{Dst, Step, step};
use crate::ray::{Hit, Mode, Ray, TraversalRay};
use query::Query;

/// A structure that rays can be traced through.
pub trait Trace: Sync {
    /// The nearest hit of a prepared ray, the lowest triangle index first among equals.
    fn closest_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit>;

    /// Whether anything is hit by a prepared ray.
    fn occluded_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> bool;

    /// The nearest hit of `ray`; a ray outside the supported range is a miss (see [`crate::ray`]).
    #[inline]
    fn closest(&self, ray: &Ray, mode: Mode) -> Option<Hit> {
        self.closest_prepared(&TraversalRay::new(ray, mode)?, &mut NoObserver)
    }

    /// Whether anything lies on `ray`.
    #[inline]
    fn occluded(&self, ray: &Ray, mode: Mode) -> bool {
        TraversalRay::new(ray, mode).is_some_and(|ray| self.occluded_prepared(&ray, &mut NoObserver))
    }
}

impl Trace for Dst {
    #[inline]
    fn closest_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
        let mut query = Query::<false>::new(ray, &self.triangles);
        if O::ACTIVE {
            by_steps(self, &mut query, observer, step);
        } else {
            dst::traverse(self, &mut query);
        }
        query.hit()
    }

    #[inline]
    fn occluded_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
        let mut query = Query::<true>::new(ray, &self.triangles);
        if O::ACTIVE { by_steps(self, &mut query, observer, step) } else { dst::traverse(self, &mut query) }
    }
}

/// The nearest hit in `dst` with every node step executed by `step`: the specification's, or hardware's.
///
/// `step` is given a node's three words, the ray and the interval, and has to do what [`crate::dst::step`] does.
pub fn closest_by_steps<O: Traversal>(
    dst: &Dst,
    ray: &TraversalRay,
    observer: &mut O,
    step: impl FnMut([u32; 3], &TraversalRay, f32, f32) -> Step,
) -> Option<Hit> {
    let mut query = Query::<false>::new(ray, &dst.triangles);
    by_steps(dst, &mut query, observer, step);
    query.hit()
}

/// Whether anything in `dst` is hit, with every node step executed by `step` as in [`closest_by_steps`].
pub fn occluded_by_steps<O: Traversal>(
    dst: &Dst,
    ray: &TraversalRay,
    observer: &mut O,
    step: impl FnMut([u32; 3], &TraversalRay, f32, f32) -> Step,
) -> bool {
    let mut query = Query::<true>::new(ray, &dst.triangles);
    by_steps(dst, &mut query, observer, step)
}

fn by_steps<const ANY: bool, O: Traversal>(
    dst: &Dst,
    query: &mut Query<'_, ANY>,
    observer: &mut O,
    mut step: impl FnMut([u32; 3], &TraversalRay, f32, f32) -> Step,
) -> bool {
    let ray = query.ray;
    let root = box_step(&dst.root_box, ray, ray.t_min, ray.t_max);
    dst_steps::traverse(dst, root, query, observer, |words, low, high| step(words, ray, low, high), |t| t)
}
