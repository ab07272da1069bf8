//! What is left of shared resources in each cycle of a quantum.

use super::quantum::LONGEST as QUANTUM;

/// How many of each resource there are still to take, by resource and slot of the quantum.
#[derive(Clone, Debug)]
pub struct Slots {
    /// For every index that a byte can be, so that none needs a check; most are never used.
    left: [Row; RESOURCES],
}

/// What is left by slot; nothing behind the quantum.
type Row = [u8; COLUMNS];
/// Slots of a table.
pub const COLUMNS: usize = 2 * QUANTUM;
const RESOURCES: usize = 1 << u8::BITS;
/// As many as a multiprocessor cannot exhaust in a cycle.
pub const ENOUGH: u8 = u8::MAX;

impl Slots {
    /// `counts` of the first resources in every slot of a quantum of `length` cycles; nothing of the others, nor behind it.
    pub fn new(counts: &[u8], length: usize) -> Self {
        let mut slots = Self { left: [[0; COLUMNS]; RESOURCES] };
        for (left, &count) in slots.left.iter_mut().zip(counts) {
            left[..length].fill(count);
        }
        slots
    }

    /// Sets the first `resources` to what they are in `all`.
    #[inline]
    pub fn reset(&mut self, all: &Self, resources: usize) {
        self.left[..resources].copy_from_slice(&all.left[..resources]);
    }

    /// Takes one of `resource` in `slot`; false if there is none.
    #[inline(always)]
    pub fn take(&mut self, resource: u8, slot: usize) -> bool {
        let left = &mut self.left[usize::from(resource)][slot];
        if *left == 0 {
            return false;
        }
        *left -= 1;
        true
    }

    /// Adds one of `resource` in `slot`.
    pub fn give(&mut self, resource: u8, slot: usize) {
        let left = &mut self.left[usize::from(resource)][slot];
        *left = left.saturating_add(1);
    }

    /// The first slot behind `slot` in which there is one of `resource`; `end` if there is none before.
    #[inline]
    pub fn next(&self, resource: u8, slot: usize, end: usize) -> usize {
        let quantum = self.left[usize::from(resource)].first_chunk::<QUANTUM>();
        // A byte for each slot, that of the first one lowest.
        let left = u64::from_le_bytes(*quantum.expect("a row is longer"));
        let next = slot + 1;
        let behind = left.checked_shr(u8::BITS * next as u32).unwrap_or(0);
        end.min(next + (behind.trailing_zeros() / u8::BITS) as usize) % COLUMNS
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_are_taken_from_a_slot_as_there_are() {
        let all = Slots::new(&[0, 2, 1], 8);
        let mut slots = all.clone();
        let taken = [3, 3, 3, 4, 7, 7, 7].map(|slot| slots.take(1, slot));
        assert_eq!(taken, [true, true, false, true, true, true, false]);
        assert_eq!([slots.next(1, 2, 8), slots.next(1, 6, 8), slots.next(1, 2, 4)], [4, 8, 4]);
        assert_eq!([slots.next(0, 0, 5), slots.next(2, 0, 8), slots.next(3, 0, 8)], [5, 1, 8]);
        slots.give(1, 7);
        assert_eq!([slots.take(1, 7), slots.take(1, 7)], [true, false]);
        slots.reset(&all, 2);
        assert!(slots.take(1, 3));
    }
}
