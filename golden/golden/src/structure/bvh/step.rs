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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Mode, Ray, TraversalRay};

    fn test(origin: [f32; 3], direction: [f32; 3], [t_min, t_max]: [f32; 2]) -> (bool, f32, f32) {
        let bounds = Aabb { min: [1.0, 2.0, 4.0], max: [3.0, 5.0, 6.0] };
        let ray = TraversalRay::new(&Ray::new(origin, direction), Mode::Fast).unwrap();
        let BoxStep { hit, t_entry, t_exit } = box_step(&bounds, &ray, t_min, t_max);
        (hit, t_entry, t_exit)
    }

    /// From a point `a` before a corner of the box, the three slabs are `a..a + size` of each axis.
    #[test]
    fn the_interval_is_that_of_all_three_slabs() {
        for octant in 0..8 {
            let sign = |axis: usize| if octant >> axis & 1 == 0 { 1.0 } else { -1.0 };
            let corner =
                |axis: usize| if sign(axis) > 0.0 { [1.0, 2.0, 4.0][axis] } else { [3.0, 5.0, 6.0][axis] };
            let direction: [f32; 3] = std::array::from_fn(sign);
            let before = |distance: [f32; 3]| std::array::from_fn(|k| corner(k) - sign(k) * distance[k]);
            let whole = [0.0, f32::INFINITY];
            assert_eq!(test(before([1.0, 2.0, 2.5]), direction, whole), (true, 2.5, 3.0));
            assert_eq!(test(before([2.0, 0.5, 1.0]), direction, whole), (true, 2.0, 3.0));
            assert_eq!(test(before([2.0, 1.0, 0.0]), direction, whole), (true, 2.0, 2.0));
            assert_eq!(test(before([2.0, 3.0, 0.0]), direction, whole), (false, 3.0, 2.0));
            assert_eq!(test(before([1.0, 2.0, 2.5]), direction, [2.75, 2.875]), (true, 2.75, 2.875));
            assert_eq!(test(before([1.0, 2.0, 2.5]), direction, [3.0, 9.0]), (true, 3.0, 3.0));
            assert_eq!(test(before([1.0, 2.0, 2.5]), direction, [3.5, 9.0]), (false, 3.5, 3.0));
        }
    }

    /// An axis without direction counts inside its slab and on its faces, and rules out everything else.
    #[test]
    fn a_parallel_axis_is_all_or_nothing() {
        for (x, hit) in [(2.0, true), (1.0, true), (3.0, true), (0.5, false), (3.5, false)] {
            for zero in [0.0, -0.0] {
                let (found, t_entry, t_exit) = test([x, 3.0, 0.0], [zero, 0.0, 1.0], [0.0, 9.0]);
                assert_eq!(found, hit, "{x}");
                assert!(!hit || (t_entry, t_exit) == (4.0, 6.0), "{x}: {t_entry}, {t_exit}");
            }
        }
    }
}
