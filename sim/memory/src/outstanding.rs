//! Lines on their way to a cache, and who waits for them.

/// When a line arrives whose time is not known yet.
pub const UNKNOWN: u32 = u32::MAX;

#[derive(Clone, Copy, Debug)]
struct Entry {
    line: u32,
    /// Cycle from which on the cache holds the line, or [`UNKNOWN`].
    arrival: u32,
    /// First of a chain in `waiters`, or [`NONE`].
    first: u32,
}

const NONE: u32 = u32::MAX;

/// Lines under way.
#[derive(Clone, Debug, Default)]
pub struct Outstanding {
    entries: Vec<Entry>,
    /// Numbers of clients, each with the place of the next in its chain.
    waiters: Vec<(u16, u32)>,
    free: Vec<u32>,
}

impl Outstanding {
    /// When `line` arrives, if it is under way.
    #[inline]
    pub fn arrival(&self, line: u32) -> Option<u32> {
        self.entries.iter().find(|entry| entry.line == line).map(|entry| entry.arrival)
    }

    /// Whether `registers` of them, or any number at 0, are enough to ask for `line` in cycle `now` as well.
    #[inline]
    pub fn has_room(&self, now: u32, line: u32, registers: u32) -> bool {
        if registers == 0 {
            return true;
        }
        let under_way = || self.entries.iter().filter(|entry| entry.arrival > now);
        under_way().count() < registers as usize || under_way().any(|entry| entry.line == line)
    }

    /// Notes that `line` is under way in cycle `now`.
    #[inline]
    pub fn insert(&mut self, now: u32, line: u32, arrival: u32) {
        self.remove_arrived(line, now);
        self.entries.push(Entry { line, arrival, first: NONE });
    }

    /// Makes the client of number `waiter` wait for `line`, whose arrival is not known yet.
    #[inline]
    pub fn wait(&mut self, line: u32, waiter: u16) {
        let entry = self.entries.iter_mut().find(|entry| entry.line == line).expect("the line is under way");
        let slot = match self.free.pop() {
            Some(slot) => {
                self.waiters[slot as usize] = (waiter, entry.first);
                slot
            }
            None => {
                self.waiters.push((waiter, entry.first));
                self.waiters.len() as u32 - 1
            }
        };
        entry.first = slot;
    }

    /// It is known now when `line` arrives. Calls `wake` with the number of everyone who waits for it. Returns false if nobody has asked for it.
    #[inline]
    pub fn arrives(&mut self, line: u32, arrival: u32, mut wake: impl FnMut(u16)) -> bool {
        let Some(entry) = self.entries.iter_mut().find(|entry| entry.line == line) else {
            return false;
        };
        entry.arrival = arrival;
        let mut slot = std::mem::replace(&mut entry.first, NONE);
        while slot != NONE {
            let (waiter, next) = self.waiters[slot as usize];
            wake(waiter);
            self.free.push(slot);
            slot = next;
        }
        true
    }

    /// Removes `line` if it has arrived by cycle `now`. A later arrival belongs to a newer request, which stays.
    #[inline]
    pub fn remove_arrived(&mut self, line: u32, now: u32) {
        if let Some(at) = self.entries.iter().position(|entry| entry.line == line && entry.arrival <= now) {
            self.entries.swap_remove(at);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_register_is_taken_until_its_line_arrives_and_a_line_needs_one() {
        let mut lines = Outstanding::default();
        lines.insert(0, 5, UNKNOWN);
        lines.insert(0, 6, 9);
        assert!(lines.has_room(8, 7, 3) && lines.has_room(8, 7, 0));
        assert!(!lines.has_room(8, 7, 2) && !lines.has_room(8, 7, 1));
        assert!(lines.has_room(8, 6, 2) && lines.has_room(8, 5, 2), "a line that is under way has one");
        assert!(lines.has_room(9, 7, 2) && !lines.has_room(9, 7, 1), "line 6 has arrived");
        lines.arrives(5, 12, |_| ());
        assert!(!lines.has_room(11, 7, 1) && lines.has_room(12, 7, 1));
    }
}
