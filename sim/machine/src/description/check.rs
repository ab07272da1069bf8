//! Which descriptions can be built.

use super::{LoadWords, MachineDescription};
use costs::Unit;
use memory::description::MAX_BANKS;
use memory::description::check::{MAX_LATENCY, OutOfRange, in_short, power_of_two, within};

/// Why a machine cannot be built.
#[derive(Debug, thiserror::Error)]
pub enum DescriptionError {
    /// Neither a preset nor a file.
    #[error("machine {file}: {error}; name a file or one of the presets {presets}")]
    Read {
        /// What was given.
        file: String,
        /// The presets.
        presets: String,
        /// Why it cannot be read.
        error: std::io::Error,
    },
    /// Not a description.
    #[error("machine {file}: {message}")]
    Parse {
        /// The file or preset.
        file: String,
        /// Line, key and remedy.
        message: String,
    },
    /// A setting that cannot be applied.
    #[error("--set {setting}: {message}")]
    Setting {
        /// The setting.
        setting: String,
        /// What is wrong.
        message: String,
    },
    /// A value out of range.
    #[error("machine: {0}")]
    Value(OutOfRange),
}

/// Not the source of the error, whose message holds it whole: a chain of messages would say it twice.
impl From<OutOfRange> for DescriptionError {
    fn from(value: OutOfRange) -> Self {
        Self::Value(value)
    }
}

/// A value out of range.
pub(crate) fn out_of_range(
    key: impl Into<String>,
    value: impl ToString,
    rule: impl Into<String>,
) -> DescriptionError {
    OutOfRange::new(key, value, rule).into()
}

/// Most threads of a multiprocessor.
pub(crate) const MAX_THREADS: u32 = 64;
const MAX_TMS: u32 = 1 << 12;

impl MachineDescription {
    /// # Errors
    /// [`DescriptionError::Value`] with the first key that is out of range.
    pub(super) fn check(&self) -> Result<(), DescriptionError> {
        let Self { chip, tm, icache, .. } = self;
        if !(0.001..=100.0).contains(&self.clock_ghz) {
            return Err(out_of_range("clock_ghz", in_short(self.clock_ghz), "from 0.001 to 100"));
        }
        within("chip.l2_partitions", chip.l2_partitions, 1, MAX_TMS)?;
        within("chip.tms_per_partition", chip.tms_per_partition, 1, MAX_TMS / chip.l2_partitions)?;
        let alignment = self.layout.alignment;
        let is_block = alignment.0.is_power_of_two() && (4..=256).contains(&alignment.0);
        if !(self.layout.is_packed() || is_block) {
            let rule = "0 for packed nodes, or a power of two of bytes from 4 to 256";
            return Err(out_of_range("layout.alignment", alignment, rule));
        }
        within("tm.threads", tm.threads, 1, MAX_THREADS)?;
        if let LoadWords::Words(words) = tm.load_words
            && ![1, 2, 4].contains(&words)
        {
            return Err(out_of_range("tm.load_words", words, "1, 2, 4, or line for all words of a line"));
        }
        within("icache.caches", icache.caches, 1, MAX_THREADS)?;
        power_of_two("icache.banks", icache.banks, MAX_BANKS)?;
        within("icache.fetches_per_bank", icache.fetches_per_bank, 1, 255)?;
        for unit in Unit::ALL {
            let (name, pool) = (unit.name(), self.units.pool(unit));
            within(&format!("units.{name}.count"), pool.count, 1, 255)?;
            within(&format!("units.{name}.latency_cycles"), pool.latency_cycles, 1, MAX_LATENCY)?;
        }
        Ok(self.memory().check()?)
    }
}
