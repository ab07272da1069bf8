//! The second-level cache of a partition.

use super::banks::Banks;
use super::lines::Lines;
use super::stats::CacheCounts;
use crate::description::Cache;

/// A partition's cache.
#[derive(Clone, Debug)]
pub struct L2 {
    lines: Lines,
    /// Banks that served accesses have taken.
    busy: Banks,
    /// What happened.
    pub counts: CacheCounts,
}

impl L2 {
    pub fn new(cache: &Cache) -> Self {
        Self { lines: Lines::new(cache), busy: Banks::new(cache.banks), counts: CacheCounts::default() }
    }

    /// Begins the quantum at cycle `start`: what has arrived by then is filled.
    pub fn begin(&mut self, start: u32) {
        self.busy.clear();
        self.lines.begin(start, |_, _| {});
    }

    /// It is known that `line` arrives from memory in cycle `cycle`.
    pub fn arrives(&mut self, line: u32, cycle: u32) {
        self.lines.arrives(line, cycle);
    }

    /// Whether the bank of word `address` is taken in slot `slot`, which refuses a request.
    pub fn refuses(&mut self, slot: usize, address: u32) -> bool {
        if self.busy.is_taken(slot, address) {
            self.counts.bank_conflicts += 1;
            return true;
        }
        false
    }

    /// Takes the bank of word `address` in slot `slot`, for an access that is served.
    pub fn take(&mut self, slot: usize, address: u32) {
        self.busy.take(slot, address);
    }

    /// Puts `line` into the cache in no time.
    pub fn warm(&mut self, line: u32) {
        self.lines.warm(line);
    }

    /// Whether `line` is held in cycle `now`.
    pub fn hit(&mut self, now: u32, line: u32) -> bool {
        self.lines.holds(now, line)
    }
}
