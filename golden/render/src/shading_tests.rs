//! The formulas on values that another implementation computed, and what the renderer needs of them.

use super::*;
use crate::Light;
use crate::sampling::PixelSamples;
use glam::DVec3;
use golden::Mode;
use golden::traverse::brute_force;
use golden::triangle::Triangle;
use proptest::prelude::*;
use scenes::{Mesh, PointLight};

fn bits<const N: usize>(x: [f32; N]) -> [u32; N] {
    x.map(f32::to_bits)
}

const NORMAL: V3 = [0.6, -0.64, 0.48];

#[test]
fn roots_sines_and_cosines() {
    assert_eq!(
        bits([1e-38, 0.3, 2.0, 3.0, 7.0, 1e38].map(inverse_square_root)),
        [0x5f0ac723, 0x3fe9b1e8, 0x3f3504f3, 0x3f13cd3a, 0x3ec1848f, 0x1fec1e4b]
    );
    let angles = [0.1, 1.0, 2.5, 6.2];
    assert_eq!(bits(angles.map(sine)), [0x3dcc7577, 0x3f576aa4, 0x3f193578, 0xbdaa2ae0]);
    assert_eq!(bits(angles.map(cosine)), [0x3f7eb898, 0x3f0a5140, 0xbf4d17bf, 0x3f7f1d62]);
}

#[test]
fn powers_of_two() {
    let subnormal = f32::from_bits(0x007f_ffff);
    for (m, power, reciprocal) in [
        (0.0, 0.0, 2f32.powi(127)),
        (subnormal, 0.0, 2f32.powi(127)),
        (f32::MIN_POSITIVE, f32::MIN_POSITIVE, 2f32.powi(126)),
        (0.75, 0.5, 2.0),
        (1.0, 1.0, 1.0),
        (1.999_999_9, 1.0, 1.0),
        (2f32.powi(126) * 1.5, 2f32.powi(126), 2f32.powi(-126)),
        (2f32.powi(127), 2f32.powi(127), 0.0),
        (f32::MAX, 2f32.powi(127), 0.0),
    ] {
        assert_eq!((power_of_two(m), unscale(m)), (power, reciprocal), "{m:e}");
    }
}

#[test]
fn primary_directions() {
    for (corner, right, down, place, expected) in [
        (
            [-0.7, 0.55, -0.9],
            [0.011, 0.002, 0.003],
            [-0.0013, -0.0127, 0.004],
            [17.5, 3.5],
            [0xbeea9331, 0x3ef7a192, 0xbf3eeaca],
        ),
        (
            [-1.0, 1.0, -1.0],
            [0.25, 0.0, 0.0],
            [0.0, -0.25, 0.0],
            [7.5, 0.5],
            [0x3f0ccaf6, 0x3f0ccaf6, 0xbf20e7f5],
        ),
        (
            [0.3, 0.1, -0.8],
            [0.0007, -0.0003, 0.0001],
            [0.0002, -0.0009, -0.0004],
            [511.25, 300.75],
            [0x3f1cb2d5, 0xbe8d703f, 0xbf3daf54],
        ),
    ] {
        assert_eq!(bits(primary_direction(corner, right, down, place)), expected);
    }
}

