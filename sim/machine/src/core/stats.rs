//! What threads did, counted.

use serde::{Deserialize, Serialize};

/// Thread-cycles of a multiprocessor by what the thread did; every thread-cycle is in exactly one class.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ThreadCycles {
    /// An instruction other than a nop was issued.
    pub issue: u64,
    /// An operand was not ready, loaded data included.
    pub data: u64,
    /// The execution unit was taken.
    pub units: u64,
    /// A cache bank or all miss registers were taken, or a memory queue was full.
    pub memory: u64,
    /// The instruction cache bank was taken.
    pub fetch: u64,
    /// A nop was issued.
    pub nop: u64,
    /// The thread had finished.
    pub halted: u64,
}

impl ThreadCycles {
    /// All of them.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.issue + self.data + self.units + self.memory + self.fetch + self.nop + self.halted
    }

    /// Adds those of `other`.
    pub fn merge(&mut self, other: &Self) {
        self.issue += other.issue;
        self.data += other.data;
        self.units += other.units;
        self.memory += other.memory;
        self.fetch += other.fetch;
        self.nop += other.nop;
        self.halted += other.halted;
    }
}
