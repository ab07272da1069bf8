//! Area and energy of memories at 65 nm: as published with the public TRaX simulator SimTRaX (dkoptacs/simtrax: constants
//! of `sim/ReadConfig.cc`, Cacti results of `samples/configs`), and where nothing is published, by a model that is fitted to that.
//! Execution units are in [`costs`].

mod model;
mod published;

use super::description::{Bytes, Cache, DescriptionError, MachineDescription, check::out_of_range};
use model::{LEAST_BYTES, MOST_BYTES, Shape};
use serde::Serialize;

const KIB: u64 = 1 << 10;

/// Area and energy of an access.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemoryCost {
    /// Area in mm2.
    pub area_mm2: f64,
    /// Energy of an access in nJ.
    pub energy_nj: f64,
}

/// Register file of a thread; three accesses are charged per instruction.
pub const REGISTERS: MemoryCost = MemoryCost { area_mm2: 0.014_766_5, energy_nj: 0.007_896_13 };
/// Accesses of the register file per instruction.
pub const REGISTER_ACCESSES: u64 = 3;
/// Local store of a thread.
pub const LOCAL_STORE: MemoryCost = MemoryCost { area_mm2: 0.013_963_29, energy_nj: 0.006_928_67 };

/// Instruction caches of 4 KiB: banks, mm2, nJ per access.
const INSTRUCTION_CACHES: [(u32, f64, f64); 7] = [
    (1, 0.090_296, 0.013_13),
    (2, 0.1103, 0.013_45),
    (4, 0.1105, 0.013_61),
    (8, 0.1295, 0.013_11),
    (16, 0.130_596, 0.013_49),
    (32, 0.1860, 0.015_14),
    (64, 0.2476, 0.016_58),
];

const INSTRUCTION_CACHE_BYTES: u64 = 4 * KIB;

/// What a cache costs, and where each number is from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CacheCost {
    /// Area in mm2.
    pub area_mm2: f64,
    /// The source of the area.
    pub area_source: &'static str,
    /// Energy of an access in nJ.
    pub energy_nj: f64,
    /// The source of the energy.
    pub energy_source: &'static str,
}

/// The source of numbers that the description gives.
const GIVEN: &str = "given in the machine's description";

impl CacheCost {
    const NONE: Self = Self::new(MemoryCost { area_mm2: 0.0, energy_nj: 0.0 }, "no cache");

    const fn new(cost: MemoryCost, source: &'static str) -> Self {
        Self {
            area_mm2: cost.area_mm2,
            area_source: source,
            energy_nj: cost.energy_nj,
            energy_source: source,
        }
    }

    /// Whether either number is the model's.
    #[must_use]
    pub fn is_modelled(&self) -> bool {
        [self.area_source, self.energy_source].iter().any(|source| source.starts_with("modelled"))
    }

    /// The cost of the data cache `section`: its own keys, the published table, or the model, in this order.
    fn of(section: &str, cache: &Cache) -> Result<Self, DescriptionError> {
        if !cache.enabled {
            return Ok(Self::NONE);
        }
        let given =
            MemoryCost { area_mm2: cache.area_mm2.unwrap_or(0.0), energy_nj: cache.energy_nj.unwrap_or(0.0) };
        let mut cost = match (cache.area_mm2, cache.energy_nj) {
            (Some(_), Some(_)) => return Ok(Self::new(given, GIVEN)),
            _ => Self::looked_up(section, cache)?,
        };
        if cache.area_mm2.is_some() {
            (cost.area_mm2, cost.area_source) = (given.area_mm2, GIVEN);
        }
        if cache.energy_nj.is_some() {
            (cost.energy_nj, cost.energy_source) = (given.energy_nj, GIVEN);
        }
        Ok(cost)
    }

    fn looked_up(section: &str, cache: &Cache) -> Result<Self, DescriptionError> {
        if !(LEAST_BYTES..=MOST_BYTES).contains(&cache.size.0) {
            let (least, most) = (Bytes(LEAST_BYTES), Bytes(MOST_BYTES));
            let rule = format!(
                "costs are known from {least} to {most}; for another size give {section}.area_mm2 and {section}.energy_nj"
            );
            return Err(out_of_range(format!("{section}.size"), cache.size, rule));
        }
        let shape = Shape {
            bytes: cache.size.0,
            line: cache.line.0,
            banks: cache.banks,
            ways: cache.associativity,
            ports: cache.ports,
        };
        let direct = shape.direct();
        Ok(match published::of(shape.bytes, shape.line, shape.banks) {
            None => Self::new(shape.cost(), model::SOURCE),
            Some(cost) if shape == direct => Self::new(cost, published::SOURCE),
            Some(cost) => {
                let (modelled, base) = (shape.cost(), direct.cost());
                let scaled = MemoryCost {
                    area_mm2: cost.area_mm2 * (modelled.area_mm2 / base.area_mm2),
                    energy_nj: cost.energy_nj * (modelled.energy_nj / base.energy_nj),
                };
                Self::new(scaled, model::SCALED)
            }
        })
    }
}

