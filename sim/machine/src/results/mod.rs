//! What a simulation comes to: time, energy and area by component, utilisation; see the fields for units and meaning.

mod physics;
mod quantities;

pub use quantities::Quantity;

use super::core::{CacheCounts, Counts, DramCounts, ThreadCycles};
use super::costs::{CacheCosts, LOCAL_STORE, REGISTER_ACCESSES, REGISTERS};
use super::description::{DescriptionError, MachineDescription};
use super::program::{Place, Program};
use costs::Pipeline;
use costs::Unit;
use physics::{area_mm2, dram_energy_mj, utilisation_pct};
use serde::Serialize;
use std::collections::BTreeMap;

/// Instructions executed, by where they executed.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Instructions {
    /// All of them, nops included.
    pub total: u64,
    /// By shared unit.
    pub units: BTreeMap<Unit, u64>,
    /// Operations of the pipeline.
    pub pipeline: u64,
    /// Accesses of local stores.
    pub local_store: u64,
    /// Loads from global memory.
    pub loads: u64,
    /// Stores to global memory.
    pub stores: u64,
    /// Nops in unfilled delay slots.
    pub nops: u64,
}

impl Instructions {
    /// Counts what `program` executed.
    #[must_use]
    pub fn new(program: &Program, counts: &Counts) -> Self {
        let mut sum = Self::default();
        for (id, &times) in counts.runs.iter().enumerate() {
            for &place in program.places_of(id as u32) {
                sum.total += times;
                match place {
                    Place::Unit(unit) => *sum.units.entry(unit).or_default() += times,
                    Place::Pipeline => sum.pipeline += times,
                    Place::LocalStore => sum.local_store += times,
                    Place::Load => sum.loads += times,
                    Place::Store => sum.stores += times,
                    Place::Nop => sum.nops += times,
                    Place::Registers | Place::Counter => {}
                }
            }
        }
        sum
    }
}

/// Energy in millijoules.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct EnergyMj {
    /// Memory, background and refresh included.
    pub dram: f64,
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
    /// Shared units, without those of the pipeline.
    pub units: f64,
    /// The pipelines.
    pub pipeline: f64,
    /// All of it.
    pub total: f64,
}

/// Energy in millijoules, summed as the paper does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct EnergyGroupsMj {
    /// Memory.
    pub dram: f64,
    /// First- and second-level caches and instruction caches.
    pub cache: f64,
    /// Registers, local stores, units and pipelines.
    pub compute: f64,
}

impl EnergyMj {
    /// The three groups.
    #[must_use]
    pub fn groups(&self) -> EnergyGroupsMj {
        EnergyGroupsMj {
            dram: self.dram,
            cache: self.l1 + self.l2 + self.icache,
            compute: self.registers + self.local_store + self.units + self.pipeline,
        }
    }
}

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
    /// Evaluates what a run of `program` counted on `machine`, whose units are those that the pipeline has left.
    ///
    /// # Errors
    /// If the cost of a cache is not known.
    pub fn new(
        machine: &MachineDescription,
        pipeline: Option<&Pipeline>,
        program: &Program,
        counts: &Counts,
    ) -> Result<Self, DescriptionError> {
        let costs = CacheCosts::new(machine)?;
        let instructions = Instructions::new(program, counts);
        let pipeline_cost = pipeline.map(|pipeline| &pipeline.cost);
        let mj = |accesses: u64, energy_nj: f64| accesses as f64 * energy_nj * 1e-6;
        let seconds = f64::from(counts.cycles) / (machine.clock_ghz * 1e9);
        let units = instructions.units.iter();
        let mut energy = EnergyMj {
            dram: dram_energy_mj(machine, &counts.dram, counts.cycles),
            l1: mj(counts.l1.loads, costs.l1.energy_nj),
            l2: mj(counts.l2.loads, costs.l2.energy_nj),
            icache: mj(instructions.total, costs.icache.energy_nj),
            registers: mj(instructions.total * REGISTER_ACCESSES, REGISTERS.energy_nj),
            local_store: mj(instructions.local_store, LOCAL_STORE.energy_nj),
            units: units.map(|(unit, times)| mj(*times, unit.published().energy_pj * 1e-3)).sum(),
            pipeline: pipeline_cost.map_or(0.0, |cost| mj(instructions.pipeline, cost.energy_pj * 1e-3)),
            total: 0.0,
        };
        energy.total = energy.dram
            + energy.l1
            + energy.l2
            + energy.icache
            + energy.registers
            + energy.local_store
            + energy.units
            + energy.pipeline;
        let bytes = |words: u64| words as f64 * 4.0 / seconds / 1e9;
        let line_words = u64::from(machine.l2.line_words());
        let timing = &machine.dram.timing;
        let lines_per_second = machine.clock_ghz * 1e9 * f64::from(machine.dram.clocks_per_cycle)
            / f64::from(timing.burst.max(timing.column_to_column));
        let total = counts.thread_cycles.total() as f64;
        let c = &counts.thread_cycles;
        let percent = |part: u64| 100.0 * part as f64 / total;
        Ok(Self {
            cycles: counts.cycles,
            frame_ms: seconds * 1e3,
            energy_mj: energy,
            energy_groups_mj: energy.groups(),
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
            utilisation_pct: utilisation_pct(machine, &instructions, counts.cycles),
            instructions,
            caches: Caches {
                l1: counts.l1,
                l1_hit_pct: 100.0 * counts.l1.hit_rate(),
                l2: counts.l2,
                l2_hit_pct: 100.0 * counts.l2.hit_rate(),
            },
            dram: DramResults {
                counts: counts.dram,
                row_hit_pct: 100.0 * counts.dram.row_hit_rate(),
                mean_read_latency_cycles: counts.dram.read_latency_clocks as f64
                    / counts.dram.reads.max(1) as f64
                    / f64::from(machine.dram.clocks_per_cycle),
            },
            bandwidth_gb_s: BandwidthGbS {
                l1: bytes(counts.l1.loads),
                l2: bytes(counts.l2.loads * line_words),
                dram: bytes((counts.dram.reads + counts.dram.writes) * line_words),
                dram_peak: lines_per_second * f64::from(machine.dram.channels) * machine.l2.line.0 as f64
                    / 1e9,
            },
            cache_costs: costs,
            pipeline_cost_source: pipeline_cost.map_or("no pipeline".to_owned(), |cost| cost.source.clone()),
        })
    }
}
