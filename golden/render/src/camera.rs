//! Rays through the pixels of a pinhole camera.

use crate::shading::primary_direction;
use glam::DVec3;
use golden::Ray;
use scenes::Camera;

/// Why a camera sees nothing.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CameraError {
    /// A component is NaN or infinite.
    #[error("{name} {value:?}: all three components must be finite")]
    NotFinite {
        /// `eye`, `target` or `up`.
        name: &'static str,
        /// Its value.
        value: [f32; 3],
    },
    /// The eye is at the target.
    #[error("eye and target are both {0:?}: move one, so that there is a direction to look in")]
    NoDirection([f32; 3]),
    /// The up vector is zero or along the line of sight.
    #[error("up {0:?} is zero or parallel to the line of sight: give another direction")]
    NoUp([f32; 3]),
    /// The field of view is out of range.
    #[error("fov {0}: the vertical field of view must be between 0 and 180 degrees, both excluded")]
    Fov(f32),
}

/// Below this sine of the angle between the line of sight and the up vector, they count as parallel.
const LEAST_SINE: f64 = 1e-6;

/// A camera, prepared for an image of a given size in double precision and rounded once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraRays {
    /// Where its rays start.
    pub eye: [f32; 3],
    /// Direction through the upper left corner of the image.
    pub corner: [f32; 3],
    /// One pixel to the right.
    pub right: [f32; 3],
    /// One pixel down.
    pub down: [f32; 3],
}

impl CameraRays {
    /// Prepares `camera` for images of `width` x `height` square pixels.
    ///
    /// # Errors
    /// See [`CameraError`].
    pub fn new(camera: &Camera, width: u32, height: u32) -> Result<Self, CameraError> {
        for (name, value) in [("eye", camera.eye), ("target", camera.target), ("up", camera.up)] {
            if value.iter().any(|x| !x.is_finite()) {
                return Err(CameraError::NotFinite { name, value });
            }
        }
        let fov = camera.fov_y_degrees;
        if !(fov > 0.0 && fov < 180.0) {
            return Err(CameraError::Fov(fov));
        }
        let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        let sight = (vector(camera.target) - vector(camera.eye)).try_normalize();
        let forward = sight.ok_or(CameraError::NoDirection(camera.eye))?;
        let up = vector(camera.up).try_normalize().ok_or(CameraError::NoUp(camera.up))?;
        let sideways = forward.cross(up);
        if sideways.length() < LEAST_SINE {
            return Err(CameraError::NoUp(camera.up));
        }
        let sideways = sideways.normalize();
        let upward = sideways.cross(forward);
        let half_height = libm::tan(f64::from(fov).to_radians() / 2.0);
        let pixel = 2.0 * half_height / f64::from(height);
        let (right, down) = (sideways * pixel, upward * -pixel);
        let corner = forward - right * (f64::from(width) / 2.0) - down * (f64::from(height) / 2.0);
        let [corner, right, down] = [corner, right, down].map(|v| v.to_array().map(|c| c as f32));
        Ok(Self { eye: camera.eye, corner, right, down })
    }

    /// The ray through the point `x` pixels to the right of and `y` pixels below the image's upper left corner; its
    /// direction has length 1 up to rounding.
    ///
    /// The centre of pixel (i, j) is at `x = i + 0.5`, `y = j + 0.5`.
    #[must_use]
    pub fn ray(&self, x: f32, y: f32) -> Ray {
        Ray::new(self.eye, primary_direction(self.corner, self.right, self.down, [x, y]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAMERA: Camera =
        Camera { eye: [1.0, 2.0, 3.0], target: [1.0, 2.0, -5.0], up: [0.0, 1.0, 0.0], fov_y_degrees: 90.0 };

    #[test]
    fn corners_and_centre() {
        let rays = CameraRays::new(&CAMERA, 4, 2).unwrap();
        let close = |ray: Ray, d: [f64; 3]| {
            let d = DVec3::from_array(d).normalize();
            assert_eq!(ray.origin, CAMERA.eye);
            assert!((DVec3::from_array(ray.direction.map(f64::from)) - d).length() < 2e-7, "{ray:?} {d}");
        };
        close(rays.ray(2.0, 1.0), [0.0, 0.0, -1.0]);
        close(rays.ray(0.0, 0.0), [-2.0, 1.0, -1.0]);
        close(rays.ray(4.0, 2.0), [2.0, -1.0, -1.0]);
        close(rays.ray(0.5, 0.5), [-1.5, 0.5, -1.0]);
    }

    #[test]
    fn cameras_that_see_nothing() {
        let new = |camera: Camera| CameraRays::new(&camera, 8, 8).unwrap_err();
        assert_eq!(new(Camera { target: CAMERA.eye, ..CAMERA }), CameraError::NoDirection(CAMERA.eye));
        assert_eq!(new(Camera { up: [0.0; 3], ..CAMERA }), CameraError::NoUp([0.0; 3]));
        assert_eq!(new(Camera { up: [0.0, 0.0, 2.0], ..CAMERA }), CameraError::NoUp([0.0, 0.0, 2.0]));
        for fov in [0.0, -1.0, 180.0] {
            assert_eq!(new(Camera { fov_y_degrees: fov, ..CAMERA }), CameraError::Fov(fov));
        }
        assert!(matches!(new(Camera { fov_y_degrees: f32::NAN, ..CAMERA }), CameraError::Fov(_)));
        for (name, camera) in [
            ("eye", Camera { eye: [f32::NAN; 3], ..CAMERA }),
            ("target", Camera { target: [f32::INFINITY; 3], ..CAMERA }),
            ("up", Camera { up: [0.0, f32::NAN, 0.0], ..CAMERA }),
        ] {
            assert!(new(camera).to_string().starts_with(name));
        }
    }
}
