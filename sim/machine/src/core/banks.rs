//! Banks of a cache that are taken, cycle by cycle of a quantum.

use super::quantum::LONGEST;
use crate::description::check::MAX_BANKS;

/// By bank, a bit for each slot of the quantum in which it is taken. The bank of a word is its address modulo their number.
#[derive(Clone, Debug)]
pub struct Banks {
    /// For as many banks as a machine can have.
    taken: [u8; BANKS],
    mask: u32,
}

const BANKS: usize = MAX_BANKS as usize;
const _: () = assert!(LONGEST <= u8::BITS as usize, "a slot is a bit");

impl Banks {
    /// `banks` banks, a power of two, of which none is taken.
    pub fn new(banks: u32) -> Self {
        Self { taken: [0; BANKS], mask: banks - 1 }
    }

    /// Begins a quantum: none is taken.
    #[inline]
    pub fn clear(&mut self) {
        self.taken = [0; BANKS];
    }

    /// Whether the bank of word `address` is taken in slot `slot`.
    #[inline(always)]
    pub fn is_taken(&self, slot: usize, address: u32) -> bool {
        self.taken[(address & self.mask) as usize % BANKS] >> (slot % LONGEST) & 1 != 0
    }

    /// Takes the bank of word `address` in slot `slot`.
    #[inline(always)]
    pub fn take(&mut self, slot: usize, address: u32) {
        self.taken[(address & self.mask) as usize % BANKS] |= 1 << (slot % LONGEST);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bank_is_taken_in_its_slots_for_all_its_words() {
        for banks in [1, 8, 64] {
            let mut taken = Banks::new(banks);
            taken.take(2, 5);
            taken.take(7, 5 + banks);
            for (word, slot) in (0..3 * banks).flat_map(|word| [(word, 2), (word, 3), (word, 7)]) {
                let same = word % banks == 5 % banks;
                assert_eq!(taken.is_taken(slot, word), same && slot != 3, "{banks} {word} {slot}");
            }
            taken.clear();
            assert!(!taken.is_taken(2, 5));
        }
    }
}
