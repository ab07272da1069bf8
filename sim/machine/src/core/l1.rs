//! The first-level cache of a multiprocessor.

use super::banks::Banks;
use super::lines::Lines;
use super::outstanding::{Outstanding, UNKNOWN, Waiter};
use super::stats::CacheCounts;
use crate::description::MachineDescription;
use crate::program::Kind;

/// A multiprocessor's data cache. A slot is a cycle of the current quantum.
#[derive(Clone, Debug)]
pub struct L1 {
    lines: Lines,
    enabled: bool,
    /// Cycles from a hit until the word is in its register; 0 where the L1 is disabled.
    pub latency_cycles: u32,
    line_shift: u32,
    /// Banks that served accesses have taken.
    busy: Banks,
    /// Banks that requests to the chip will take if the chip serves them.
    asked: Banks,
    outstanding: Outstanding,
    /// What happened.
    pub counts: CacheCounts,
}

/// What becomes of an access.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// The words can be used from this cycle on. At [`UNKNOWN`] they come with a line whose time of arrival is not known.
    Served(u32),
    /// The bank is taken.
    Refused,
    /// The chip has to serve it.
    Ask,
}

impl L1 {
    pub fn new(machine: &MachineDescription) -> Self {
        let cache = &machine.l1;
        Self {
            lines: Lines::new(cache),
            enabled: cache.enabled,
            latency_cycles: if cache.enabled { cache.latency_cycles } else { 0 },
            line_shift: cache.line_words().trailing_zeros(),
            busy: Banks::new(cache.banks),
            asked: Banks::new(cache.banks),
            outstanding: Outstanding::default(),
            counts: CacheCounts::default(),
        }
    }

    /// Begins the quantum at cycle `start`: what has arrived by then is filled.
    #[inline]
    pub fn begin(&mut self, start: u32) {
        self.busy.clear();
        self.asked.clear();
        let outstanding = &mut self.outstanding;
        self.lines.begin(start, |line, arrival| outstanding.remove_arrived(line, arrival));
    }

    /// Puts `line` into the cache in no time. Returns whether it was there before.
    pub fn warm(&mut self, line: u32) -> bool {
        self.lines.warm(line)
    }

    /// A load or store of a thread at `address` in cycle `now`, which is `slot` of the quantum.
    #[inline(always)]
    pub fn access(&mut self, kind: Kind, now: u32, slot: usize, address: u32) -> Access {
        // The chip decides which of several requests to it gets the bank.
        if self.asked.is_taken(slot, address) {
            return Access::Ask;
        }
        if self.refuses(slot, address) {
            return Access::Refused;
        }
        if kind == Kind::Load
            && let Some(ready) = self.find(now, slot, address)
        {
            return Access::Served(ready);
        }
        self.asked.take(slot, address);
        Access::Ask
    }

    /// Whether the bank of `address` is taken in slot `slot` by what the L1 has served or the chip has taken, which refuses an
    /// access.
    #[inline(always)]
    pub fn refuses(&mut self, slot: usize, address: u32) -> bool {
        let refuses = self.enabled && self.busy.is_taken(slot, address);
        if refuses {
            self.counts.bank_conflicts += 1;
        }
        refuses
    }

    /// A load of `address` in cycle `now`, which is `slot` of the quantum, whose bank is free: when its words can be used, if their
    /// line is held or on its way.
    #[inline(always)]
    pub fn find(&mut self, now: u32, slot: usize, address: u32) -> Option<u32> {
        let line = address >> self.line_shift;
        let ready = if self.lines.holds(now, line) {
            self.counts.hits += 1;
            now + self.latency_cycles
        } else {
            self.join(now, line)?
        };
        self.counts.loads += 1;
        self.busy.take(slot, address);
        Some(ready)
    }

    /// When the words of `line` can be used, if it is on its way in cycle `now`.
    fn join(&mut self, now: u32, line: u32) -> Option<u32> {
        // A line that has arrived and is not held has been replaced since.
        let arrival = self.outstanding.arrival(line).filter(|arrival| *arrival > now)?;
        self.counts.joined += 1;
        Some(if arrival == UNKNOWN { UNKNOWN } else { arrival + self.latency_cycles })
    }

    /// `waiter` waits for the line of `address`, whose time of arrival is not known.
    pub fn wait(&mut self, address: u32, waiter: Waiter) {
        self.outstanding.wait(address >> self.line_shift, waiter);
    }

    /// The chip has taken a load, whose line arrives in cycle `arrival`.
    pub fn taken(&mut self, now: u32, slot: usize, address: u32, arrival: u32) {
        let line = address >> self.line_shift;
        self.counts.loads += 1;
        self.busy.take(slot, address);
        self.outstanding.insert(now, line, arrival);
        if arrival != UNKNOWN {
            self.lines.arrives(line, arrival);
        }
    }

    /// The chip has taken a store.
    pub fn stored(&mut self, slot: usize, address: u32) {
        self.counts.stores += 1;
        self.busy.take(slot, address);
    }

    /// It is known now when `line` arrives; `wake` is called for everyone who waits for it.
    pub fn arrives(&mut self, line: u32, arrival: u32, wake: impl FnMut(Waiter)) {
        if self.outstanding.arrives(line, arrival, wake) {
            self.lines.arrives(line, arrival);
        }
    }
}
