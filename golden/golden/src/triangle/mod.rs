//! The ray-triangle test: exact acceptance, at the price of the watertight single-precision test.
//!
//! A ray is accepted if its line meets the closed triangle (edges and corners included) exactly, for the float
//! inputs as given; a ray in the triangle's plane and a triangle without area are defined misses. So two
//! triangles that share an edge leave no gap between them, and a closed mesh leaks no ray.
//!
//! The edge functions are evaluated as by Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1),
//! 2013: corners relative to the origin, sheared along the ray's largest component, cross products in 2-D. Where they do
//! not exceed their error bound, [`exact`] decides.
//!
//! # Error bound
//! Let `u = 2^-24`, `M` the largest component of the translated corners and `E` the largest sheared coordinate, both as
//! computed, and neither overflow nor underflow. Translation rounds once, the shear factor, its product and
//! the difference once each, and the factor is at most 1 in magnitude, so a sheared coordinate is off by
//! less than `6.1 u M`. Over the two products of an edge function that makes `4 (6.1 u M) E + 2 (6.1 u M)^2`, and their own
//! rounding adds `4.1 u E^2 <= 8.7 u M E`: together less than `34 u M (E + 3 u M)`. `EDGE_BOUND` asks for 40, which
//! covers the rounding of the bound itself. `M` is required to lie in `RANGE` so that nothing overflows and what
//! underflows is far below the bound. Where it does not, the same operations are tried in units of the power of two at or below `M`,
//! so that a scene and the same scene times a power of two have the same hits.
//!
//! The sign of `t`, which decides whether a ray that starts on a triangle hits it, is that of `depth = U z_a + V z_b + W z_c`,
//! off by at most `3 bound M` for the edge functions and `9 u M max(U, V, W)` for its own rounding; nearer to zero,
//! [`exact`] decides again.
//!
//! # Distance
//! `t` is clamped to the interval in which the ray crosses the triangle's bounding box, computed with the same planes
//! and reciprocals as in a tree. Every box around the triangle has, by monotone rounding, an interval that
//! contains this one, so any tree reaches each hit that testing all triangles finds. If the interval is empty
//! the triangle is missed; [`Mode::Robust`](crate::Mode::Robust) rules that out.

pub mod exact;

use crate::Aabb;
use crate::ray::TraversalRay;
use crate::simd::F32x4;
use scenes::Mesh;
use std::cmp::Ordering;

const UNIT_ROUNDOFF: f32 = 1.0 / 16_777_216.0;

/// The error bound's factor of `M (E + 4 u M)`.
const EDGE_BOUND: f32 = 40.0 * UNIT_ROUNDOFF;

/// The magnitudes of translated corners for which single precision is tried.
const RANGE: std::ops::Range<f32> = 1.0 / 1_073_741_824.0..34_359_738_368.0;

/// A triangle as traversal reads it: 40 bytes.
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Triangle {
    /// `rows[k]` holds component `k` of the three corners.
    rows: [[f32; 3]; 3],
    /// Bits 25:0 index in the mesh, bit 27 last triangle of its leaf, bit 30 set so that the word, which
    /// four-lane loads of the last row read along, is an ordinary float.
    tag: u32,
}

const TAG_BASE: u32 = 1 << 30;
const TAG_LAST: u32 = 1 << 27;
const TAG_INDEX: u32 = (1 << 26) - 1;

impl Triangle {
    /// The 32-bit words that a triangle takes in memory.
    pub const WORDS: u32 = 10;

    /// Triangle `index` of `mesh`; `last` marks the end of its leaf.
    ///
    /// # Panics
    /// If an index is out of range.
    #[must_use]
    pub fn new(mesh: &Mesh, index: u32, last: bool) -> Self {
        let corners = mesh.corners(index as usize);
        let rows = std::array::from_fn(|k| corners.map(|corner| corner[k]));
        Self { rows, tag: TAG_BASE | if last { TAG_LAST } else { 0 } | index }
    }

    /// Index of the triangle in its mesh.
    #[inline(always)]
    #[must_use]
    pub fn index(&self) -> u32 {
        self.tag & TAG_INDEX
    }

    /// Whether this is the last triangle of its leaf.
    #[inline(always)]
    #[must_use]
    pub fn is_last(&self) -> bool {
        self.tag & TAG_LAST != 0
    }

    /// The three corners.
    #[must_use]
    pub fn corners(&self) -> [[f32; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|k| self.rows[k][i]))
    }

    /// The box of the three corners.
    #[must_use]
    pub fn aabb(&self) -> Aabb {
        Aabb::of_points(&self.corners())
    }

    /// Whether this is what [`Triangle::new`] makes for some index and finite corners.
    pub(crate) fn is_valid(&self) -> bool {
        let is_tag = self.tag & !(TAG_LAST | TAG_INDEX) == TAG_BASE;
        is_tag && self.rows.iter().flatten().all(|x| x.is_finite())
    }

    /// Row `k` in lanes 0 to 2; lane 3 holds some finite number.
    #[inline(always)]
    fn row(&self, k: usize) -> F32x4 {
        let words: &[f32; 10] = bytemuck::cast_ref(self);
        F32x4::load(words[3 * k..3 * k + 4].try_into().expect("four words"))
    }
}

