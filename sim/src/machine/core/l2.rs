//! The second-level cache of a partition.

use super::lines::Lines;
use super::stats::CacheCounts;
use super::tm::QUANTUM;
use crate::machine::description::Cache;

/// A partition's cache.
#[derive(Clone, Debug)]
pub struct L2 {
    lines: Lines,
    bank_mask: u32,
    /// Banks that are taken, by slot of the quantum.
    busy: [u64; QUANTUM],
    /// What happened.
    pub counts: CacheCounts,
}

impl L2 {
    pub fn new(cache: &Cache) -> Self {
        Self {
            lines: Lines::new(cache),
            bank_mask: cache.banks - 1,
            busy: [0; QUANTUM],
            counts: CacheCounts::default(),
        }
    }

    /// Begins the quantum at cycle `start`: what has arrived by then is filled.
    pub fn begin(&mut self, start: u32) {
        self.busy = [0; QUANTUM];
        self.lines.begin(start, |_, _| {});
    }

    /// It is known that `line` arrives from memory in cycle `cycle`.
    pub fn arrives(&mut self, line: u32, cycle: u32) {
        self.lines.arrives(line, cycle);
    }

    /// Whether the bank of word `address` is free in slot `slot`.
    pub fn is_free(&mut self, slot: usize, address: u32) -> bool {
        let free = self.busy[slot] & self.bank(address) == 0;
        if !free {
            self.counts.bank_conflicts += 1;
        }
        free
    }

    /// Takes the bank of word `address` in slot `slot`, for an access that is served.
    pub fn take(&mut self, slot: usize, address: u32) {
        self.busy[slot] |= self.bank(address);
    }

    fn bank(&self, address: u32) -> u64 {
        1 << (address & self.bank_mask)
    }

    /// Holds `line` from now on, in no time.
    pub fn warm(&mut self, line: u32) {
        self.lines.warm(line);
    }

    /// Whether `line` is held in cycle `now`.
    pub fn hit(&mut self, now: u32, line: u32) -> bool {
        self.lines.holds(now, line)
    }
}
