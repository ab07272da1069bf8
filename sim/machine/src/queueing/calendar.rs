//! What a server has promised: which of its slots are taken.

/// Words of a calendar.
const WORDS: usize = 8;
/// Slots of a word.
const BITS: u64 = u64::BITS as u64;

/// Which slots of a server are taken, from the first that can still be asked for on. A slot holds one request. Requests may come in
/// any order: one that is for an earlier slot than another takes what that has left free.
#[derive(Clone, Debug, Default)]
pub struct Calendar {
    /// The first slot that can be asked for.
    first: u64,
    /// A bit for each slot, in a ring.
    taken: [u64; WORDS],
}

impl Calendar {
    /// Forgets the slots before `first`.
    pub fn advance(&mut self, first: u64) {
        let (from, to) = (self.first / BITS, first / BITS);
        for word in from..to.min(from + WORDS as u64) {
            self.taken[word as usize % WORDS] = 0;
        }
        self.first = self.first.max(first);
    }

    /// The first free slot from `from` on. Beyond what the calendar reaches, all slots count as free.
    #[inline]
    pub fn free(&self, from: u64) -> u64 {
        let mut slot = from.max(self.first);
        let end = (self.first / BITS + WORDS as u64) * BITS;
        while slot < end {
            let free = !self.taken[(slot / BITS) as usize % WORDS] >> (slot % BITS);
            if free != 0 {
                return slot + u64::from(free.trailing_zeros());
            }
            slot = (slot / BITS + 1) * BITS;
        }
        slot
    }

    /// Takes the first free slot from `from` on.
    #[inline]
    pub fn take(&mut self, from: u64) -> u64 {
        let slot = self.free(from);
        if slot < (self.first / BITS + WORDS as u64) * BITS {
            self.taken[(slot / BITS) as usize % WORDS] |= 1 << (slot % BITS);
        }
        slot
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn requests_take_the_first_free_slot_in_whatever_order_they_come() {
        let mut calendar = Calendar::default();
        assert_eq!([5, 5, 3, 3, 3].map(|from| calendar.take(from)), [5, 6, 3, 4, 7]);
        calendar.advance(6);
        assert_eq!([0, 0].map(|from| calendar.take(from)), [8, 9]);
    }

    #[test]
    fn a_ring_is_used_again_once_its_slots_are_past() {
        let mut calendar = Calendar::default();
        let all = WORDS as u64 * BITS;
        assert!((0..all).all(|slot| calendar.take(0) == slot));
        assert_eq!(calendar.take(0), all, "beyond the ring");
        calendar.advance(2 * BITS);
        assert!((all..all + 2 * BITS).all(|slot| calendar.take(0) == slot));
        calendar.advance(100 * all);
        assert_eq!([0, 0].map(|from| calendar.take(from)), [100 * all, 100 * all + 1]);
    }
}