/// From the front, from behind, at a large scale, thin, and too thin.
#[test]
fn surfaces() {
    const TRIANGLE: [V3; 3] = [[0.1, 0.2, 0.3], [1.7, -0.4, 2.1], [-0.6, 0.9, 5.3]];
    const DIRECTION: V3 = [0.36, -0.48, 0.8];
    for (corners, [u, v], direction, normal, origin) in [
        (
            TRIANGLE,
            [0.3, 0.45],
            DIRECTION,
            [0x3ed57b3f, 0x3f6805f3, 0xbd8c5101],
            [0x3e87b04b, 0x3eab89ec, 0x4045c284],
        ),
        (
            TRIANGLE,
            [0.3, 0.45],
            DIRECTION.map(|d| -d),
            [0xbed57b3f, 0xbf6805f3, 0x3d8c5101],
            [0x3e87abdf, 0x3eab8050, 0x4045c29c],
        ),
        (
            TRIANGLE.map(|corner| corner.map(|x| x * 1e30)),
            [0.1, 0.7],
            DIRECTION,
            [0x3ed57b3e, 0x3f6805f3, 0xbd8c5101],
            [0xf039c767, 0x70fe7843, 0x7248f043],
        ),
        (
            [[1.0; 3], [2.0; 3], [3.0, 3.0, 3.0001]],
            [0.5, 0.25],
            DIRECTION,
            [0xbf3504f3, 0x3f3504f3, 0x80000000],
            [0x3fffff78, 0x40000044, 0x40000069],
        ),
        (
            [[1.0; 3], [2.0; 3], [3.0, 3.0, 3.00001]],
            [0.5, 0.25],
            DIRECTION,
            [0xbeb851ec, 0x3ef5c28f, 0xbf4ccccd],
            [0x3fffffbb, 0x4000002e, 0x3fffff7a],
        ),
    ] {
        let found = surface(&corners, &Hit { t: 1.0, u, v, triangle: 0 }, direction);
        assert_eq!((bits(found.normal), bits(found.origin)), (normal, origin), "{corners:?} {direction:?}");
    }
}

#[test]
fn ways_to_the_light() {
    for (origin, position, throughput, extent, direction, t_max, reflected) in [
        (
            [0.1, 0.2, 0.3],
            [3.3, -2.2, 1.1],
            0.7,
            1.0,
            [0x3fcccccd, 0xbf99999a, 0x3ecccccd],
            0x40000000,
            0x3c4e8601,
        ),
        (
            [0.1, 0.2, 0.3],
            [0.3, 0.1, 0.4],
            0.343,
            4.0,
            [0x3fccccce, 0xbf4ccccd, 0x3f4ccccc],
            0x3e000000,
            0x41dc9ae0,
        ),
        (
            [-0.27, 0.12, -0.73],
            [-3.45, -1.45, 1.93],
            0.49,
            2.0,
            [0xbfcb851f, 0xbf48f5c3, 0x3faa3d70],
            0x40000000,
            0x3b2f541f,
        ),
        (
            [1e20, 2e20, -1e20],
            [3e20, 1e20, 5e20],
            0.7,
            2f32.powi(69),
            [0x3ead78ec, 0xbe2d78ec, 0x3f821ab1],
            0x62000000,
            0x3e0ef0a3,
        ),
    ] {
        let towards = towards_light(&Surface { normal: NORMAL, origin }, position).unwrap();
        let Ray { origin: start, direction: found, t_min, t_max: end } = towards.shadow;
        assert_eq!((start, bits(found), t_min, end.to_bits()), (origin, direction, 0.0, t_max));
        assert_eq!(towards.reflected(throughput, extent).to_bits(), reflected);
    }
    let level = Surface { normal: [0.0, 1.0, 0.0], origin: [1.0; 3] };
    for position in [[9.0, 1.0, 3.0], [1.0, 0.0, 1.0], [1.0; 3], [0.0, 2f32.powi(127), 0.0]] {
        assert_eq!(towards_light(&level, position), None, "{position:?}");
    }
}

#[test]
fn light_does_not_depend_on_the_unit_of_length() {
    let reflected = |exponent: i32| {
        let scale = 2f32.powi(exponent);
        let corners = [[0.0, 0.0, 0.0], [5.0, 0.0, 0.0], [0.0, 0.0, 3.0]].map(|p: V3| p.map(|x| x * scale));
        let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]] };
        let light = PointLight {
            position: [0.7, 20.0, 0.9].map(|x| x * scale),
            intensity: [1.7 * f64::from(scale).powi(2), 0.0, 0.0],
        };
        let light = Light::new(&light, &mesh);
        let hit = Hit { t: 1.0, u: 0.3, v: 0.4, triangle: 0 };
        let surface = surface(&corners, &hit, [0.36, -0.48, 0.8]);
        let towards = towards_light(&surface, light.position).unwrap();
        (surface.normal, towards.reflected(0.7, light.extent) * light.intensity[0])
    };
    assert_eq!(reflected(0).0, [0.0, 1.0, 0.0]);
    for exponent in [-100, -62, -20, 20, 62, 115] {
        assert_eq!(reflected(exponent), reflected(0), "2^{exponent}");
    }
}

