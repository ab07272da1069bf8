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

/// Who issues an operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Issue {
    /// The thread: waiting for an operand and its unit and writing its result is all there is to do.
    Plain,
    /// The thread, with the L1: a load of one word.
    Load,
    /// The thread, like a plain one that waits for a second operand.
    Pair,
    /// The multiprocessor.
    Other,
    /// Nobody: it stands behind the last operation of a run.
    End,
}

/// An operation as the core executes it.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(16))]
pub struct MicroOp {
    /// Who issues it.
    pub issue: Issue,
    /// What else there is to do.
    pub kind: Kind,
    /// Bank of the instruction cache; `NO_BANK` behind the last operation of a run.
    pub bank: u8,
    /// Index of the unit pool.
    pub pool: u8,
    /// Entries of the registers that it can find not to be ready, `READY` for none; only [`Issue::Pair`] has a second.
    pub reads: [BoardEntry; 2],
    /// Entry of the register that it writes, `SINK` if nobody looks at the result before it is ready.
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

/// The bank behind the last operation of a run: it never has a fetch left.
const NO_BANK: u8 = u8::MAX;

impl MicroOp {
    /// What stands behind the last operation of a run.
    pub const END: Self = Self {
        issue: Issue::End,
        kind: Kind::Plain,
        bank: NO_BANK,
        pool: UNLIMITED,
        reads: [READY; 2],
        write: SINK,
        latency: 0,
        base: 0,
        offset: 0,
        operands: 0,
    };
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
pub const POOLS: usize = crate::unit_costs::Unit::ALL.len() + 3;
/// The pool of what is not limited.
pub const UNLIMITED: u8 = crate::unit_costs::Unit::ALL.len() as u8;
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
