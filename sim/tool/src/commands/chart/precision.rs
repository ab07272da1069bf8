//! `dualsplit chart precision`: visits, errors, area, energy and time in every format.

use crate::artifacts::Artifacts;
use crate::cli::{Global, PrecisionArgs};
use crate::console::{Report, fixed, progress, table};
use crate::input::{self, Built, display};
use estimate::Method;
use golden::precision::{Precision, Variant};
use golden::structure::{Structure, StructureKind};
use machine::description::MachineDescription;
use machine::frame::{FrameMachine, MachineStructure};
use render::RenderOptions;
use serde::Serialize;
use studies::charts::cost::format_cost;
use studies::charts::precision::{PrecisionPoint, Sweep, formats, mark_front};
use view::plot::{Axis, Chart, Point, Series, Style};

#[derive(Serialize)]
struct Document {
    scene: String,
    triangles: usize,
    structure: &'static str,
    test: &'static str,
    width: u32,
    height: u32,
    rays: u64,
    /// Of binary32 in robust mode.
    reference_node_visits: u64,
    points: Vec<PrecisionPoint>,
    /// Formats that visit more than this many times as many nodes are left out.
    most_visits: f64,
    /// Those formats with their variant.
    left_out: Vec<String>,
    /// Where area and energy come from.
    cost_source: Option<String>,
    artifacts: Vec<String>,
}

pub fn run(args: &PrecisionArgs, global: &Global) -> anyhow::Result<Report> {
    let scene = input::scene(&args.scene, global)?;
    let folder = args.out.clone().unwrap_or_else(|| format!("precision-{}", scene.name).into());
    let mut artifacts = Artifacts::create(&folder, global.force)?;
    let built = Built::new(&scene, args.quality.quality)?;
    let [width, height] = args.size;
    let options = RenderOptions { seed: global.seed, ..RenderOptions::new(args.test, width, height) };
    let sweep = Sweep::new(&scene, &built.tree, &built.triangles, args.structure, options)?;
    let formats = formats();
    let bar = progress(formats.len() as u64, "formats");
    let (mut points, mut left_out, mut cost_source) = (vec![], vec![], None);
    let most_visits = (args.most_visits * sweep.reference_counters.node_visits as f64) as u64;
    // The pipeline is that of dual-split trees, whatever is traversed.
    let (dst, _) = built.convert(StructureKind::Dst)?;
    let rays = sweep.closest_rays(Variant::Naive.mode());
    let machine = match args.simulate {
        true => {
            let description = MachineDescription::load(&args.machine.machine, &args.machine.settings)?;
            Some(FrameMachine::new(
                &description,
                MachineStructure::Dst,
                estimate::by_name(Method::Published),
            )?)
        }
        false => None,
    };
    for format in formats {
        bar.set_message(format.to_string());
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
        bar.inc(1);
    }
    bar.finish_and_clear();
    mark_front(&mut points);

    artifacts.write("precision.csv", &csv(&points)?)?;
    for (name, chart) in charts(&scene.name, &sweep, &points) {
        artifacts.write(&format!("{name}.svg"), chart.svg().as_bytes())?;
    }
    let document = Document {
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
        artifacts: artifacts.finish()?.iter().map(|path| display(path)).collect(),
    };
    let text = text(&document);
    Ok(Report::new(&document, text))
}

fn csv(points: &[PrecisionPoint]) -> anyhow::Result<Vec<u8>> {
    let mut csv = csv::Writer::from_writer(vec![]);
    for point in points {
        csv.serialize(point)?;
    }
    Ok(csv.into_inner()?)
}

/// Visits and error over the significand, and the front.
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

fn text(document: &Document) -> String {
    let d = document;
    let mut text = format!(
        "{}: {} triangles, {}, {} {}x{}, {} rays; binary32 robust visits {} nodes per ray\n\n",
        d.scene,
        d.triangles,
        d.structure,
        d.test,
        d.width,
        d.height,
        d.rays,
        fixed(d.reference_node_visits as f64 / d.rays.max(1) as f64, 2)
    );
    let header = [
        "format",
        "variant",
        "bits",
        "node visits/ray",
        "triangles/ray",
        "false misses",
        "false hits",
        "wrong nearest",
        "other distance",
        "RMSE",
        "differing pixels",
        "frame ms",
        "area um2",
        "pJ/ray",
        "front",
    ];
    text += &table(
        header,
        d.points.iter().map(|p| {
            [
                p.format.clone(),
                p.variant.to_owned(),
                (p.exponent_bits + p.significand_bits).to_string(),
                fixed(p.node_visits_per_ray, 2),
                fixed(p.triangle_tests_per_ray, 2),
                p.false_misses.to_string(),
                p.false_hits.to_string(),
                p.wrong_nearest.to_string(),
                p.other_distance.to_string(),
                format!("{:.3e}", p.rmse),
                p.differing_pixels.to_string(),
                p.frame_ms.map(|ms| fixed(ms, 4)).unwrap_or_default(),
                p.area_um2.map(|area| fixed(area, 0)).unwrap_or_default(),
                p.energy_pj_per_ray.map(|energy| fixed(energy, 1)).unwrap_or_default(),
                if p.pareto { "*" } else { "" }.to_owned(),
            ]
        }),
    );
    text += "\nFront: no other has at most as many bits, visits, false misses and RMSE, and less of one.\n";
    if !d.left_out.is_empty() {
        text += &format!(
            "Left out, as they visit more than {} times the nodes of binary32: {}.\n",
            d.most_visits,
            d.left_out.join(", ")
        );
    }
    if let Some(source) = &d.cost_source {
        text += &format!("Area, and energy of a ray's node steps, of the dual-split pipeline: {source}.\n");
    }
    text
}
