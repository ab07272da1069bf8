//! The traversal of one pixel's primary ray, step by step, in the dual-split tree and in the BVH2.

use crate::input::{Built, SceneSource, View};
use crate::progress::Progress;
use crate::walk::{Step, Walk, walk_bvh2, walk_dst};
use crate::work::CounterRow;
use anyhow::ensure;
use golden::build::Quality;
use golden::bvh::Bvh2;
use golden::dst::Dst;
use golden::traverse::{Counters, Trace};
use golden::{Hit, Mode, Ray, TraversalRay};
use render::CameraRays;
use serde::Serialize;
use std::sync::Arc;

/// Which ray of which scene.
#[derive(Clone, Debug)]
pub struct Options {
    /// Of what.
    pub scene: SceneSource,
    /// From where.
    pub view: View,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// Column and row of the pixel, counted from the upper left corner, from 0.
    pub pixel: [u32; 2],
    /// How plane distances are rounded.
    pub mode: Mode,
    /// Of the trees.
    pub quality: Quality,
}

/// A ray and its way through both structures.
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
    /// Absent where the ray has no end.
    pub t_max: Option<f32>,
}

/// What it hits.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct HitRow {
    pub t: f32,
    pub u: f32,
    pub v: f32,
    pub triangle: u32,
}

/// Its way through one structure.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Section {
    pub name: &'static str,
    #[serde(flatten)]
    pub counters: CounterRow,
    pub steps: Vec<Step>,
}

impl Section {
    fn new(
        name: &'static str,
        structure: &impl Trace,
        walk: Walk,
        ray: &TraversalRay,
    ) -> (Self, Option<Hit>) {
        let mut counters = Counters::default();
        let hit = structure.closest_prepared(ray, &mut counters);
        assert_eq!(hit, walk.hit, "the walk and the kernel take the same steps");
        (Self { name, counters: counters.into(), steps: walk.steps }, hit)
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
    let ray = CameraRays::new(&scene.camera, width, height)?.ray(f64::from(x) + 0.5, f64::from(y) + 0.5);
    let built = Built::new(&scene, args.quality, progress)?;
    let dst = Dst::convert(&built.tree, Arc::clone(&built.triangles))?;
    let bvh = Bvh2::encode(&built.tree, Arc::clone(&built.triangles));
    let mode = args.mode;
    let Some(prepared) = TraversalRay::new(&ray, mode) else {
        anyhow::bail!(
            "the ray of pixel {x},{y} is outside the supported range: {ray:?}; move --eye or --target"
        );
    };
    let (dst, hit) = Section::new("dst", &dst, walk_dst(&dst, &prepared), &prepared);
    let (bvh, _) = Section::new("bvh2", &bvh, walk_bvh2(&bvh, &prepared), &prepared);
    let Ray { origin, direction, t_min, t_max } = ray;
    Ok(Explanation {
        scene: scene.name,
        triangles: scene.mesh.triangles.len(),
        mode: mode.name(),
        pixel: [x, y],
        size: [width, height],
        ray: RayRow { origin, direction, t_min, t_max: t_max.is_finite().then_some(t_max) },
        hit: hit.map(|Hit { t, u, v, triangle }| HitRow { t, u, v, triangle }),
        structures: vec![dst, bvh],
    })
}
