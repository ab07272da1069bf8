//! `dualsplit chart fidelity`: the host's time against the error of the simulation.

use crate::artifacts::Artifacts;
use crate::cli::{FidelityArgs, Global};
use crate::console::{Report, fixed, progress, table};
use crate::input::{self, Built, display};
use estimate::Method;
use machine::description::MachineDescription;
use machine::frame::FrameMachine;
use render::RenderOptions;
use serde::Serialize;
use studies::charts::fidelity::{FidelityPoint, charts, points, runs};
use studies::fidelity::{Level, Subject};

#[derive(Serialize)]
struct Document {
    scene: String,
    triangles: usize,
    structure: &'static str,
    test: &'static str,
    machine: String,
    threads: u32,
    width: u32,
    height: u32,
    batches: u32,
    points: Vec<FidelityPoint>,
    artifacts: Vec<String>,
}

pub fn run(args: &FidelityArgs, global: &Global) -> anyhow::Result<Report> {
    let scene = input::scene(&args.scene, global)?;
    let folder = args.out.clone().unwrap_or_else(|| format!("fidelity-{}", scene.name).into());
    let mut artifacts = Artifacts::create(&folder, global.force)?;
    let machine = MachineDescription::load(&args.machine.machine, &args.machine.settings)?;
    let set_up = FrameMachine::new(&machine, args.structure, estimate::by_name(Method::Published))?;
    let (structure, _) = Built::new(&scene, args.quality.quality)?.convert(args.structure.kind())?;
    let [width, height] = args.size;
    let options = RenderOptions { seed: global.seed, ..RenderOptions::new(args.test, width, height) };
    let subject = Subject { machine: &set_up, scene: &scene, structure: &structure, options: &options };
    let bar = progress(runs(&subject, args.rtl, args.repeats), "levels and samples");
    let points = points(&subject, args.rtl, args.repeats, global.seed, || bar.inc(1))?;
    bar.finish_and_clear();
    artifacts.write("fidelity.csv", &csv(&points)?)?;
    for (name, chart) in charts(&scene.name, &points) {
        artifacts.write(&format!("{name}.svg"), chart.svg().as_bytes())?;
    }
    let document = Document {
        scene: scene.name.clone(),
        triangles: scene.mesh.triangles.len(),
        structure: args.structure.name(),
        test: args.test.name(),
        machine: machine.name.clone(),
        threads: subject.threads(),
        width,
        height,
        batches: subject.batches(1.0).count,
        points,
        artifacts: artifacts.finish()?.iter().map(|path| display(path)).collect(),
    };
    let text = text(&document);
    Ok(Report::new(&document, text))
}

/// The points as CSV with a header.
pub fn csv(points: &[FidelityPoint]) -> anyhow::Result<Vec<u8>> {
    let mut csv = csv::Writer::from_writer(vec![]);
    for point in points {
        csv.serialize(point)?;
    }
    Ok(csv.into_inner()?)
}

fn text(d: &Document) -> String {
    let mut text = format!(
        "{}: {} triangles, {}, {}, {}x{} in {} batches on {} with {} threads\n\n",
        d.scene, d.triangles, d.structure, d.test, d.width, d.height, d.batches, d.machine, d.threads
    );
    let header = [
        "level",
        "warming",
        "batches",
        "draws",
        "pixels timed %",
        "host s",
        "frame ms",
        "error %",
        "not corrected",
        "spread",
        "interval",
        "energy mJ",
        "error %",
        "not corrected",
        "spread",
        "interval",
    ];
    text += &table(
        header,
        d.points.iter().map(|p| {
            [
                p.level.to_owned(),
                p.warming.to_owned(),
                p.batches.to_string(),
                p.draws.to_string(),
                fixed(100.0 * p.pixels_timed_share, 1),
                fixed(p.seconds, 3),
                fixed(p.frame_ms, 4),
                fixed(p.time_error_pct, 2),
                fixed(p.plain_time_error_pct, 2),
                fixed(p.time_spread_pct, 2),
                fixed(p.time_interval_pct, 2),
                fixed(p.energy_mj, 4),
                fixed(p.energy_error_pct, 2),
                fixed(p.plain_energy_error_pct, 2),
                fixed(p.energy_spread_pct, 2),
                fixed(p.energy_interval_pct, 2),
            ]
        }),
    );
    text += &format!(
        "\nErrors against the last row; the interval is half of the 95 % interval; not corrected: if everything timed, cold\n\
         start and end included, simply stood for the rest. {} is a lower bound.\n",
        Level::Analytic
    );
    text
}
