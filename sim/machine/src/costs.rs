//! Area and energy of memories at 65 nm, as published with the public TRaX simulator SimTRaX (dkoptacs/simtrax: constants
//! of `sim/ReadConfig.cc`, Cacti results of `samples/configs`). Execution units are in [`costs`].

use super::description::{Cache, DescriptionError, MachineDescription, check::out_of_range};

/// Where these numbers are from.
pub const SOURCE: &str = "published Cacti results of SimTRaX (65 nm)";

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

/// Data caches with lines of 64 bytes: KiB, banks, mm2, nJ per access.
const CACHES: [(u64, u32, f64, f64); 14] = [
    (16, 4, 0.268_184, 0.134_578),
    (16, 8, 0.650_707, 0.204_198),
    (32, 4, 0.391_508, 0.165_190),
    (32, 8, 0.775_049, 0.220_453),
    (32, 16, 1.385_896, 0.283_138),
    (64, 8, 1.017, 0.2514),
    (128, 16, 2.317_749, 0.364_071),
    (512, 8, 4.575_878, 0.559_878),
    (512, 16, 5.960_245, 0.611_974),
    (512, 32, 7.666_410, 0.682_989),
    (1024, 16, 10.04, 0.828),
    (4096, 8, 32.752_730, 1.559_834),
    (4096, 16, 35.399_670, 1.554_774),
    (4096, 32, 39.884_160, 1.604_445),
];

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

const LINE: u64 = 64;
const INSTRUCTION_CACHE_BYTES: u64 = 4096;

/// Cost of a data cache: its own keys, or the published table.
fn cache(section: &str, cache: &Cache) -> Result<MemoryCost, DescriptionError> {
    if let (Some(area_mm2), Some(energy_nj)) = (cache.area_mm2, cache.energy_nj) {
        return Ok(MemoryCost { area_mm2, energy_nj });
    }
    let known = |(kib, banks, _, _): &&(u64, u32, f64, f64)| {
        kib * 1024 == cache.size.0 && *banks == cache.banks && cache.line.0 == LINE
    };
    let &(_, _, area_mm2, energy_nj) = CACHES.iter().find(known).ok_or_else(|| {
        let shape = format!("{} in {} banks, lines of {}", cache.size, cache.banks, cache.line);
        let rule = format!("no published cost: give {section}.area_mm2 and {section}.energy_nj");
        out_of_range(format!("{section}.size"), shape, rule)
    })?;
    Ok(MemoryCost {
        area_mm2: cache.area_mm2.unwrap_or(area_mm2),
        energy_nj: cache.energy_nj.unwrap_or(energy_nj),
    })
}

/// Costs of a machine's caches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CacheCosts {
    /// Each first-level cache.
    pub l1: MemoryCost,
    /// Each second-level cache.
    pub l2: MemoryCost,
    /// Each instruction cache.
    pub icache: MemoryCost,
}

impl CacheCosts {
    /// The costs of `machine`'s caches. A cache that is not enabled costs nothing.
    ///
    /// # Errors
    /// If the published tables do not have a cache and its own keys do not say what it costs.
    pub fn new(machine: &MachineDescription) -> Result<Self, DescriptionError> {
        let none = MemoryCost { area_mm2: 0.0, energy_nj: 0.0 };
        let of = |section, description: &Cache| match description.enabled {
            true => cache(section, description),
            false => Ok(none),
        };
        let icache = &machine.icache;
        let known = |(banks, _, _): &&(u32, f64, f64)| {
            *banks == icache.banks && icache.size.0 == INSTRUCTION_CACHE_BYTES
        };
        let &(_, area_mm2, energy_nj) = INSTRUCTION_CACHES.iter().find(known).ok_or_else(|| {
            let rule = "published costs are for 4KiB";
            out_of_range("icache.size", format!("{} in {} banks", icache.size, icache.banks), rule)
        })?;
        Ok(Self {
            l1: of("l1", &machine.l1)?,
            l2: of("l2", &machine.l2)?,
            icache: MemoryCost { area_mm2, energy_nj },
        })
    }
}
