//! Banks of a cache that are taken, cycle by cycle of a quantum.

use crate::LONGEST_QUANTUM as LONGEST;
use crate::description::{BankBy, Cache, MAX_BANKS, MAX_PORTS};

/// By port and bank, a bit for each slot of the quantum in which the port is taken. A bank's ports are taken in their order.
#[derive(Clone, Debug)]
pub struct Banks {
    /// For as many ports and banks as a machine can have.
    taken: [[u8; BANKS]; MAX_PORTS as usize],
    /// The last port of each bank. A bank is taken where this one is.
    last: usize,
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
        let taken = [[0; BANKS]; MAX_PORTS as usize];
        Self { taken, last: cache.ports as usize - 1, shift, mask: cache.banks - 1 }
    }

    /// The bank of word `address`.
    #[inline(always)]
    pub fn of(&self, address: u32) -> usize {
        (address >> self.shift & self.mask) as usize % BANKS
    }

    /// Begins a quantum: none is taken.
    #[inline]
    pub fn clear(&mut self) {
        self.taken[..=self.last].fill([0; BANKS]);
    }

    /// Whether all ports of `bank` are taken in slot `slot`.
    #[inline(always)]
    pub fn is_taken(&self, slot: usize, bank: usize) -> bool {
        self.taken[self.last][bank % BANKS] >> (slot % LONGEST) & 1 != 0
    }

    /// Takes a port of `bank` in slot `slot`; none if all are taken.
    #[inline(always)]
    pub fn take(&mut self, slot: usize, bank: usize) {
        let bit = 1 << (slot % LONGEST);
        for port in &mut self.taken[..=self.last] {
            let bits = &mut port[bank % BANKS];
            if *bits & bit == 0 {
                *bits |= bit;
                return;
            }
        }
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

    #[test]
    fn a_bank_is_taken_once_all_its_ports_are() {
        for ports in 1..=MAX_PORTS {
            let mut taken = Banks::new(&Cache { ports, ..cache() });
            for _ in 0..ports {
                assert!(!taken.is_taken(2, 5), "{ports}");
                taken.take(2, 5);
            }
            assert!(taken.is_taken(2, 5) && !taken.is_taken(2, 6) && !taken.is_taken(3, 5));
            taken.clear();
            assert!(!taken.is_taken(2, 5));
        }
    }
}
