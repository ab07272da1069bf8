//! Every quantity with its unit and meaning, as a table.

use super::Results;
use serde::Serialize;

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
        let s = &self.energy_storage_mj;
        add("energy_storage_mj.dram", s.dram, "mJ", "memory");
        add(
            "energy_storage_mj.on_chip",
            s.on_chip,
            "mJ",
            "caches, instruction caches, registers, local stores",
        );
        add("energy_storage_mj.execution", s.execution, "mJ", "units, pipelines");
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
        let c = &self.cache_costs;
        for (name, cost) in [("l1", &c.l1), ("l2", &c.l2), ("icache", &c.icache)] {
            add(&format!("cache_costs.{name}.area_mm2"), cost.area_mm2, "mm2", cost.area_source);
            add(&format!("cache_costs.{name}.energy_nj"), cost.energy_nj, "nJ", cost.energy_source);
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
            let name = format!("instructions.units.{}", unit.name());
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
            add(
                &key("register_conflicts"),
                counts.register_conflicts as f64,
                "",
                "tries to load refused as all miss registers were taken",
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
