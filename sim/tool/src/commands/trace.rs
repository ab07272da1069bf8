//! `dualsplit trace`: a saved ray stream, traced for closest hits.

use super::work::{ClassRow, class_table};
use crate::cli::{Global, TraceArgs};
use crate::console::{Report, progress};
use crate::input::{self, check_writable, display};
use golden::TraversalRay;
use golden::structure::Structure;
use golden::traverse::{Counters, Trace};
use golden::{Mode, Ray};
use rayon::prelude::*;
use render::ray_file::{FileHit, read_rays, write_hits};
use render::{ClassTotals, RayClass, RayStream};
use serde::Serialize;
use std::time::Instant;

#[derive(Serialize)]
struct Document {
    scene: String,
    triangles: usize,
    structure: &'static str,
    mode: &'static str,
    /// Absent for a structure that was loaded.
    #[serde(skip_serializing_if = "Option::is_none")]
    quality: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tree: Option<String>,
    threads: usize,
    rays: u64,
    hits: u64,
    seconds: f64,
    rays_per_second: f64,
    node_visits: u64,
    plane_tests: u64,
    box_tests: u64,
    triangle_tests: u64,
    bytes: u64,
    stack_depth: u32,
    classes: Vec<ClassRow>,
    out: Option<String>,
}

pub fn run(args: &TraceArgs, global: &Global) -> anyhow::Result<Report> {
    if let Some(out) = &args.out {
        check_writable("--out", out, global.force)?;
    }
    let stream = read_rays(&args.rays)?;
    let scene = input::scene(&args.scene, global)?;
    let (structure, quality) = input::structure(&scene, &args.structure)?;
    let mode = args.mode.mode;

    let start = Instant::now();
    let hits = closest(&structure, &stream.rays, mode);
    let seconds = start.elapsed().as_secs_f64();
    let classes = classes(&structure, &stream, mode);
    if let Some(out) = &args.out {
        write_hits(out, &hits, global.force)?;
    }

    let mut all = Counters::default();
    classes.iter().for_each(|(_, totals)| all.merge(&totals.counters));
    let document = Document {
        scene: scene.name,
        triangles: scene.mesh.triangles.len(),
        structure: structure.kind().name(),
        mode: mode.name(),
        quality,
        tree: args.structure.tree.as_deref().map(display),
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
        out: args.out.as_deref().map(display),
    };
    let text = text(&document);
    Ok(Report::new(&document, text))
}

/// The closest hit of every ray, without observation.
fn closest(structure: &Structure, rays: &[Ray], mode: Mode) -> Vec<Option<FileHit>> {
    let hit =
        |ray: &Ray| structure.closest(ray, mode).map(|hit| FileHit { triangle: hit.triangle, t: hit.t });
    rays.par_iter().with_min_len(1024).map(hit).collect()
}

/// What the rays of each class find and cost.
fn classes(structure: &Structure, stream: &RayStream, mode: Mode) -> Vec<(RayClass, ClassTotals)> {
    let bar = progress(stream.rays.len() as u64, "counting");
    let observe = |ray: &Ray| {
        let mut counters = Counters::default();
        let hit = TraversalRay::new(ray, mode)
            .and_then(|ray| structure.closest_prepared(&ray, &mut counters))
            .is_some();
        ClassTotals { rays: 1, hits: u64::from(hit), counters }
    };
    // Sums and maxima of integers: the order does not matter.
    let merged = |mut a: ClassTotals, b: ClassTotals| {
        a.merge(&b);
        a
    };
    let class = |(class, rays): (RayClass, &[Ray])| {
        let totals = rays.par_iter().map(observe).reduce(ClassTotals::default, merged);
        bar.inc(rays.len() as u64);
        (class, totals)
    };
    let classes = stream.by_wave().map(class).collect();
    bar.finish_and_clear();
    classes
}

fn text(document: &Document) -> String {
    let d = document;
    let mut text = format!(
        "{}: {} rays, {} hits, {} mode, {}, {} thread(s), {:.3} s, {:.3} million rays/s\n\n",
        d.scene,
        d.rays,
        d.hits,
        d.mode,
        d.structure,
        d.threads,
        d.seconds,
        d.rays_per_second / 1e6
    );
    text += &class_table(&d.classes);
    text
}
