//! The traversal stack: a fixed array that is not cleared for every ray.

use crate::build::MAX_DEPTH;
use std::mem::MaybeUninit;

/// Up to `PER_LEVEL` entries for each level of a tree: one fewer than a node has children is enough.
pub(crate) struct Stack<T, const PER_LEVEL: usize> {
    entries: [[MaybeUninit<T>; PER_LEVEL]; MAX_DEPTH as usize],
    len: usize,
}

impl<T: Copy, const PER_LEVEL: usize> Stack<T, PER_LEVEL> {
    #[inline(always)]
    pub fn new() -> Self {
        Self { entries: [const { [const { MaybeUninit::uninit() }; PER_LEVEL] }; MAX_DEPTH as usize], len: 0 }
    }

    /// # Panics
    /// If the stack is full, which the bound on a tree's depth rules out.
    #[inline(always)]
    pub fn push(&mut self, entry: T) {
        self.entries.as_flattened_mut()[self.len] = MaybeUninit::new(entry);
        self.len += 1;
    }

    #[inline(always)]
    pub fn pop(&mut self) -> Option<T> {
        self.len = self.len.checked_sub(1)?;
        // SAFETY: entries below the old length have been written by `push`.
        Some(unsafe { self.entries.as_flattened()[self.len].assume_init() })
    }

    #[inline(always)]
    pub fn len(&self) -> u32 {
        self.len as u32
    }
}
