//! The DRAM: what exists, its timing and its power.

use super::check::{OutOfRange, amount, power_of_two, within};
use super::words::one_of;
use serde::{Deserialize, Deserializer, Serialize};

/// The DRAM.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Dram {
    /// DRAM clocks per cycle of the machine; times of `timing` count DRAM clocks.
    pub clocks_per_cycle: u32,
    /// Channels, each with one rank.
    pub channels: u32,
    /// Banks of a rank.
    pub banks: u32,
    /// Rows of a bank.
    pub rows: u32,
    /// Lines of a row.
    pub columns: u32,
    /// Which bits of a line's number select what.
    pub mapping: Mapping,
    /// Reads that a channel holds.
    pub read_queue: u32,
    /// Writes that a channel holds.
    pub write_queue: u32,
    /// Writes that a channel waits for before it serves them in preference to reads.
    pub write_drain_high: u32,
    /// Writes at which it turns to reads again.
    pub write_drain_low: u32,
    /// Timing in DRAM clocks.
    pub timing: DramTiming,
    /// Currents, for energy.
    pub power: DramPower,
}

impl Dram {
    /// Bytes of the whole DRAM with lines of `line` bytes.
    #[must_use]
    pub fn bytes(&self, line: u64) -> u64 {
        u64::from(self.channels)
            * u64::from(self.banks)
            * u64::from(self.rows)
            * u64::from(self.columns)
            * line
    }

    /// Channel, bank and row of a line.
    #[must_use]
    pub fn place(&self, line: u32) -> (usize, u32, u32) {
        let mut rest = line;
        let mut take = |size: u32| {
            let field = rest & (size - 1);
            rest >>= size.trailing_zeros();
            field
        };
        let (channel, bank) = match self.mapping {
            Mapping::ColumnChannelBankRow => {
                take(self.columns);
                (take(self.channels), take(self.banks))
            }
            Mapping::ChannelColumnBankRow => {
                let channel = take(self.channels);
                take(self.columns);
                (channel, take(self.banks))
            }
            Mapping::ChannelBankColumnRow => {
                let (channel, bank) = (take(self.channels), take(self.banks));
                take(self.columns);
                (channel, bank)
            }
        };
        (channel as usize, bank, rest & (self.rows - 1))
    }

    /// Whether it can be built for lines of `line` bytes.
    ///
    /// # Errors
    /// The first key that is out of range.
    pub fn check(&self, line: u64) -> Result<(), OutOfRange> {
        within("dram.clocks_per_cycle", self.clocks_per_cycle, 1, 16)?;
        power_of_two("dram.channels", self.channels, 256)?;
        power_of_two("dram.banks", self.banks, 64)?;
        power_of_two("dram.rows", self.rows, 1 << 20)?;
        power_of_two("dram.columns", self.columns, 1 << 12)?;
        if self.bytes(line) > 1 << 34 {
            let rule = "at most 2^34 bytes of memory: 32-bit word addresses";
            return Err(OutOfRange::new("dram.rows", self.rows, rule));
        }
        within("dram.read_queue", self.read_queue, 1, 1 << 12)?;
        within("dram.write_queue", self.write_queue, 1, 1 << 12)?;
        within("dram.write_drain_high", self.write_drain_high, 1, self.write_queue)?;
        within("dram.write_drain_low", self.write_drain_low, 0, self.write_drain_high - 1)?;
        self.timing.check()?;
        self.power.check()
    }
}

/// Order of the fields of a line's number, from the least significant bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mapping {
    /// A row's lines are adjacent.
    ColumnChannelBankRow,
    /// Adjacent lines are in different channels, and the next ones of a channel in the same row.
    ChannelColumnBankRow,
    /// Adjacent lines are in different channels, and the next ones of a channel in different banks.
    ChannelBankColumnRow,
}

impl<'de> Deserialize<'de> for Mapping {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        one_of(
            deserializer,
            &[
                ("column-channel-bank-row", Self::ColumnChannelBankRow),
                ("channel-column-bank-row", Self::ChannelColumnBankRow),
                ("channel-bank-column-row", Self::ChannelBankColumnRow),
            ],
        )
    }
}

