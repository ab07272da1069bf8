//! What happened, counted.

use serde::{Deserialize, Serialize};

/// Accesses of a cache.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CacheCounts {
    /// Loads that were taken.
    pub loads: u64,
    /// Loads that found their line.
    pub hits: u64,
    /// Loads that joined a request under way.
    pub joined: u64,
    /// Stores that passed.
    pub stores: u64,
    /// Tries that were refused as the bank was taken.
    pub bank_conflicts: u64,
    /// Tries to load that were refused as no miss register was free.
    pub register_conflicts: u64,
}

impl CacheCounts {
    /// Adds those of `other`.
    pub fn merge(&mut self, other: &Self) {
        self.loads += other.loads;
        self.hits += other.hits;
        self.joined += other.joined;
        self.stores += other.stores;
        self.bank_conflicts += other.bank_conflicts;
        self.register_conflicts += other.register_conflicts;
    }

    /// All of `counts` together.
    #[must_use]
    pub fn sum<'a>(counts: impl Iterator<Item = &'a Self>) -> Self {
        let mut sum = Self::default();
        counts.for_each(|counts| sum.merge(counts));
        sum
    }

    /// Share of loads that found their line.
    #[must_use]
    pub fn hit_rate(&self) -> f64 {
        if self.loads == 0 { 0.0 } else { self.hits as f64 / self.loads as f64 }
    }
}

/// What the memory did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DramCounts {
    /// Lines read.
    pub reads: u64,
    /// Lines written.
    pub writes: u64,
    /// Reads that joined another of the same line, or were served by a waiting write.
    pub merged_reads: u64,
    /// Writes that joined another of the same line.
    pub merged_writes: u64,
    /// Rows opened.
    pub activates: u64,
    /// Refreshes.
    pub refreshes: u64,
    /// DRAM clocks between arrival and data of all reads together.
    pub read_latency_clocks: u64,
    /// Channel-clocks with an open row.
    pub active_clocks: u64,
    /// Requests that were refused as the queue was full.
    pub refused: u64,
}

impl DramCounts {
    /// Adds those of `other`.
    pub fn merge(&mut self, other: &Self) {
        self.reads += other.reads;
        self.writes += other.writes;
        self.merged_reads += other.merged_reads;
        self.merged_writes += other.merged_writes;
        self.activates += other.activates;
        self.refreshes += other.refreshes;
        self.read_latency_clocks += other.read_latency_clocks;
        self.active_clocks += other.active_clocks;
        self.refused += other.refused;
    }

    /// Share of accesses that found their row open.
    #[must_use]
    pub fn row_hit_rate(&self) -> f64 {
        let accesses = self.reads + self.writes;
        if accesses == 0 { 0.0 } else { 1.0 - (self.activates.min(accesses) as f64 / accesses as f64) }
    }
}
