//! A port: a first-level cache, and what is on its way to it.

use crate::CacheCounts;
use crate::banks::Banks;
use crate::description::Cache;
use crate::lines::Lines;
use crate::outstanding::{Outstanding, UNKNOWN};
use crate::request::Access;

/// A first-level cache with the lines on their way to it. A slot is a cycle of the current quantum, counted from its start.
#[derive(Clone, Debug)]
pub struct Port {
    lines: Lines,
    enabled: bool,
    /// Cycles from a hit until the word can be used; 0 where the cache is disabled.
    latency_cycles: u32,
    line_shift: u32,
    /// Banks that served accesses have taken.
    busy: Banks,
    /// Banks that a request that goes beyond the port will take if it is served.
    asked: Banks,
    outstanding: Outstanding,
    /// Lines that may be on their way at a time, if it is not 0.
    miss_registers: u32,
    /// What happened.
    pub(crate) counts: CacheCounts,
}

/// What a port answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Near {
    /// The words can be used from this cycle on.
    At(u32),
    /// The line is on its way, and it is not known yet when it arrives.
    Later,
    /// The bank is taken.
    Refused,
    /// [`Memory::serve`](crate::Memory::serve) has to answer.
    Beyond,
}

impl Port {
    pub(crate) fn new(cache: &Cache) -> Self {
        Self {
            lines: Lines::new(cache),
            enabled: cache.enabled,
            latency_cycles: if cache.enabled { cache.latency_cycles } else { 0 },
            line_shift: cache.line_words().trailing_zeros(),
            busy: Banks::new(cache),
            asked: Banks::new(&Cache { ports: 1, ..*cache }),
            outstanding: Outstanding::default(),
            miss_registers: cache.miss_registers,
            counts: CacheCounts::default(),
        }
    }

    /// Cycles from a hit until the word can be used; 0 where the cache is disabled.
    pub(crate) fn latency_cycles(&self) -> u32 {
        self.latency_cycles
    }

    /// Begins the quantum at cycle `start`: what has arrived by then is filled.
    #[inline]
    pub(crate) fn begin(&mut self, start: u32) {
        self.busy.clear();
        self.asked.clear();
        let outstanding = &mut self.outstanding;
        self.lines.begin(start, |line, arrival| outstanding.remove_arrived(line, arrival));
    }

    /// Puts `line` into the cache in no time. Returns whether it was there before.
    pub(crate) fn warm(&mut self, line: u32) -> bool {
        self.lines.warm(line)
    }

    /// How many of `words` words from `address` on lie in one line, and come with one request.
    #[inline(always)]
    #[must_use]
    pub fn within_line(&self, address: u32, words: u32) -> u32 {
        let line_words = 1 << self.line_shift;
        words.min(line_words - address % line_words)
    }

    /// A client asks for words from `address` on in cycle `now`, which is `slot` of the quantum.
    #[inline(always)]
    pub fn ask(&mut self, access: Access, now: u32, slot: usize, address: u32) -> Near {
        let bank = self.bank(address);
        // Which of several requests gets the bank is decided beyond the port.
        if self.asked.is_taken(slot, bank) {
            return Near::Beyond;
        }
        if self.refuses(slot, bank) {
            return Near::Refused;
        }
        if access == Access::Load
            && let Some(ready) = self.find(now, slot, bank, address)
        {
            return if ready == UNKNOWN { Near::Later } else { Near::At(ready) };
        }
        self.asked.take(slot, bank);
        Near::Beyond
    }

    /// The bank of word `address`.
    #[inline(always)]
    pub(crate) fn bank(&self, address: u32) -> usize {
        self.busy.of(address)
    }

    /// Whether `bank` is taken in slot `slot` by what has been served, which refuses a request.
    #[inline(always)]
    pub(crate) fn refuses(&mut self, slot: usize, bank: usize) -> bool {
        let refuses = self.enabled && self.busy.is_taken(slot, bank);
        if refuses {
            self.counts.bank_conflicts += 1;
        }
        refuses
    }

