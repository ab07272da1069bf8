//! Endless rays with one hit known by construction: each ray is aimed at a triangle, and one exact test of that
//! triangle confirms the hit.
//!
//! A traversal has lost the hit if it returns none, one farther away, or one of a higher index at the same distance.
//! The check needs no search over all triangles, so millions of rays take seconds. The aims are where traversal goes
//! wrong: corners and edges, which lie on the corners, edges and faces of boxes; along axes, so that a plane contains
//! the ray; from points in the planes of boxes; from the surface itself; from afar; and a few units in the last place
//! beside all of these.

use super::shapes::Random;
use golden::ray::{Hit, Ray, TraversalRay};
use golden::triangle::{Triangle, TriangleTest};
use golden::{Aabb, Mode};
use scenes::Mesh;

/// A ray and a hit of that ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aimed {
    /// The ray.
    pub ray: Ray,
    /// What it was aimed at, as the triangle test sees it; something else may be nearer.
    pub known: Hit,
}

impl Aimed {
    /// The same ray and triangle with the hit of the triangle test in `mode`, or `None` if that test misses.
    #[must_use]
    pub fn in_mode(&self, mesh: &Mesh, mode: Mode) -> Option<Self> {
        confirm(mesh, &self.ray, self.known.triangle, mode)
    }

    /// Whether `found` shows that the known hit was lost.
    #[must_use]
    pub fn is_lost(&self, found: Option<Hit>) -> bool {
        // Written so that a distance that is no number counts as lost.
        !found.is_some_and(|hit| {
            hit.t < self.known.t || hit.t == self.known.t && hit.triangle <= self.known.triangle
        })
    }
}

/// Aims rays at the triangles of a mesh.
#[derive(Debug)]
pub struct Aim<'a> {
    mesh: &'a Mesh,
    bounds: Aabb,
    random: Random,
    mode: Mode,
}

impl<'a> Aim<'a> {
    /// The sequence of `seed`; hits are those of the triangle test in `mode`.
    ///
    /// # Panics
    /// If the mesh has no triangles.
    #[must_use]
    pub fn new(mesh: &'a Mesh, mode: Mode, seed: u64) -> Self {
        assert!(!mesh.triangles.is_empty(), "nothing to aim at");
        Self { mesh, bounds: Aabb::of_points(&mesh.positions), random: Random::new(seed), mode }
    }

    /// A ray, which may miss what it is aimed at, and the triangle.
    fn shoot(&mut self) -> (Ray, u32) {
        let index = self.random.below(self.mesh.triangles.len());
        let corners = self.mesh.corners(index);
        let target = self.target(&corners);
        let mut ray = self.towards(target);
        if self.random.below(2) == 0 {
            let (at, ulps) = (self.random.below(6), self.random.below(7) as i32 - 3);
            let component = if at < 3 { &mut ray.origin[at] } else { &mut ray.direction[at - 3] };
            *component = nudged(*component, ulps);
        }
        if self.random.below(8) == 0 {
            let exponent = self.random.below(81) as i32 - 40;
            let scale = f32::from_bits(((127 + exponent) as u32) << 23);
            ray.direction = ray.direction.map(|d| d * scale);
        }
        (ray, index as u32)
    }

    /// A point on the triangle, up to rounding.
    fn target(&mut self, corners: &[[f32; 3]; 3]) -> [f32; 3] {
        let first = self.random.below(3);
        let [a, b, c] = [0, 1, 2].map(|i| corners[(first + i) % 3]);
        let weights = match self.random.below(5) {
            0 | 1 => return a,
            2 => [0.5, 0.5, 0.0],
            3 => {
                let w = self.random.uniform();
                [1.0 - w, w, 0.0]
            }
            _ => {
                let (u, v) = (self.random.uniform(), self.random.uniform());
                let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
                [1.0 - u - v, u, v]
            }
        };
        std::array::from_fn(|k| weights[0] * a[k] + weights[1] * b[k] + weights[2] * c[k])
    }

