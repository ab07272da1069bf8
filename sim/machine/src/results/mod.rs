//! What a simulation comes to: time, energy and area by component, utilisation; see the fields for units and meaning.

mod energy;
mod physics;
mod quantities;
mod tally;

pub use energy::{EnergyGroupsMj, EnergyMj, EnergyStorageMj};
pub use quantities::Quantity;
pub use tally::{Instructions, Tally};

use super::core::{CacheCounts, DramCounts, ThreadCycles};
use super::costs::CacheCosts;
use super::description::{DescriptionError, MachineDescription};
use costs::Pipeline;
use physics::{area_mm2, utilisation_pct};
use serde::Serialize;
use std::collections::BTreeMap;

/// Area in mm2 at 65 nm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct AreaMm2 {
    /// First-level caches.
    pub l1: f64,
    /// Second-level caches.
    pub l2: f64,
    /// Instruction caches.
    pub icache: f64,
    /// Register files.
    pub registers: f64,
    /// Local stores.
    pub local_store: f64,
    /// Shared units, those of the pipelines included.
    pub units: f64,
    /// What the pipelines have beyond shared units.
    pub pipeline: f64,
    /// All of it.
    pub total: f64,
}

/// Memory traffic in GB/s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct BandwidthGbS {
    /// First-level caches to registers.
    pub l1: f64,
    /// Second-level to first-level caches.
    pub l2: f64,
    /// Memory, both directions.
    pub dram: f64,
    /// The most that the memory could do.
    pub dram_peak: f64,
}

/// Everything about a run.
#[derive(Clone, Debug, Serialize)]
pub struct Results {
    /// Cycles until the last thread finished.
    pub cycles: u32,
    /// Milliseconds at the machine's clock.
    pub frame_ms: f64,
    /// Energy by component.
    pub energy_mj: EnergyMj,
    /// Energy as the paper sums it.
    pub energy_groups_mj: EnergyGroupsMj,
    /// Energy as the talk words it.
    pub energy_storage_mj: EnergyStorageMj,
    /// Area by component.
    pub area_mm2: AreaMm2,
    /// Percent of thread-cycles in each class; they sum to 100.
    pub thread_cycles: BTreeMap<&'static str, f64>,
    /// Number of thread-cycles in each class.
    pub thread_cycle_counts: ThreadCycles,
    /// Instructions by where they executed.
    pub instructions: Instructions,
    /// Percent of its operations that each unit could have done.
    pub utilisation_pct: BTreeMap<String, f64>,
    /// Caches.
    pub caches: Caches,
    /// Memory.
    pub dram: DramResults,
    /// Traffic.
    pub bandwidth_gb_s: BandwidthGbS,
    /// What each cache costs, and where the number is from.
    pub cache_costs: CacheCosts,
    /// Where the energy of a pipeline operation is from.
    pub pipeline_cost_source: String,
}

/// Accesses of the caches.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Caches {
    /// All first-level caches.
    pub l1: CacheCounts,
    /// Percent of loads that found their line there.
    pub l1_hit_pct: f64,
    /// All second-level caches.
    pub l2: CacheCounts,
    /// Percent of loads that found their line there.
    pub l2_hit_pct: f64,
}

/// What the memory did.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct DramResults {
    /// Counts.
    #[serde(flatten)]
    pub counts: DramCounts,
    /// Percent of accesses that found their row open.
    pub row_hit_pct: f64,
    /// Cycles of the machine between a read's arrival and its data, on average.
    pub mean_read_latency_cycles: f64,
}

impl Results {
    /// Evaluates what a run on `machine` counted, whose units are those that the pipeline has left.
    ///
    /// # Errors
    /// If the cost of a cache is not known.
    pub fn new(
        machine: &MachineDescription,
        pipeline: Option<&Pipeline>,
        tally: &Tally,
    ) -> Result<Self, DescriptionError> {
        let costs = CacheCosts::new(machine)?;
        let pipeline_cost = pipeline.map(|pipeline| &pipeline.cost);
        let energy = EnergyMj::new(machine, pipeline_cost, &costs, tally);
        let seconds = f64::from(tally.cycles) / (machine.clock_ghz * 1e9);
        let bytes = |words: u64| words as f64 * 4.0 / seconds / 1e9;
        let line_words = u64::from(machine.l2.line_words());
        let timing = &machine.dram.timing;
        let lines_per_second = machine.clock_ghz * 1e9 * f64::from(machine.dram.clocks_per_cycle)
            / f64::from(timing.burst.max(timing.column_to_column));
        let total = tally.thread_cycles.total() as f64;
        let c = &tally.thread_cycles;
        let percent = |part: u64| 100.0 * part as f64 / total;
        Ok(Self {
            cycles: tally.cycles,
            frame_ms: seconds * 1e3,
            energy_mj: energy,
            energy_groups_mj: energy.groups(),
            energy_storage_mj: energy.storage(),
            area_mm2: area_mm2(machine, pipeline, &costs),
            thread_cycles: BTreeMap::from([
                ("issue", percent(c.issue)),
                ("data", percent(c.data)),
                ("units", percent(c.units)),
                ("memory", percent(c.memory)),
                ("fetch", percent(c.fetch)),
                ("nop", percent(c.nop)),
                ("halted", percent(c.halted)),
            ]),
            thread_cycle_counts: *c,
            utilisation_pct: utilisation_pct(machine, &tally.instructions, tally.cycles),
            instructions: tally.instructions.clone(),
            caches: Caches {
                l1: tally.l1,
                l1_hit_pct: 100.0 * tally.l1.hit_rate(),
                l2: tally.l2,
                l2_hit_pct: 100.0 * tally.l2.hit_rate(),
            },
            dram: DramResults {
                counts: tally.dram,
                row_hit_pct: 100.0 * tally.dram.row_hit_rate(),
                mean_read_latency_cycles: tally.dram.read_latency_clocks as f64
                    / tally.dram.reads.max(1) as f64
                    / f64::from(machine.dram.clocks_per_cycle),
            },
            bandwidth_gb_s: BandwidthGbS {
                l1: bytes(tally.l1.loads),
                l2: bytes(tally.l2.loads * line_words),
                dram: bytes((tally.dram.reads + tally.dram.writes) * line_words),
                dram_peak: lines_per_second * f64::from(machine.dram.channels) * machine.l2.line.0 as f64
                    / 1e9,
            },
            cache_costs: costs,
            pipeline_cost_source: pipeline_cost.map_or("no pipeline".to_owned(), |cost| cost.source.clone()),
        })
    }
}
