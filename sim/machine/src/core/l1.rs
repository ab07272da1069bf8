//! The first-level cache of a multiprocessor.

use super::banks::Banks;
use super::lines::Lines;
use super::outstanding::{Outstanding, UNKNOWN, Waiter};
use super::quantum::LONGEST as QUANTUM;
use super::stats::CacheCounts;
use crate::description::MachineDescription;
use crate::program::BoardEntry;

/// As many lines as no L1 has asked for: it has not been looked up.
pub const NOT_LOOKED_UP: u32 = u32::MAX;

/// A multiprocessor's data cache. Times within the current quantum are slots.
#[derive(Clone, Debug)]
pub struct L1 {
    lines: Lines,
    enabled: bool,
    /// Cycles from its lines to a register; none where there is no L1.
    pub latency_cycles: u32,
    line_shift: u32,
    /// Banks that are taken.
    busy: Banks,
    /// Banks that a request to the chip takes if it is served.
    asked: Banks,
    outstanding: Outstanding,
    /// Lines that the chip has been asked for.
    pub lines_asked: u32,
    /// What happened; `loads` leaves out the hits.
    counts: CacheCounts,
}

/// Where the words of a load go.
#[derive(Clone, Copy, Debug)]
pub struct Target<'a> {
    /// The thread.
    pub thread: u8,
    /// Its registers.
    pub entries: &'a [BoardEntry],
}

/// What becomes of an access.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// The data can be used from this cycle on, or [`UNKNOWN`] if they have to arrive first.
    Served(u32),
    /// The bank is taken.
    Refused,
    /// The chip has to serve it; see [`super::tm::Request::missed`].
    Ask(u32),
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
            lines_asked: 0,
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

    /// What happened so far.
    pub fn counts(&self) -> CacheCounts {
        CacheCounts { loads: self.counts.loads + self.counts.hits, ..self.counts }
    }

    /// Holds `line` from now on, in no time; whether it did before.
    pub fn warm(&mut self, line: u32) -> bool {
        self.lines.warm(line)
    }

    /// A load of `address` in cycle `now`, which is `slot` of the quantum, if it is a hit: the cycle from which on the data
    /// can be used. If not, [`L1::load`] says what becomes of it.
    #[inline(always)]
    pub fn hit(&mut self, now: u32, slot: usize, address: u32) -> Option<u32> {
        let taken = self.busy.slots(address) | self.asked.slots(address);
        if taken >> (slot % QUANTUM) & 1 != 0 || !self.lines.holds_since(now, address >> self.line_shift) {
            return None;
        }
        self.counts.hits += 1;
        self.busy.take(slot, address);
        Some(now + self.latency_cycles)
    }

    /// A load of `address` in the first of `slots` of the quantum that begins at cycle `start` in which it is not refused; in
    /// the end it still is. That slot comes back, too.
    pub fn load(
        &mut self,
        start: u32,
        slots: std::ops::Range<usize>,
        address: u32,
        target: Target<'_>,
    ) -> (Access, usize) {
        let asked = self.asked.slots(address);
        let busy = if self.enabled { self.busy.slots(address) } else { 0 };
        // Behind the quantum it is not refused, so that there is a slot.
        let open = u32::from(asked | !busy) | 1 << QUANTUM;
        let slot = (slots.start + (open >> slots.start).trailing_zeros() as usize).min(slots.end);
        self.counts.bank_conflicts += (slot - slots.start) as u64;
        if slot == slots.end {
            return (Access::Refused, slot);
        }
        if self.asked.is_taken(slot, address) {
            return (Access::Ask(NOT_LOOKED_UP), slot);
        }
        let access = self.load_now(start + slot as u32, slot, address, target);
        if let Access::Ask(_) = access {
            self.asked.take(slot, address);
        }
        (access, slot)
    }

    /// A load of `address` in cycle `now`, which is `slot` of the quantum, whose bank is free.
    #[inline(always)]
    pub fn load_now(&mut self, now: u32, slot: usize, address: u32, target: Target<'_>) -> Access {
        let line = address >> self.line_shift;
        if self.lines.holds(now, line) {
            self.counts.hits += 1;
            self.busy.take(slot, address);
            return Access::Served(now + self.latency_cycles);
        }
        match self.outstanding.arrival(line) {
            Some(arrival) if arrival > now => {
                self.counts.loads += 1;
                self.counts.joined += 1;
                self.busy.take(slot, address);
                if arrival == UNKNOWN {
                    self.wait(line, target);
                    return Access::Served(UNKNOWN);
                }
                Access::Served(arrival + self.latency_cycles)
            }
            // It has been replaced since.
            _ => Access::Ask(self.lines_asked),
        }
    }

    /// The registers of `target` wait for `line`, whose time of arrival is not known.
    fn wait(&mut self, line: u32, target: Target<'_>) {
        for &entry in target.entries {
            self.outstanding.wait(line, Waiter { thread: target.thread, entry });
        }
    }

    /// A store to `address` in slot `slot`: refused, or to be passed on to the chip.
    #[inline(always)]
    pub fn store(&mut self, slot: usize, address: u32) -> Access {
        if !self.asked.is_taken(slot, address) && self.refuses(slot, address) {
            return Access::Refused;
        }
        self.asked.take(slot, address);
        Access::Ask(NOT_LOOKED_UP)
    }

    /// Whether the bank of `address` is taken in slot `slot` by what the L1 has served or the chip has taken, which refuses a
    /// request to the chip.
    #[inline]
    pub fn refuses(&mut self, slot: usize, address: u32) -> bool {
        let refuses = self.enabled && self.busy.is_taken(slot, address);
        self.counts.bank_conflicts += u64::from(refuses);
        refuses
    }

    /// The chip has taken a load, whose line arrives in cycle `arrival`.
    pub fn taken(&mut self, now: u32, slot: usize, address: u32, arrival: u32, target: Target<'_>) {
        let line = address >> self.line_shift;
        self.lines_asked += 1;
        self.counts.loads += 1;
        self.busy.take(slot, address);
        self.outstanding.insert(now, line, arrival);
        if arrival == UNKNOWN {
            self.wait(line, target);
        } else {
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