    fn towards(&mut self, target: [f32; 3]) -> Ray {
        let extents: [f32; 3] = std::array::from_fn(|k| self.bounds.max[k] - self.bounds.min[k]);
        let largest = extents.iter().fold(f32::MIN_POSITIVE, |m, x| m.max(*x));
        // A flat mesh is seen from all sides too.
        let size = extents.map(|x| if x > 0.0 { x } else { largest });
        let mut origin: [f32; 3] =
            std::array::from_fn(|k| self.bounds.min[k] + size[k] * (2.0 * self.random.uniform() - 0.5));
        match self.random.below(8) {
            // Along an axis, from either side.
            0 => {
                let axis = self.random.below(3);
                let sign = if self.random.below(2) == 0 { 1.0 } else { -1.0 };
                let zero = if self.random.below(2) == 0 { 0.0 } else { -0.0 };
                let mut direction = [zero; 3];
                direction[axis] = sign;
                origin = target;
                origin[axis] -= sign * size[axis];
                return Ray::new(origin, direction);
            }
            // In an axis plane through the target.
            1 => {
                let axis = self.random.below(3);
                origin[axis] = target[axis];
            }
            // From another vertex.
            2 => {
                let other = self.mesh.triangles[self.random.below(self.mesh.triangles.len())];
                origin = self.mesh.positions[other[self.random.below(3)] as usize];
            }
            // From the surface.
            3 => {
                let direction = self.random.in_sphere();
                return Ray::new(target, direction);
            }
            // From afar.
            4 => origin = std::array::from_fn(|k| target[k] + (origin[k] - target[k]) * 1e4),
            // From a coarse grid, so that the difference is exact as far as the target's bits allow.
            5 => origin = std::array::from_fn(|k| f32::from_bits(origin[k].to_bits() & 0xffff_0000)),
            // Almost in an axis plane through the target: the reciprocal is huge, or beyond all numbers.
            6 => {
                let axis = self.random.below(3);
                let tiny = f32::from_bits((self.random.below(64) as u32) << 23 | 1);
                origin[axis] = target[axis] + if self.random.below(2) == 0 { tiny } else { -tiny };
            }
            _ => {}
        }
        Ray::new(origin, std::array::from_fn(|k| target[k] - origin[k]))
    }

    /// `ray` if it hits triangle `index` at a distance that is a normal number, or exactly zero.
    #[must_use]
    pub fn confirm(&self, ray: &Ray, index: u32) -> Option<Aimed> {
        confirm(self.mesh, ray, index, self.mode)
    }
}

fn confirm(mesh: &Mesh, ray: &Ray, index: u32, mode: Mode) -> Option<Aimed> {
    let prepared = TraversalRay::new(ray, mode)?;
    let triangle = Triangle::new(mesh, index, true);
    let hit = TriangleTest::new(&prepared).intersect(&prepared, &triangle, prepared.t_max)?;
    let known = Hit { t: prepared.given_t(hit.t), u: hit.u, v: hit.v, triangle: index };
    // Distances that differ along the scaled direction may become the same subnormal or zero along the given
    // direction. The check would then see ties where there are none.
    (known.t.is_normal() || hit.t == 0.0).then_some(Aimed { ray: *ray, known })
}

impl Iterator for Aim<'_> {
    type Item = Aimed;

    /// The iterator never ends on a mesh with a triangle that has an area.
    fn next(&mut self) -> Option<Aimed> {
        loop {
            let (ray, index) = self.shoot();
            if let Some(aimed) = self.confirm(&ray, index) {
                return Some(aimed);
            }
        }
    }
}

/// `x`, `ulps` units in the last place further up; the largest finite number at most.
#[must_use]
pub fn nudged(x: f32, ulps: i32) -> f32 {
    // Positions in the order of floats: both zeros are 0.
    let magnitude = (x.to_bits() & 0x7fff_ffff) as i32;
    let position = i64::from(if x.is_sign_negative() { -magnitude } else { magnitude }) + i64::from(ulps);
    let most = i64::from(f32::MAX.to_bits());
    let position = position.clamp(-most, most);
    f32::from_bits(position.unsigned_abs() as u32).copysign(if position < 0 { -1.0 } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::closed_sphere;

    #[test]
    fn nudging_counts_floats() {
        assert_eq!(nudged(1.0, 1), 1.0f32.next_up());
        assert_eq!(nudged(1.0, -3), 1.0f32.next_down().next_down().next_down());
        assert_eq!(nudged(-0.0, 1), f32::from_bits(1));
        assert_eq!(nudged(f32::from_bits(1), -2), -f32::from_bits(1));
        assert_eq!(nudged(f32::MAX, 5), f32::MAX);
    }

    #[test]
    fn known_hits_are_hits_and_lost_ones_are_seen() {
        let mesh = closed_sphere(2);
        let tree = golden::build::build(&mesh, &golden::build::BuildOptions::default()).unwrap();
        let oracle = super::super::oracle::Oracle::new(&mesh, &tree);
        for aimed in Aim::new(&mesh, Mode::Robust, 1).take(300) {
            assert!(!oracle.nearest(&aimed.ray).is_empty(), "{aimed:?}");
            let known = aimed.known;
            assert!(!aimed.is_lost(Some(known)));
            assert!(!aimed.is_lost(Some(Hit { t: known.t.next_down(), triangle: u32::MAX, ..known })));
            assert!(aimed.is_lost(None));
            assert!(aimed.is_lost(Some(Hit { triangle: known.triangle + 1, ..known })));
            assert!(aimed.is_lost(Some(Hit { t: known.t.next_up(), ..known })));
            assert!(aimed.is_lost(Some(Hit { t: f32::NAN, ..known })));
        }
    }
}
