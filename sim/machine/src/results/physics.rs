//! Area and energy of what the core does not count by itself, and utilisation.

use super::{AreaMm2, Instructions};
use crate::core::DramCounts;
use crate::costs::{CacheCosts, LOCAL_STORE, REGISTERS};
use crate::description::MachineDescription;
use costs::Pipeline;
use costs::Unit;
use std::collections::BTreeMap;

/// Percent of the operations that each unit could have done.
pub fn utilisation_pct(
    machine: &MachineDescription,
    instructions: &Instructions,
    cycles: u32,
) -> BTreeMap<String, f64> {
    let slots = f64::from(cycles) * f64::from(machine.chip.tms());
    let mut percent: BTreeMap<String, f64> = Unit::ALL
        .into_iter()
        .map(|unit| {
            let times = instructions.units.get(&unit).copied().unwrap_or(0) as f64;
            let name = unit.name().to_owned();
            (name, 100.0 * times / (slots * f64::from(machine.units.pool(unit).count)))
        })
        .collect();
    percent.insert("pipeline".to_owned(), 100.0 * instructions.pipeline as f64 / slots);
    percent
}

/// Area by component.
pub fn area_mm2(machine: &MachineDescription, pipeline: Option<&Pipeline>, costs: &CacheCosts) -> AreaMm2 {
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
pub fn dram_energy_mj(machine: &MachineDescription, counts: &DramCounts, cycles: u32) -> f64 {
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