/// The triangles of the leaf that starts in slot `first`, up to the one that is marked as its last.
pub(crate) fn leaf_at(triangles: &[Triangle], first: u32) -> Option<&[Triangle]> {
    let rest = triangles.get(first as usize..)?;
    let last = rest.iter().position(Triangle::is_last)?;
    Some(&rest[..=last])
}

/// Where a ray meets a triangle, with the distance along the scaled direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// Distance along [`TraversalRay::direction`].
    pub t: f32,
    /// Weight of the second corner.
    pub u: f32,
    /// Weight of the third corner.
    pub v: f32,
}

/// A ray, prepared for triangle tests.
#[derive(Clone, Copy)]
pub struct TriangleTest {
    /// The axis of the direction's largest component last.
    axes: [usize; 3],
    /// `direction[axes[0]] / direction[axes[2]]`, likewise for `axes[1]`, and `1 / direction[axes[2]]`.
    shear: [f32; 3],
}

impl TriangleTest {
    /// Prepares the tests of `ray`.
    #[inline]
    #[must_use]
    pub fn new(ray: &TraversalRay) -> Self {
        Self::along(ray.direction)
    }

    #[inline]
    fn along(d: [f32; 3]) -> Self {
        let largest = largest_axis(d);
        let axes = [(largest + 1) % 3, (largest + 2) % 3, largest];
        Self { axes, shear: [d[axes[0]] / d[axes[2]], d[axes[1]] / d[axes[2]], 1.0 / d[axes[2]]] }
    }

    /// Tests `triangle`; a hit lies in `ray.t_min..=t_max`.
    #[inline(always)]
    #[must_use]
    pub fn intersect(&self, ray: &TraversalRay, triangle: &Triangle, t_max: f32) -> Option<TriangleHit> {
        match self.decide(self.translated(ray.origin, |k| triangle.row(k))) {
            Decision::Missed => None,
            Decision::Met(hit) => within_box(ray, triangle, hit, t_max),
            Decision::Unsure => decide_exactly(ray, triangle, t_max),
        }
    }

    /// The corners relative to `origin`, along the axes of the test; `row` gives a component of all corners.
    #[inline(always)]
    fn translated(&self, origin: [f32; 3], row: impl Fn(usize) -> F32x4) -> [F32x4; 3] {
        self.axes.map(|axis| row(axis).sub(F32x4::splat(origin[axis])))
    }

    /// What single precision tells of the triangle with the translated corners.
    #[inline(always)]
    fn decide(&self, [ax, ay, az]: [F32x4; 3]) -> Decision {
        // Sheared so that the ray runs along the third axis.
        let x = ax.sub(az.mul(F32x4::splat(self.shear[0])));
        let y = ay.sub(az.mul(F32x4::splat(self.shear[1])));
        // Lanes a, b, c hold U = x_c y_b - y_c x_b and its rotations.
        let edges = x.zxy().mul(y.yzx()).sub(y.zxy().mul(x.yzx()));

        let (m, e) = (largest_lane(ax.abs().max(ay.abs()).max(az.abs())), largest_lane(x.abs().max(y.abs())));
        let bound = EDGE_BOUND * m * (e + 4.0 * UNIT_ROUNDOFF * m);
        let positive = edges.gt(F32x4::splat(bound)) & 7;
        let negative = F32x4::splat(-bound).gt(edges) & 7;
        let in_range = RANGE.contains(&m);
        if positive != 0 && negative != 0 && in_range {
            return Decision::Missed;
        }
        if !((positive == 7 || negative == 7) && in_range) {
            return Decision::Unsure;
        }
        // The edge functions' signs are certain and equal.
        let depths = edges.mul(az);
        let depth = depths.x() + depths.y() + depths.z();
        if depth.abs() <= 4.0 * m * (bound + 4.0 * UNIT_ROUNDOFF * largest_lane(edges.abs())) {
            return Decision::Unsure;
        }
        let determinant = edges.x() + edges.y() + edges.z();
        let inv_determinant = 1.0 / determinant;
        let t = depth * self.shear[2] * inv_determinant;
        Decision::Met(TriangleHit { t, u: edges.y() * inv_determinant, v: edges.z() * inv_determinant })
    }

    /// As [`TriangleTest::decide`] in units of the power of two at or below `M`, for an `M` beyond [`RANGE`].
    fn decide_in_units(&self, corners: [F32x4; 3]) -> Decision {
        let [ax, ay, az] = corners;
        let m = largest_lane(ax.abs().max(ay.abs()).max(az.abs()));
        if RANGE.contains(&m) || !m.is_normal() {
            return Decision::Unsure;
        }
        let unit = f32::from_bits(m.to_bits() & f32::INFINITY.to_bits());
        let scale = F32x4::splat(1.0 / unit);
        match self.decide(corners.map(|row| row.mul(scale))) {
            Decision::Met(hit) => Decision::Met(TriangleHit { t: hit.t * unit, ..hit }),
            other => other,
        }
    }
}

