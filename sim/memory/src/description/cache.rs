//! A cache: how large it is, how its banks are chosen, how long it takes.

use super::Bytes;
use super::check::{MAX_LATENCY, OutOfRange, amount, power_of_two, within};
use super::words::one_of;
use serde::{Deserialize, Deserializer, Serialize};

/// Most banks of a cache.
pub const MAX_BANKS: u32 = 64;
/// Most ports of a bank.
pub const MAX_PORTS: u32 = 4;

/// Most registers for lines on their way to a cache.
const MAX_MISS_REGISTERS: u32 = 1 << 16;

/// A data cache. Stores go around it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cache {
    /// Whether lines stay in it; requests under way are joined all the same.
    pub enabled: bool,
    /// Capacity.
    pub size: Bytes,
    /// Length of a line.
    pub line: Bytes,
    /// Banks.
    pub banks: u32,
    /// Accesses that each bank takes in a cycle; 1 where the key is missing.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub ports: u32,
    /// Which bank a word is in; by word where the key is missing.
    #[serde(default)]
    pub bank_by: BankBy,
    /// Lines of a set; the least recently used is replaced.
    pub associativity: u32,
    /// Cycles until a hit can be used.
    pub latency_cycles: u32,
    /// Lines that may be on their way to it at a time; any number where it is 0 or the key is missing.
    #[serde(default)]
    pub miss_registers: u32,
    /// Area in mm2, in the place of the published or modelled one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub area_mm2: Option<f64>,
    /// Energy of an access in nJ, in the place of the published or modelled one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy_nj: Option<f64>,
}

const fn one() -> u32 {
    1
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "the form that serde asks for")]
const fn is_one(ports: &u32) -> bool {
    *ports == 1
}

/// What selects a bank, modulo the number of banks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum BankBy {
    /// The address in words: adjacent words are in different banks.
    #[default]
    Word,
    /// The number of the line: a line is in one bank.
    Line,
}

impl<'de> Deserialize<'de> for BankBy {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        one_of(deserializer, &[("word", Self::Word), ("line", Self::Line)])
    }
}

impl Cache {
    /// 32-bit words of a line.
    #[must_use]
    pub fn line_words(&self) -> u32 {
        (self.line.0 / 4) as u32
    }

    /// Lines that it holds.
    #[must_use]
    pub fn lines(&self) -> u32 {
        (self.size.0 / self.line.0) as u32
    }

    /// Whether it can be built. `section` names it in messages.
    ///
    /// # Errors
    /// The first key that is out of range.
    pub fn check(&self, section: &str) -> Result<(), OutOfRange> {
        let key = |name: &str| format!("{section}.{name}");
        let power = |name: &str, value: Bytes, least: Bytes, most: Bytes| {
            if (least..=most).contains(&value) && value.0.is_power_of_two() {
                return Ok(());
            }
            Err(OutOfRange::new(key(name), value, format!("a power of two from {least} to {most}")))
        };
        power("line", self.line, Bytes(16), Bytes(256))?;
        power("size", self.size, self.line, Bytes(64 << 20))?;
        power_of_two(&key("banks"), self.banks, MAX_BANKS)?;
        within(&key("ports"), self.ports, 1, MAX_PORTS)?;
        power_of_two(&key("associativity"), self.associativity, self.lines())?;
        within(&key("latency_cycles"), self.latency_cycles, 1, MAX_LATENCY)?;
        within(&key("miss_registers"), self.miss_registers, 0, MAX_MISS_REGISTERS)?;
        for (name, value) in [("area_mm2", self.area_mm2), ("energy_nj", self.energy_nj)] {
            if let Some(value) = value {
                amount(&key(name), value)?;
            }
        }
        Ok(())
    }
}
