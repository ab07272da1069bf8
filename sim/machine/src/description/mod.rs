//! The machine, described by a TOML file: what exists, how large it is and how long it takes.
//!
//! [`MachineDescription::load`] reads a preset or a file, applies `--set` and checks that the machine can be built. What
//! the pipelines consist of is not described here: it is read from the hardware (see [`super::pipelines`]). The keys of caches and
//! DRAM are those of [`memory::description`].

pub(crate) mod check;
mod explained;
mod settings;
mod timing;

pub use check::DescriptionError;
pub use memory::description::{BankBy, Bytes, Cache, Dram, DramPower, DramTiming, Mapping, Network};

use serde::{Deserialize, Serialize};
use std::path::Path;

/// The machines that come with the tool: name and text.
pub const PRESETS: [(&str, &str); 2] = [
    ("trax", include_str!("../../presets/trax.toml")),
    ("simtrax-reference", include_str!("../../presets/simtrax-reference.toml")),
];

/// Most bytes of a description.
const MOST_BYTES: u64 = 1 << 20;

/// Everything about a machine that can be chosen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MachineDescription {
    /// Name in results.
    pub name: String,
    /// Clock of all but the DRAM.
    pub clock_ghz: f64,
    /// How many of everything.
    pub chip: Chip,
    /// How a structure's nodes lie in memory; packed where the key is missing.
    #[serde(default)]
    pub layout: NodeLayout,
    /// One thread multiprocessor.
    pub tm: Tm,
    /// Its instruction caches.
    pub icache: Icache,
    /// Its shared execution units.
    pub units: Units,
    /// Its data cache.
    pub l1: Cache,
    /// Between the data caches and the cache of their partition; without latency where the key is missing.
    #[serde(default)]
    pub network: Network,
    /// The cache of a partition.
    pub l2: Cache,
    /// The memory that all share.
    pub dram: Dram,
    /// What a scene needs, where `dualsplit needs` wrote the description. Nothing depends on it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub needs: Option<toml::Table>,
}

/// Number of partitions and multiprocessors.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Chip {
    /// Partitions, each an L2 with its multiprocessors.
    pub l2_partitions: u32,
    /// Thread multiprocessors (TMs) per partition.
    pub tms_per_partition: u32,
}

impl Chip {
    /// Thread multiprocessors of the chip.
    #[must_use]
    pub fn tms(&self) -> u32 {
        self.l2_partitions * self.tms_per_partition
    }
}

/// How the nodes of a structure lie in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NodeLayout {
    /// The children of a node lie in as few blocks of this size as they can, each block at a multiple of its size. At 0, nodes are
    /// packed.
    pub alignment: Bytes,
}

impl Default for NodeLayout {
    fn default() -> Self {
        Self { alignment: Bytes(0) }
    }
}

impl NodeLayout {
    /// Whether nodes lie one after another as golden stores them.
    #[must_use]
    pub fn is_packed(self) -> bool {
        self.alignment == Bytes(0)
    }
}

/// A thread multiprocessor.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tm {
    /// Thread processors: in order, one instruction a cycle each.
    pub threads: u32,
    /// What one load instruction brings to registers.
    pub load_words: LoadWords,
}

/// Words that one load brings, if they are adjacent and in one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged, expecting = "expected 1, 2, 4 or \"line\"")]
pub enum LoadWords {
    /// At most this many: 1, 2 or 4, naturally aligned.
    Words(u32),
    /// Whatever the line holds.
    Line(Line),
}

/// The word `line`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Line {
    /// A whole line.
    Line,
}

/// The instruction caches of a multiprocessor. They hold the whole program.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Icache {
    /// Caches; thread `t` uses cache `t` modulo their number.
    pub caches: u32,
    /// Size of each, for area and energy.
    pub size: Bytes,
    /// Banks of each; an instruction is in bank `address` modulo their number.
    pub banks: u32,
    /// Fetches per bank and cycle.
    pub fetches_per_bank: u32,
}

/// The execution units that the threads of a multiprocessor share.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs, reason = "named as in `costs::Unit`")]
pub struct Units {
    pub fp_add: UnitPool,
    pub fp_mul: UnitPool,
    pub fp_min_max: UnitPool,
    pub fp_cmp: UnitPool,
    pub int_add: UnitPool,
    pub int_mul: UnitPool,
    pub fp_inv: UnitPool,
    pub convert: UnitPool,
    pub branch: UnitPool,
    pub bitwise: UnitPool,
}