#[test]
fn bounces() {
    for (normal, point, expected) in [
        (NORMAL, [0.3, 0.7], [0x3e747c04, 0xbf74c4a7, 0x3e2dd6c4]),
        ([0.6, -0.64, -0.48], [0.3, 0.7], [0x3f025238, 0xbe4f7dfc, 0xbf562737]),
        ([0.0, 0.0, 1.0], [0.81, 0.125], [0x3f22eada, 0x3f22eada, 0x3edf2cf6]),
        ([1.0, 0.0, -0.0], [1f32.next_down(), 0.4], [0x39800000, 0xbf167916, 0xbf4f1bbd]),
        ([-0.36, 0.48, 0.8], [0.0, 0.9], [0xbeb851ec, 0x3ef5c28f, 0x3f4ccccd]),
    ] {
        assert_eq!(bits(cosine_direction(normal, point)), expected, "{normal:?} {point:?}");
    }
}

#[test]
fn directions_are_unit_and_cosine_distributed() {
    let wide = |v: V3| DVec3::from_array(v.map(f64::from));
    let normals = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0], [-0.6, 0.48, -0.64]];
    for (i, normal) in normals.into_iter().enumerate() {
        let samples = PixelSamples::new(7, i as u64);
        let count = 4096;
        let mut moments = [0.0; 2];
        let mut sideways = DVec3::ZERO;
        for sample in 0..count {
            let d = wide(cosine_direction(normal, samples.bounce(sample, 3)));
            assert!((d.length() - 1.0).abs() < 1e-6);
            let cosine = d.dot(wide(normal));
            assert!(cosine > 0.0);
            moments[0] += cosine / f64::from(count);
            moments[1] += cosine * cosine / f64::from(count);
            sideways += (d - wide(normal) * cosine) / f64::from(count);
        }
        // Under the density cos / pi, the mean of cos is 2/3, that of cos^2 is 1/2.
        assert!((moments[0] - 2.0 / 3.0).abs() < 2e-3, "{moments:?}");
        assert!((moments[1] - 0.5).abs() < 2e-3, "{moments:?}");
        assert!(sideways.length() < 5e-3, "{sideways}");
    }
}

fn corner() -> impl Strategy<Value = V3> {
    prop::array::uniform3(prop_oneof![2 => -1.0f32..1.0, 1 => Just(0.0f32), 1 => Just(1.0f32)])
}

/// `squared` of [`surface`]'s formula in double precision.
fn squared_normal(corners: &[V3; 3]) -> f64 {
    let [a, b, c] = corners.map(|p| DVec3::from_array(p.map(f64::from)));
    let (e, f) = (b - a, c - a);
    let m = e.abs().max_element().max(f.abs().max_element());
    let s = 2f64.powf(-m.log2().floor());
    ((e * s).cross(f * s)).length_squared()
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
        direction in (prop_oneof![3 => 0.0f32..1.0, 1 => 0.99999f32..1.0], 0.0f32..1.0),
    ) {
        let corners = corners.map(|p| p.map(|x| (x + shift) * scale));
        // The bound that `OFFSET_ULPS` derives.
        prop_assume!(squared_normal(&corners) >= 1.0 / 4096.0);
        let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]] };
        let triangle = [Triangle::new(&mesh, 0, true)];
        let (u, v) = (weights.0, weights.1 * (1.0 - weights.0));
        let aim: V3 = std::array::from_fn(|k| {
            corners[0][k] * (1.0 - u - v) + corners[1][k] * u + corners[2][k] * v
        });
        let eye: V3 = std::array::from_fn(|k| aim[k] + from[k] * scale);
        let ray = Ray::new(eye, std::array::from_fn(|k| aim[k] - eye[k]));
        for mode in [Mode::Fast, Mode::Robust] {
            let Some(hit) = brute_force(&triangle, &ray, mode) else { continue };
            let surface = surface(&corners, &hit, ray.direction);
            let next = Ray::new(surface.origin, cosine_direction(surface.normal, direction.into()));
            prop_assert_eq!(brute_force(&triangle, &next, mode), None, "{:?} {:?}", surface, next);
        }
    }
}
