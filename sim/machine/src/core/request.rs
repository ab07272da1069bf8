//! What a thread asks of the chip.

use crate::program::Kind;

/// What a thread asks of the chip.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// Cycle in which it asks.
    pub cycle: u32,
    /// The multiprocessor.
    pub tm: u16,
    /// The thread.
    pub thread: u8,
    /// Load, store or counter.
    pub kind: Kind,
    /// Word address.
    pub address: u32,
}
