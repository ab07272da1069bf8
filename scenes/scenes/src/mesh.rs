//! The plain data that the other crates work on.

/// Largest magnitude of a coordinate: 2^120.
///
/// The length of an edge, its ratio to another and the sum of two such lengths then stay finite in `f32`.
/// Products of two lengths may not, which is why code that multiplies them does so in `f64`.
pub const MAX_COORDINATE: f32 = (1_u128 << 120) as f32;

/// Largest number of triangles in a mesh, from the 26-bit offsets of dual-split tree nodes.
pub const MAX_TRIANGLES: usize = 1 << 26;

/// An indexed triangle mesh.
///
/// Triangle `i` of the mesh is primitive `i` of every tree and of every hit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertex positions in scene units.
    pub positions: Vec<[f32; 3]>,
    /// Three indices into [`Mesh::positions`] for each triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

impl Mesh {
    /// The three corners of triangle `triangle`.
    ///
    /// # Panics
    /// If `triangle` or one of its indices is out of range.
    #[inline]
    #[must_use]
    pub fn corners(&self, triangle: usize) -> [[f32; 3]; 3] {
        self.triangles[triangle].map(|i| self.positions[i as usize])
    }

    /// The smallest axis-parallel box around all triangles, or `None` if there is no triangle.
    ///
    /// # Panics
    /// If an index of a triangle is out of range.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        let mut corners = self.triangles.iter().flatten().map(|&i| self.positions[i as usize]);
        let first = corners.next()?;
        let bounds = corners.fold(Bounds { min: first, max: first }, |b, p| Bounds {
            min: std::array::from_fn(|axis| b.min[axis].min(p[axis])),
            max: std::array::from_fn(|axis| b.max[axis].max(p[axis])),
        });
        Some(bounds)
    }
}

/// An axis-parallel box with inclusive faces; flat and single-point boxes are valid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower corner.
    pub min: [f32; 3],
    /// Upper corner.
    pub max: [f32; 3],
}

impl Bounds {
    /// The centre, in `f64` so that it is exact up to one rounding.
    #[must_use]
    pub fn center(&self) -> [f64; 3] {
        std::array::from_fn(|axis| (f64::from(self.min[axis]) + f64::from(self.max[axis])) * 0.5)
    }

    /// The length of the diagonal in scene units.
    #[must_use]
    pub fn diagonal(&self) -> f64 {
        let extent = |axis: usize| f64::from(self.max[axis]) - f64::from(self.min[axis]);
        (0..3).map(|axis| extent(axis) * extent(axis)).sum::<f64>().sqrt()
    }
}

/// A pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Position of the pinhole.
    pub eye: [f32; 3],
    /// A point in the centre of the image.
    pub target: [f32; 3],
    /// The direction that appears upwards in the image.
    pub up: [f32; 3],
    /// Vertical field of view in degrees.
    pub fov_y_degrees: f32,
}

/// A light that radiates equally in all directions from one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Position of the light.
    pub position: [f32; 3],
    /// Radiant intensity, linear RGB; irradiance at distance `r` is `intensity / r^2`. In `f64`, which holds the square of every
    /// distance between coordinates.
    pub intensity: [f64; 3],
}

/// A mesh with the view and the light that it is rendered with.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Name of the built-in scene, or the file's stem.
    pub name: String,
    /// The geometry.
    pub mesh: Mesh,
    /// The default view.
    pub camera: Camera,
    /// The default light.
    pub light: PointLight,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits() {
        assert_eq!(f64::from(MAX_COORDINATE), (0..120).fold(1.0, |p, _| p * 2.0));
        assert_eq!(MAX_TRIANGLES, 67_108_864);
    }

    #[test]
    fn bounds_ignore_unused_vertices() {
        let mesh = Mesh {
            positions: vec![[9.0; 3], [0.0, 1.0, 2.0], [-1.0, 1.0, 5.0], [0.0, 3.0, 2.0]],
            triangles: vec![[1, 2, 3]],
        };
        let bounds = mesh.bounds().unwrap();
        assert_eq!(bounds, Bounds { min: [-1.0, 1.0, 2.0], max: [0.0, 3.0, 5.0] });
        assert_eq!(bounds.center(), [-0.5, 2.0, 3.5]);
        assert_eq!(bounds.diagonal(), 14f64.sqrt());
        assert_eq!(Mesh::default().bounds(), None);
    }
}
