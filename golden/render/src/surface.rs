//! The point that a ray has hit, and where the next ray starts.

use glam::DVec3;
use golden::ray::Hit;

/// How far a secondary ray starts from its surface, in units of 2^-24 of the triangle's largest coordinate.
///
/// The point is evaluated in double precision and rounded once, so it lies within 0.9 of these units of the
/// triangle's plane. The triangle test's distance is off by less than 40 of them (the larger part is the translation
/// of corners that are up to twice the coordinate away), so that the triangle itself is never hit again. Waechter and
/// Binder, "A Fast and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, 2019, step by 256 units of
/// each coordinate of the point, and by a fixed distance near the origin. The triangle's largest coordinate, taken
/// instead, makes the offset scale with the scene and covers large triangles near the origin.
pub const OFFSET_ULPS: u32 = 128;

/// A point on a triangle, seen from a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The unit normal of the triangle, on the side from which the ray came.
    pub normal: DVec3,
    /// Start of the rays that leave the point on that side.
    pub origin: [f32; 3],
}

impl Surface {
    /// The surface where a ray with `direction` made `hit` on the triangle with `corners`.
    ///
    /// Where the normal cannot be computed (a triangle thinner than double precision resolves) the surface faces
    /// the ray.
    #[must_use]
    pub fn new(corners: [[f32; 3]; 3], hit: &Hit, direction: [f32; 3]) -> Self {
        let [a, b, c] = corners.map(|p| DVec3::from_array(p.map(f64::from)));
        let direction = DVec3::from_array(direction.map(f64::from));
        let normal = (b - a).cross(c - a).try_normalize().unwrap_or(-direction.normalize());
        let normal = if normal.dot(direction) > 0.0 { -normal } else { normal };
        let point = a + (b - a) * f64::from(hit.u) + (c - a) * f64::from(hit.v);
        let largest = corners.as_flattened().iter().fold(0f32, |largest, x| largest.max(x.abs()));
        let offset = f64::from(largest) * f64::from(OFFSET_ULPS) / f64::from(1 << 24);
        Self { normal, origin: (point + normal * offset).to_array().map(|x| x as f32) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::cosine_direction;
    use golden::traverse::brute_force;
    use golden::triangle::Triangle;
    use golden::{Mode, Ray};
    use proptest::prelude::*;
    use scenes::Mesh;

    fn corner() -> impl Strategy<Value = [f32; 3]> {
        prop::array::uniform3(prop_oneof![2 => -1.0f32..1.0, 1 => Just(0.0f32), 1 => Just(1.0f32)])
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 20_000, ..ProptestConfig::default() })]

        /// Whatever the scale and the place of the scene, in whatever direction a ray leaves.
        #[test]
        fn leaving_rays_miss_their_own_triangle(
            corners in prop::array::uniform3(corner()),
            scale in prop_oneof![Just(1e-6f32), Just(1.0), Just(1e9), Just(1e-30), Just(1e30)],
            shift in prop_oneof![3 => Just(0.0f32), 1 => Just(1000.0)],
            from in prop::array::uniform3(-1.0f32..1.0),
            weights in (0.0f32..1.0, 0.0f32..1.0),
            direction in (prop_oneof![3 => 0.0..1.0, 1 => 0.99999..1.0], 0.0..1.0),
        ) {
            let corners = corners.map(|p| p.map(|x| (x + shift) * scale));
            let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]] };
            let triangle = [Triangle::new(&mesh, 0, true)];
            let (u, v) = (weights.0, weights.1 * (1.0 - weights.0));
            let aim: [f32; 3] = std::array::from_fn(|k| {
                corners[0][k] * (1.0 - u - v) + corners[1][k] * u + corners[2][k] * v
            });
            let eye: [f32; 3] = std::array::from_fn(|k| aim[k] + from[k] * scale);
            let ray = Ray::new(eye, std::array::from_fn(|k| aim[k] - eye[k]));
            for mode in [Mode::Fast, Mode::Robust] {
                let Some(hit) = brute_force(&triangle, &ray, mode) else { continue };
                let surface = Surface::new(corners, &hit, ray.direction);
                let d = cosine_direction(surface.normal, [direction.0, direction.1]);
                let next = Ray::new(surface.origin, d.to_array().map(|x| x as f32));
                prop_assert_eq!(brute_force(&triangle, &next, mode), None, "{:?} {:?}", surface, next);
            }
        }
    }
}
