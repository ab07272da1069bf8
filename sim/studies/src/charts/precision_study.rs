//! The study of precision: visits, errors, area, energy and time in every format.

use super::cost::format_cost;
use super::csv;
use super::precision::{PrecisionPoint, Sweep, formats, mark_front};
use crate::artifacts::Artifacts;
use crate::input::{Built, SceneSource, display};
use crate::progress::{Part, Progress};
use estimate::Method;
use golden::build::Quality;
use golden::precision::{Precision, Variant};
use golden::structure::{Structure, StructureKind};
use machine::description::MachineDescription;
use machine::frame::{FrameMachine, MachineStructure};
use render::{RenderOptions, Test};
use serde::Serialize;
use std::path::PathBuf;
use view::plot::{Axis, Chart, Point, Series, Style};

/// The scene, its rays, the machine, and the folder of the results.
#[derive(Clone, Debug)]
pub struct Options {
    /// The scene, whose seed is also that of the rays.
    pub scene: SceneSource,
    /// The structure that the rays are traced through.
    pub structure: StructureKind,
    /// The test: primary and shadow rays, or paths.
    pub test: Test,
    /// How the tree is built.
    pub quality: Quality,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// Formats with more than this many times the node visits of binary32 are left out.
    pub most_visits: f64,
    /// The machine that simulates the frame in each format, and its changed keys.
    pub machine: Option<(PathBuf, Vec<String>)>,
    /// The folder that is written; if absent, `precision-` and the scene's name.
    pub out: Option<PathBuf>,
    /// Writes into the folder even if it holds files that the tool did not make.
    pub force: bool,
}

/// All formats over one scene.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct PrecisionChart {
    pub scene: String,
    pub triangles: usize,
    pub structure: &'static str,
    pub test: &'static str,
    pub width: u32,
    pub height: u32,
    pub rays: u64,
    /// Node visits of all rays in binary32 in robust mode.
    pub reference_node_visits: u64,
    pub points: Vec<PrecisionPoint>,
    /// Formats with more than this many times the node visits of the reference are left out.
    pub most_visits: f64,
    /// The formats that were left out, with their variants.
    pub left_out: Vec<String>,
    /// The source of area and energy.
    pub cost_source: Option<String>,
    /// The folder that was written.
    #[serde(skip)]
    pub folder: PathBuf,
    #[serde(skip)]
    pub artifacts: Vec<String>,
}

/// Traces the scene in every format, and writes a table and charts to a folder.
///
/// # Errors
/// The scene or the machine cannot be loaded, a format cannot be traced or measured, or a file cannot be written.
pub fn run(args: &Options, progress: &dyn Progress) -> anyhow::Result<PrecisionChart> {
    let scene = args.scene.load(progress)?;
    let folder = args.out.clone().unwrap_or_else(|| format!("precision-{}", scene.name).into());
    let machine = match &args.machine {
        Some((name, settings)) => {
            let description = MachineDescription::load(name, settings)?;
            Some(FrameMachine::new(
                &description,
                MachineStructure::Dst,
                estimate::by_name(Method::Published),
            )?)
        }
        None => None,
    };
    let mut artifacts = Artifacts::create(&folder, args.force)?;
    let built = Built::new(&scene, args.quality, progress)?;
    let [width, height] = args.size;
    let options = RenderOptions { seed: args.scene.seed, ..RenderOptions::new(args.test, width, height) };
    let sweep = Sweep::new(&scene, &built.tree, &built.triangles, args.structure, options)?;
    let formats = formats();
    let part = Part::begin(progress, formats.len() as u64, "formats");
    let (mut points, mut left_out, mut cost_source) = (vec![], vec![], None);
    let most_visits = (args.most_visits * sweep.reference_counters.node_visits as f64) as u64;
    // Area and energy are those of the dual-split pipeline, whichever structure is traversed.
    let (dst, _) = built.convert(StructureKind::Dst)?;
    let rays = sweep.closest_rays(Variant::Naive.mode());
    for format in formats {
        part.next(&format.to_string());
        let cost = match &dst {
            Structure::Dst(dst) => format_cost(format, dst, &rays)?,
            _ => None,
        };
        for variant in Variant::ALL {
            let precision = Precision::new(format, variant);
            let Some(point) = sweep.point(precision, most_visits)? else {
                left_out.push(precision.to_string());
                continue;
            };
            let frame_ms = match &machine {
                Some(machine) => sweep.frame_ms(machine, precision)?,
                None => None,
            };
            points.push(PrecisionPoint {
                area_um2: cost.as_ref().map(|cost| cost.area_um2),
                energy_pj_per_ray: cost.as_ref().map(|cost| cost.energy_pj * point.node_visits_per_ray),
                frame_ms,
                ..point
            });
        }
        cost_source = cost_source.or(cost.map(|cost| cost.source));
        part.advance(1);
    }
    drop(part);
    mark_front(&mut points);

    artifacts.write("precision.csv", &csv(&points)?)?;
    for (name, chart) in charts(&scene.name, &sweep, &points) {
        artifacts.write(&format!("{name}.svg"), chart.svg().as_bytes())?;
    }
    Ok(PrecisionChart {
        scene: scene.name.clone(),
        triangles: scene.mesh.triangles.len(),
        structure: args.structure.name(),
        test: args.test.name(),
        width,
        height,
        rays: sweep.rays(),
        reference_node_visits: sweep.reference_counters.node_visits,
        points,
        most_visits: args.most_visits,
        left_out,
        cost_source,
        folder,
        artifacts: artifacts.finish()?.iter().map(|path| display(path)).collect(),
    })
}

