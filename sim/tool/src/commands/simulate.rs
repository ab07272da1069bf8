//! `dualsplit simulate`: frames and reference runs on the many-core machine.

use crate::cli::{Fidelity, Global, SceneArgs, SimulateArgs};
use crate::console::{Report, fixed, progress, table};
use crate::input::{self, Built, check_writable};
use anyhow::ensure;
use base::output::write_file;
use machine::description::MachineDescription;
use machine::frame::FrameMachine;
use machine::reference::{ReferenceRuns, ValidatedRun};
use machine::results::{Quantity, Results};
use rayon::prelude::*;
use render::RenderOptions;
use serde::Serialize;
use std::path::Path;
use std::time::Instant;
use studies::fidelity::auto::{Step, auto};
use studies::fidelity::{Interval, Sample, Subject};

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
    /// Of the pixels recorded: all of them, but for an analytic sample.
    rays: u64,
    exact_triangle_tests: u64,
    triangle_tests: u64,
    fidelity: FidelityRow,
    #[serde(flatten)]
    results: Results,
    /// The results again, each with its unit and meaning.
    quantities: Vec<Quantity>,
    /// Of the host; the only numbers here that differ from run to run.
    seconds: f64,
    simulated_rays_per_second: f64,
}

/// How closely the frame was simulated, and what that leaves open.
#[derive(Serialize)]
struct FidelityRow {
    asked: &'static str,
    level: &'static str,
    batches: u32,
    batches_measured: u32,
    pixels_timed_share: f64,
    /// Of 95 % confidence; of a point if nothing was left out.
    frame_ms: Interval,
    energy_mj: Interval,
    /// The resource that an analytic bound is due to.
    bound_by: Option<String>,
    /// Pipeline operations that the netlist executed, and those whose result differed.
    rtl_operations: u64,
    rtl_differences: u64,
    /// What `auto` did, the result last.
    steps: Vec<StepRow>,
}

#[derive(Serialize)]
struct StepRow {
    level: &'static str,
    batches_measured: u32,
    pixels_timed_share: f64,
    frame_ms: Interval,
    energy_mj: Interval,
    verdict: String,
}

impl StepRow {
    fn new(step: &Step) -> Self {
        let e = &step.estimate;
        Self {
            level: e.level.name(),
            batches_measured: e.measured,
            pixels_timed_share: e.timed_share,
            frame_ms: e.frame_ms,
            energy_mj: e.energy_mj,
            verdict: step.verdict.clone(),
        }
    }
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
    ensure!(
        args.fidelity == Fidelity::Auto || args.tolerance.is_none(),
        "--tolerance: goes with --fidelity auto; a level with --sample says what its interval is"
    );
    ensure!(
        args.fidelity != Fidelity::Auto || args.sample.is_none(),
        "--sample: --fidelity auto draws its own samples; name a level"
    );
    let set_up =
        FrameMachine::new(machine, args.structure, estimate::by_name(args.machine.pipeline_cost.method()))?;
    let scene = input::scene(&SceneArgs { scene: scene.to_owned(), detail: args.detail }, global)?;
    let built = Built::new(&scene, args.quality.quality)?;
    let (structure, _) = built.convert(args.structure.kind())?;
    let [width, height] = args.size;
    let mut options = RenderOptions::new(args.test, width, height);
    options.mode = args.mode.mode;
    options.seed = global.seed;
    let subject = Subject { machine: &set_up, scene: &scene, structure: &structure, options: &options };
    let bar = progress(u64::from(width) * u64::from(height), "simulating");
    let start = Instant::now();
    let (estimate, steps) = match args.fidelity {
        Fidelity::Auto => {
            let tolerance = args.tolerance.unwrap_or(TOLERANCE);
            let mut steps = auto(&subject, tolerance, global.seed, |pixels| bar.inc(pixels.into()))?;
            let rows = steps.iter().map(StepRow::new).collect();
            (steps.pop().expect("there is a first step").estimate, rows)
        }
        Fidelity::Level(level) => {
            let batches = subject.batches(Sample::ALL.batch_fills);
            let sample = Sample::share(args.sample.unwrap_or(1.0), &batches, global.seed);
            (subject.estimate(level, &sample, |pixels| bar.inc(pixels.into()))?, vec![])
        }
    };
    let seconds = start.elapsed().as_secs_f64();
    bar.finish_and_clear();
    let totals = estimate.totals;
    if let Some(csv) = &args.csv {
        let text = estimate.results.to_csv(totals.rays);
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
        rays: totals.rays,
        exact_triangle_tests: totals.exact_tests,
        triangle_tests: totals.triangle_tests,
        fidelity: FidelityRow {
            asked: args.fidelity.name(),
            level: estimate.level.name(),
            batches: estimate.batches,
            batches_measured: estimate.measured,
            pixels_timed_share: estimate.timed_share,
            frame_ms: estimate.frame_ms,
            energy_mj: estimate.energy_mj,
            bound_by: estimate.bound_by.clone(),
            rtl_operations: totals.rtl_operations,
            rtl_differences: totals.rtl_differences,
            steps,
        },
        quantities: estimate.results.quantities(totals.rays),
        results: estimate.results,
        seconds,
        simulated_rays_per_second: totals.rays as f64 * estimate.timed_share / seconds,
    };
    let text = text(&document);
    let mut report = Report::new(&document, text);
    report.difference = totals.rtl_differences > 0;
    Ok(report)
}

/// What `auto` is within by default.
const TOLERANCE: f64 = 0.02;

/// What was simulated, in words.
fn fidelity_text(f: &FidelityRow) -> String {
    let percent = |x: f64| fixed(100.0 * x, 2);
    let mut text = String::new();
    if !f.steps.is_empty() {
        let header =
            ["level", "batches", "pixels timed %", "frame ms", "+- %", "energy mJ", "+- %", "verdict"];
        let rows = f.steps.iter().map(|step| {
            [
                step.level.to_owned(),
                format!("{} of {}", step.batches_measured, f.batches),
                fixed(100.0 * step.pixels_timed_share, 1),
                fixed(step.frame_ms.value, 4),
                percent(step.frame_ms.relative()),
                fixed(step.energy_mj.value, 4),
                percent(step.energy_mj.relative()),
                step.verdict.clone(),
            ]
        });
        text += &table(header, rows);
        text += "\n";
    }
    let range = |i: &Interval| format!("{:.4} .. {:.4}", i.low, i.high);
    match (f.level, &f.bound_by) {
        (_, Some(resource)) => text += &format!("analytic: a lower bound by {resource}, not an estimate\n"),
        _ if f.pixels_timed_share < 1.0 => {
            text += &format!(
                "{}: {} of {} batches measured, {} % of the pixels timed; 95 % intervals: {} ms, {} mJ\n",
                f.level,
                f.batches_measured,
                f.batches,
                fixed(100.0 * f.pixels_timed_share, 1),
                range(&f.frame_ms),
                range(&f.energy_mj)
            );
        }
        _ => {}
    }
    if f.rtl_operations > 0 {
        text += &format!(
            "rtl: {} pipeline operations executed by the netlist, {} differ from golden\n",
            f.rtl_operations, f.rtl_differences
        );
    }
    if text.is_empty() { text } else { text + "\n" }
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
    text += &fidelity_text(&d.fidelity);
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
        let pair = |c: machine::reference::Compared| format!("{:.2} ({:.2})", c.ours, c.reference);
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