    /// A load of `address` in cycle `now`, which is `slot` of the quantum, from `bank`, which is free: when its words can be used, if
    /// their line is held or on its way. At [`UNKNOWN`] the time of arrival is not known yet.
    #[inline(always)]
    pub(crate) fn find(&mut self, now: u32, slot: usize, bank: usize, address: u32) -> Option<u32> {
        let line = address >> self.line_shift;
        let ready = if self.lines.holds(now, line) {
            self.counts.hits += 1;
            now + self.latency_cycles
        } else {
            self.join(now, line)?
        };
        self.counts.loads += 1;
        self.busy.take(slot, bank);
        Some(ready)
    }

    /// When the words of `line` can be used, if it is on its way in cycle `now`.
    #[inline]
    fn join(&mut self, now: u32, line: u32) -> Option<u32> {
        // A line that has arrived and is not held has been replaced since.
        let arrival = self.outstanding.arrival(line).filter(|arrival| *arrival > now)?;
        self.counts.joined += 1;
        Some(if arrival == UNKNOWN { UNKNOWN } else { arrival + self.latency_cycles })
    }

    /// Whether all registers for lines on their way are taken in cycle `now`, which refuses a load of `address` that has to go
    /// beyond the port.
    #[inline]
    pub(crate) fn is_full(&mut self, now: u32, address: u32) -> bool {
        let is_full = !self.outstanding.has_room(now, address >> self.line_shift, self.miss_registers);
        self.counts.register_conflicts += u64::from(is_full);
        is_full
    }

    /// The client of number `number` waits for the line of `address`, which it was told to come later. It may wait with several
    /// numbers.
    ///
    /// # Panics
    /// If the line is not on its way.
    pub fn wait(&mut self, address: u32, number: u16) {
        self.outstanding.wait(address >> self.line_shift, number);
    }

    /// A load has been taken beyond the port, and its line arrives in cycle `arrival`.
    pub(crate) fn taken(&mut self, now: u32, slot: usize, bank: usize, address: u32, arrival: u32) {
        let line = address >> self.line_shift;
        self.counts.loads += 1;
        self.busy.take(slot, bank);
        self.outstanding.insert(now, line, arrival);
        if arrival != UNKNOWN {
            self.lines.arrives(line, arrival);
        }
    }

    /// A store has been taken beyond the port.
    pub(crate) fn stored(&mut self, slot: usize, bank: usize) {
        self.counts.stores += 1;
        self.busy.take(slot, bank);
    }

    /// It is known now when `line` arrives; `wake` is called with the number of everyone who waits for it.
    pub(crate) fn arrives(&mut self, line: u32, arrival: u32, wake: impl FnMut(u16)) {
        if self.outstanding.arrives(line, arrival, wake) {
            self.lines.arrives(line, arrival);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::tests::cache;

    #[test]
    fn a_bank_serves_one_request_a_cycle_and_refuses_one_that_comes_early() {
        let cache = cache();
        let latency = cache.latency_cycles;
        let mut port = Port::new(&cache);
        port.begin(0);
        // A line that arrives in cycle 4 can be joined a cycle before, and is held from then on.
        assert_eq!(port.find(0, 0, 0, 64), None);
        port.taken(0, 0, 0, 64, 4);
        assert!(port.refuses(0, port.bank(64 + 8)), "the same bank in the same cycle");
        assert!(!port.refuses(0, port.bank(64 + 7)) && !port.refuses(1, port.bank(64 + 8)));
        assert_eq!(port.find(3, 3, 1, 65), Some(4 + latency));
        assert_eq!((port.counts.joined, port.counts.hits), (1, 0));
        assert_eq!(port.find(4, 4, 1, 65), Some(4 + latency));
        assert_eq!((port.counts.joined, port.counts.hits), (1, 1));
        assert_eq!(port.counts.bank_conflicts, 1);
    }

    #[test]
    fn a_request_brings_what_lies_in_the_line_of_its_first_word() {
        let port = Port::new(&cache());
        let brought = [(0, 1), (0, 16), (0, 17), (62, 4), (63, 4), (64, 4)];
        assert_eq!(brought.map(|(address, words)| port.within_line(address, words)), [1, 16, 16, 2, 1, 4]);
    }
}
