//! The box of the builder's inner loops: two SIMD vectors, the same values as [`Aabb`].

use glam::Vec3A;

use crate::aabb::{Aabb, positive_zero};

/// An [`Aabb`] in two 4-lane registers. Planes are never NaN nor -0.0, so that minimum and maximum are exact
/// and independent of the order of their operands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    pub(super) min: Vec3A,
    pub(super) max: Vec3A,
}

impl Bounds {
    pub(super) const EMPTY: Self =
        Self { min: Vec3A::splat(f32::INFINITY), max: Vec3A::splat(f32::NEG_INFINITY) };

    pub(super) fn of_triangle(corners: [[f32; 3]; 3]) -> Self {
        let [a, b, c] = corners.map(|point| Vec3A::from_array(point.map(positive_zero)));
        Self { min: a.min(b).min(c), max: a.max(b).max(c) }
    }

    #[inline(always)]
    pub(super) fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    #[inline(always)]
    pub(super) fn grow(self, point: Vec3A) -> Self {
        Self { min: self.min.min(point), max: self.max.max(point) }
    }

    #[inline(always)]
    pub(super) fn centre(self) -> Vec3A {
        self.min * 0.5 + self.max * 0.5
    }

    /// As [`Aabb::half_area`], for a box that is not empty.
    #[inline(always)]
    pub(super) fn half_area(self) -> f64 {
        let extent = self.max.as_dvec3() - self.min.as_dvec3();
        extent.x * extent.y + extent.y * extent.z + extent.z * extent.x
    }

    /// Half of the area in `f32`, of the box scaled by `scale`.
    #[inline(always)]
    pub(super) fn scaled_half_area(self, scale: Vec3A) -> f32 {
        let extent = (self.max - self.min) * scale;
        // Not a dot product: its order of additions is the platform's.
        let [x, y, z] = (extent * Vec3A::new(extent.y, extent.z, extent.x)).to_array();
        x + y + z
    }
}

impl From<Bounds> for Aabb {
    fn from(bounds: Bounds) -> Self {
        Self { min: bounds.min.to_array(), max: bounds.max.to_array() }
    }
}
