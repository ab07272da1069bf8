//! `dualsplit explain`: the traversal of one pixel's primary ray, step by step.

use super::work::CounterRow;
use crate::cli::{ExplainArgs, Global};
use crate::console::Report;
use crate::input::{self, Built};
use anyhow::ensure;
use golden::structure::Structure;
use golden::traverse::{Counters, Trace};
use golden::{Hit, Ray, TraversalRay};
use render::CameraRays;
use serde::Serialize;
use std::fmt::Write;
use studies::walk::{Step, walk};

#[derive(Serialize)]
struct Document {
    scene: String,
    triangles: usize,
    mode: &'static str,
    pixel: [u32; 2],
    size: [u32; 2],
    ray: RayRow,
    hit: Option<HitRow>,
    structures: Vec<Section>,
}

#[derive(Serialize)]
struct RayRow {
    origin: [f32; 3],
    direction: [f32; 3],
    t_min: f32,
    /// Absent where the ray has no end.
    t_max: Option<f32>,
}

#[derive(Serialize)]
struct HitRow {
    t: f32,
    u: f32,
    v: f32,
    triangle: u32,
}

#[derive(Serialize)]
struct Section {
    name: &'static str,
    #[serde(flatten)]
    counters: CounterRow,
    steps: Vec<Step>,
}

impl Section {
    fn new(structure: &Structure, ray: &TraversalRay) -> (Self, Option<Hit>) {
        let mut counters = Counters::default();
        structure.closest_prepared(ray, &mut counters);
        let walk = walk(structure, ray);
        (Self { name: structure.kind().name(), counters: counters.into(), steps: walk.steps }, walk.hit)
    }
}

pub fn run(args: &ExplainArgs, global: &Global) -> anyhow::Result<Report> {
    let [x, y] = args.pixel;
    let [width, height] = args.view.size;
    ensure!(
        x < width && y < height,
        "--pixel {x},{y} is outside the image of {width}x{height} pixels; count from 0, or change --size"
    );
    let mut scene = input::scene(&args.scene, global)?;
    input::set_view(&mut scene, &args.view)?;
    let ray = CameraRays::new(&scene.camera, width, height)?.ray(f64::from(x) + 0.5, f64::from(y) + 0.5);
    let built = Built::new(&scene, args.quality.quality)?;
    let mode = args.mode.mode;
    let Some(prepared) = TraversalRay::new(&ray, mode) else {
        anyhow::bail!(
            "the ray of pixel {x},{y} is outside the supported range: {ray:?}; move --eye or --target"
        );
    };
    let (mut structures, mut hits) = (vec![], vec![]);
    for &kind in &args.structure {
        let (section, hit) = Section::new(&built.convert(kind)?.0, &prepared);
        structures.push(section);
        hits.push(hit);
    }
    let hit = hits[0];
    assert!(hits.iter().all(|other| *other == hit), "all structures give the same hit");
    let Ray { origin, direction, t_min, t_max } = ray;
    let document = Document {
        scene: scene.name,
        triangles: scene.mesh.triangles.len(),
        mode: mode.name(),
        pixel: [x, y],
        size: [width, height],
        ray: RayRow { origin, direction, t_min, t_max: t_max.is_finite().then_some(t_max) },
        hit: hit.map(|Hit { t, u, v, triangle }| HitRow { t, u, v, triangle }),
        structures,
    };
    let text = text(&document);
    Ok(Report::new(&document, text))
}

fn text(document: &Document) -> String {
    let d = document;
    let mut text = format!(
        "{}: {} triangles, pixel {},{} of {}x{}, {} mode\norigin {:?}, direction {:?}\n",
        d.scene,
        d.triangles,
        d.pixel[0],
        d.pixel[1],
        d.size[0],
        d.size[1],
        d.mode,
        d.ray.origin,
        d.ray.direction
    );
    match &d.hit {
        Some(hit) => {
            _ = writeln!(
                text,
                "hit: triangle {} at t = {}, u = {}, v = {}",
                hit.triangle, hit.t, hit.u, hit.v
            )
        }
        None => text += "no hit\n",
    }
    for section in &d.structures {
        let c = section.counters;
        let _ = writeln!(
            text,
            "\n{}: {} node visits, {} plane tests, {} triangle tests, stack depth {}",
            section.name, c.node_visits, c.plane_tests, c.triangle_tests, c.stack_depth
        );
        for (number, step) in section.steps.iter().enumerate() {
            let _ = writeln!(text, "{:>5}  {}", number + 1, line(step));
        }
    }
    text
}

fn line(step: &Step) -> String {
    let outcome = |hit: &bool| if *hit { "hit" } else { "miss" };
    match step {
        Step::Root { hit, t_entry, t_exit } => format!("root box   [{t_entry}, {t_exit}] {}", outcome(hit)),
        Step::Node { offset, header, planes, t_min, t_max, outcome } => {
            format!("node @{offset} [{t_min}, {t_max}] {header}, planes {planes:?} -> {outcome}")
        }
        Step::Box { node, leaf, hit, t_entry, t_exit } => {
            let kind = if *leaf { "leaf" } else { "inner" };
            format!("box {node} ({kind}) [{t_entry}, {t_exit}] {}", outcome(hit))
        }
        Step::Push { offset, t_min, depth } => format!("  push @{offset} from {t_min}, depth {depth}"),
        Step::Pop { offset, discarded } => {
            format!("  pop @{offset}{}", if *discarded { ", discarded: beyond the hit" } else { "" })
        }
        Step::Triangle { slot, triangle, t, best } => match t {
            Some(t) => {
                format!("  triangle {triangle} (slot {slot}) hit at {t}{}", if *best { ", best" } else { "" })
            }
            None => format!("  triangle {triangle} (slot {slot}) missed"),
        },
    }
}
