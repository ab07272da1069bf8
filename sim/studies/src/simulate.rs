//! Simulations of frames, and of the reference runs, on the many-core machine.

use crate::fidelity::auto::{FEWEST_BATCHES, Step, auto};
use crate::fidelity::{FidelityError, Interval, Level, Sample, Subject};
use crate::input::{Built, SceneSource, check_outputs};
use crate::kernel::Program;
use crate::progress::{Part, Progress};
use anyhow::{bail, ensure};
use base::output::write_file;
use estimate::Method;
use golden::Mode;
use golden::build::Quality;
use machine::core::Counts;
use machine::description::MachineDescription;
use machine::frame::{FrameError, FrameMachine, MachineStructure, Totals, node_bytes};
use machine::reference::{ReferenceRun, ReferenceRuns, TABLE, ValidatedRun};
use machine::results::{Quantity, Results};
use rayon::prelude::*;
use render::{RenderOptions, Test};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// How the level of a simulation is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fidelity {
    /// The level is given.
    Level(Level),
    /// The cheapest level and sample within the tolerance are found.
    Auto,
}

impl Fidelity {
    /// All choices.
    pub const ALL: [Self; 5] = [
        Self::Level(Level::Analytic),
        Self::Level(Level::Queueing),
        Self::Level(Level::Transaction),
        Self::Level(Level::Rtl),
        Self::Auto,
    ];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Level(level) => level.name(),
            Self::Auto => "auto",
        }
    }
}

/// The frame, the machine, and the level of the simulation.
#[derive(Clone, Debug)]
pub struct Options {
    /// The scene, whose seed is also that of the samples.
    pub scene: SceneSource,
    /// The structure, with its program and its pipeline.
    pub structure: MachineStructure,
    /// A program in the place of the structure's: a listing (`.s`) or a program in C (`.c`).
    pub kernel: Option<PathBuf>,
    /// Time such a program although its picture is not golden's.
    pub allow_difference: bool,
    /// The test: primary and shadow rays, or paths.
    pub test: Test,
    /// How plane distances are rounded.
    pub mode: Mode,
    /// How the tree is built.
    pub quality: Quality,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// The machine.
    pub machine: MachineDescription,
    /// How area and energy of the pipeline are found.
    pub pipeline_cost: Method<'static>,
    /// The level of the simulation.
    pub fidelity: Fidelity,
    /// The share of the frame that is timed. The rest is estimated; if absent, the whole frame is timed.
    pub sample: Option<f64>,
    /// For `auto`: how far the 95 % intervals of frame time and energy may reach to either side, as a fraction of the value; if
    /// absent, 0.02.
    pub tolerance: Option<f64>,
    /// The file that the results are written to as CSV.
    pub csv: Option<PathBuf>,
    /// Replaces `csv` if it exists.
    pub force: bool,
}

/// The default tolerance of `auto`.
const TOLERANCE: f64 = 0.02;

/// The results of a frame, with its scene, machine and options.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Simulation {
    pub scene: String,
    pub triangles: usize,
    pub structure: &'static str,
    /// The program in the place of the structure's, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kernel: Option<KernelRow>,
    pub test: &'static str,
    pub mode: &'static str,
    pub machine: String,
    pub width: u32,
    pub height: u32,
    /// Gaps between them included.
    pub node_bytes: u64,
    /// The rays of all pixels recorded. Only an analytic sample leaves pixels unrecorded.
    pub rays: u64,
    pub exact_triangle_tests: u64,
    pub triangle_tests: u64,
    pub fidelity: FidelityRow,
    #[serde(flatten)]
    pub results: Results,
    /// The results again, each with its unit and meaning.
    pub quantities: Vec<Quantity>,
    /// Seconds of the host. Only this and `simulated_rays_per_second` differ from run to run.
    pub seconds: f64,
    pub simulated_rays_per_second: f64,
}

/// A program of the user's, and what of its picture is not golden's.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct KernelRow {
    pub file: String,
    /// Of the listing.
    pub sha256: String,
    /// Of the pixels recorded: all of them, but for an analytic sample.
    pub different_pixels: u64,
    /// Row by row from the top.
    pub first_difference: Option<DifferenceRow>,
}