/// Least distances between DRAM commands, in DRAM clocks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DramTiming {
    /// tRCD.
    pub activate_to_column: u32,
    /// tRP.
    pub precharge: u32,
    /// tCAS.
    pub read_latency: u32,
    /// tCWD.
    pub write_latency: u32,
    /// tRC.
    pub activate_to_activate_same_bank: u32,
    /// tRAS.
    pub activate_to_precharge: u32,
    /// tRRD.
    pub activate_to_activate: u32,
    /// tFAW.
    pub four_activates: u32,
    /// tWR.
    pub write_recovery: u32,
    /// tWTR.
    pub write_to_read: u32,
    /// tRTP.
    pub read_to_precharge: u32,
    /// tCCD.
    pub column_to_column: u32,
    /// Clocks that a line takes on the data bus.
    pub burst: u32,
    /// tRFC.
    pub refresh: u32,
    /// tREFI.
    pub refresh_interval: u32,
}

impl DramTiming {
    /// Clocks in which a row is opened, used and closed, one after the other.
    #[must_use]
    pub fn turn(&self) -> u32 {
        self.activate_to_column
            + self.read_latency.max(self.write_latency)
            + self.burst
            + self.write_recovery
            + self.activate_to_precharge
            + self.activate_to_activate_same_bank
            + self.precharge
    }

    fn check(&self) -> Result<(), OutOfRange> {
        for (key, clocks) in [
            ("activate_to_column", self.activate_to_column),
            ("precharge", self.precharge),
            ("read_latency", self.read_latency),
            ("write_latency", self.write_latency),
            ("activate_to_activate_same_bank", self.activate_to_activate_same_bank),
            ("activate_to_precharge", self.activate_to_precharge),
            ("activate_to_activate", self.activate_to_activate),
            ("four_activates", self.four_activates),
            ("write_recovery", self.write_recovery),
            ("write_to_read", self.write_to_read),
            ("read_to_precharge", self.read_to_precharge),
            ("column_to_column", self.column_to_column),
            ("burst", self.burst),
            ("refresh", self.refresh),
        ] {
            within(&format!("dram.timing.{key}"), clocks, 1, 1 << 16)?;
        }
        // Each refresh closes all rows. Between two of them a row has to be opened, used and closed, or nothing is ever read.
        let least = (2 * self.refresh).max(self.refresh + self.turn());
        if (least..=1 << 24).contains(&self.refresh_interval) {
            return Ok(());
        }
        let rule = format!(
            "from {least} to {}: what a refresh takes, and time to open, use and close a row",
            1 << 24
        );
        Err(OutOfRange::new("dram.timing.refresh_interval", self.refresh_interval, rule))
    }
}

/// Supply of one chip, named as in Micron TN-41-01, "Calculating Memory System Power for DDR3".
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(missing_docs, reason = "named as in the technical note")]
pub struct DramPower {
    pub chips_per_channel: u32,
    pub vdd_v: f64,
    pub idd0_ma: f64,
    pub idd2n_ma: f64,
    pub idd3n_ma: f64,
    pub idd4r_ma: f64,
    pub idd4w_ma: f64,
    pub idd5_ma: f64,
}

impl DramPower {
    fn check(&self) -> Result<(), OutOfRange> {
        within("dram.power.chips_per_channel", self.chips_per_channel, 1, 64)?;
        for (key, value) in [
            ("vdd_v", self.vdd_v),
            ("idd0_ma", self.idd0_ma),
            ("idd2n_ma", self.idd2n_ma),
            ("idd3n_ma", self.idd3n_ma),
            ("idd4r_ma", self.idd4r_ma),
            ("idd4w_ma", self.idd4w_ma),
            ("idd5_ma", self.idd5_ma),
        ] {
            amount(&format!("dram.power.{key}"), value)?;
        }
        Ok(())
    }
}
