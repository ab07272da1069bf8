//! What a simulation comes to: time, energy and area by component, utilisation; see the fields for units and meaning.

use super::core::{CacheCounts, Counts, DramCounts, ThreadCycles};
use super::costs::{CacheCosts, LOCAL_STORE, REGISTER_ACCESSES, REGISTERS};
use super::description::{DescriptionError, MachineDescription};
use super::pipelines::Pipeline;
use super::program::{PIPELINE, Program, UNLIMITED};
use crate::unit_costs::Unit;
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
        use super::program::{COUNTER, Kind};
        let mut sum = Self::default();
        for (id, &times) in counts.runs.iter().enumerate() {
            for op in program.ops_of(id as u32) {
                sum.total += times;
                match op.kind {
                    Kind::Nop => sum.nops += times,
                    Kind::Load => sum.loads += times,
                    Kind::Store => sum.stores += times,
                    Kind::Plain | Kind::Counter => match op.pool {
                        PIPELINE => sum.pipeline += times,
                        UNLIMITED if op.local_store => sum.local_store += times,
                        UNLIMITED | COUNTER => {}
                        pool => *sum.units.entry(Unit::ALL[usize::from(pool)]).or_default() += times,
                    },
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
            pipeline_cost_source: pipeline_cost.map_or("no pipeline".to_owned(), |cost| cost.source.clone()),
        })
    }
}

/// A quantity with its unit and meaning.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Quantity {
    /// Name, as the path of its key in the JSON document.
    pub name: String,
    /// Value.
    pub value: f64,
    /// Unit; empty for counts.
    pub unit: &'static str,
    /// Meaning.
    pub meaning: &'static str,
}

impl Results {
    /// Every quantity; `rays` were traced.
    #[must_use]
    pub fn quantities(&self, rays: u64) -> Vec<Quantity> {
        let mut all = vec![];
        let mut add = |name: &str, value: f64, unit, meaning| {
            all.push(Quantity { name: name.to_owned(), value, unit, meaning });
        };
        add("rays", rays as f64, "", "rays traced");
        add("cycles", self.cycles.into(), "cycles", "until the last thread finished");
        add("frame_ms", self.frame_ms, "ms", "time of the frame at the machine's clock");
        let e = &self.energy_mj;
        for (name, value, meaning) in [
            ("dram", e.dram, "memory, background and refresh included"),
            ("l1", e.l1, "first-level caches, per load"),
            ("l2", e.l2, "second-level caches, per load"),
            ("icache", e.icache, "instruction caches, per instruction"),
            ("registers", e.registers, "register files, three accesses per instruction"),
            ("local_store", e.local_store, "local stores, per access"),
            ("units", e.units, "shared execution units"),
            ("pipeline", e.pipeline, "ray-box or dual-split pipelines"),
            ("total", e.total, "all of it"),
        ] {
            add(&format!("energy_mj.{name}"), value, "mJ", meaning);
        }
        let g = &self.energy_groups_mj;
        add("energy_groups_mj.dram", g.dram, "mJ", "memory");
        add("energy_groups_mj.cache", g.cache, "mJ", "first- and second-level and instruction caches");
        add("energy_groups_mj.compute", g.compute, "mJ", "registers, local stores, units, pipelines");
        let a = &self.area_mm2;
        for (name, value, meaning) in [
            ("l1", a.l1, "first-level caches"),
            ("l2", a.l2, "second-level caches"),
            ("icache", a.icache, "instruction caches"),
            ("registers", a.registers, "register files"),
            ("local_store", a.local_store, "local stores"),
            ("units", a.units, "execution units, those of the pipelines included"),
            ("pipeline", a.pipeline, "what the pipelines have beyond units"),
            ("total", a.total, "all of it, without memory, network and clock"),
        ] {
            add(&format!("area_mm2.{name}"), value, "mm2", meaning);
        }
        for (name, meaning) in [
            ("issue", "an instruction other than a nop was issued"),
            ("data", "an operand was not ready, loaded data included"),
            ("units", "the execution unit was taken"),
            ("memory", "a cache bank was taken or a memory queue full"),
            ("fetch", "the instruction cache bank was taken"),
            ("nop", "a nop was issued"),
            ("halted", "the thread had finished"),
        ] {
            add(&format!("thread_cycles.{name}"), self.thread_cycles[name], "% of thread-cycles", meaning);
        }
        let i = &self.instructions;
        add("instructions.total", i.total as f64, "", "instructions, nops included");
        for (unit, times) in &i.units {
            let name = format!("instructions.units.{}", super::description::check::unit_key(*unit));
            add(&name, *times as f64, "", "instructions on this unit");
        }
        add("instructions.pipeline", i.pipeline as f64, "", "operations of the pipelines");
        add("instructions.local_store", i.local_store as f64, "", "accesses of local stores");
        add("instructions.loads", i.loads as f64, "", "loads from global memory");
        add("instructions.stores", i.stores as f64, "", "stores to global memory");
        add("instructions.nops", i.nops as f64, "", "nops in delay slots");
        for (name, percent) in &self.utilisation_pct {
            add(
                &format!("utilisation_pct.{name}"),
                *percent,
                "%",
                "share of the operations it could have done",
            );
        }
        for (name, counts, rate) in
            [("l1", &self.caches.l1, self.caches.l1_hit_pct), ("l2", &self.caches.l2, self.caches.l2_hit_pct)]
        {
            let key = |key: &str| format!("caches.{name}.{key}");
            add(&key("loads"), counts.loads as f64, "", "loads that were taken");
            add(&key("hits"), counts.hits as f64, "", "loads that found their line");
            add(&key("joined"), counts.joined as f64, "", "loads that joined a request under way");
            add(&key("stores"), counts.stores as f64, "", "stores that passed");
            add(
                &key("bank_conflicts"),
                counts.bank_conflicts as f64,
                "",
                "tries refused as the bank was taken",
            );
            add(&format!("caches.{name}_hit_pct"), rate, "% of loads", "loads that found their line");
        }
        let d = &self.dram.counts;
        add("dram.reads", d.reads as f64, "lines", "lines read");
        add("dram.writes", d.writes as f64, "lines", "lines written");
        add("dram.merged_reads", d.merged_reads as f64, "", "reads that joined another");
        add("dram.merged_writes", d.merged_writes as f64, "", "writes that joined another");
        add("dram.activates", d.activates as f64, "", "rows opened");
        add("dram.refreshes", d.refreshes as f64, "", "refreshes");
        add("dram.refused", d.refused as f64, "", "requests refused as the queue was full");
        add("dram.row_hit_pct", self.dram.row_hit_pct, "% of accesses", "accesses that found their row open");
        add(
            "dram.mean_read_latency_cycles",
            self.dram.mean_read_latency_cycles,
            "cycles",
            "from a read's arrival to its data",
        );
        let b = &self.bandwidth_gb_s;
        add("bandwidth_gb_s.l1", b.l1, "GB/s", "first-level caches to registers");
        add("bandwidth_gb_s.l2", b.l2, "GB/s", "second-level to first-level caches");
        add("bandwidth_gb_s.dram", b.dram, "GB/s", "memory, both directions");
        add("bandwidth_gb_s.dram_peak", b.dram_peak, "GB/s", "the most that the memory could do");
        all
    }

