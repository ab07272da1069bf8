//! The table of the reference runs, and the same runs by this machine.

use super::scene::{RaySet, ReferenceError, ReferenceScene};
use super::{ANY, CLOSEST, ReferenceWork};
use crate::core::{SimulationError, simulate};
use crate::description::{DescriptionError, MachineDescription};
use crate::program::{ListingError, Program};
use crate::results::Results;
use cpu_time::ThreadTime;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The preset that the reference runs were made with.
pub const PRESET: &str = "simtrax-reference";

/// One run of the table `reference_runs.csv`. Columns that are not compared are not read.
#[derive(Clone, Debug, Deserialize)]
pub struct ReferenceRun {
    /// Set of rays.
    pub set: String,
    /// What differs from the main configuration; empty for that.
    pub variant: String,
    /// `closest` or `anyhit`.
    pub kernel: String,
    /// Multiprocessors.
    #[serde(rename = "TMs")]
    pub tms: u32,
    cycles: u64,
    instr: u64,
    #[serde(rename = "L1_acc")]
    l1_accesses: u64,
    #[serde(rename = "L1_hits")]
    l1_hits: u64,
    #[serde(rename = "L2_acc")]
    l2_accesses: u64,
    #[serde(rename = "L2_hits")]
    l2_hits: u64,
    dram_reads: u64,
    #[serde(rename = "E_fu")]
    units_j: f64,
    #[serde(rename = "E_l1")]
    l1_j: f64,
    #[serde(rename = "E_l2")]
    l2_j: f64,
    #[serde(rename = "E_ic")]
    icache_j: f64,
    #[serde(rename = "E_ls")]
    local_store_j: f64,
    #[serde(rename = "E_rf")]
    registers_j: f64,
    #[serde(rename = "E_dram")]
    dram_j: f64,
    wall_s: f64,
}

/// One line of `counts.csv`: where a set lies in memory.
#[derive(Clone, Debug, Deserialize)]
struct Addresses {
    set: String,
    ray_addr: u32,
    out_addr: u32,
}