/// What single precision tells of a ray and a triangle.
enum Decision {
    /// The ray's line does not meet it.
    Missed,
    /// The ray's line meets it here.
    Met(TriangleHit),
    /// Rounding could decide otherwise.
    Unsure,
}

/// The axis of the largest component; of equal ones the last.
#[inline(always)]
fn largest_axis(direction: [f32; 3]) -> usize {
    let [x, y, z] = direction.map(f32::abs);
    if x > y && x > z {
        0
    } else if y > z {
        1
    } else {
        2
    }
}

/// The largest of lanes 0 to 2, none of which is NaN for finite input unless a difference overflowed.
#[inline(always)]
fn largest_lane(x: F32x4) -> f32 {
    x.max(x.yzx()).max(x.zxy()).x()
}

#[cold]
#[inline(never)]
fn decide_exactly(ray: &TraversalRay, triangle: &Triangle, t_max: f32) -> Option<TriangleHit> {
    let hit = decided_hit(ray.origin, ray.direction, &triangle.corners())?;
    within_box(ray, triangle, hit, t_max)
}

/// Where the line from `origin` along `direction` meets the closed triangle, if single precision does not tell directly: in another
/// unit of length where that is all that it takes, else as [`exact_hit`]. All inputs must be finite, and the largest component of
/// `direction` in (1/2, 1], as that of [`TraversalRay::direction`].
#[must_use]
pub fn decided_hit(origin: [f32; 3], direction: [f32; 3], corners: &[[f32; 3]; 3]) -> Option<TriangleHit> {
    let test = TriangleTest::along(direction);
    let row = |k: usize| F32x4::load(&[corners[0][k], corners[1][k], corners[2][k], 0.0]);
    match test.decide_in_units(test.translated(origin, row)) {
        Decision::Missed => None,
        Decision::Met(hit) => Some(hit),
        Decision::Unsure => exact_hit(origin, direction, corners),
    }
}

/// Where the line from `origin` along `direction` meets the closed triangle, decided exactly; `t` is not clamped to the triangle's
/// bounding box, and is negative for a triangle behind the origin. All inputs must be finite.
///
/// `t` is in units of the length of `direction`. Scaled like [`TraversalRay::direction`], it gives the `t` of [`TriangleHit`].
#[must_use]
pub fn exact_hit(origin: [f32; 3], direction: [f32; 3], corners: &[[f32; 3]; 3]) -> Option<TriangleHit> {
    let exact::Signed { edges, depth_sign } = exact::evaluate(origin, direction, corners);
    let positive = edges.iter().any(|x| *x > 0.0);
    let negative = edges.iter().any(|x| *x < 0.0);
    if positive == negative {
        // Both: outside. Neither: the ray lies in the plane, or the triangle has no area.
        return None;
    }
    // Dividing by the largest first keeps tiny and huge weights alike in range.
    let largest = edges.iter().fold(0.0f64, |m, x| m.max(x.abs()));
    let weights = edges.map(|x| x.abs() / largest);
    let axis = largest_axis(direction);
    let sum = weights[0] + weights[1] + weights[2];
    let depth: f64 =
        (0..3).map(|i| weights[i] * (f64::from(corners[i][axis]) - f64::from(origin[axis]))).sum();
    let t = (depth / sum / f64::from(direction[axis])) as f32;
    // Rounding must not move the triangle to the other side of the origin.
    let t = match depth_sign {
        Ordering::Less => t.min(-f32::MIN_POSITIVE),
        Ordering::Equal => 0.0,
        Ordering::Greater => t.max(0.0),
    };
    Some(TriangleHit { t, u: (weights[1] / sum) as f32, v: (weights[2] / sum) as f32 })
}

/// The lesser of two finite numbers; either of two zeros.
#[inline(always)]
fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The greater of two finite numbers; either of two zeros.
#[inline(always)]
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Clamps `hit.t` to the interval of the triangle's bounding box and tests it against the ray's.
#[inline(always)]
fn within_box(ray: &TraversalRay, triangle: &Triangle, hit: TriangleHit, t_max: f32) -> Option<TriangleHit> {
    // Unbounded at first: a distance behind the origin has to stay there, to be rejected by the ray's own bounds.
    let (mut entry, mut exit) = (f32::NEG_INFINITY, f32::INFINITY);
    for (axis, [a, b, c]) in triangle.rows.iter().enumerate() {
        // Adding +0 turns -0 into +0, as in the planes of every tree.
        let (low, high) = (lesser(lesser(*a, *b), *c) + 0.0, greater(greater(*a, *b), *c) + 0.0);
        let (first, second) = if ray.is_negative(axis) { (high, low) } else { (low, high) };
        let (near, far) = (ray.entry(first, axis), ray.exit(second, axis));
        entry = if near > entry { near } else { entry };
        exit = if far < exit { far } else { exit };
    }
    // A NaN t (0/0 cannot occur, inf - inf could) fails the last comparison.
    let t = if hit.t < entry { entry } else { hit.t };
    let t = if t > exit { exit } else { t };
    (entry <= exit && ray.t_min <= t && t <= t_max).then_some(TriangleHit { t, ..hit })
}

#[cfg(test)]
mod tests;
