//! Banks of a cache that are taken, cycle by cycle of a quantum.

use crate::LONGEST_QUANTUM as LONGEST;
use crate::description::{BankBy, Cache, MAX_BANKS};

/// By bank, a bit for each slot of the quantum in which it is taken.
#[derive(Clone, Debug)]
pub struct Banks {
    /// For as many banks as a machine can have.
    taken: [u8; BANKS],
    /// The bank of a word is its address without so many low bits, modulo the number of banks.
    shift: u32,
    mask: u32,
}

const BANKS: usize = MAX_BANKS as usize;
const _: () = assert!(LONGEST <= u8::BITS as usize, "a slot is a bit");

impl Banks {
    /// The banks of `cache`, of which none is taken.
    pub fn new(cache: &Cache) -> Self {
        let shift = match cache.bank_by {
            BankBy::Word => 0,
            BankBy::Line => cache.line_words().trailing_zeros(),
        };
        Self { taken: [0; BANKS], shift, mask: cache.banks - 1 }
    }

    /// The bank of word `address`.
    #[inline(always)]
    pub fn of(&self, address: u32) -> usize {
        (address >> self.shift & self.mask) as usize % BANKS
    }

    /// Begins a quantum: none is taken.
    #[inline]
    pub fn clear(&mut self) {
        self.taken = [0; BANKS];
    }

    /// Whether `bank` is taken in slot `slot`.
    #[inline(always)]
    pub fn is_taken(&self, slot: usize, bank: usize) -> bool {
        self.taken[bank % BANKS] >> (slot % LONGEST) & 1 != 0
    }

    /// Takes `bank` in slot `slot`.
    #[inline(always)]
    pub fn take(&mut self, slot: usize, bank: usize) {
        self.taken[bank % BANKS] |= 1 << (slot % LONGEST);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::tests::cache;

    #[test]
    fn a_bank_is_taken_in_its_slots_for_all_its_words() {
        let line_words = 16;
        for (bank_by, words) in [(BankBy::Word, 1), (BankBy::Line, line_words)] {
            for banks in [1, 8, 64] {
                let mut taken = Banks::new(&Cache { banks, bank_by, ..cache() });
                taken.take(2, taken.of(5 * words));
                taken.take(7, taken.of((5 + banks) * words));
                for (word, slot) in (0..3 * banks * words).flat_map(|word| [(word, 2), (word, 3), (word, 7)])
                {
                    let same = word / words % banks == 5 % banks;
                    let expected = same && slot != 3;
                    assert_eq!(
                        taken.is_taken(slot, taken.of(word)),
                        expected,
                        "{bank_by:?} {banks} {word} {slot}"
                    );
                }
                taken.clear();
                assert!(!taken.is_taken(2, taken.of(5 * words)));
            }
        }
    }
}