/// Costs of a machine's caches.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CacheCosts {
    /// Each first-level cache.
    pub l1: CacheCost,
    /// Each second-level cache.
    pub l2: CacheCost,
    /// Each instruction cache.
    pub icache: CacheCost,
}

impl CacheCosts {
    /// The costs of `machine`'s caches. A cache that is not enabled costs nothing.
    ///
    /// # Errors
    /// If a cache is of a size that neither the published tables nor the model has, and its own keys do not say what it costs.
    pub fn new(machine: &MachineDescription) -> Result<Self, DescriptionError> {
        let icache = &machine.icache;
        let known = |(banks, _, _): &&(u32, f64, f64)| {
            *banks == icache.banks && icache.size.0 == INSTRUCTION_CACHE_BYTES
        };
        let &(_, area_mm2, energy_nj) = INSTRUCTION_CACHES.iter().find(known).ok_or_else(|| {
            let rule = "published costs are for 4KiB";
            out_of_range("icache.size", format!("{} in {} banks", icache.size, icache.banks), rule)
        })?;
        Ok(Self {
            l1: CacheCost::of("l1", &machine.l1)?,
            l2: CacheCost::of("l2", &machine.l2)?,
            icache: CacheCost::new(MemoryCost { area_mm2, energy_nj }, published::SOURCE),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn costs(settings: &[&str]) -> Result<CacheCosts, DescriptionError> {
        let settings: Vec<String> = settings.iter().map(|setting| (*setting).to_owned()).collect();
        CacheCosts::new(&MachineDescription::load("trax", &settings)?)
    }

    #[test]
    fn published_costs_stay() {
        let trax = costs(&[]).unwrap();
        assert_eq!((trax.l1.area_mm2, trax.l1.energy_nj), (0.775_049, 0.220_453));
        assert_eq!((trax.l2.area_mm2, trax.l2.energy_nj), (5.960_245, 0.611_974));
        assert_eq!([trax.l1.area_source, trax.l2.energy_source], [published::SOURCE; 2]);
        let lines = costs(&["l1.line=128B", "l2.line=128B"]).unwrap();
        assert_eq!((lines.l1.energy_nj, lines.l1.is_modelled()), (0.220_03, false));
    }

    #[test]
    fn every_power_of_two_has_a_cost() {
        for section in ["l1", "l2"] {
            for log2 in 10..=24 {
                for banks in [1, 8, 16, 64] {
                    let size = format!("{section}.size={}", 1 << log2);
                    let costs = costs(&[&size, &format!("{section}.banks={banks}")]).unwrap();
                    let cost = if section == "l1" { costs.l1 } else { costs.l2 };
                    assert!(cost.area_mm2 > 0.0 && cost.energy_nj > 0.0, "{size} {banks}");
                    let is_published = published::of(1 << log2, 64, banks).is_some();
                    assert_eq!(cost.is_modelled(), !is_published, "{size} {banks}");
                }
            }
        }
    }

    #[test]
    fn other_sizes_are_refused_unless_their_cost_is_given() {
        for (setting, key) in [("l1.size=512B", "l1.size = 512B"), ("l2.size=32MiB", "l2.size = 32MiB")] {
            let error = costs(&[setting]).unwrap_err().to_string();
            let section = &key[..2];
            assert!(error.contains(key) && error.contains(&format!("{section}.energy_nj")), "{error}");
            let [area, energy] = ["area_mm2", "energy_nj"].map(|cost| format!("{section}.{cost}=1.5"));
            assert!(costs(&[setting, &area]).is_err());
            costs(&[setting, &area, &energy]).unwrap();
        }
        let one = costs(&["l1.energy_nj=0.3"]).unwrap().l1;
        assert_eq!((one.energy_nj, one.energy_source), (0.3, GIVEN));
        assert_eq!((one.area_mm2, one.area_source), (0.775_049, published::SOURCE));
    }

    #[test]
    fn ways_and_ports_cost_and_their_cost_is_marked() {
        let trax = costs(&[]).unwrap().l1;
        for setting in ["l1.associativity=4", "l1.ports=2"] {
            let more = costs(&[setting]).unwrap().l1;
            assert!(more.area_mm2 > trax.area_mm2 && more.energy_nj > trax.energy_nj, "{setting}");
            assert_eq!((more.is_modelled(), more.area_source), (true, model::SCALED));
        }
    }
}
