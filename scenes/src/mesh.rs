//! The plain data that the other crates work on.

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
    /// Radiant intensity, linear RGB; irradiance at distance `r` is `intensity / r^2`.
    pub intensity: [f32; 3],
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