    /// Every quantity as CSV with its unit and meaning.
    #[must_use]
    pub fn to_csv(&self, rays: u64) -> String {
        let mut text = "quantity,value,unit,meaning\n".to_owned();
        for Quantity { name, value, unit, meaning } in self.quantities(rays) {
            text += &format!("{name},{value},{unit},\"{meaning}\"\n");
        }
        text
    }
}

fn utilisation_pct(
    machine: &MachineDescription,
    instructions: &Instructions,
    cycles: u32,
) -> BTreeMap<String, f64> {
    let slots = f64::from(cycles) * f64::from(machine.chip.tms());
    let mut percent: BTreeMap<String, f64> = Unit::ALL
        .into_iter()
        .map(|unit| {
            let times = instructions.units.get(&unit).copied().unwrap_or(0) as f64;
            let name = super::description::check::unit_key(unit).to_owned();
            (name, 100.0 * times / (slots * f64::from(machine.units.pool(unit).count)))
        })
        .collect();
    percent.insert("pipeline".to_owned(), 100.0 * instructions.pipeline as f64 / slots);
    percent
}

fn area_mm2(machine: &MachineDescription, pipeline: Option<&Pipeline>, costs: &CacheCosts) -> AreaMm2 {
    let tms = f64::from(machine.chip.tms());
    let threads = tms * f64::from(machine.tm.threads);
    // The divider and the inverse square root share one unit, counted once.
    let pools = Unit::ALL
        .into_iter()
        .map(|unit| f64::from(machine.units.pool(unit).count) * unit.published().area_um2)
        .sum::<f64>();
    let of_pipeline = pipeline.map_or(0.0, Pipeline::unit_area_um2);
    let beyond = pipeline.map_or(0.0, |pipeline| pipeline.cost.area_um2) - of_pipeline;
    let mut area = AreaMm2 {
        l1: tms * costs.l1.area_mm2,
        l2: f64::from(machine.chip.l2_partitions) * costs.l2.area_mm2,
        icache: tms * f64::from(machine.icache.caches) * costs.icache.area_mm2,
        registers: threads * REGISTERS.area_mm2,
        local_store: threads * LOCAL_STORE.area_mm2,
        units: tms * (pools + of_pipeline) * 1e-6,
        pipeline: tms * beyond * 1e-6,
        total: 0.0,
    };
    area.total =
        area.l1 + area.l2 + area.icache + area.registers + area.local_store + area.units + area.pipeline;
    area
}

/// Energy of the memory from the currents of its chips, after Micron TN-41-01: standby with and without open rows, an
/// activate with its precharge, bursts, refresh. Terminations are left out.
fn dram_energy_mj(machine: &MachineDescription, counts: &DramCounts, cycles: u32) -> f64 {
    let (dram, t, p) = (&machine.dram, &machine.dram.timing, &machine.dram.power);
    let clock_s = 1.0 / (machine.clock_ghz * 1e9 * f64::from(dram.clocks_per_cycle));
    let clocks = f64::from(cycles) * f64::from(dram.clocks_per_cycle) * f64::from(dram.channels);
    let active = counts.active_clocks as f64;
    let standby = active * p.idd3n_ma + (clocks - active).max(0.0) * p.idd2n_ma;
    let (rc, ras) = (f64::from(t.activate_to_activate_same_bank), f64::from(t.activate_to_precharge));
    let activate = p.idd0_ma * rc - p.idd3n_ma * ras - p.idd2n_ma * (rc - ras).max(0.0);
    let burst = f64::from(t.burst);
    let charge_ma_clocks = standby
        + counts.activates as f64 * activate
        + counts.reads as f64 * (p.idd4r_ma - p.idd3n_ma) * burst
        + counts.writes as f64 * (p.idd4w_ma - p.idd3n_ma) * burst
        + counts.refreshes as f64 * (p.idd5_ma - p.idd3n_ma) * f64::from(t.refresh);
    // mA times V are mW, times seconds mJ.
    charge_ma_clocks * p.vdd_v * clock_s * f64::from(p.chips_per_channel)
}
