//! The lines of a cache, with the time of the last use of each.

use crate::description::{BankBy, Cache};
use std::collections::HashMap;

/// When something was used. The turn that it was used in counts first, then the thread's rank, then the order of events.
pub type Use = (u32, usize, u64);

/// The bank of a word.
pub fn bank(cache: &Cache, address: u32) -> u32 {
    match cache.bank_by {
        BankBy::Word => address % cache.banks,
        BankBy::Line => address / cache.line_words() % cache.banks,
    }
}

/// A cache's lines.
pub struct Lines {
    cache: Cache,
    held: HashMap<u32, Use>,
    /// Cycle and line of what is on its way.
    pub arrivals: Vec<(u32, u32)>,
}

impl Lines {
    pub fn new(cache: &Cache) -> Self {
        Self { cache: *cache, held: HashMap::new(), arrivals: vec![] }
    }

    fn set(&self, line: u32) -> u32 {
        line % (self.cache.lines() / self.cache.associativity)
    }

    /// Puts what has arrived by cycle `start` in the place of the line of its set that was used longest ago.
    pub fn fill(&mut self, start: u32, turn: u32, events: &mut u64) {
        self.arrivals.sort_by_key(|(cycle, _)| *cycle);
        while self.arrivals.first().is_some_and(|(cycle, _)| *cycle <= start) {
            let (_, line) = self.arrivals.remove(0);
            if !self.cache.enabled {
                continue;
            }
            let set = self.set(line);
            let rivals = self.held.iter().filter(|(held, _)| self.set(**held) == set && **held != line);
            let full = rivals.clone().count() >= self.cache.associativity as usize;
            let oldest = rivals.min_by_key(|(_, used)| **used).map(|(held, _)| *held);
            if full && !self.held.contains_key(&line) {
                self.held.remove(&oldest.expect("a full set has a line"));
            }
            *events += 1;
            self.held.insert(line, (turn, 0, *events));
        }
    }

    /// Whether `line` is held in cycle `now`. A line that has arrived since the quantum began is held; the line whose place it
    /// takes is gone where that is the only one of its set, and in larger sets goes at the end of the quantum.
    pub fn hit(&mut self, now: u32, line: u32, used: Use) -> bool {
        let arrived = self.arrivals.iter().filter(|(cycle, _)| *cycle <= now && self.cache.enabled);
        let direct = self.cache.associativity == 1;
        let of_its_set =
            arrived.filter(|(_, other)| *other == line || direct && self.set(*other) == self.set(line));
        let last = of_its_set.max_by_key(|(cycle, _)| *cycle).map(|(_, other)| *other);
        match (last, self.held.get_mut(&line)) {
            (Some(other), _) => other == line,
            (None, Some(last_used)) => {
                *last_used = used;
                true
            }
            (None, None) => false,
        }
    }
}
