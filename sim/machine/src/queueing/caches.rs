//! Caches by their tags: which lines they hold, and from which cycle on.

use crate::description::Cache;

/// No line.
const EMPTY: u32 = u32::MAX;

/// The lines of a cache, each with the cycle from which on it is there. A line takes its place when it is asked for. A new line
/// replaces the least recently used one of its set.
#[derive(Clone, Debug)]
pub struct Tags {
    /// Line and cycle by set; within a set the most recently used first.
    lines: Vec<(u32, u32)>,
    ways: usize,
    set_mask: u32,
    enabled: bool,
    /// The cycle in which the line arrives that each register is for; none if any number may be on their way.
    registers: Vec<u32>,
}

impl Tags {
    /// An empty cache.
    pub fn new(cache: &Cache) -> Self {
        let sets = cache.lines() / cache.associativity;
        Self {
            lines: vec![(EMPTY, 0); cache.lines() as usize],
            ways: cache.associativity as usize,
            set_mask: sets - 1,
            enabled: cache.enabled,
            registers: vec![0; cache.miss_registers as usize],
        }
    }

    /// The cycle from which on `line` is there, if it is by cycle `now` or is on its way.
    #[inline(always)]
    pub fn find(&mut self, line: u32, now: u32) -> Option<u32> {
        let set = (line & self.set_mask) as usize;
        let ways = &mut self.lines[set * self.ways..][..self.ways];
        let way = ways.iter().position(|(held, _)| *held == line)?;
        ways[..=way].rotate_right(1);
        let from = ways[0].1;
        (self.enabled || from > now).then_some(from)
    }

    /// The first cycle from `now` on in which a line can be asked for that is not there.
    #[inline]
    pub fn free(&self, now: u32) -> u32 {
        self.registers.iter().min().map_or(now, |arrival| now.max(*arrival))
    }

    /// `line` has been asked for, and is there from cycle `from` on.
    #[inline]
    pub fn fill(&mut self, line: u32, from: u32) {
        if let Some(register) = self.registers.iter_mut().min() {
            *register = from;
        }
        let set = (line & self.set_mask) as usize;
        let ways = &mut self.lines[set * self.ways..][..self.ways];
        let way = ways.iter().position(|(held, _)| *held == line).unwrap_or(self.ways - 1);
        ways[..=way].rotate_right(1);
        ways[0] = (line, from);
    }
}
