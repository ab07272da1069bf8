//! The tags of a cache: which lines it holds.

use crate::description::Cache;

/// No line.
const EMPTY: u32 = u32::MAX;

/// Which lines a cache holds. A new line replaces the least recently used one of its set.
#[derive(Clone, Debug)]
pub struct Tags {
    /// Lines by set; within a set the most recently used first.
    lines: Vec<u32>,
    ways: usize,
    set_mask: u32,
    enabled: bool,
}

impl Tags {
    /// An empty cache.
    pub fn new(cache: &Cache) -> Self {
        let sets = cache.lines() / cache.associativity;
        Self {
            lines: vec![EMPTY; cache.lines() as usize],
            ways: cache.associativity as usize,
            set_mask: sets - 1,
            enabled: cache.enabled,
        }
    }

    /// Whether `line` is held; if so it becomes the most recently used of its set.
    #[inline(always)]
    pub fn hit(&mut self, line: u32) -> bool {
        let set = (line & self.set_mask) as usize;
        if self.ways == 1 {
            return self.lines[set] == line;
        }
        let ways = &mut self.lines[set * self.ways..][..self.ways];
        let Some(way) = ways.iter().position(|held| *held == line) else {
            return false;
        };
        ways[..=way].rotate_right(1);
        true
    }

    /// Whether the sets have one place each, and two lines compete for the same.
    #[inline(always)]
    pub fn compete(&self, a: u32, b: u32) -> bool {
        self.ways == 1 && (a ^ b) & self.set_mask == 0
    }

    /// Whether the cache holds lines at all.
    #[inline(always)]
    pub fn is_enabled(&self) -> bool {
        self.enabled
    }

    /// Puts `line` in the place of the least recently used of its set.
    #[inline]
    pub fn fill(&mut self, line: u32) {
        if !self.enabled {
            return;
        }
        let set = (line & self.set_mask) as usize;
        let ways = &mut self.lines[set * self.ways..][..self.ways];
        let way = ways.iter().position(|held| *held == line).unwrap_or(self.ways - 1);
        ways[..=way].rotate_right(1);
        ways[0] = line;
    }
}
