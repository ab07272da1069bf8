//! Runs of operations, as the timing core executes them.

use super::EntryId;
use super::isa;
use super::scoreboard::{BoardEntry, READY, SINK};

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

/// Who issues an operation, and what else is to be known for that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Issue {
    /// The thread: waiting for an operand and its unit and writing its result is all there is to do.
    Plain {
        /// Index of the unit pool.
        pool: u8,
        /// Cycles until the result can be used.
        latency: u8,
    },
    /// The thread, with the L1: a load of one word.
    Load {
        /// Which of the event's addresses it is relative to.
        base: u8,
        /// Words behind that address.
        offset: u16,
    },
    /// The thread, like a plain one that waits for a second operand.
    Pair {
        /// Index of the unit pool.
        pool: u8,
        /// Cycles until the result can be used.
        latency: u8,
        /// Entry of its second operand.
        second: BoardEntry,
    },
    /// The multiprocessor, see its [`MicroOp`].
    Other,
    /// Nobody: it stands behind the last operation of a run.
    End,
}

/// What a thread looks at to issue an operation. Kept small: threads come by in turn, and by the time that one comes back, its
/// operations have left the host's nearest cache.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(align(8))]
pub struct Step {
    /// Bank of the instruction cache; `NO_BANK` behind the last operation of a run.
    pub bank: u8,
    /// Entry of the first register that it can find not to be ready, `READY` for none.
    pub read: BoardEntry,
    /// Entry of the register that it writes, `SINK` if nobody looks at the result before it is ready.
    pub write: BoardEntry,
    /// Who issues it.
    pub issue: Issue,
}

const _: () = assert!(size_of::<Step>() == 8, "eight in a line of the host's cache");

/// The bank behind the last operation of a run: it never has a fetch left.
const NO_BANK: u8 = u8::MAX;

impl Step {
    /// What stands behind the last operation of a run.
    pub const END: Self = Self { bank: NO_BANK, read: READY, write: SINK, issue: Issue::End };
}

/// What else there is to know of an operation.
#[derive(Clone, Copy, Debug)]
pub struct MicroOp {
    /// What there is to do.
    pub kind: Kind,
    /// Index of the unit pool.
    pub pool: u8,
    /// Entry of the register that it writes, as in its [`Step`].
    pub write: BoardEntry,
    /// Cycles until the result can be used.
    pub latency: u8,
    /// For memory operations, which of the event's addresses they are relative to.
    pub base: u8,
    /// Words behind that address.
    pub offset: u16,
    /// Index of its further operands in [`super::Code::operands`]; 0 for none.
    pub operands: u16,
}

impl MicroOp {
    /// What stands behind the last operation of a run.
    pub const END: Self =
        Self { kind: Kind::Plain, pool: UNLIMITED, write: SINK, latency: 0, base: 0, offset: 0, operands: 0 };
}

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
    /// Number of operations; behind them stands an [`Issue::End`].
    pub length: u32,
    /// Names of the addresses that it needs, as indices of [`super::Program::bases`], in the order in which an event gives them.
    pub bases: Vec<u8>,
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
pub fn pool_of(place: isa::Place) -> u8 {
    use isa::Place;
    match place {
        Place::Unit(unit) => unit as u8,
        Place::Pipeline => PIPELINE,
        Place::Counter => COUNTER,
        Place::Registers | Place::LocalStore | Place::Load | Place::Store | Place::Nop => UNLIMITED,
    }
}
