//! Sample points and directions, a function of seed, pixel, sample and bounce alone.

use base::split_mix::hash;
use glam::DVec3;

/// The Owen-scrambled Sobol sequence of one pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct PixelSamples {
    seed: u32,
}

/// Dimensions 0 and 1 are the place in the pixel, then two for each bounce.
const PIXEL_DIMENSION: u32 = 0;
const FIRST_BOUNCE_DIMENSION: u32 = 2;

impl PixelSamples {
    pub fn new(seed: u64, pixel: u64) -> Self {
        Self { seed: (hash(hash(seed).wrapping_add(pixel)) >> 32) as u32 }
    }

    /// Where sample `sample` is in its pixel, from the upper left corner; the first is in the centre.
    pub fn place(self, sample: u32) -> [f64; 2] {
        if sample == 0 { [0.5; 2] } else { self.point(sample, PIXEL_DIMENSION) }
    }

    /// The point in the unit square from which the direction of bounce `bounce`, counted from 0, is made.
    pub fn bounce(self, sample: u32, bounce: usize) -> [f64; 2] {
        self.point(sample, FIRST_BOUNCE_DIMENSION + 2 * bounce as u32)
    }

    fn point(self, sample: u32, dimension: u32) -> [f64; 2] {
        [0, 1].map(|i| f64::from(sobol_burley::sample(sample, dimension + i, self.seed)))
    }
}

/// The direction at `point` of the cosine-weighted distribution around the unit vector `normal`.
///
/// Malley's method: a uniform point of the disk, projected upwards. The cosine is positive as `point` is below 1.
pub(super) fn cosine_direction(normal: DVec3, point: [f64; 2]) -> DVec3 {
    let (sin, cos) = libm::sincos(std::f64::consts::TAU * point[1]);
    let radius = point[0].sqrt();
    let [tangent, bitangent] = tangents(normal);
    tangent * (radius * cos) + bitangent * (radius * sin) + normal * (1.0 - point[0]).sqrt()
}

/// Two unit vectors, perpendicular to each other and to the unit vector `n`.
///
/// Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
fn tangents(n: DVec3) -> [DVec3; 2] {
    let sign = 1f64.copysign(n.z);
    let a = -1.0 / (sign + n.z);
    let b = n.x * n.y * a;
    [DVec3::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x), DVec3::new(b, sign + n.y * n.y * a, -n.y)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_unit_and_cosine_distributed() {
        let normals = [DVec3::X, DVec3::NEG_Z, DVec3::Z, DVec3::new(-0.6, 0.48, -0.64)];
        for (i, normal) in normals.into_iter().enumerate() {
            let samples = PixelSamples::new(7, i as u64);
            let count = 4096;
            let mut moments = [0.0; 2];
            let mut sideways = DVec3::ZERO;
            for sample in 0..count {
                let d = cosine_direction(normal, samples.bounce(sample, 3));
                assert!((d.length() - 1.0).abs() < 1e-12);
                let cosine = d.dot(normal);
                assert!(cosine > 0.0);
                moments[0] += cosine / f64::from(count);
                moments[1] += cosine * cosine / f64::from(count);
                sideways += (d - normal * cosine) / f64::from(count);
            }
            // Under the density cos / pi, the mean of cos is 2/3, that of cos^2 is 1/2.
            assert!((moments[0] - 2.0 / 3.0).abs() < 2e-3, "{moments:?}");
            assert!((moments[1] - 0.5).abs() < 2e-3, "{moments:?}");
            assert!(sideways.length() < 5e-3, "{sideways}");
        }
    }

    #[test]
    fn pixels_seeds_and_dimensions_differ() {
        let first = |seed, pixel, bounce| PixelSamples::new(seed, pixel).bounce(1, bounce);
        let all = [first(0, 0, 0), first(1, 0, 0), first(0, 1, 0), first(0, 0, 1)];
        for (i, a) in all.iter().enumerate() {
            assert!(!all[..i].contains(a), "{all:?}");
        }
        assert_eq!(PixelSamples::new(3, 5).place(0), [0.5; 2]);
        assert_ne!(PixelSamples::new(3, 5).place(1), PixelSamples::new(3, 6).place(1));
    }
}
