//! The second-level cache of a partition.

use super::stats::CacheCounts;
use super::tags::Tags;
use super::tm::QUANTUM;
use crate::machine::description::Cache;
use std::collections::VecDeque;

/// A partition's cache.
#[derive(Clone, Debug)]
pub struct L2 {
    tags: Tags,
    bank_mask: u32,
    /// Banks that are taken, by slot of the quantum.
    busy: [u64; QUANTUM],
    /// Lines on their way from memory, in the order of arrival.
    fills: VecDeque<(u32, u32)>,
    /// What happened.
    pub counts: CacheCounts,
}

impl L2 {
    pub fn new(cache: &Cache) -> Self {
        Self {
            tags: Tags::new(cache),
            bank_mask: cache.banks - 1,
            busy: [0; QUANTUM],
            fills: VecDeque::new(),
            counts: CacheCounts::default(),
        }
    }

    /// Begins the quantum at cycle `start`: what has arrived by then is filled.
    pub fn begin(&mut self, start: u32) {
        self.busy = [0; QUANTUM];
        while let Some(&(cycle, line)) = self.fills.front() {
            if cycle > start {
                break;
            }
            self.fills.pop_front();
            self.tags.fill(line);
        }
    }

    /// It is known that `line` arrives from memory in cycle `cycle`.
    pub fn arrives(&mut self, line: u32, cycle: u32) {
        let at = self.fills.partition_point(|(other, _)| *other <= cycle);
        self.fills.insert(at, (cycle, line));
    }

    /// Takes the bank of word `address` in slot `slot`; false if it is taken.
    pub fn take_bank(&mut self, slot: usize, address: u32) -> bool {
        let bank = 1 << (address & self.bank_mask);
        if self.busy[slot] & bank != 0 {
            self.counts.bank_conflicts += 1;
            return false;
        }
        self.busy[slot] |= bank;
        true
    }

    /// Whether `line` is held.
    pub fn hit(&mut self, line: u32) -> bool {
        self.tags.hit(line)
    }
}
