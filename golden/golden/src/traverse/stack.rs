//! The traversal stack: a fixed array that is not cleared for every ray.

use std::mem::MaybeUninit;

/// Up to `CAPACITY` entries.
pub(crate) struct Stack<T, const CAPACITY: usize> {
    entries: [MaybeUninit<T>; CAPACITY],
    len: usize,
}

impl<T: Copy, const CAPACITY: usize> Stack<T, CAPACITY> {
    #[inline(always)]
    pub fn new() -> Self {
        Self { entries: [const { MaybeUninit::uninit() }; CAPACITY], len: 0 }
    }

    /// # Panics
    /// If the stack is full, which the bound on a tree's depth rules out.
    #[inline(always)]
    pub fn push(&mut self, entry: T) {
        self.entries[self.len] = MaybeUninit::new(entry);
        self.len += 1;
    }

    #[inline(always)]
    pub fn pop(&mut self) -> Option<T> {
        self.len = self.len.checked_sub(1)?;
        // SAFETY: entries below the old length have been written by `push`.
        Some(unsafe { self.entries[self.len].assume_init() })
    }

    #[inline(always)]
    pub fn len(&self) -> u32 {
        self.len as u32
    }
}
