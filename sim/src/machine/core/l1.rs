//! The first-level cache of a multiprocessor.

use super::outstanding::{Arrival, Outstanding, UNKNOWN, Waiter};
use super::stats::CacheCounts;
use super::tags::Tags;
use super::tm::QUANTUM;
use crate::machine::description::MachineDescription;
use crate::machine::program::Register;
use std::collections::VecDeque;

/// A multiprocessor's data cache. Times within the current quantum are slots.
#[derive(Clone, Debug)]
pub struct L1 {
    tags: Tags,
    enabled: bool,
    latency: u32,
    bank_mask: u32,
    line_shift: u32,
    /// Banks that are taken, by slot.
    busy: [u64; QUANTUM],
    /// Banks that a request to the chip takes if it is served, by slot.
    asked: [u64; QUANTUM],
    outstanding: Outstanding,
    /// Lines whose time of arrival is known, in its order.
    fills: VecDeque<(u32, u32)>,
    /// What happened.
    pub counts: CacheCounts,
}

/// Where the words of a load go.
#[derive(Clone, Copy, Debug)]
pub struct Target<'a> {
    /// The thread.
    pub thread: u8,
    /// Its registers.
    pub registers: &'a [Register],
}

/// What becomes of an access.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// The data can be used from this cycle on, or [`UNKNOWN`] if they have to arrive first.
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
            tags: Tags::new(cache),
            enabled: cache.enabled,
            latency: cache.latency_cycles,
            bank_mask: cache.banks - 1,
            line_shift: cache.line_words().trailing_zeros(),
            busy: [0; QUANTUM],
            asked: [0; QUANTUM],
            outstanding: Outstanding::default(),
            fills: VecDeque::new(),
            counts: CacheCounts::default(),
        }
    }

    /// Begins the quantum at cycle `start`: what has arrived by then is filled.
    #[inline]
    pub fn begin(&mut self, start: u32) {
        self.busy = [0; QUANTUM];
        self.asked = [0; QUANTUM];
        while let Some(&(arrival, line)) = self.fills.front() {
            if arrival > start {
                break;
            }
            self.fills.pop_front();
            self.tags.fill(line);
            self.outstanding.remove_arrived(line, arrival);
        }
    }

    /// Holds `line` from now on, in no time; whether it did before.
    pub fn warm(&mut self, line: u32) -> bool {
        let held = self.tags.hit(line);
        if !held {
            self.tags.fill(line);
        }
        held
    }

    #[inline(always)]
    fn bank(&self, address: u32) -> u64 {
        1 << (address & self.bank_mask)
    }

    /// A load of `address` in cycle `now`, which is `slot` of the quantum.
    #[inline(always)]
    pub fn load(&mut self, now: u32, slot: usize, address: u32, target: Target<'_>) -> Access {
        if self.asked[slot] & self.bank(address) != 0 {
            return Access::Ask;
        }
        let access = self.load_now(now, slot, address, target);
        if access == Access::Ask {
            self.asked[slot] |= self.bank(address);
        }
        access
    }

    /// [`L1::load`] after all earlier requests to the chip have been served.
    #[inline(always)]
    pub fn load_now(&mut self, now: u32, slot: usize, address: u32, target: Target<'_>) -> Access {
        let bank = self.bank(address);
        if self.enabled && self.busy[slot] & bank != 0 {
            self.counts.bank_conflicts += 1;
            return Access::Refused;
        }
        let line = address >> self.line_shift;
        if self.holds(now, line) {
            self.counts.loads += 1;
            self.counts.hits += 1;
            self.busy[slot] |= bank;
            return Access::Served(now + self.latency);
        }
        match self.outstanding.arrival(line) {
            Some(arrival) if arrival.filled > now => {
                self.counts.loads += 1;
                self.counts.joined += 1;
                self.busy[slot] |= bank;
                Access::Served(self.wait(now, line, arrival, target))
            }
            // It has been replaced since.
            _ => Access::Ask,
        }
    }

    /// Whether `line` is held in cycle `now`: what has arrived since the quantum began counts.
    #[inline(always)]
    fn holds(&mut self, now: u32, line: u32) -> bool {
        if self.fills.front().is_some_and(|(filled, _)| *filled <= now) && self.tags.is_enabled() {
            let arrived = self.fills.iter().rev().filter(|(filled, _)| *filled <= now);
            for &(_, other) in arrived {
                if other == line {
                    return true;
                }
                if self.tags.compete(other, line) {
                    return false;
                }
            }
        }
        self.tags.hit(line)
    }

    fn wait(&mut self, now: u32, line: u32, arrival: Arrival, target: Target<'_>) -> u32 {
        if arrival.usable == UNKNOWN {
            for &register in target.registers {
                self.outstanding.wait(line, Waiter { thread: target.thread, register });
            }
            return UNKNOWN;
        }
        arrival.usable.max(now + self.latency)
    }

    /// A store to `address` in slot `slot`: refused, or to be passed on to the chip.
    #[inline(always)]
    pub fn store(&mut self, slot: usize, address: u32) -> Access {
        let bank = self.bank(address);
        if self.asked[slot] & bank == 0 && self.store_now(slot, address) == Access::Refused {
            return Access::Refused;
        }
        self.asked[slot] |= bank;
        Access::Ask
    }

    /// [`L1::store`] after all earlier requests to the chip have been served.
    #[inline]
    pub fn store_now(&mut self, slot: usize, address: u32) -> Access {
        if self.enabled && self.busy[slot] & self.bank(address) != 0 {
            self.counts.bank_conflicts += 1;
            return Access::Refused;
        }
        Access::Ask
    }

    /// The chip has taken a load. Returns when its result can be used.
    pub fn taken(
        &mut self,
        now: u32,
        slot: usize,
        address: u32,
        arrival: Arrival,
        target: Target<'_>,
    ) -> u32 {
        let line = address >> self.line_shift;
        self.counts.loads += 1;
        self.busy[slot] |= self.bank(address);
        self.outstanding.insert(now, line, arrival);
        if arrival.filled != UNKNOWN {
            self.fill_at(arrival.filled, line);
        }
        self.wait(now, line, arrival, target)
    }

    /// The chip has taken a store.
    pub fn stored(&mut self, slot: usize, address: u32) {
        self.counts.stores += 1;
        self.busy[slot] |= self.bank(address);
    }

    fn fill_at(&mut self, arrival: u32, line: u32) {
        let at = self.fills.partition_point(|(other, _)| *other <= arrival);
        self.fills.insert(at, (arrival, line));
    }

    /// It is known now when `line` arrives; `wake` is called for everyone who waits for it.
    pub fn arrives(&mut self, line: u32, arrival: Arrival, wake: impl FnMut(Waiter)) {
        if self.outstanding.arrives(line, arrival, wake) {
            self.fill_at(arrival.filled, line);
        }
    }
}
