//! The traversal of one pixel's primary ray through one or more structures, step by step.

use crate::input::{Built, SceneSource, View};
use crate::progress::Progress;
use crate::walk::{Step, walk};
use crate::work::CounterRow;
use anyhow::ensure;
use golden::build::Quality;
use golden::structure::{Structure, StructureKind};
use golden::traverse::{Counters, Trace};
use golden::{Hit, Mode, Ray, TraversalRay};
use render::CameraRays;
use serde::Serialize;

/// The scene, the pixel, and the structures that its ray is traced through.
#[derive(Clone, Debug)]
pub struct Options {
    /// The scene.
    pub scene: SceneSource,
    /// Camera and light.
    pub view: View,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// Column and row of the pixel, counted from 0 at the upper left corner.
    pub pixel: [u32; 2],
    /// How plane distances are rounded.
    pub mode: Mode,
    /// How the trees are built.
    pub quality: Quality,
    /// The structures that the ray is traced through, in this order; at least one.
    pub structures: Vec<StructureKind>,
}

/// A ray and its way through the structures.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Explanation {
    pub scene: String,
    pub triangles: usize,
    pub mode: &'static str,
    pub pixel: [u32; 2],
    pub size: [u32; 2],
    pub ray: RayRow,
    pub hit: Option<HitRow>,
    pub structures: Vec<Section>,
}

/// The ray.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct RayRow {
    pub origin: [f32; 3],
    pub direction: [f32; 3],
    pub t_min: f32,
    /// The ray's end; absent if the ray is unbounded.
    pub t_max: Option<f32>,
}

/// The ray's nearest hit.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct HitRow {
    pub t: f32,
    pub u: f32,
    pub v: f32,
    pub triangle: u32,
}

/// The ray's way through one structure.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Section {
    pub name: &'static str,
    #[serde(flatten)]
    pub counters: CounterRow,
    pub steps: Vec<Step>,
}

impl Section {
    fn new(structure: &Structure, ray: &TraversalRay) -> (Self, Option<Hit>) {
        let mut counters = Counters::default();
        structure.closest_prepared(ray, &mut counters);
        let walk = walk(structure, ray);
        (Self { name: structure.kind().name(), counters: counters.into(), steps: walk.steps }, walk.hit)
    }
}

/// Follows the primary ray of a pixel.
///
/// # Errors
/// The pixel is outside the image, the scene cannot be loaded, or the ray is outside the supported range.
pub fn run(args: &Options, progress: &dyn Progress) -> anyhow::Result<Explanation> {
    let [x, y] = args.pixel;
    let [width, height] = args.size;
    ensure!(
        x < width && y < height,
        "--pixel {x},{y} is outside the image of {width}x{height} pixels; count from 0, or change --size"
    );
    let mut scene = args.scene.load(progress)?;
    args.view.apply(&mut scene)?;
    let ray = CameraRays::new(&scene.camera, width, height)?.ray(x as f32 + 0.5, y as f32 + 0.5);
    let built = Built::new(&scene, args.quality, progress)?;
    let mode = args.mode;
    let Some(prepared) = TraversalRay::new(&ray, mode) else {
        anyhow::bail!(
            "the ray of pixel {x},{y} is outside the supported range: {ray:?}; move --eye or --target"
        );
    };
    let (mut structures, mut hits) = (vec![], vec![]);
    for &kind in &args.structures {
        let (section, hit) = Section::new(&built.convert(kind)?.0, &prepared);
        structures.push(section);
        hits.push(hit);
    }
    let hit = hits.first().copied().flatten();
    assert!(hits.iter().all(|other| *other == hit), "all structures give the same hit");
    let Ray { origin, direction, t_min, t_max } = ray;
    Ok(Explanation {
        scene: scene.name,
        triangles: scene.mesh.triangles.len(),
        mode: mode.name(),
        pixel: [x, y],
        size: [width, height],
        ray: RayRow { origin, direction, t_min, t_max: t_max.is_finite().then_some(t_max) },
        hit: hit.map(|Hit { t, u, v, triangle }| HitRow { t, u, v, triangle }),
        structures,
    })
}
