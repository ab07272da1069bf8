//! The lines of a cache, and those that are about to arrive.

use super::tags::Tags;
use crate::machine::description::Cache;
use std::collections::VecDeque;

/// Which lines a cache holds from which cycle on.
#[derive(Clone, Debug)]
pub struct Lines {
    tags: Tags,
    /// Cycle and line of what arrives, in the order of arrival.
    arrivals: VecDeque<(u32, u32)>,
}

impl Lines {
    /// An empty cache.
    pub fn new(cache: &Cache) -> Self {
        Self { tags: Tags::new(cache), arrivals: VecDeque::new() }
    }

    /// Begins the quantum at cycle `start`: fills what has arrived by then, and passes line and cycle to `filled`.
    #[inline]
    pub fn begin(&mut self, start: u32, mut filled: impl FnMut(u32, u32)) {
        while let Some(&(cycle, line)) = self.arrivals.front() {
            if cycle > start {
                break;
            }
            self.arrivals.pop_front();
            self.tags.fill(line);
            filled(line, cycle);
        }
    }

    /// It is known that `line` arrives in cycle `cycle`.
    pub fn arrives(&mut self, line: u32, cycle: u32) {
        let at = self.arrivals.partition_point(|(other, _)| *other <= cycle);
        self.arrivals.insert(at, (cycle, line));
    }

    /// Holds `line` from now on, in no time; whether it did before.
    pub fn warm(&mut self, line: u32) -> bool {
        let held = self.tags.hit(line);
        if !held {
            self.tags.fill(line);
        }
        held
    }

    /// Whether `line` is held in cycle `now`: what has arrived since the quantum began counts.
    #[inline(always)]
    pub fn holds(&mut self, now: u32, line: u32) -> bool {
        if self.arrivals.front().is_some_and(|(cycle, _)| *cycle <= now) && self.tags.is_enabled() {
            let arrived = self.arrivals.iter().rev().filter(|(cycle, _)| *cycle <= now);
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
}
