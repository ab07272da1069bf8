//! The second-level cache of a partition.

use super::stats::CacheCounts;
use super::tags::Tags;
use crate::machine::description::Cache;

/// A partition's cache.
#[derive(Clone, Debug)]
pub struct L2 {
    tags: Tags,
    bank_mask: u32,
    busy: u64,
    busy_in: u32,
    /// What happened.
    pub counts: CacheCounts,
}

impl L2 {
    pub fn new(cache: &Cache) -> Self {
        Self {
            tags: Tags::new(cache),
            bank_mask: cache.banks - 1,
            busy: 0,
            busy_in: u32::MAX,
            counts: CacheCounts::default(),
        }
    }

    /// Takes the bank of word `address` for cycle `now`; false if it is taken.
    pub fn take_bank(&mut self, now: u32, address: u32) -> bool {
        if self.busy_in != now {
            self.busy_in = now;
            self.busy = 0;
        }
        let bank = 1 << (address & self.bank_mask);
        if self.busy & bank != 0 {
            self.counts.bank_conflicts += 1;
            return false;
        }
        self.busy |= bank;
        true
    }

    /// Whether `line` is held.
    pub fn hit(&mut self, line: u32) -> bool {
        self.tags.hit(line)
    }

    /// A line has arrived from memory.
    pub fn fill(&mut self, line: u32) {
        self.tags.fill(line);
    }
}
