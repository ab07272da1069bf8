//! The memory: what exists, its timing and its power.

use serde::{Deserialize, Serialize};

/// The memory.
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
    /// Bytes of the whole memory with lines of `line` bytes.
    #[must_use]
    pub fn bytes(&self, line: u64) -> u64 {
        u64::from(self.channels)
            * u64::from(self.banks)
            * u64::from(self.rows)
            * u64::from(self.columns)
            * line
    }
}

/// Order of the fields of a line's number, from the least significant bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mapping {
    /// A row's lines are adjacent.
    ColumnChannelBankRow,
    /// Adjacent lines are in different channels.
    ChannelColumnBankRow,
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
