//! `dualsplit simulate`: frames and reference runs on the many-core machine.

use crate::cli::{Global, SceneArgs, SimulateArgs};
use crate::console::{Report, fixed, progress, table};
use crate::input::{self, Built, check_writable};
use golden::render::RenderOptions;
use rayon::prelude::*;
use scenes::output::write_file;
use serde::Serialize;
use sim::machine::description::MachineDescription;
use sim::machine::frame::{FrameMachine, frame};
use sim::machine::reference::{ReferenceRuns, ValidatedRun};
use sim::machine::results::{Quantity, Results};
use std::path::Path;
use std::time::Instant;

pub fn run(args: &SimulateArgs, global: &Global) -> anyhow::Result<Report> {
    if let Some(folder) = &args.validate {
        return validate(folder);
    }
    let machine = MachineDescription::load(&args.machine.machine, &args.machine.settings)?;
    match &args.scene {
        Some(scene) if !args.dump_config => simulate(args, global, scene, &machine),
        _ => Ok(Report::new(&machine, machine.to_toml())),
    }
}

/// A frame's results with what it is a frame of.
#[derive(Serialize)]
struct Document {
    scene: String,
    triangles: usize,
    structure: &'static str,
    test: &'static str,
    mode: &'static str,
    machine: String,
    width: u32,
    height: u32,
    node_bytes: usize,
    rays: u64,
    exact_triangle_tests: u64,
    triangle_tests: u64,
    #[serde(flatten)]
    results: Results,
    /// The results again, each with its unit and meaning.
    quantities: Vec<Quantity>,
    /// Of the host; the only numbers here that differ from run to run.
    seconds: f64,
    simulated_rays_per_second: f64,
}

fn simulate(
    args: &SimulateArgs,
    global: &Global,
    scene: &str,
    machine: &MachineDescription,
) -> anyhow::Result<Report> {
    if let Some(csv) = &args.csv {
        check_writable("--csv", csv, global.force)?;
    }
    let set_up = FrameMachine::new(machine, args.structure, args.machine.pipeline_cost.method())?;
    let scene = input::scene(&SceneArgs { scene: scene.to_owned(), detail: args.detail }, global)?;
    let built = Built::new(&scene, args.quality.quality)?;
    let (structure, _) = built.convert(args.structure.kind())?;
    let [width, height] = args.size;
    let mut options = RenderOptions::new(args.test, width, height);
    options.mode = args.mode.mode;
    options.seed = global.seed;
    let bar = progress(u64::from(width) * u64::from(height), "simulating");
    let start = Instant::now();
    let frame = frame(&set_up, &scene, &structure, &options, |pixels| bar.inc(pixels.into()))?;
    let seconds = start.elapsed().as_secs_f64();
    bar.finish_and_clear();
    let results = Results::new(&set_up.description, set_up.pipeline.as_ref(), &frame.program, &frame.counts)?;
    if let Some(csv) = &args.csv {
        let text = results.to_csv(frame.rays);
        write_file(csv, global.force, |file| file.write_all(text.as_bytes()))?;
    }
    let document = Document {
        scene: scene.name.clone(),
        triangles: scene.mesh.triangles.len(),
        structure: args.structure.name(),
        test: args.test.name(),
        mode: args.mode.mode.name(),
        machine: machine.name.clone(),
        width,
        height,
        node_bytes: structure.node_bytes(),
        rays: frame.rays,
        exact_triangle_tests: frame.exact_tests,
        triangle_tests: frame.triangle_tests,
        quantities: results.quantities(frame.rays),
        results,
        seconds,
        simulated_rays_per_second: frame.rays as f64 / seconds,
    };
    let text = text(&document);
    Ok(Report::new(&document, text))
}

fn text(d: &Document) -> String {
    let mut text = format!(
        "{}, {} triangles, {}, {}, {}x{} on {}: {} rays, {} cycles, {:.3} ms, {:.3} mJ\n\n",
        d.scene,
        d.triangles,
        d.structure,
        d.test,
        d.width,
        d.height,
        d.machine,
        d.rays,
        d.results.cycles,
        d.results.frame_ms,
        d.results.energy_mj.total
    );
    let rows = d.quantities.iter();
    text += &table(
        ["quantity", "value", "unit", "meaning"],
        rows.map(|q| [q.name.clone(), fixed(q.value, 4), q.unit.to_owned(), q.meaning.to_owned()]),
    );
    text += &format!(
        "\nsimulated {:.0} rays/s; pipeline energy: {}\n",
        d.simulated_rays_per_second, d.results.pipeline_cost_source
    );
    text
}

#[derive(Serialize)]
struct Validation {
    runs: Vec<ValidatedRun>,
}

/// Makes the reference runs, each on one thread.
fn validate(folder: &Path) -> anyhow::Result<Report> {
    let reference = ReferenceRuns::read(folder)?;
    let bar = progress(reference.runs.len() as u64, "validating");
    let one = |run| {
        // Within a pool of one thread, large machines do not share out their multiprocessors.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
        let validated = pool.install(|| reference.validate(run))?;
        bar.inc(1);
        Ok(validated)
    };
    let runs: Vec<ValidatedRun> = reference.runs.par_iter().map(one).collect::<anyhow::Result<_>>()?;
    bar.finish_and_clear();
    let header = [
        "set",
        "variant",
        "TMs",
        "cycles",
        "reference",
        "error %",
        "instructions %",
        "L1 hit % (ref)",
        "L2 hit % (ref)",
        "units uJ (ref)",
        "rays/s",
        "speed ratio",
        "within",
    ];
    let rows = runs.iter().map(|run| {
        let pair = |c: sim::machine::reference::Compared| format!("{:.2} ({:.2})", c.ours, c.reference);
        [
            run.set.clone(),
            run.variant.clone(),
            run.tms.to_string(),
            run.cycles.to_string(),
            run.reference_cycles.to_string(),
            fixed(run.error_pct, 2),
            fixed(run.instructions_error_pct, 2),
            pair(run.l1_hit_pct),
            pair(run.l2_hit_pct),
            pair(run.units_uj),
            fixed(run.rays_per_second, 0),
            fixed(run.speed_ratio, 0),
            if run.within { "yes" } else { "NO" }.to_owned(),
        ]
    });
    let text = table(header, rows);
    let difference = runs.iter().any(|run| !run.within);
    let mut report = Report::new(&Validation { runs }, text);
    report.difference = difference;
    Ok(report)
}
