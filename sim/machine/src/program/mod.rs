//! Programs: read from a listing, prepared for execution and for the timing core.
//!
//! A program is a listing as the compiler writes it. [`crate::execute`] executes it; the timing core executes the straight *runs*
//! of instructions that this has gone through, and computes nothing.

mod code;
mod decode;
mod graph;
mod listing;
mod liveness;
mod operation;
mod registers;
mod run;
mod scoreboard;

pub use code::Code;
pub use decode::Test;
pub use graph::{Branch, Edge, Graph, Node, NodeId};
pub use listing::{Listing, ListingError, MOST_INSTRUCTIONS};
pub use operation::{Opcode, Operation, Place};
pub use registers::{
    CONDITION, FIRST_FLOAT, LANE_WORDS, REGISTERS, Register, SINK, STACK_POINTER, ZERO, name as register_name,
};
pub use run::{COUNTER, Kind, MicroOp, Operands, PIPELINE, POOLS, Run, RunId, UNLIMITED};
pub use scoreboard::{BOARD_ENTRIES, BoardEntry};

use super::description::MachineDescription;
use code::{Source, new_addresses};

/// Index of an entry point.
pub type EntryId = u8;

/// The entry point at which every thread starts.
pub const START: EntryId = 0;

/// Lanes of boxes of the widest pipeline.
pub const MOST_LANES: u32 = 8;

/// A program, prepared for a machine.
#[derive(Clone, Debug)]
pub struct Program {
    /// Name.
    pub name: String,
    /// What the timing core executes.
    pub code: Code,
    /// The paths through the operations.
    pub graph: Graph,
    /// The operations by their indices; `b` of an access to global memory is 1 if it gives its run a new address.
    pub operations: Vec<Operation>,
    /// Lists of registers of operations with many operands.
    pub lists: Vec<Vec<Register>>,
    /// The line of each operation in the listing.
    pub lines: Vec<u32>,
    /// Registers that are read from each entry point on before they are written.
    pub read_first: Vec<Vec<Register>>,
    /// Lanes of boxes that the pipeline has, at most [`MOST_LANES`].
    pub lanes: u32,
}

impl Program {
    /// Prepares the listing `text` for `machine`, whose pipeline takes so many cycles.
    ///
    /// # Errors
    /// See [`ListingError`].
    pub fn new(
        name: &str,
        text: &str,
        machine: &MachineDescription,
        pipeline_latency_cycles: u32,
    ) -> Result<Self, ListingError> {
        let mut listing = Listing::parse(name, text)?;
        listing.widen_loads(machine.load_words() as usize);
        let graph = Graph::new(name, &listing)?;
        let source = Source {
            listing: &listing,
            machine,
            pipeline_latency_cycles,
            routes: &graph.routes,
            entries: graph.entries.len(),
        };
        let code = Code::new(&source).map_err(|at| ListingError {
            program: name.to_owned(),
            line: listing.instructions[at].line as usize,
            message: "too many accesses to global memory without a loop".to_owned(),
        })?;
        let live = liveness::read_first(&listing);
        let read_first = graph.entries.iter().map(|node| {
            let live = live[graph.nodes[*node as usize].body.start as usize];
            (0..REGISTERS as Register).filter(|register| live >> register & 1 == 1).collect()
        });
        let read_first = read_first.collect();
        let is_new = new_addresses(&listing);
        let operations = listing.instructions.iter().zip(is_new).map(|(instruction, is_new)| {
            let operation = instruction.operation;
            match operation.place() {
                Place::Load | Place::Store => Operation { b: is_new.into(), ..operation },
                _ => operation,
            }
        });
        Ok(Self {
            name: name.to_owned(),
            code,
            operations: operations.collect(),
            lines: listing.instructions.iter().map(|instruction| instruction.line).collect(),
            lists: listing.lists,
            read_first,
            lanes: MOST_LANES,
            graph,
        })
    }

    /// The further operands of `op`.
    #[inline(always)]
    #[must_use]
    pub fn operands_of(&self, op: &MicroOp) -> &Operands {
        &self.code.operands[usize::from(op.operands)]
    }

    /// Where the instructions of a run execute.
    #[must_use]
    pub fn places_of(&self, run: RunId) -> &[Place] {
        &self.code.places[run as usize]
    }

    /// The operations of a run.
    #[must_use]
    pub fn ops_of(&self, run: RunId) -> &[MicroOp] {
        let run = &self.code.runs[run as usize];
        &self.code.ops[run.first as usize..(run.first + run.length) as usize]
    }
}
