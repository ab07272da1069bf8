//! The lines of a cache, and those that are about to arrive.

use crate::description::Cache;
use crate::tags::Tags;

/// Which lines a cache holds from which cycle on.
#[derive(Clone, Debug)]
pub struct Lines {
    tags: Tags,
    /// Cycle and line of what arrives, in the order of arrival.
    arrivals: Vec<(u32, u32)>,
    /// Cycle of the first of these.
    next: u32,
}

impl Lines {
    /// An empty cache.
    pub fn new(cache: &Cache) -> Self {
        Self { tags: Tags::new(cache), arrivals: vec![], next: u32::MAX }
    }

    /// Begins the quantum at cycle `start`: fills what has arrived by then, and passes line and cycle to `filled`.
    #[inline]
    pub fn begin(&mut self, start: u32, mut filled: impl FnMut(u32, u32)) {
        if self.next > start {
            return;
        }
        let behind = self.arrivals.partition_point(|(cycle, _)| *cycle <= start);
        for (cycle, line) in self.arrivals.drain(..behind) {
            self.tags.fill(line);
            filled(line, cycle);
        }
        self.next = self.arrivals.first().map_or(u32::MAX, |(cycle, _)| *cycle);
    }

    /// It is known that `line` arrives in cycle `cycle`.
    #[inline]
    pub fn arrives(&mut self, line: u32, cycle: u32) {
        let at = self.arrivals.partition_point(|(other, _)| *other <= cycle);
        self.arrivals.insert(at, (cycle, line));
        self.next = self.next.min(cycle);
    }

    /// Puts `line` into the cache in no time. Returns whether it was there before.
    pub fn warm(&mut self, line: u32) -> bool {
        let held = self.tags.hit(line);
        if !held {
            self.tags.fill(line);
        }
        held
    }

    /// Whether the cache holds `line` in cycle `now`. A line that has arrived since the quantum began counts as held; the line that
    /// it will replace counts as gone where a set has one place.
    #[inline(always)]
    pub fn holds(&mut self, now: u32, line: u32) -> bool {
        if now < self.next || !self.tags.is_enabled() {
            return self.tags.hit(line);
        }
        self.holds_or_has_got(now, line)
    }

    /// [`Lines::holds`] where some line has arrived since the quantum began.
    #[inline]
    fn holds_or_has_got(&mut self, now: u32, line: u32) -> bool {
        let mut has_got = None;
        for &(cycle, other) in &self.arrivals {
            if cycle > now {
                break;
            }
            if other == line {
                has_got = Some(true);
            } else if self.tags.compete(other, line) {
                has_got = Some(false);
            }
        }
        has_got.unwrap_or_else(|| self.tags.hit(line))
    }
}
