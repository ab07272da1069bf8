//! Energy: counts by kind times prices.

use super::Tally;
use super::physics::dram_energy_mj;
use crate::costs::{CacheCosts, LOCAL_STORE, REGISTERS};
use crate::description::MachineDescription;
use costs::PipelineCost;
use serde::Serialize;

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

/// Energy in millijoules, summed as the talk words it: whatever keeps data on the chip is one group.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct EnergyStorageMj {
    /// Memory.
    pub dram: f64,
    /// Caches, instruction caches, registers and local stores.
    pub on_chip: f64,
    /// Units and pipelines.
    pub execution: f64,
}

impl EnergyMj {
    /// What `tally` costs on `machine`, whose caches and pipeline have these costs.
    #[must_use]
    pub fn new(
        machine: &MachineDescription,
        pipeline: Option<&PipelineCost>,
        caches: &CacheCosts,
        tally: &Tally,
    ) -> Self {
        let mj = |accesses: u64, energy_nj: f64| accesses as f64 * energy_nj * 1e-6;
        let instructions = &tally.instructions;
        let units = instructions.units.iter();
        let mut energy = Self {
            dram: dram_energy_mj(machine, &tally.dram, tally.cycles),
            l1: mj(tally.l1.loads, caches.l1.energy_nj),
            l2: mj(tally.l2.loads, caches.l2.energy_nj),
            icache: mj(instructions.total, caches.icache.energy_nj),
            registers: mj(tally.register_accesses, REGISTERS.energy_nj),
            local_store: mj(instructions.local_store, LOCAL_STORE.energy_nj),
            units: units.map(|(unit, times)| mj(*times, unit.published().energy_pj * 1e-3)).sum(),
            pipeline: pipeline.map_or(0.0, |cost| mj(instructions.pipeline, cost.energy_pj * 1e-3)),
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
        energy
    }

    /// The paper's three groups.
    #[must_use]
    pub fn groups(&self) -> EnergyGroupsMj {
        EnergyGroupsMj {
            dram: self.dram,
            cache: self.l1 + self.l2 + self.icache,
            compute: self.registers + self.local_store + self.units + self.pipeline,
        }
    }

    /// The talk's three groups.
    #[must_use]
    pub fn storage(&self) -> EnergyStorageMj {
        EnergyStorageMj {
            dram: self.dram,
            on_chip: self.groups().cache + self.registers + self.local_store,
            execution: self.units + self.pipeline,
        }
    }
}