/// Units of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UnitPool {
    /// How many; each takes one operation a cycle.
    pub count: u32,
    /// Cycles until a result can be used.
    pub latency_cycles: u32,
}

impl Units {
    /// The pool of `unit`.
    #[must_use]
    pub fn pool(&self, unit: costs::Unit) -> UnitPool {
        use costs::Unit;
        match unit {
            Unit::FpAdd => self.fp_add,
            Unit::FpMul => self.fp_mul,
            Unit::FpMinMax => self.fp_min_max,
            Unit::FpCmp => self.fp_cmp,
            Unit::IntAdd => self.int_add,
            Unit::IntMul => self.int_mul,
            Unit::FpInv => self.fp_inv,
            Unit::Convert => self.convert,
            Unit::Branch => self.branch,
            Unit::Bitwise => self.bitwise,
        }
    }
}

impl Units {
    /// The pool of `unit`, to be changed.
    pub(crate) fn pool_mut(&mut self, unit: costs::Unit) -> &mut UnitPool {
        use costs::Unit;
        match unit {
            Unit::FpAdd => &mut self.fp_add,
            Unit::FpMul => &mut self.fp_mul,
            Unit::FpMinMax => &mut self.fp_min_max,
            Unit::FpCmp => &mut self.fp_cmp,
            Unit::IntAdd => &mut self.int_add,
            Unit::IntMul => &mut self.int_mul,
            Unit::FpInv => &mut self.fp_inv,
            Unit::Convert => &mut self.convert,
            Unit::Branch => &mut self.branch,
            Unit::Bitwise => &mut self.bitwise,
        }
    }
}

impl MachineDescription {
    /// The machine `name_or_file`, a preset or a TOML file, changed by `settings` of the form `l1.size=64KiB`.
    ///
    /// # Errors
    /// See [`DescriptionError`].
    pub fn load(name_or_file: impl AsRef<Path>, settings: &[String]) -> Result<Self, DescriptionError> {
        let (source, text) = text(name_or_file.as_ref())?;
        let machine = settings::parse(&source, &text, settings)?;
        machine.check()?;
        Ok(machine)
    }

    /// The machine that [`MachineDescription::load`] gives, as a TOML file with a comment for each key: what it means, its unit and its
    /// range. Behind a value stands what the preset or the file says behind the same value: where it is from.
    ///
    /// # Errors
    /// See [`DescriptionError`].
    pub fn explained(
        name_or_file: impl AsRef<Path>,
        settings: &[String],
    ) -> Result<String, DescriptionError> {
        let machine = Self::load(&name_or_file, settings)?;
        let (_, text) = text(name_or_file.as_ref())?;
        Ok(explained::explained(&machine, &text))
    }

    /// The machine as a TOML file that [`MachineDescription::load`] reads back.
    ///
    /// # Panics
    /// Never: every field has a TOML form.
    #[must_use]
    pub fn to_toml(&self) -> String {
        toml::to_string(self).expect("every field has a TOML form")
    }

    /// The memory, with a port for each multiprocessor.
    #[must_use]
    pub fn memory(&self) -> memory::description::Description {
        memory::description::Description {
            partitions: self.chip.l2_partitions,
            ports_per_partition: self.chip.tms_per_partition,
            l1: self.l1,
            network: self.network,
            l2: self.l2,
            dram: self.dram,
        }
    }

    /// Words that one load may bring.
    #[must_use]
    pub fn load_words(&self) -> u32 {
        match self.tm.load_words {
            LoadWords::Words(words) => words,
            LoadWords::Line(Line::Line) => self.l1.line_words(),
        }
    }
}

