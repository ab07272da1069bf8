//! Traces a saved stream of rays for closest hits.

use crate::input::{SceneSource, StructureSource, check_outputs, display};
use crate::progress::{Part, Progress};
use crate::work::ClassRow;
use anyhow::ensure;
use golden::structure::Structure;
use golden::traverse::{Counters, Trace};
use golden::{Mode, Ray, TraversalRay};
use rayon::prelude::*;
use render::ray_file::{FileHit, read_rays, write_hits};
use render::{ClassTotals, RayClass, RayStream};
use serde::Serialize;
use std::path::PathBuf;
use std::time::Instant;

/// The rays, the scene, and the file for the hits.
#[derive(Clone, Debug)]
pub struct Options {
    /// The scene.
    pub scene: SceneSource,
    /// The structure that rays are traced through.
    pub structure: StructureSource,
    /// The file of the rays, in the format DSTRAYS1.
    pub rays: PathBuf,
    /// How plane distances are rounded.
    pub mode: Mode,
    /// The file that the hits are written to, in the format DSTHITS1.
    pub out: Option<PathBuf>,
    /// Replaces `out` if it exists.
    pub force: bool,
}

/// The results of tracing the rays.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Traced {
    pub scene: String,
    pub triangles: usize,
    pub structure: &'static str,
    pub mode: &'static str,
    /// How the structure was built; absent for a structure from a file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quality: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tree: Option<String>,
    pub threads: usize,
    pub rays: u64,
    pub hits: u64,
    pub seconds: f64,
    pub rays_per_second: f64,
    pub node_visits: u64,
    pub plane_tests: u64,
    pub box_tests: u64,
    pub triangle_tests: u64,
    pub bytes: u64,
    pub stack_depth: u32,
    pub classes: Vec<ClassRow>,
}

/// Traces all rays for their hits, which is timed, and then once more to count the work.
///
/// # Errors
/// The rays, the scene or the structure cannot be loaded, or the hits cannot be written.
pub fn run(options: &Options, progress: &dyn Progress) -> anyhow::Result<Traced> {
    check_outputs(&[("--out", options.out.as_deref())], options.force)?;
    let stream = read_rays(&options.rays)?;
    ensure!(!stream.rays.is_empty(), "{}: the file holds no ray to trace", options.rays.display());
    let scene = options.scene.load(progress)?;
    let structure = options.structure.load(&scene, progress)?;
    let mode = options.mode;

    let start = Instant::now();
    let hits = closest(&structure, &stream.rays, mode);
    let seconds = start.elapsed().as_secs_f64();
    let classes = classes(&structure, &stream, mode, progress);
    if let Some(out) = &options.out {
        write_hits(out, &hits, options.force)?;
    }

    let mut all = Counters::default();
    classes.iter().for_each(|(_, totals)| all.merge(&totals.counters));
    Ok(Traced {
        scene: scene.name,
        triangles: scene.mesh.triangles.len(),
        structure: structure.kind().name(),
        mode: mode.name(),
        quality: options.structure.quality_name(),
        tree: options.structure.file.as_deref().map(display),
        threads: rayon::current_num_threads(),
        rays: hits.len() as u64,
        hits: hits.iter().flatten().count() as u64,
        seconds,
        rays_per_second: if seconds > 0.0 { hits.len() as f64 / seconds } else { 0.0 },
        node_visits: all.node_visits,
        plane_tests: all.plane_tests,
        box_tests: all.box_tests,
        triangle_tests: all.triangle_tests,
        bytes: all.bytes,
        stack_depth: all.stack_depth,
        classes: classes.iter().map(|(class, totals)| ClassRow::new(*class, totals, true)).collect(),
    })
}

/// The closest hit of every ray, without observation.
fn closest(structure: &Structure, rays: &[Ray], mode: Mode) -> Vec<Option<FileHit>> {
    let hit =
        |ray: &Ray| structure.closest(ray, mode).map(|hit| FileHit { triangle: hit.triangle, t: hit.t });
    rays.par_iter().with_min_len(1024).map(hit).collect()
}

/// The hits and the work of the rays of each class.
fn classes(
    structure: &Structure,
    stream: &RayStream,
    mode: Mode,
    progress: &dyn Progress,
) -> Vec<(RayClass, ClassTotals)> {
    let part = Part::begin(progress, stream.rays.len() as u64, "counting");
    let observe = |ray: &Ray| {
        let mut counters = Counters::default();
        let hit = TraversalRay::new(ray, mode)
            .and_then(|ray| structure.closest_prepared(&ray, &mut counters))
            .is_some();
        ClassTotals { rays: 1, hits: u64::from(hit), counters }
    };
    // Sums and maxima of integers do not depend on the order.
    let merged = |mut a: ClassTotals, b: ClassTotals| {
        a.merge(&b);
        a
    };
    let class = |(class, rays): (RayClass, &[Ray])| {
        let totals = rays.par_iter().map(observe).reduce(ClassTotals::default, merged);
        part.advance(rays.len() as u64);
        (class, totals)
    };
    stream.by_wave().map(class).collect()
}