/// Charts of visits, errors, time and energy, and of the Pareto front.
fn charts(scene: &str, sweep: &Sweep<'_>, points: &[PrecisionPoint]) -> Vec<(&'static str, Chart)> {
    // Formats with 8 exponent bits are joined by lines; the others stand alone.
    let series = |x: fn(&PrecisionPoint) -> f64, y: &dyn Fn(&PrecisionPoint) -> f64| -> Vec<Series> {
        let of = |variant: Variant, wide: bool| {
            let mine = |p: &&PrecisionPoint| p.variant == variant.name() && (p.exponent_bits == 8) == wide;
            let point = |p: &PrecisionPoint| Point {
                x: x(p),
                y: y(p),
                label: (!wide).then(|| p.format.clone()),
                marked: p.pareto,
                ..Point::default()
            };
            Series {
                name: format!("{}, {}", variant.name(), if wide { "8 exponent bits" } else { "fewer" }),
                style: if wide { Style::Line } else { Style::Points },
                points: points.iter().filter(mine).map(point).collect(),
            }
        };
        [true, false].into_iter().flat_map(|wide| Variant::ALL.map(|v| of(v, wide))).collect()
    };
    let significand = |p: &PrecisionPoint| f64::from(p.significand_bits);
    let rays = sweep.rays().max(1) as f64;
    let rate = move |p: &PrecisionPoint| (p.false_misses + p.wrong_nearest + p.false_hits) as f64 / rays;
    let chart =
        |title: &str, x: Axis, y: Axis, series| Chart { title: format!("{scene}: {title}"), x, y, series };
    let bits = || Axis::linear("significand (bits)");
    vec![
        (
            "visits",
            chart(
                "node visits, Pareto front ringed",
                bits(),
                Axis::log("node visits per ray"),
                series(significand, &|p| p.node_visits_per_ray),
            ),
        ),
        (
            "wrong-rays",
            chart(
                "rays that lose their hit or hit something else (none: not drawn)",
                bits(),
                Axis::log("fraction of rays"),
                series(significand, &rate),
            ),
        ),
        (
            "image-error",
            chart(
                "image error (none: not drawn)",
                bits(),
                Axis::log("RMSE of linear radiance"),
                series(significand, &|p| p.rmse),
            ),
        ),
        (
            "frame-time",
            chart(
                "simulated frame time",
                bits(),
                Axis::log("ms"),
                series(significand, &|p| p.frame_ms.unwrap_or(f64::NAN)),
            ),
        ),
        (
            "energy",
            chart(
                "energy of node steps against image error (none: at the left)",
                Axis::log("RMSE of linear radiance, at least 1e-9"),
                Axis::log("pJ per ray"),
                series(|p| p.rmse.max(1e-9), &|p| p.energy_pj_per_ray.unwrap_or(f64::NAN)),
            ),
        ),
        (
            "front",
            chart(
                "width against visits, Pareto front ringed",
                Axis::linear("bits per number"),
                Axis::log("node visits per ray"),
                series(|p| f64::from(p.exponent_bits + p.significand_bits), &|p| p.node_visits_per_ray),
            ),
        ),
    ]
}