/// A pixel that is not golden's.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct DifferenceRow {
    /// Column and row.
    pub pixel: [u32; 2],
    /// The first channel that differs.
    pub channel: &'static str,
    /// What the program has written; none if it has written nothing.
    pub found_bits: Option<String>,
    pub golden_bits: String,
    /// The same in words.
    pub text: String,
}

impl KernelRow {
    fn new(program: &Program, totals: &Totals) -> Self {
        let hex = |bits: u32| format!("{bits:08x}");
        let first_difference = totals.first_difference.map(|difference| DifferenceRow {
            pixel: difference.pixel,
            channel: difference.channel_name(),
            found_bits: difference.found.map(hex),
            golden_bits: hex(difference.golden),
            text: difference.to_string(),
        });
        Self {
            file: program.file.clone(),
            sha256: program.sha256.clone(),
            different_pixels: totals.different_pixels,
            first_difference,
        }
    }
}

/// The level and the sample of the simulation, and the intervals that follow from them.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct FidelityRow {
    pub asked: &'static str,
    pub level: &'static str,
    pub batches: u32,
    pub batches_measured: u32,
    pub pixels_timed_share: f64,
    /// The 95 % interval of the frame time; a point if no pixel was left out.
    pub frame_ms: Interval,
    pub energy_mj: Interval,
    /// The resource that sets an analytic bound.
    pub bound_by: Option<String>,
    /// Number of pipeline operations that the netlist executed.
    pub rtl_operations: u64,
    pub rtl_differences: u64,
    /// The estimates that `auto` made, the result last.
    pub steps: Vec<StepRow>,
}

/// One estimate of `auto`.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct StepRow {
    pub level: &'static str,
    pub batches_measured: u32,
    pub pixels_timed_share: f64,
    pub frame_ms: Interval,
    pub energy_mj: Interval,
    pub verdict: String,
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

/// Simulates the frame.
///
/// # Errors
/// The options contradict each other, the scene cannot be loaded, the simulation fails, or the file cannot be written.
pub fn run(args: &Options, progress: &dyn Progress) -> anyhow::Result<Simulation> {
    check_outputs(&[("--csv", args.csv.as_deref())], args.force)?;
    let machine = &args.machine;
    ensure!(
        args.fidelity == Fidelity::Auto || args.tolerance.is_none(),
        "--tolerance needs --fidelity auto; a level with --sample reports its interval"
    );
    ensure!(
        args.fidelity != Fidelity::Auto || args.sample.is_none(),
        "--sample does not go with --fidelity auto, which draws its own samples; name a level"
    );
    ensure!(
        args.fidelity != Fidelity::Level(Level::Queueing) || args.sample.is_none(),
        "--sample does not go with --fidelity queueing, which goes through the whole frame"
    );
    let mut set_up = FrameMachine::new(machine, args.structure, estimate::by_name(args.pipeline_cost))?;
    let kernel = args
        .kernel
        .as_deref()
        .map(|path| Program::load(path, &args.structure.defines(machine.layout), args.allow_difference));
    let kernel = kernel.transpose()?;
    let explained = |error: FidelityError| match &kernel {
        Some(kernel) => kernel.explained(error),
        None => error.into(),
    };
    if let Some(kernel) = &kernel {
        set_up = set_up.with_kernel(kernel.kernel.clone());
    }
    // A machine whose parts have no cost shows before its frame is simulated.
    let program = set_up.program().map_err(|error| explained(FrameError::from(error).into()))?;
    let none = Counts { runs: vec![0; program.code.runs.len()], ..Counts::default() };
    set_up.results(&program, &none)?;
    let scene = args.scene.load(progress)?;
    let built = Built::new(&scene, args.quality, progress)?;
    let (structure, _) = built.convert(args.structure.kind())?;
    let node_bytes = node_bytes(&structure, machine.layout)?;
    let [width, height] = args.size;
    let mut options = RenderOptions::new(args.test, width, height);
    options.mode = args.mode;
    options.seed = args.scene.seed;
    let subject = Subject { machine: &set_up, scene: &scene, structure: &structure, options: &options };
    let part = Part::begin(progress, u64::from(width) * u64::from(height), "simulating");
    let start = Instant::now();
    let (estimate, steps) = match args.fidelity {
        Fidelity::Auto => {
            let batches = subject.batches(Sample::ALL.batch_fills).count;
            if batches < FEWEST_BATCHES {
                progress.note(&format!(
                    "--fidelity auto saves nothing here: {width}x{height} pixels are {batches} batches of one pixel a thread \
                     ({} threads), fewer than {FEWEST_BATCHES}",
                    subject.threads()
                ));
            }
            let tolerance = args.tolerance.unwrap_or(TOLERANCE);
            let steps = auto(&subject, tolerance, args.scene.seed, |pixels| part.advance(pixels.into()));
            let mut steps = steps.map_err(explained)?;
            let rows = steps.iter().map(StepRow::new).collect();
            (steps.pop().expect("there is a first step").estimate, rows)
        }
        Fidelity::Level(level) => {
            let batches = subject.batches(Sample::ALL.batch_fills);
            let sample = Sample::share(args.sample.unwrap_or(1.0), &batches, args.scene.seed);
            let estimate = subject.estimate(level, &sample, |pixels| part.advance(pixels.into()));
            (estimate.map_err(explained)?, vec![])
        }
    };
    let seconds = start.elapsed().as_secs_f64();
    drop(part);
    let totals = estimate.totals;
    if let Some(csv) = &args.csv {
        let text = estimate.results.to_csv(totals.rays);
        write_file(csv, args.force, |file| file.write_all(text.as_bytes()))?;
    }
    Ok(Simulation {
        scene: scene.name.clone(),
        triangles: scene.mesh.triangles.len(),
        structure: args.structure.name(),
        kernel: kernel.as_ref().map(|kernel| KernelRow::new(kernel, &totals)),
        test: args.test.name(),
        mode: args.mode.name(),
        machine: machine.name.clone(),
        width,
        height,
        node_bytes: node_bytes.0,
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
    })
}