/// Why the reference runs cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum ValidationError {
    /// A file is missing or is not what it should be.
    #[error(transparent)]
    File(#[from] ReferenceError),
    /// A table cannot be read.
    #[error("{}: {error}", .file.display())]
    Table {
        /// The file.
        file: PathBuf,
        /// Line and reason.
        error: csv::Error,
    },
    /// A run that this machine cannot be set up for.
    #[error("{}: {message}", .file.display())]
    Run {
        /// The file.
        file: PathBuf,
        /// Which run, and what is wrong.
        message: String,
    },
    /// A variant that cannot be built.
    #[error(transparent)]
    Description(#[from] DescriptionError),
    /// A mistake in the program.
    #[error(transparent)]
    Listing(#[from] ListingError),
    /// A run that does not end.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
}

/// Our quantity beside the reference's.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Compared {
    /// By this machine.
    pub ours: f64,
    /// By the public simulator.
    pub reference: f64,
    /// Whether they agree within the tolerance of their kind.
    pub within: bool,
}

/// The outcome of one run.
#[derive(Clone, Debug, Serialize)]
pub struct ValidatedRun {
    /// Set of rays.
    pub set: String,
    /// What differs from the main configuration.
    pub variant: String,
    /// Multiprocessors.
    pub tms: u32,
    /// Cycles by this machine.
    pub cycles: u64,
    /// Cycles by the public simulator.
    pub reference_cycles: u64,
    /// Difference of cycles in percent of the reference's.
    pub error_pct: f64,
    /// Percent that the cycles may differ by.
    pub tolerance_pct: f64,
    /// Instructions by this machine, nops included.
    pub instructions: u64,
    /// Instructions by the public simulator.
    pub reference_instructions: u64,
    /// Difference of instructions in percent of the reference's.
    pub instructions_error_pct: f64,
    /// Rays whose result is not the reference's, bit for bit.
    pub result_mismatches: u64,
    /// Percent of first-level accesses that hit, stores counted as misses.
    pub l1_hit_pct: Compared,
    /// Percent of second-level accesses that hit, stores counted as misses.
    pub l2_hit_pct: Compared,
    /// Lines read from memory; for information.
    pub dram_reads: Compared,
    /// Energy of the shared units and local stores in microjoules.
    pub units_uj: Compared,
    /// Energy of the first-level caches in microjoules.
    pub l1_uj: Compared,
    /// Energy of the second-level caches in microjoules.
    pub l2_uj: Compared,
    /// Energy of the instruction caches in microjoules.
    pub icache_uj: Compared,
    /// Energy of the local stores in microjoules.
    pub local_store_uj: Compared,
    /// Energy of the register files in microjoules.
    pub registers_uj: Compared,
    /// Energy of the memory in microjoules; for information.
    pub dram_uj: Compared,
    /// Whether everything is within its tolerance.
    pub within: bool,
    /// Seconds of one processor that the simulation took.
    pub seconds: f64,
    /// Simulated rays per second.
    pub rays_per_second: f64,
    /// That over the public simulator's, by the wall time that its table gives.
    pub speed_ratio: f64,
}

/// Tolerances: percent of cycles on the main rows of the Cornell box and elsewhere, percent of instructions, points of
/// hit rates, percent of energies.
const MAIN_CYCLES_PCT: f64 = 5.0;
const OTHER_CYCLES_PCT: f64 = 10.0;
const INSTRUCTIONS_PCT: f64 = 3.0;
const HIT_POINTS: f64 = 2.0;
const ENERGY_PCT: f64 = 5.0;
/// Printed energies are rounded to this.
const ENERGY_ROUNDING_UJ: f64 = 0.5;

fn table<T: for<'de> Deserialize<'de>>(file: &Path) -> Result<Vec<T>, ValidationError> {
    let failed = |error| ValidationError::Table { file: file.to_owned(), error };
    let mut reader = csv::Reader::from_path(file).map_err(failed)?;
    reader.deserialize().collect::<Result<_, _>>().map_err(failed)
}

/// The runs of `folder`, with the addresses of their sets.
pub struct ReferenceRuns {
    folder: PathBuf,
    /// All runs, in the order of the table.
    pub runs: Vec<ReferenceRun>,
    addresses: Vec<Addresses>,
}

impl ReferenceRuns {
    /// Reads `reference_runs.csv` and `counts.csv` in `folder`.
    ///
    /// # Errors
    /// If a table is missing or malformed.
    pub fn read(folder: &Path) -> Result<Self, ValidationError> {
        let runs: Vec<ReferenceRun> = table(&folder.join("reference_runs.csv"))?;
        if runs.is_empty() {
            let file = folder.join("reference_runs.csv");
            return Err(ValidationError::Run { file, message: "the table has no run to repeat".to_owned() });
        }
        let addresses = table(&folder.join("counts.csv"))?;
        Ok(Self { folder: folder.to_owned(), runs, addresses })
    }

    fn fail(&self, run: &ReferenceRun, message: &str) -> ValidationError {
        ValidationError::Run {
            file: self.folder.join("reference_runs.csv"),
            message: format!("run {} {} with {} TMs: {message}", run.set, run.variant, run.tms),
        }
    }

    /// The machine of a run.
    fn machine(&self, run: &ReferenceRun) -> Result<MachineDescription, ValidationError> {
        let mut settings = vec![format!("chip.tms_per_partition={}", run.tms)];
        let number = |text: &str| text.parse::<u32>().ok();
        let variant = run.variant.as_str();
        if let Some(threads) = variant.strip_suffix("TP").and_then(number) {
            settings.push(format!("tm.threads={threads}"));
        } else if let Some((caches, banks)) = variant.strip_prefix("ic").and_then(|v| v.split_once('x')) {
            settings.push(format!("icache.caches={caches}"));
            settings.push(format!("icache.banks={banks}"));
        } else if let Some(count) = variant.strip_prefix("fp").and_then(number) {
            settings.push(format!("units.fp_add.count={count}"));
            settings.push(format!("units.fp_mul.count={count}"));
        } else if variant == "l1off" {
            settings.push("l1.enabled=false".to_owned());
        } else if !variant.is_empty() {
            return Err(self.fail(run, "unknown variant; known are NTP, icCxB, fpN and l1off"));
        }
        Ok(MachineDescription::load(PRESET, &settings)?)
    }

    /// Makes a run and compares it. `seconds` are right only where a single host thread runs it.
    ///
    /// # Errors
    /// If its files are missing or its machine cannot be built.
    pub fn validate(&self, run: &ReferenceRun) -> Result<ValidatedRun, ValidationError> {
        let machine = self.machine(run)?;
        let any = match run.kernel.as_str() {
            "closest" => false,
            "anyhit" => true,
            _ => return Err(self.fail(run, "the kernel is neither `closest` nor `anyhit`")),
        };
        let (scene_name, _) =
            run.set.rsplit_once('_').ok_or_else(|| self.fail(run, "the set is not called SCENE_RAYS"))?;
        let place = self.addresses.iter().find(|place| place.set == run.set);
        let place = place.ok_or_else(|| self.fail(run, "counts.csv does not have the set"))?;
        let scene = ReferenceScene::read(&self.folder, scene_name)?;
        let rays = RaySet::read(&self.folder, &run.set, place.ray_addr, place.out_addr)?;
        let program = Program::new("reference", if any { ANY } else { CLOSEST }, &machine, 1)?;
        let program = Arc::new(program);
        // Processor time: other work on the host does not count.
        let start = ThreadTime::now();
        let work = ReferenceWork::new(Arc::clone(&program), &scene, &rays).map_err(SimulationError::from)?;
        let counts = simulate(&machine, &program, &work, |_| {})?;
        let seconds = start.elapsed().as_secs_f64();
        let result_mismatches = work.mismatches();
        let results = Results::new(&machine, None, &program, &counts)?;
        Ok(compare(run, &results, result_mismatches, rays.rays.len() as u64, seconds))
    }
}

fn compare(
    run: &ReferenceRun,
    results: &Results,
    result_mismatches: u64,
    rays: u64,
    seconds: f64,
) -> ValidatedRun {
    let error = |ours: u64, reference: u64| 100.0 * (ours as f64 / reference as f64 - 1.0);
    let rate = |hits: u64, accesses: u64| 100.0 * hits as f64 / accesses.max(1) as f64;
    let points = |ours: f64, reference: f64| {
        let within = (ours - reference).abs() <= HIT_POINTS;
        Compared { ours, reference, within }
    };
    let energy = |ours_mj: f64, reference_j: f64| {
        let (ours, reference) = (ours_mj * 1e3, reference_j * 1e6);
        let within = (ours - reference).abs() <= reference * ENERGY_PCT / 100.0 + ENERGY_ROUNDING_UJ;
        Compared { ours, reference, within }
    };
    let informative = |ours: f64, reference: f64| Compared { ours, reference, within: true };
    let e = &results.energy_mj;
    let (l1, l2) = (&results.caches.l1, &results.caches.l2);
    let tolerance_pct = if run.variant.is_empty() && run.set.starts_with("cornell_") {
        MAIN_CYCLES_PCT
    } else {
        OTHER_CYCLES_PCT
    };
    let cycles = u64::from(results.cycles);
    let instructions = results.instructions.total;
    let mut validated = ValidatedRun {
        set: run.set.clone(),
        variant: run.variant.clone(),
        tms: run.tms,
        cycles,
        reference_cycles: run.cycles,
        error_pct: error(cycles, run.cycles),
        tolerance_pct,
        instructions,
        reference_instructions: run.instr,
        instructions_error_pct: error(instructions, run.instr),
        result_mismatches,
        l1_hit_pct: points(rate(l1.hits, l1.loads + l1.stores), rate(run.l1_hits, run.l1_accesses)),
        l2_hit_pct: points(rate(l2.hits, l2.loads + l2.stores), rate(run.l2_hits, run.l2_accesses)),
        dram_reads: informative(results.dram.counts.reads as f64, run.dram_reads as f64),
        // The public simulator counts the local store among the units, and again by itself.
        units_uj: energy(e.units + e.local_store, run.units_j),
        l1_uj: energy(e.l1, run.l1_j),
        l2_uj: energy(e.l2, run.l2_j),
        icache_uj: energy(e.icache, run.icache_j),
        local_store_uj: energy(e.local_store, run.local_store_j),
        registers_uj: energy(e.registers, run.registers_j),
        dram_uj: informative(e.dram * 1e3, run.dram_j * 1e6),
        within: false,
        seconds,
        rays_per_second: rays as f64 / seconds,
        speed_ratio: run.wall_s / seconds,
    };
    let v = &validated;
    validated.within = v.error_pct.abs() <= tolerance_pct
        && v.instructions_error_pct.abs() <= INSTRUCTIONS_PCT
        && v.result_mismatches == 0
        && [
            v.l1_hit_pct,
            v.l2_hit_pct,
            v.units_uj,
            v.l1_uj,
            v.l2_uj,
            v.icache_uj,
            v.local_store_uj,
            v.registers_uj,
        ]
        .iter()
        .all(|compared| compared.within);
    validated
}
