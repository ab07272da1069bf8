//! `dualsplit trace`: a saved ray stream, traced for closest hits.

use crate::cli::{Global, TraceArgs, quality_name};
use crate::console::{Report, fixed, progress, table};
use crate::input::{self, Built, check_writable};
use golden::TraversalRay;
use golden::ray_file::{FileHit, read_rays, write_hits};
use golden::render::RayStream;
use golden::structure::Structure;
use golden::traverse::{Counters, Trace};
use golden::{Mode, Ray};
use rayon::prelude::*;
use serde::Serialize;
use std::time::Instant;

#[derive(Serialize)]
struct Document {
    scene: String,
    triangles: usize,
    structure: &'static str,
    mode: &'static str,
    quality: &'static str,
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
    classes: Vec<Class>,
    out: Option<std::path::PathBuf>,
}

#[derive(Serialize)]
struct Class {
    class: String,
    rays: u64,
    hits: u64,
    #[serde(flatten)]
    counters: CounterRow,
}

/// [`Counters`] with the keys of result files.
#[derive(Clone, Copy, Serialize)]
pub struct CounterRow {
    pub node_visits: u64,
    pub plane_tests: u64,
    pub box_tests: u64,
    pub triangle_tests: u64,
    pub bytes: u64,
    pub stack_depth: u32,
}

impl From<Counters> for CounterRow {
    fn from(c: Counters) -> Self {
        Self {
            node_visits: c.node_visits,
            plane_tests: c.plane_tests,
            box_tests: c.box_tests,
            triangle_tests: c.triangle_tests,
            bytes: c.bytes,
            stack_depth: c.stack_depth,
        }
    }
}

pub fn run(args: &TraceArgs, global: &Global) -> anyhow::Result<Report> {
    if let Some(out) = &args.out {
        check_writable("--out", out, global.force)?;
    }
    let stream = read_rays(&args.rays)?;
    let scene = input::scene(&args.scene, global)?;
    let built = Built::new(&scene, args.quality.quality)?;
    let (structure, _) = built.convert(args.structure)?;
    let mode = args.mode.mode;

    let start = Instant::now();
    let hits = closest(&structure, &stream.rays, mode);
    let seconds = start.elapsed().as_secs_f64();
    let classes = classes(&structure, &stream, mode);
    if let Some(out) = &args.out {
        write_hits(out, &hits, global.force)?;
    }

    let mut all = Counters::default();
    classes.iter().for_each(|(_, _, _, counters)| all.merge(counters));
    let document = Document {
        scene: scene.name,
        triangles: scene.mesh.triangles.len(),
        structure: args.structure.name(),
        mode: mode.name(),
        quality: quality_name(args.quality.quality),
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
        classes: classes
            .into_iter()
            .map(|(class, rays, hits, counters)| Class { class, rays, hits, counters: counters.into() })
            .collect(),
        out: args.out.clone(),
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

/// Rays, hits and work of each class: name, rays, hits, counters.
fn classes(structure: &Structure, stream: &RayStream, mode: Mode) -> Vec<(String, u64, u64, Counters)> {
    let bar = progress(stream.rays.len() as u64, "counting");
    let class = |(class, rays): (golden::render::RayClass, &[Ray])| {
        let count = |ray: &Ray| {
            let mut counters = Counters::default();
            let hit = TraversalRay::new(ray, mode)
                .and_then(|ray| structure.closest_prepared(&ray, &mut counters))
                .is_some();
            (u64::from(hit), counters)
        };
        // Sums and maxima of integers: the order does not matter.
        let (hits, counters) = rays.par_iter().map(count).reduce(Default::default, |mut a, b| {
            a.0 += b.0;
            a.1.merge(&b.1);
            a
        });
        bar.inc(rays.len() as u64);
        (class.to_string(), rays.len() as u64, hits, counters)
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
    let header = [
        "class",
        "rays",
        "hits",
        "node visits/ray",
        "planes/ray",
        "boxes/ray",
        "triangles/ray",
        "stack depth",
    ];
    let rows = d.classes.iter().map(|c| {
        let per_ray = |x: u64| fixed(x as f64 / c.rays.max(1) as f64, 2);
        [
            c.class.clone(),
            c.rays.to_string(),
            c.hits.to_string(),
            per_ray(c.counters.node_visits),
            per_ray(c.counters.plane_tests),
            per_ray(c.counters.box_tests),
            per_ray(c.counters.triangle_tests),
            c.counters.stack_depth.to_string(),
        ]
    });
    text += &table(header, rows);
    text
}
