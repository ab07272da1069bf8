//! The local store of a thread: stack and arrays, 32-bit words in big-endian order of bytes.

/// Bytes of a thread's local store, as in the public simulator. The stack grows down from its end.
pub const LOCAL_STORE_BYTES: u32 = 32 << 10;
/// Words of it.
pub const LOCAL_STORE_WORDS: usize = LOCAL_STORE_BYTES as usize / 4;

/// Words of a local store, with the item that has written each.
///
/// A word that an item has not written holds what it held when the thread came to its first item from there: the thread's own
/// set-up.
#[derive(Clone, Debug)]
pub struct LocalStore {
    values: Vec<u32>,
    /// When each word was written: never if 0.
    written: Vec<u32>,
    /// Counts items.
    now: u32,
    /// Words that this item has written, each once.
    touched: Vec<u16>,
}

/// Why an access fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Misplaced {
    /// The address is not in the local store.
    Outside,
    /// The address is not that of a word.
    Unaligned,
}

impl LocalStore {
    /// An empty one.
    #[must_use]
    pub fn new() -> Self {
        Self {
            values: vec![0; LOCAL_STORE_WORDS],
            written: vec![0; LOCAL_STORE_WORDS],
            now: 1,
            touched: vec![],
        }
    }

    /// Begins an item, which has written nothing.
    pub fn begin(&mut self) {
        self.touched.clear();
        self.now = self.now.checked_add(1).unwrap_or_else(|| {
            self.written.fill(0);
            1
        });
    }

    /// The index of the word at byte address `address`.
    ///
    /// # Errors
    /// [`Misplaced`].
    #[inline(always)]
    pub fn index(address: u32) -> Result<usize, Misplaced> {
        if address >= LOCAL_STORE_BYTES {
            Err(Misplaced::Outside)
        } else if address & 3 != 0 {
            Err(Misplaced::Unaligned)
        } else {
            Ok(address as usize / 4)
        }
    }

    /// The word with index `at`, if this item has written it.
    #[inline(always)]
    pub fn load(&self, at: usize) -> Option<u32> {
        (self.written[at] == self.now).then(|| self.values[at])
    }

    /// Writes the word with index `at`.
    #[inline(always)]
    pub fn store(&mut self, at: usize, value: u32) {
        if self.written[at] != self.now {
            self.written[at] = self.now;
            self.touched.push(at as u16);
        }
        self.values[at] = value;
    }

    /// The words that this item has written, by index and value.
    pub fn touched(&self) -> impl Iterator<Item = (usize, u32)> {
        self.touched.iter().map(|at| (usize::from(*at), self.values[usize::from(*at)]))
    }
}

impl Default for LocalStore {
    fn default() -> Self {
        Self::new()
    }
}
