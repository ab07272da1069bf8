//! What all pixels of a picture share: camera, light, background and the number of bounces.

use super::camera::CameraRays;
use super::shading::power_of_two;
use super::{
    MAX_LIGHT_COORDINATE, MAX_PIXELS, MAX_SAMPLES, MAX_SIDE, MOST_KEPT_RAYS, RenderError, RenderOptions,
};
use scenes::{Mesh, PointLight, Scene};

/// The parameters of the shading of a picture, as [`shading`](crate::shading) uses them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The camera.
    pub camera: CameraRays,
    /// The light.
    pub light: Light,
    /// Radiance of rays that leave the scene, linear RGB.
    pub background: [f32; 3],
    /// Bounces after the primary ray.
    pub bounces: usize,
}

impl Frame {
    /// The parameters with which `scene` is rendered.
    ///
    /// # Errors
    /// See [`RenderError`].
    ///
    /// # Panics
    /// If an index of a triangle is out of range.
    pub fn new(scene: &Scene, options: &RenderOptions) -> Result<Self, RenderError> {
        check(scene, options)?;
        Ok(Self {
            camera: CameraRays::new(&scene.camera, options.width, options.height)?,
            light: Light::new(&scene.light, &scene.mesh),
            background: options.background,
            bounces: options.test.bounces(),
        })
    }
}

fn check(scene: &Scene, options: &RenderOptions) -> Result<(), RenderError> {
    let RenderOptions { width, height, samples, .. } = *options;
    let sides = 1..=MAX_SIDE;
    if !sides.contains(&width) || !sides.contains(&height) || width * height > MAX_PIXELS {
        return Err(RenderError::Size { width, height });
    }
    if !(1..=MAX_SAMPLES).contains(&samples) {
        return Err(RenderError::Samples(samples));
    }
    let rays_per_sample = 2 * (options.test.bounces() as u64 + 1);
    let rays = u64::from(width) * u64::from(height) * u64::from(samples) * rays_per_sample;
    if options.keep_rays && rays > MOST_KEPT_RAYS {
        return Err(RenderError::TooManyRays(rays));
    }
    let intensity = scene.light.intensity;
    if intensity.iter().any(|x| !x.is_finite()) {
        return Err(RenderError::NotFinite { name: "light intensity", value: intensity.map(|x| x as f32) });
    }
    for (name, value) in [("light position", scene.light.position), ("background", options.background)] {
        if value.iter().any(|x| !x.is_finite()) {
            return Err(RenderError::NotFinite { name, value });
        }
    }
    let position = scene.light.position;
    if position.iter().any(|x| x.abs() > MAX_LIGHT_COORDINATE) {
        return Err(RenderError::LightTooFar(position));
    }
    Ok(())
}

/// A point light, as the shading of one mesh uses it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Its position.
    pub position: [f32; 3],
    /// The unit of its distance: the power of two at or below the largest side of the smallest axis-parallel box around the mesh's
    /// triangles and the light; 1 where that side is below the least normal number, as without triangles.
    ///
    /// No point of the mesh is further from the light than the box's diagonal. So the inverse square of the distance in this unit is
    /// at least 1/12, and does not underflow.
    pub extent: f32,
    /// Its radiant intensity over the square of `extent`, linear RGB, computed in binary64, limited to finite numbers of binary32
    /// and rounded.
    pub intensity: [f32; 3],
}

impl Light {
    /// Prepares `light`, whose position is within [`MAX_LIGHT_COORDINATE`], for pictures of `mesh`.
    ///
    /// # Panics
    /// If an index of a triangle is out of range.
    #[must_use]
    pub fn new(light: &PointLight, mesh: &Mesh) -> Self {
        let side = mesh.bounds().map_or(0.0, |bounds| {
            let sides = (0..3).map(|k| {
                let position = light.position[k];
                bounds.max[k].max(position) - bounds.min[k].min(position)
            });
            sides.fold(0.0, f32::max)
        });
        let extent = if side.is_normal() { power_of_two(side) } else { 1.0 };
        let squared = f64::from(extent) * f64::from(extent);
        let [least, greatest] = [f32::MIN, f32::MAX].map(f64::from);
        let intensity = light.intensity.map(|channel| (channel / squared).clamp(least, greatest) as f32);
        Self { position: light.position, extent, intensity }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extent_is_that_of_mesh_and_light() {
        let mesh =
            |positions: [[f32; 3]; 3]| Mesh { positions: positions.to_vec(), triangles: vec![[0, 1, 2]] };
        let at = |position| PointLight { position, intensity: [3.0, 6.0, 1e38] };
        let flat = mesh([[0.0; 3], [5.0, 0.0, 0.0], [5.0, 7.9, 0.0]]);
        let light = Light::new(&at([1.0; 3]), &flat);
        assert_eq!((light.extent, light.intensity), (4.0, [3.0 / 16.0, 6.0 / 16.0, 1e38 / 16.0]));
        assert_eq!(Light::new(&at([0.0, 0.0, -9.0]), &flat).extent, 8.0);
        // A minute mesh: the light's distance counts.
        let minute = mesh([[1.0; 3], [1.0; 3], [1.0; 3]]);
        assert_eq!(Light::new(&at([1.0, 1.0, 1.25]), &minute).extent, 0.25);
        assert_eq!(Light::new(&at([1.0, 1.0, 1.25]), &minute).intensity, [48.0, 96.0, f32::MAX]);
        assert_eq!(Light::new(&at([1.0; 3]), &minute).extent, 1.0);
        assert_eq!(Light::new(&at([1e-40; 3]), &mesh([[0.0; 3]; 3])).extent, 1.0);
        assert_eq!(Light::new(&at([9.0; 3]), &Mesh::default()).extent, 1.0);
    }
}