/// Our results for the reference runs, beside the published ones.
#[derive(Debug, Serialize)]
pub struct Validation {
    /// All runs whose files the folder has.
    pub runs: Vec<ValidatedRun>,
    /// The others.
    pub absent: Vec<AbsentRun>,
}

/// A run of the table that cannot be made.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct AbsentRun {
    pub set: String,
    pub variant: String,
    pub tms: u32,
    /// What the folder lacks.
    pub reason: String,
}

/// Which rows of the table of reference runs are meant, as `SET`, `SET/VARIANT` or `SET/VARIANT/TMS`.
fn is_meant(row: &str, run: &ReferenceRun) -> bool {
    let tms = run.tms.to_string();
    let mut parts = [run.set.as_str(), &run.variant, &tms].into_iter();
    row.split('/').all(|asked| parts.next() == Some(asked))
}

/// Repeats the reference runs of a folder on our machine, each on one thread: those of `rows` (`SET`, `SET/VARIANT` or
/// `SET/VARIANT/TMS`), or all if it is empty.
///
/// # Errors
/// The folder cannot be read or has nothing to run, there is no such row, or a run fails.
pub fn validate(folder: &Path, rows: &[String], progress: &dyn Progress) -> anyhow::Result<Validation> {
    let reference = ReferenceRuns::read(folder)?;
    for row in rows {
        ensure!(
            reference.runs.iter().any(|run| is_meant(row, run)),
            "--row {row}: {} has no such row; write SET, SET/VARIANT or SET/VARIANT/TMS as its columns have them",
            folder.join(TABLE).display()
        );
    }
    let meant = |run: &&ReferenceRun| rows.is_empty() || rows.iter().any(|row| is_meant(row, run));
    let (mut present, mut absent) = (vec![], vec![]);
    for run in reference.runs.iter().filter(meant) {
        match reference.lacks(run) {
            None => present.push(run),
            Some(reason) => absent.push(AbsentRun {
                set: run.set.clone(),
                variant: run.variant.clone(),
                tms: run.tms,
                reason,
            }),
        }
    }
    if present.is_empty() {
        let reason = absent.first().map_or("its table has no row", |absent| &absent.reason);
        bail!("{}: there is nothing to validate: {reason}", folder.display());
    }
    let part = Part::begin(progress, present.len() as u64, "validating");
    let one = |run: &&ReferenceRun| {
        // Within a pool of one thread, the simulation of a large machine stays on one thread.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
        let validated = pool.install(|| reference.validate(run))?;
        part.advance(1);
        Ok(validated)
    };
    let runs: Vec<ValidatedRun> = present.par_iter().map(one).collect::<anyhow::Result<_>>()?;
    Ok(Validation { runs, absent })
}
