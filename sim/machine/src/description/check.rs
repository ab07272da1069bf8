//! Which descriptions can be built.

use super::{Cache, LoadWords, MachineDescription};
use costs::Unit;

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
    #[error("machine: {key} = {value}: {rule}")]
    Value {
        /// The key, with its section.
        key: String,
        /// Its value.
        value: String,
        /// What values it takes.
        rule: String,
    },
}

/// A value out of range.
pub(crate) fn out_of_range(
    key: impl Into<String>,
    value: impl ToString,
    rule: impl Into<String>,
) -> DescriptionError {
    DescriptionError::Value { key: key.into(), value: value.to_string(), rule: rule.into() }
}

/// Most threads of a multiprocessor.
pub(crate) const MAX_THREADS: u32 = 64;
const MAX_TMS: u32 = 1 << 12;
/// Most banks of a cache.
pub(crate) const MAX_BANKS: u32 = 64;
const MAX_LATENCY: u32 = 200;

impl MachineDescription {
    /// # Errors
    /// [`DescriptionError::Value`] with the first key that is out of range.
    pub(super) fn check(&self) -> Result<(), DescriptionError> {
        let Self { chip, tm, icache, dram, .. } = self;
        if !(self.clock_ghz > 0.0 && self.clock_ghz <= 100.0) {
            return Err(out_of_range("clock_ghz", self.clock_ghz, "above 0, at most 100"));
        }
        within("chip.l2_partitions", chip.l2_partitions, 1, MAX_TMS)?;
        within("chip.tms_per_partition", chip.tms_per_partition, 1, MAX_TMS / chip.l2_partitions)?;
        within("tm.threads", tm.threads, 1, MAX_THREADS)?;
        if let LoadWords::Words(words) = tm.load_words
            && ![1, 2, 4].contains(&words)
        {
            return Err(out_of_range("tm.load_words", words, "1, 2, 4 or \"line\""));
        }
        within("icache.caches", icache.caches, 1, MAX_THREADS)?;
        power_of_two("icache.banks", icache.banks, MAX_BANKS)?;
        within("icache.fetches_per_bank", icache.fetches_per_bank, 1, 255)?;
        for unit in Unit::ALL {
            let (name, pool) = (unit.name(), self.units.pool(unit));
            within(&format!("units.{name}.count"), pool.count, 1, 255)?;
            within(&format!("units.{name}.latency_cycles"), pool.latency_cycles, 1, MAX_LATENCY)?;
        }
        check_cache("l1", &self.l1)?;
        check_cache("l2", &self.l2)?;
        if self.l1.line != self.l2.line {
            return Err(out_of_range("l2.line", self.l2.line, format!("equal to l1.line, {}", self.l1.line)));
        }
        within("dram.clocks_per_cycle", dram.clocks_per_cycle, 1, 16)?;
        power_of_two("dram.channels", dram.channels, 256)?;
        power_of_two("dram.banks", dram.banks, 64)?;
        power_of_two("dram.rows", dram.rows, 1 << 20)?;
        power_of_two("dram.columns", dram.columns, 1 << 12)?;
        if dram.bytes(self.l2.line.0) > 1 << 34 {
            return Err(out_of_range(
                "dram.rows",
                dram.rows,
                "at most 2^34 bytes of memory: 32-bit word addresses",
            ));
        }
        within("dram.read_queue", dram.read_queue, 1, 1 << 12)?;
        within("dram.write_queue", dram.write_queue, 1, 1 << 12)?;
        within("dram.write_drain_high", dram.write_drain_high, 1, dram.write_queue)?;
        within("dram.write_drain_low", dram.write_drain_low, 0, dram.write_drain_high - 1)?;
        self.check_timing()?;
        let power = &dram.power;
        within("dram.power.chips_per_channel", power.chips_per_channel, 1, 64)?;
        for (key, value) in [
            ("vdd_v", power.vdd_v),
            ("idd0_ma", power.idd0_ma),
            ("idd2n_ma", power.idd2n_ma),
            ("idd3n_ma", power.idd3n_ma),
            ("idd4r_ma", power.idd4r_ma),
            ("idd4w_ma", power.idd4w_ma),
            ("idd5_ma", power.idd5_ma),
        ] {
            if !(value.is_finite() && value >= 0.0) {
                return Err(out_of_range(format!("dram.power.{key}"), value, "finite, at least 0"));
            }
        }
        Ok(())
    }

    fn check_timing(&self) -> Result<(), DescriptionError> {
        let t = &self.dram.timing;
        for (key, clocks) in [
            ("activate_to_column", t.activate_to_column),
            ("precharge", t.precharge),
            ("read_latency", t.read_latency),
            ("write_latency", t.write_latency),
            ("activate_to_activate_same_bank", t.activate_to_activate_same_bank),
            ("activate_to_precharge", t.activate_to_precharge),
            ("activate_to_activate", t.activate_to_activate),
            ("four_activates", t.four_activates),
            ("write_recovery", t.write_recovery),
            ("write_to_read", t.write_to_read),
            ("read_to_precharge", t.read_to_precharge),
            ("column_to_column", t.column_to_column),
            ("burst", t.burst),
            ("refresh", t.refresh),
        ] {
            within(&format!("dram.timing.{key}"), clocks, 1, 1 << 16)?;
        }
        within("dram.timing.refresh_interval", t.refresh_interval, 2 * t.refresh, 1 << 24)
    }
}

fn check_cache(section: &str, cache: &Cache) -> Result<(), DescriptionError> {
    let key = |name: &str| format!("{section}.{name}");
    let power = |name: &str, value: u64, least: u64, most: u64| {
        if (least..=most).contains(&value) && value.is_power_of_two() {
            return Ok(());
        }
        Err(out_of_range(key(name), value, format!("a power of two of bytes from {least} to {most}")))
    };
    power("line", cache.line.0, 16, 256)?;
    power("size", cache.size.0, cache.line.0, 64 << 20)?;
    power_of_two(&key("banks"), cache.banks, MAX_BANKS)?;
    power_of_two(&key("associativity"), cache.associativity, cache.lines())?;
    within(&key("latency_cycles"), cache.latency_cycles, 1, MAX_LATENCY)?;
    for (name, value) in [("area_mm2", cache.area_mm2), ("energy_nj", cache.energy_nj)] {
        if let Some(value) = value.filter(|value| !(value.is_finite() && *value >= 0.0)) {
            return Err(out_of_range(key(name), value, "finite, at least 0"));
        }
    }
    Ok(())
}

fn within(key: &str, value: u32, least: u32, most: u32) -> Result<(), DescriptionError> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(out_of_range(key, value, format!("from {least} to {most}")))
}

fn power_of_two(key: &str, value: u32, most: u32) -> Result<(), DescriptionError> {
    if value.is_power_of_two() && value <= most {
        return Ok(());
    }
    Err(out_of_range(key, value, format!("a power of two from 1 to {most}")))
}
