//! The two rendering tests, from which come the rays that everything is measured with.
//!
//! * [`Test::Raycast`] traces a primary ray per sample, and a shadow ray to the point light from where the primary ray hits.
//! * [`Test::Path`] traces paths with [`DIFFUSE_BOUNCES`] diffuse bounces, cosine-weighted, and a shadow ray from every vertex
//!   (next-event estimation).
//!
//! A picture depends on the scene and on [`RenderOptions`] alone, not on the structure, the number of threads or the machine. All
//! structures find the same hits bit for bit. Every sample is drawn from a sequence of its own. Sine, cosine and tangent come from
//! `libm`. [`shading`] states every operation, all in single precision. Only what the pixels share, the [`Frame`], is prepared in
//! double precision.
//!
//! Surfaces are grey and diffuse ([`ALBEDO`]). The normal is that of the triangle, turned towards the ray. A shadow ray is cast only
//! where the light is above the surface.
//!
//! [`ray_file`] reads and writes the rays of a rendering and their hits.
//!
//! ```
//! use golden::build::{BuildOptions, Quality, build};
//! use golden::structure::{Structure, StructureKind, pack_triangles};
//! use render::{RenderOptions, Test, render};
//!
//! let scene = scenes::procedural::build("statue", 0.0005, 0)?;
//! let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast))?;
//! let triangles = pack_triangles(&scene.mesh, &tree);
//! let options = RenderOptions::new(Test::Raycast, 8, 6);
//!
//! let mut pictures = Vec::new();
//! for kind in [StructureKind::Bvh2, StructureKind::Dst] {
//!     let structure = Structure::convert(kind, &tree, &triangles)?;
//!     pictures.push(render(&structure, &scene, &options, |_rows| ())?.pixels);
//! }
//! assert_eq!(pictures[0].len(), 8 * 6);
//! assert_eq!(pictures[0], pictures[1], "all structures give the same picture");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod camera;
mod frame;
mod integrate;
mod output;
pub mod ray_file;
mod sampling;
pub mod shading;
mod stream;

pub use camera::{CameraError, CameraRays};
pub use frame::{Frame, Light};
pub use output::{ClassTotals, Pixel, Rendering, Work};
pub use sampling::{SAMPLE_DIMENSIONS, sample};
pub use stream::{RayClass, RayStream, Wave};

use golden::ray::Mode;
use golden::traverse::Trace;
use scenes::{Mesh, Scene};
use std::fmt;

/// Bounces of a path after its primary ray.
pub const DIFFUSE_BOUNCES: usize = 5;

/// The fraction of light that every surface reflects.
pub const ALBEDO: f32 = 0.7;

/// The greatest width and height of an image.
pub const MAX_SIDE: u32 = 16_384;

/// The greatest number of pixels, about 4 GiB of results.
pub const MAX_PIXELS: u32 = 1 << 26;

/// The most rays that are kept, 8 GiB.
pub const MOST_KEPT_RAYS: u64 = 1 << 28;

/// The greatest number of samples per pixel, the length of the sample sequence.
pub const MAX_SAMPLES: u32 = 1 << 16;

/// The largest magnitude of a coordinate of the light: 2^125, so that its distance from any point of a mesh stays below 2^127.
pub const MAX_LIGHT_COORDINATE: f32 = 32.0 * scenes::MAX_COORDINATE;

/// What is rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Test {
    /// Primary and shadow rays.
    Raycast,
    /// Path tracing.
    Path,
}

impl Test {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Raycast, Self::Path];

    /// The test's name on the command line and in result files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Raycast => "raycast",
            Self::Path => "path",
        }
    }

    /// Bounces after the primary ray.
    #[must_use]
    pub fn bounces(self) -> usize {
        match self {
            Self::Raycast => 0,
            Self::Path => DIFFUSE_BOUNCES,
        }
    }
}

