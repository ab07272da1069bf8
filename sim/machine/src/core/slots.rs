//! What is left of shared resources in each cycle of a quantum.

use memory::LONGEST_QUANTUM as LONGEST;

/// How many of each resource there are still to take, by resource and slot of the quantum.
#[derive(Clone, Debug)]
pub struct Slots {
    left: [[u8; LONGEST]; RESOURCES],
}

/// A resource is a byte.
const RESOURCES: usize = 1 << u8::BITS;
/// As many as a multiprocessor cannot exhaust in a cycle.
pub const ENOUGH: u8 = u8::MAX;

impl Slots {
    /// `counts` of the first resources in every slot, nothing of the others.
    pub fn new(counts: &[u8]) -> Self {
        let mut slots = Self { left: [[0; LONGEST]; RESOURCES] };
        slots.reset(counts);
        slots
    }

    /// Sets the first resources to `counts` in every slot.
    #[inline]
    pub fn reset(&mut self, counts: &[u8]) {
        for (left, &count) in self.left.iter_mut().zip(counts) {
            *left = [count; LONGEST];
        }
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
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_are_taken_from_a_slot_as_there_are() {
        let counts = [0, 2, 1];
        let mut slots = Slots::new(&counts);
        let taken = [3, 3, 3, 4, 7, 7, 7].map(|slot| slots.take(1, slot));
        assert_eq!(taken, [true, true, false, true, true, true, false]);
        assert_eq!([slots.take(0, 0), slots.take(2, 0), slots.take(3, 0)], [false, true, false]);
        slots.reset(&counts);
        assert!(slots.take(1, 3));
    }
}
