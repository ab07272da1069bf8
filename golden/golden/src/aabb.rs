//! Axis-aligned bounding boxes, exact to the bit.
//!
//! A box is the componentwise minimum and maximum of the coordinates that it encloses; no epsilon is ever
//! added. A coordinate of -0.0 enters a box as +0.0, so that two planes are equal exactly when their bits
//! are, which is what the dual-split conversion compares. This changes no point set, since -0.0 = +0.0.

use bytemuck::{Pod, Zeroable};

/// A closed axis-aligned box in scene units, `min[i] <= max[i]` on every axis unless it is [`Aabb::EMPTY`].
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Aabb {
    /// The lower planes on x, y and z.
    pub min: [f32; 3],
    /// The upper planes on x, y and z.
    pub max: [f32; 3],
}

impl Aabb {
    /// The box of no points, neutral under [`Aabb::union`].
    pub const EMPTY: Self = Self { min: [f32::INFINITY; 3], max: [f32::NEG_INFINITY; 3] };

    /// The smallest box around `points`; [`Aabb::EMPTY`] for none. The coordinates must not be NaN.
    #[must_use]
    pub fn of_points(points: &[[f32; 3]]) -> Self {
        points.iter().fold(Self::EMPTY, |aabb, &point| aabb.grow(point))
    }

    /// The smallest box around `self` and `point`, whose coordinates must not be NaN.
    #[must_use]
    pub fn grow(self, point: [f32; 3]) -> Self {
        let point = point.map(positive_zero);
        self.union(Self { min: point, max: point })
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self {
            min: std::array::from_fn(|i| if other.min[i] < self.min[i] { other.min[i] } else { self.min[i] }),
            max: std::array::from_fn(|i| if other.max[i] > self.max[i] { other.max[i] } else { self.max[i] }),
        }
    }

    /// Half of the surface area in square scene units, the measure of the surface area heuristic.
    ///
    /// Computed in `f64`, whose range holds the area of every box with finite `f32` planes. Zero for the
    /// empty box.
    #[must_use]
    pub fn half_area(&self) -> f64 {
        if self.is_empty() {
            return 0.0;
        }
        let [x, y, z] = std::array::from_fn(|i| f64::from(self.max[i]) - f64::from(self.min[i]));
        x * y + y * z + z * x
    }

    /// Whether no point is inside.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        (0..3).any(|i| self.min[i] > self.max[i])
    }

    /// Whether every point of `other` is in `self`.
    #[must_use]
    pub fn contains(&self, other: &Self) -> bool {
        other.is_empty() || (0..3).all(|i| self.min[i] <= other.min[i] && other.max[i] <= self.max[i])
    }

    /// Whether `point` is inside or on a face.
    #[must_use]
    pub fn contains_point(&self, point: [f32; 3]) -> bool {
        (0..3).all(|i| self.min[i] <= point[i] && point[i] <= self.max[i])
    }

    /// The centre, halved before adding so that it is finite for every box with finite planes.
    #[must_use]
    pub fn centre(&self) -> [f32; 3] {
        std::array::from_fn(|i| 0.5 * self.min[i] + 0.5 * self.max[i])
    }

    /// The planes' bits, for exact comparison: minima, then maxima.
    #[must_use]
    pub fn to_bits(&self) -> [u32; 6] {
        bytemuck::cast(*self)
    }
}

/// `x`, with -0.0 replaced by +0.0.
#[inline]
#[must_use]
pub fn positive_zero(x: f32) -> f32 {
    // Round to nearest makes -0.0 + 0.0 = +0.0; every other sum is x itself.
    x + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn area_of_a_huge_box_is_finite() {
        let aabb = Aabb { min: [-f32::MAX; 3], max: [f32::MAX; 3] };
        let edge = 2.0 * f64::from(f32::MAX);
        assert_eq!(aabb.half_area(), 3.0 * edge * edge);
        assert_eq!(aabb.centre(), [0.0; 3]);
    }

    #[test]
    fn planes_never_hold_a_negative_zero() {
        for points in [[[-0.0; 3], [0.0; 3]], [[0.0; 3], [-0.0; 3]], [[-0.0; 3], [-0.0; 3]]] {
            assert_eq!(Aabb::of_points(&points).to_bits(), [0; 6]);
        }
        assert_eq!(positive_zero(-f32::from_bits(1)).to_bits(), 0x8000_0001);
    }

    #[test]
    fn empty_is_neutral() {
        let aabb = Aabb::of_points(&[[1.0, 2.0, 3.0], [-1.0, 5.0, 0.5]]);
        assert_eq!(aabb.union(Aabb::EMPTY), aabb);
        assert_eq!(Aabb::EMPTY.union(aabb), aabb);
        assert_eq!(Aabb::EMPTY.half_area(), 0.0);
        assert!(Aabb::EMPTY.is_empty() && aabb.contains(&Aabb::EMPTY) && !Aabb::EMPTY.contains(&aabb));
        assert_eq!(aabb, Aabb { min: [-1.0, 2.0, 0.5], max: [1.0, 5.0, 3.0] });
        assert_eq!(aabb.half_area(), 2.0 * 3.0 + 3.0 * 2.5 + 2.5 * 2.0);
        assert!(aabb.contains_point([1.0, 2.0, 0.5]) && !aabb.contains_point([1.1, 2.0, 0.5]));
    }
}