impl fmt::Display for Test {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// How a scene is rendered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RenderOptions {
    /// Which test.
    pub test: Test,
    /// Width of the image in pixels, 1 to [`MAX_SIDE`]; width times height is at most [`MAX_PIXELS`].
    pub width: u32,
    /// Height of the image in pixels, 1 to [`MAX_SIDE`].
    pub height: u32,
    /// Samples per pixel, 1 to [`MAX_SAMPLES`]; the first goes through the pixel's centre.
    pub samples: u32,
    /// Selects the sample sequences.
    pub seed: u64,
    /// How rays are traversed.
    pub mode: Mode,
    /// Radiance of rays that leave the scene, linear RGB.
    pub background: [f32; 3],
    /// Whether work is counted. If it is not, [`Pixel::work`] and the counters of [`Rendering::totals`] stay zero.
    /// Counting goes node by node, which takes about twice as long.
    pub count_work: bool,
    /// Whether the rays are kept in [`Rendering::rays`], 32 bytes each.
    pub keep_rays: bool,
}

impl RenderOptions {
    /// `test` at `width` x `height`, one sample per pixel, a dim sky.
    #[must_use]
    pub fn new(test: Test, width: u32, height: u32) -> Self {
        Self {
            test,
            width,
            height,
            samples: 1,
            seed: 0,
            mode: Mode::default(),
            background: [0.24, 0.3, 0.4],
            count_work: false,
            keep_rays: false,
        }
    }
}

/// Why nothing is rendered.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RenderError {
    /// The image is too small or too large.
    #[error("size {width}x{height}: each side must be 1 to {MAX_SIDE} pixels, and all at most {MAX_PIXELS}")]
    Size {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
    },
    /// The number of samples is out of range.
    #[error("spp {0}: the number of samples per pixel must be 1 to {MAX_SAMPLES}")]
    Samples(u32),
    /// More rays would have to be kept than memory is given to.
    #[error("up to {0} rays cannot be kept, at most {MOST_KEPT_RAYS}: lower the size or spp")]
    TooManyRays(u64),
    /// The light or the background is not finite.
    #[error("{name} {value:?}: all three components must be finite")]
    NotFinite {
        /// Which quantity.
        name: &'static str,
        /// Its value.
        value: [f32; 3],
    },
    /// The light is too far away.
    #[error(
        "light position {0:?}: each component must be at most {MAX_LIGHT_COORDINATE:e} in magnitude; move the light closer"
    )]
    LightTooFar([f32; 3]),
    /// The camera sees nothing.
    #[error(transparent)]
    Camera(#[from] CameraError),
}

/// Renders `scene` with the rays traced through `structure`, on the threads of the current `rayon` pool.
///
/// Any thread calls `rows_done` with the number of rows that have been finished since the last call.
///
/// # Errors
/// See [`RenderError`].
///
/// # Panics
/// If `structure` was not built over `scene.mesh`.
pub fn render<S: Trace>(
    structure: &S,
    scene: &Scene,
    options: &RenderOptions,
    rows_done: impl Fn(u64) + Sync,
) -> Result<Rendering, RenderError> {
    let frame = Frame::new(scene, options)?;
    Ok(integrate::render(structure, &scene.mesh, &frame, options, rows_done))
}

/// Renders the pixels of a picture one by one, so that a caller knows which rays belong to which pixel.
pub struct PixelRenderer<'a> {
    mesh: &'a Mesh,
    options: RenderOptions,
    frame: Frame,
}

impl<'a> PixelRenderer<'a> {
    /// Prepares the pixels of the picture that [`render`] makes.
    ///
    /// # Errors
    /// See [`RenderError`].
    pub fn new(scene: &'a Scene, options: &RenderOptions) -> Result<Self, RenderError> {
        Ok(Self { mesh: &scene.mesh, options: *options, frame: Frame::new(scene, options)? })
    }

    /// What the pixels share.
    #[must_use]
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// The pixel at column and row `place`, with its rays traced through `structure` one after another, and how many these were.
    ///
    /// # Panics
    /// If `structure` was not built over the scene's mesh.
    pub fn pixel<S: Trace>(&self, structure: &S, place: [u32; 2]) -> (Pixel, u64) {
        integrate::pixel(structure, self.mesh, &self.frame, &self.options, place)
    }
}

#[cfg(test)]
mod tests;
