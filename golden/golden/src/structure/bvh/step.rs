//! The ray-box test: what the ray-box pipeline computes, operation for operation.
//!
//! For each axis, with `s` the sign bit of `inv_entry[axis]`:
//!
//! ```text
//! t_low  = (min - origin) * (s ? inv_exit : inv_entry)     near = minimum(t_low, t_high)
//! t_high = (max - origin) * (s ? inv_entry : inv_exit)     far  = maximum(t_low, t_high)
//! t_entry = maximum_number(maximum_number(near_x, near_y), maximum_number(near_z, t_min))
//! t_exit  = minimum_number(minimum_number(far_x, far_y), minimum_number(far_z, t_max))
//! hit     = t_entry <= t_exit
//! ```
//!
//! The per-axis pair propagates NaN, so that an axis whose face contains a parallel ray is dropped from both folds.

use crate::Aabb;
use crate::ray::PlaneDistances;
use fp::{maximum, maximum_number, minimum, minimum_number};

/// The outcome of a ray-box test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxStep {
    /// Whether the interval is not empty, bounds included.
    pub hit: bool,
    /// Where the ray enters the box, at least `t_min`.
    pub t_entry: f32,
    /// Where the ray leaves the box, at most `t_max`.
    pub t_exit: f32,
}

/// Tests `bounds` against the part `t_min..=t_max` of `ray`.
#[inline]
#[must_use]
pub fn box_step<R: PlaneDistances>(bounds: &Aabb, ray: &R, t_min: f32, t_max: f32) -> BoxStep {
    let mut near = [0.0; 3];
    let mut far = [0.0; 3];
    for axis in 0..3 {
        let (low, high) = (bounds.min[axis], bounds.max[axis]);
        let (t_low, t_high) = if ray.is_negative(axis) {
            (ray.exit(low, axis), ray.entry(high, axis))
        } else {
            (ray.entry(low, axis), ray.exit(high, axis))
        };
        near[axis] = minimum(t_low, t_high);
        far[axis] = maximum(t_low, t_high);
    }
    let t_entry = maximum_number(maximum_number(near[0], near[1]), maximum_number(near[2], t_min));
    let t_exit = minimum_number(minimum_number(far[0], far[1]), minimum_number(far[2], t_max));
    BoxStep { hit: t_entry <= t_exit, t_entry, t_exit }
}
