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

pub(crate) mod box_test;
mod brute_force;
mod leaves;
mod observer;
pub(crate) mod query;
pub(crate) mod stack;

pub use crate::dst::{closest_by_steps, occluded_by_steps};
pub use brute_force::brute_force;
pub use leaves::{Leaf, Leaves};
pub use observer::{Counters, NoObserver, Node, Observer, Outcome, Part, Target, Tests};

use crate::ray::{Hit, Mode, Ray, TraversalRay};

/// A structure that rays can be traced through.
pub trait Trace: Sync {
    /// The nearest hit of a prepared ray, the lowest triangle index first among equals.
    fn closest_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit>;

    /// Whether anything is hit by a prepared ray.
    fn occluded_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> bool;

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
