//! The second-level cache of a partition.

use crate::banks::Banks;
use crate::description::Cache;
use crate::lines::Lines;
use crate::outstanding::{Outstanding, UNKNOWN};
use crate::stats::CacheCounts;

/// A partition's cache.
#[derive(Clone, Debug)]
pub struct L2 {
    lines: Lines,
    /// Banks that served accesses have taken.
    busy: Banks,
    /// Lines on their way, which are noted where registers limit them.
    outstanding: Outstanding,
    /// Lines that may be on their way at a time, if it is not 0.
    miss_registers: u32,
    /// What happened.
    pub counts: CacheCounts,
}

impl L2 {
    pub fn new(cache: &Cache) -> Self {
        Self {
            lines: Lines::new(cache),
            busy: Banks::new(cache),
            outstanding: Outstanding::default(),
            miss_registers: cache.miss_registers,
            counts: CacheCounts::default(),
        }
    }

    /// Begins the quantum at cycle `start`: what has arrived by then is filled.
    pub fn begin(&mut self, start: u32) {
        self.busy.clear();
        let outstanding = &mut self.outstanding;
        self.lines.begin(start, |line, arrival| outstanding.remove_arrived(line, arrival));
    }

    /// It is known that `line` arrives from memory in cycle `cycle`.
    pub fn arrives(&mut self, line: u32, cycle: u32) {
        self.lines.arrives(line, cycle);
        self.outstanding.arrives(line, cycle, |_| ());
    }

    /// Whether all registers for lines on their way are taken in cycle `now`, which refuses a load of `line` that is not held.
    pub fn is_full(&mut self, now: u32, line: u32) -> bool {
        let is_full = !self.outstanding.has_room(now, line, self.miss_registers);
        self.counts.register_conflicts += u64::from(is_full);
        is_full
    }

    /// `line` is on its way from memory in cycle `now`.
    pub fn asked(&mut self, now: u32, line: u32) {
        if self.miss_registers > 0 && self.outstanding.arrival(line).is_none_or(|arrival| arrival <= now) {
            self.outstanding.insert(now, line, UNKNOWN);
        }
    }

    /// Whether the bank of word `address` is taken in slot `slot`, which refuses a request.
    pub fn refuses(&mut self, slot: usize, address: u32) -> bool {
        if self.busy.is_taken(slot, self.busy.of(address)) {
            self.counts.bank_conflicts += 1;
            return true;
        }
        false
    }

    /// Takes the bank of word `address` in slot `slot`, for an access that is served.
    pub fn take(&mut self, slot: usize, address: u32) {
        self.busy.take(slot, self.busy.of(address));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::tests::cache;

    #[test]
    fn a_bank_serves_one_request_a_cycle_and_a_line_is_held_from_its_arrival_on() {
        let cache = cache();
        let mut l2 = L2::new(&cache);
        l2.begin(0);
        assert!(!l2.refuses(0, 5));
        l2.take(0, 5);
        assert!(l2.refuses(0, 5 + cache.banks), "the same bank in the same cycle");
        assert!(!l2.refuses(0, 6) && !l2.refuses(1, 5));
        l2.arrives(9, 6);
        assert!(!l2.hit(5, 9) && l2.hit(6, 9));
    }
}
