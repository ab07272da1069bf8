//! Lines on their way to a first-level cache, and who waits for them.

/// When a line arrives whose time is not known yet.
pub const UNKNOWN: u32 = u32::MAX;

/// A register of a thread that waits for a line.
#[derive(Clone, Copy, Debug)]
pub struct Waiter {
    /// The thread.
    pub thread: u8,
    /// The register.
    pub register: u8,
}

#[derive(Clone, Copy, Debug)]
struct Entry {
    line: u32,
    /// Cycle in which the line arrives, or [`UNKNOWN`].
    arrival: u32,
    /// First of a chain in `waiters`, or [`NONE`].
    first: u32,
}

const NONE: u32 = u32::MAX;

/// Lines under way.
#[derive(Clone, Debug, Default)]
pub struct Outstanding {
    entries: Vec<Entry>,
    waiters: Vec<(Waiter, u32)>,
    free: Vec<u32>,
}

impl Outstanding {
    /// When `line` arrives, if it is under way.
    #[inline]
    pub fn arrival(&self, line: u32) -> Option<u32> {
        self.entries.iter().find(|entry| entry.line == line).map(|entry| entry.arrival)
    }

    /// Notes that `line` is under way.
    #[inline]
    pub fn insert(&mut self, line: u32, arrival: u32) {
        self.entries.push(Entry { line, arrival, first: NONE });
    }

    /// Makes `waiter` wait for `line`, whose arrival is [`UNKNOWN`].
    pub fn wait(&mut self, line: u32, waiter: Waiter) {
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

    /// Removes `line`, which has arrived, and passes everyone who waited for it.
    #[inline]
    pub fn remove(&mut self, line: u32, mut wake: impl FnMut(Waiter)) {
        let Some(at) = self.entries.iter().position(|entry| entry.line == line) else {
            return;
        };
        let mut slot = self.entries.swap_remove(at).first;
        while slot != NONE {
            let (waiter, next) = self.waiters[slot as usize];
            wake(waiter);
            self.free.push(slot);
            slot = next;
        }
    }
}
