//! A view and a light for geometry that has none.

use crate::mesh::{Bounds, Camera, PointLight};

/// Direction from the centre of the box to the eye: from the front, slightly above and to the right. Its
/// length is the distance in diagonals from which objects of ordinary proportions fill the image.
const TOWARDS_EYE: [f64; 3] = [0.15, 0.2, 0.9];
const FOV_Y_DEGREES: f32 = 45.0;
/// tan(45 deg / 2) = sqrt(2) - 1.
const TAN_HALF_FOV: f64 = std::f64::consts::SQRT_2 - 1.0;
/// Free space around the box, as a fraction of the distance.
const MARGIN: f64 = 0.02;
/// Irradiance that the light gives at the centre of the box.
const IRRADIANCE_AT_CENTER: f64 = 4.0;

/// Smallest diagonal that is framed, relative to the largest coordinate: below it, eye and target would come
/// close to each other in `f32`.
const SMALLEST_RELATIVE_DIAGONAL: f64 = 1e-4;

/// A view and a light under which the whole of `bounds` is visible and lit, for square and wider images.
///
/// A flat box is framed like any other; around a point or a minute box far from the origin, the view is as
/// narrow as the precision of `f32` allows.
#[must_use]
pub fn frame(bounds: &Bounds) -> (Camera, PointLight) {
    let center = bounds.center();
    let magnitude = center.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let diagonal = match bounds.diagonal().max(magnitude * SMALLEST_RELATIVE_DIAGONAL) {
        0.0 => 1.0,
        diagonal => diagonal,
    };

    let length = dot(TOWARDS_EYE, TOWARDS_EYE).sqrt();
    let backward = TOWARDS_EYE.map(|x| x / length);
    let right = normalized(cross([0.0, 1.0, 0.0], backward));
    let upward = cross(backward, right);
    let distance = corner_offsets(bounds).into_iter().fold(length * diagonal, |distance, corner| {
        let sideways = dot(corner, right).abs().max(dot(corner, upward).abs());
        distance.max((dot(corner, backward) + sideways / TAN_HALF_FOV) * (1.0 + MARGIN))
    });

    let at = |offset: [f64; 3]| std::array::from_fn(|axis| (center[axis] + offset[axis]) as f32);
    let camera = Camera {
        eye: at(backward.map(|x| x * distance)),
        target: at([0.0; 3]),
        up: [0.0, 1.0, 0.0],
        fov_y_degrees: FOV_Y_DEGREES,
    };
    let to_light =
        std::array::from_fn(|axis| (backward[axis] + 0.4 * upward[axis] - 0.3 * right[axis]) * distance);
    let intensity = IRRADIANCE_AT_CENTER * dot(to_light, to_light);
    (camera, PointLight { position: at(to_light), intensity: [intensity; 3] })
}

fn corner_offsets(bounds: &Bounds) -> [[f64; 3]; 8] {
    let center = bounds.center();
    std::array::from_fn(|corner| {
        std::array::from_fn(|axis| {
            let side = if corner >> axis & 1 == 0 { bounds.min[axis] } else { bounds.max[axis] };
            f64::from(side) - center[axis]
        })
    })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn normalized(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bounds(min: [f32; 3], max: [f32; 3]) -> Bounds {
        Bounds { min, max }
    }

    /// Largest coordinate of a box corner on the image plane, where the image reaches to 1.
    fn image_extent(bounds: &Bounds) -> f64 {
        let (camera, _) = frame(bounds);
        let eye = camera.eye.map(f64::from);
        let target = camera.target.map(f64::from);
        let forward = normalized(std::array::from_fn(|i| target[i] - eye[i]));
        let right = normalized(cross(forward, camera.up.map(f64::from)));
        let upward = cross(right, forward);
        let scale = libm::tan(f64::from(camera.fov_y_degrees).to_radians() / 2.0);
        let center = bounds.center();
        corner_offsets(bounds)
            .into_iter()
            .map(|offset| {
                let d: [f64; 3] = std::array::from_fn(|i| center[i] + offset[i] - eye[i]);
                assert!(dot(d, forward) > 0.0, "the corner lies behind the eye");
                dot(d, right).abs().max(dot(d, upward).abs()) / (dot(d, forward) * scale)
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn the_whole_box_is_in_the_image() {
        let boxes = [
            bounds([-1.0; 3], [1.0; 3]),
            bounds([0.0; 3], [10.0, 0.1, 0.1]),
            bounds([0.0; 3], [0.1, 10.0, 0.1]),
            bounds([0.0; 3], [0.1, 0.1, 10.0]),
            bounds([1e6; 3], [1.001e6; 3]),
            bounds([-1.0, 0.0, -1.0], [1.0, 0.0, 1.0]),
            bounds([-1e-12; 3], [1e-12; 3]),
            bounds([-crate::MAX_COORDINATE; 3], [crate::MAX_COORDINATE; 3]),
        ];
        for b in boxes {
            let extent = image_extent(&b);
            assert!((0.2..=1.0).contains(&extent), "{b:?} reaches to {extent} of the image");
        }
    }

    #[test]
    fn a_point_has_a_view() {
        for p in [[0.0; 3], [5.0, -3.0, 1e20], [1e-30; 3], [-1e6, 0.0, 1e6]] {
            let (camera, light) = frame(&bounds(p, p.map(f32::next_up)));
            assert_ne!(camera.eye[2], camera.target[2]);
            assert!(camera.eye.iter().chain(&light.position).all(|x| x.is_finite()));
            assert!(light.intensity[0] > 0.0 && light.intensity[0].is_finite());
        }
    }
}
