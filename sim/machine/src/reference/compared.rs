//! The outcome of a run beside the public simulator's, and what may lie between them.

use super::runs::ReferenceRun;
use crate::results::Results;
use serde::Serialize;

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
    /// The name of what differs from the main configuration.
    pub variant: String,
    /// What differs, but for the number of multiprocessors.
    pub settings: Vec<String>,
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

/// Compares `results` with those of `run`, whose machine has other `settings` than the main configuration. Of `rays` rays, so many
/// have another result; the simulation took `seconds`.
pub(super) fn compare(
    run: &ReferenceRun,
    settings: Vec<String>,
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
    let tolerance_pct = if settings.is_empty() && run.set.starts_with("cornell_") {
        MAIN_CYCLES_PCT
    } else {
        OTHER_CYCLES_PCT
    };
    let cycles = u64::from(results.cycles);
    let instructions = results.instructions.total;
    let mut validated = ValidatedRun {
        set: run.set.clone(),
        variant: run.variant.clone(),
        settings,
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
