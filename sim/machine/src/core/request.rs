//! What a thread asks of the chip.

use crate::program::{BoardEntry, Kind};
use memory::{Access, Client};

/// What a thread asks of the chip.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// Cycle in which it asks.
    pub cycle: u32,
    /// The multiprocessor.
    pub tm: u16,
    /// The thread.
    pub thread: u8,
    /// What it asks for.
    pub what: What,
}

/// What is asked for.
#[derive(Clone, Copy, Debug)]
pub enum What {
    /// The next item of work.
    Item,
    /// Words of a line, from a word address on.
    Words(Access, u32),
}

impl Request {
    /// A request that the memory gives back.
    pub fn given_back(request: memory::Request) -> Self {
        let memory::Request { cycle, client: Client { port: tm, number }, access, address } = request;
        Self { cycle, tm, thread: number as u8, what: What::Words(access, address) }
    }
}

/// What a load or store does with the words.
#[inline(always)]
pub fn access(kind: Kind) -> Access {
    if kind == Kind::Store { Access::Store } else { Access::Load }
}

/// The number under which a thread waits with a register for a line, by its entry on the scoreboard.
pub fn waiter(thread: u8, entry: BoardEntry) -> u16 {
    u16::from_be_bytes([thread, entry])
}

/// The thread and the register that wait under `number`.
pub fn waiting(number: u16) -> (u8, BoardEntry) {
    number.to_be_bytes().into()
}
