//! The part of a description that a simulation's counts depend on.

use super::{Bytes, Cache, Dram, DramPower, Icache, MachineDescription};

impl MachineDescription {
    /// The description without its name, its needs and what only has a price: two machines with the same timing count the same.
    #[must_use]
    pub fn timing(&self) -> Self {
        let free = |cache: &Cache| Cache { area_mm2: None, energy_nj: None, ..*cache };
        let power = DramPower {
            chips_per_channel: 0,
            vdd_v: 0.0,
            idd0_ma: 0.0,
            idd2n_ma: 0.0,
            idd3n_ma: 0.0,
            idd4r_ma: 0.0,
            idd4w_ma: 0.0,
            idd5_ma: 0.0,
        };
        Self {
            name: String::new(),
            // Everything is timed in cycles of this clock; those of the memory are a multiple of it.
            clock_ghz: 1.0,
            icache: Icache { size: Bytes(0), ..self.icache },
            l1: free(&self.l1),
            l2: free(&self.l2),
            dram: Dram { power, ..self.dram },
            needs: None,
            ..self.clone()
        }
    }
}