/// The preset or file `name_or_file`: what messages call it, and its text.
fn text(name_or_file: &Path) -> Result<(String, String), DescriptionError> {
    if let Some((name, text)) = PRESETS.iter().find(|(name, _)| Path::new(name) == name_or_file) {
        return Ok((format!("preset {name}"), (*text).to_owned()));
    }
    let read = base::input::read_text(name_or_file, MOST_BYTES);
    let text = read.map_err(|error| DescriptionError::Read {
        file: name_or_file.display().to_string(),
        presets: PRESETS.map(|(name, _)| name).join(", "),
        error,
    })?;
    Ok((name_or_file.display().to_string(), text))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(settings: &[&str]) -> String {
        let settings: Vec<String> = settings.iter().map(|s| (*s).to_owned()).collect();
        let error = MachineDescription::load("trax", &settings).unwrap_err();
        assert!(
            std::error::Error::source(&error).is_none(),
            "a chain of messages would say it twice: {error}"
        );
        error.to_string()
    }

    #[test]
    fn presets_read_back() {
        for (name, _) in PRESETS {
            let machine = MachineDescription::load(name, &[]).unwrap();
            assert_eq!(machine.name, name);
            let again: MachineDescription = toml::from_str(&machine.to_toml()).unwrap();
            assert_eq!(again, machine);
        }
        let trax = MachineDescription::load("trax", &[]).unwrap();
        assert_eq!(trax.dram.bytes(trax.l2.line.0), 2 << 30);
    }

    #[test]
    fn settings_change_keys() {
        let settings = ["l1.size=64KiB", "tm.load_words=line", "units.fp_add.count = 4", "name=mine"];
        let machine = MachineDescription::load("trax", &settings.map(str::to_owned)).unwrap();
        assert_eq!(machine.l1.size, Bytes(64 << 10));
        assert_eq!(machine.load_words(), 16);
        assert_eq!(machine.units.fp_add.count, 4);
        assert_eq!(machine.name, "mine");
    }

    #[test]
    fn keys_that_a_file_leaves_out_can_be_set() {
        let mut table: toml::Table = toml::from_str(PRESETS[0].1).unwrap();
        assert!(table.remove("layout").is_some() && table.remove("network").is_some());
        let text = toml::to_string(&table).unwrap();
        let settings = ["layout.alignment=64B", "network.latency_cycles=3"].map(str::to_owned);
        let trax = MachineDescription::load("trax", &settings).unwrap();
        assert_eq!(settings::parse("old.toml", &text, &settings).unwrap(), trax);
        assert_eq!(
            settings::parse("old.toml", &text, &[]).unwrap(),
            MachineDescription::load("trax", &[]).unwrap()
        );
    }

    #[test]
    fn errors_name_the_key() {
        for (setting, key) in [
            ("l1.banks=0", "l1.banks"),
            ("l1.banks=3", "l1.banks"),
            ("l1.bank_by=row", "variant `row`, expected `word` or `line`"),
            ("l1.bank_by=3", "expected `word` or `line`"),
            ("dram.mapping=3", "expected `column-channel-bank-row` or"),
            ("tm.load_words=2.5", "1, 2, 4 or \"line\""),
            ("clock_ghz=1e-308", "clock_ghz = 1e-308: from 0.001 to 100"),
            ("l1.energy_nj=1e300", "1e300"),
            ("l1.size=128MiB", "l1.size = 128MiB: a power of two from 64B to 64MiB"),
            ("tm.load_words=16", "tm.load_words = 16: 1, 2, 4, or line"),
            ("l1.sizes=64KiB", "sizes"),
            ("l3.size=64KiB", "l3"),
            ("l1.size=48KiB", "l1.size"),
            ("l1.size=big", "l1.size"),
            ("l1.size=64KB", "size"),
            ("layout.alignment=48B", "layout.alignment"),
            ("layout.alignment=512B", "layout.alignment"),
            ("l2.miss_registers=-1", "l2.miss_registers"),
            ("network.latency_cycles=201", "network.latency_cycles"),
            ("tm.threads=0", "tm.threads"),
            ("tm.threads=65", "tm.threads"),
            ("tm.load_words=3", "tm.load_words"),
            ("units.fp_add.count=-1", "units.fp_add.count"),
            ("units.fp_add.latency_cycles=0", "units.fp_add.latency_cycles"),
            ("dram.channels=0", "dram.channels"),
            ("dram.write_drain_high=90", "dram.write_drain_high"),
            ("dram.timing.burst=0", "dram.timing.burst"),
            ("clock_ghz=nan", "clock_ghz"),
            ("chip.l2_partitions=0", "chip.l2_partitions"),
            ("l1.size", "l1.size"),
        ] {
            let message = error(&[setting]);
            assert!(message.contains(key), "{setting}: {message}");
        }
        let message = MachineDescription::load("no-such-machine", &[]).unwrap_err().to_string();
        assert!(message.contains("no-such-machine") && message.contains("simtrax-reference"), "{message}");
    }
}
