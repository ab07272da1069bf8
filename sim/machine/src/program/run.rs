//! Runs of operations, as the timing core executes them.

use super::EntryId;
use super::operation::Place;
use super::scoreboard::BoardEntry;

/// What the core has to do for an operation beyond waiting for its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum Kind {
    /// Nothing.
    Plain,
    /// Nothing, and it counts as a nop.
    Nop,
    /// A load from global memory.
    Load,
    /// A store to global memory.
    Store,
    /// The next item of work.
    Counter,
}

/// An operation. Kept small: threads come by in turn, and by the time that one comes back, its operations have left the host's
/// nearest cache.
#[derive(Clone, Copy, Debug)]
pub struct MicroOp {
    /// What there is to do.
    pub kind: Kind,
    /// Bank of the instruction cache.
    pub bank: u8,
    /// Entries of the registers that it can find not to be ready, `READY` for none; of several, the first, and the second if
    /// there are two.
    pub reads: [BoardEntry; 2],
    /// Entry of the register that it writes, `SINK` if nobody looks at the result before it is ready.
    pub write: BoardEntry,
    /// Index of the unit pool.
    pub pool: u8,
    /// Cycles until the result can be used.
    pub latency: u8,
    /// For memory operations, which of the run's addresses they are relative to.
    pub base: u8,
    /// Words behind that address.
    pub offset: u16,
    /// Index of its further operands in [`super::Code::operands`]; 0 for none.
    pub operands: u16,
}

const _: () = assert!(size_of::<MicroOp>() == 12);

/// Registers of an operation that do not fit in it, by their entries.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Operands {
    /// All registers written, where there are several.
    pub writes: Vec<BoardEntry>,
    /// Registers that it can find not to be ready, beyond these.
    pub reads: Vec<BoardEntry>,
}

/// Index of a run in [`super::Code::runs`].
pub type RunId = u32;

/// Operations from one entry point to the next.
#[derive(Clone, Debug)]
pub struct Run {
    /// Index of its first operation.
    pub first: u32,
    /// Number of operations.
    pub length: u32,
    /// Number of addresses that its operations are relative to, in the order in which executing it meets them.
    pub addresses: u8,
    /// The entry point that follows; none at the end of the program.
    pub next: Option<EntryId>,
}

/// Number of pools: the shared units, then one for what is not limited.
pub const POOLS: usize = costs::Unit::ALL.len() + 3;
/// The pool of what is not limited.
pub const UNLIMITED: u8 = costs::Unit::ALL.len() as u8;
/// The pool of the pipeline: one operation a cycle.
pub const PIPELINE: u8 = UNLIMITED + 1;
/// The pool of the shared counter: one operation a cycle.
pub const COUNTER: u8 = UNLIMITED + 2;

/// The pool that an operation takes its unit from.
#[must_use]
pub fn pool_of(place: Place) -> u8 {
    match place {
        Place::Unit(unit) => unit as u8,
        Place::Pipeline => PIPELINE,
        Place::Counter => COUNTER,
        Place::Registers | Place::LocalStore | Place::Load | Place::Store | Place::Nop => UNLIMITED,
    }
}
