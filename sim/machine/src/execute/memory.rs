//! Global memory: a scene and what a frame writes of it.

use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Words that items read, and words that they write.
///
/// Items are executed ahead of time, in any order and on several threads. So a word that is written belongs to the item that
/// writes it: only that item may read it, and only after it has written it.
#[derive(Debug)]
pub struct Memory {
    /// All words, those that are written as they are before.
    words: Vec<u32>,
    /// Addresses of the words that items write.
    written: Range<u32>,
    values: Vec<AtomicU32>,
    /// The item that has written each of these words, plus 1.
    writers: Vec<AtomicU32>,
}

/// Why an access fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Denied {
    /// There is no such word.
    Outside,
    /// The word is for reading only.
    ReadOnly,
    /// The item has not written the word that it reads.
    NotWritten,
    /// Another item has written the word.
    Shared,
}

impl Memory {
    /// The memory that holds `words`, of which items may write those in `written`.
    ///
    /// # Panics
    /// If there are no such words.
    #[must_use]
    pub fn new(words: Vec<u32>, written: Range<u32>) -> Self {
        assert!(written.start <= written.end && written.end as usize <= words.len(), "{written:?}");
        let zeros = || (0..written.len()).map(|_| AtomicU32::new(0)).collect();
        Self { words, values: zeros(), writers: zeros(), written }
    }

    /// What item `item` reads at `address`.
    ///
    /// # Errors
    /// [`Denied`].
    #[inline(always)]
    pub fn load(&self, address: u32, item: u32) -> Result<u32, Denied> {
        match self.words.get(address as usize) {
            Some(word) if address.wrapping_sub(self.written.start) as usize >= self.values.len() => Ok(*word),
            Some(_) => self.load_written(address, item),
            None => Err(Denied::Outside),
        }
    }

    #[cold]
    fn load_written(&self, address: u32, item: u32) -> Result<u32, Denied> {
        let at = (address - self.written.start) as usize;
        match self.writers[at].load(Relaxed) {
            0 => Err(Denied::NotWritten),
            writer if writer == item + 1 => Ok(self.values[at].load(Relaxed)),
            _ => Err(Denied::Shared),
        }
    }

    /// Item `item` writes `value` at `address`.
    ///
    /// # Errors
    /// [`Denied`].
    pub fn store(&self, address: u32, value: u32, item: u32) -> Result<(), Denied> {
        if address as usize >= self.words.len() {
            return Err(Denied::Outside);
        }
        let at = address.wrapping_sub(self.written.start) as usize;
        let writer = self.writers.get(at).ok_or(Denied::ReadOnly)?;
        match writer.compare_exchange(0, item + 1, Relaxed, Relaxed) {
            Err(other) if other != item + 1 => Err(Denied::Shared),
            _ => {
                self.values[at].store(value, Relaxed);
                Ok(())
            }
        }
    }

    /// The word at `address`, if an item has written it.
    #[must_use]
    pub fn written(&self, address: u32) -> Option<u32> {
        let at = address.checked_sub(self.written.start)? as usize;
        let writer = self.writers.get(at)?.load(Relaxed);
        (writer != 0).then(|| self.values[at].load(Relaxed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_that_is_written_belongs_to_its_item() {
        let memory = Memory::new(vec![5, 6, 7, 8], 1..3);
        assert_eq!([0, 3].map(|address| memory.load(address, 9)), [Ok(5), Ok(8)]);
        assert_eq!(memory.load(4, 9), Err(Denied::Outside));
        assert_eq!(memory.load(1, 9), Err(Denied::NotWritten));
        assert_eq!(memory.written(1), None);
        assert_eq!(memory.store(1, 60, 9), Ok(()));
        assert_eq!((memory.load(1, 9), memory.written(1)), (Ok(60), Some(60)));
        assert_eq!(memory.store(1, 61, 9), Ok(()));
        assert_eq!(memory.load(1, 8), Err(Denied::Shared));
        assert_eq!(memory.store(1, 61, 8), Err(Denied::Shared));
        assert_eq!([0, 3].map(|address| memory.store(address, 1, 9)), [Err(Denied::ReadOnly); 2]);
        assert_eq!(memory.store(4, 1, 9), Err(Denied::Outside));
    }
}
