//! A thread: its state, and how it goes through a program.

use super::fault::{Fault, Mistake};
use super::local_store::LocalStore;
use super::memory::Memory;
use super::set_up::SetUp;
use super::special::Special;
use crate::core::Tape;
use crate::program::{Edge, EntryId, MOST_LANES, NodeId, Program, Register, Test};
use std::collections::{BTreeMap, BTreeSet};

/// Lanes of boxes, numbered from 1.
const LANES: usize = MOST_LANES as usize;

/// Most instructions of an item.
const MOST_INSTRUCTIONS: u64 = 1 << 27;

/// Where the dimensions that `RAND` goes through begin: behind the two of the place in the pixel.
const FIRST_DIMENSION: u32 = 2;

/// Where a thread has come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The operation with this index needs an item; the program goes on at an entry point.
    Counter(usize, EntryId),
    /// The program ends behind the operation with this index.
    End(usize),
}

/// The state of a thread.
#[derive(Clone, Debug)]
pub struct Thread {
    /// Registers by their numbers.
    pub registers: [u32; 256],
    /// The local store.
    pub local: LocalStore,
    /// Words of the local store that items have read as their thread's set-up has left them, by entry point.
    pub inherited: Vec<BTreeSet<usize>>,
    /// Words of the local store that the item has read although nothing or another item has written them, with the operation.
    pub poisoned_reads: BTreeMap<usize, usize>,
    /// What the item has stored to global memory: address and value.
    pub stored: Vec<[u32; 2]>,
    /// Exact decisions of triangle tests.
    pub exact_tests: u64,
    pub(super) lanes: [[f32; 6]; LANES],
    pub(super) entries: [f32; LANES],
    pub(super) item: u32,
    pub(super) dimension: u32,
}

/// What a thread executes, and what surrounds it.
pub struct Surroundings<'a, S> {
    /// The program.
    pub program: &'a Program,
    /// Global memory.
    pub memory: &'a Memory,
    /// The machine's own operations.
    pub special: &'a S,
}

impl<S> Clone for Surroundings<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S> Copy for Surroundings<'_, S> {}

impl Thread {
    /// A thread before its first instruction.
    #[must_use]
    pub fn new(program: &Program) -> Self {
        Self {
            registers: [0; 256],
            local: LocalStore::new(),
            inherited: vec![BTreeSet::new(); program.graph.entries.len()],
            poisoned_reads: BTreeMap::new(),
            stored: vec![],
            exact_tests: 0,
            lanes: [[0.0; 6]; LANES],
            entries: [0.0; LANES],
            item: 0,
            dimension: 0,
        }
    }

    /// Begins item `item`.
    pub fn begin(&mut self, item: u32) {
        self.local.begin();
        self.stored.clear();
        self.poisoned_reads.clear();
        self.item = item;
        self.dimension = FIRST_DIMENSION;
    }

    #[inline(always)]
    pub(super) fn get(&self, register: Register) -> u32 {
        self.registers[usize::from(register)]
    }

    #[inline(always)]
    pub(super) fn set(&mut self, register: Register, value: u32) {
        self.registers[usize::from(register)] = value;
    }

    #[inline(always)]
    pub(super) fn float(&self, register: Register) -> f32 {
        f32::from_bits(self.get(register))
    }

    #[inline(always)]
    pub(super) fn set_float(&mut self, register: Register, value: f32) {
        self.set(register, value.to_bits());
    }

    #[inline(always)]
    pub(super) fn floats<const N: usize>(&self, registers: &[Register]) -> [f32; N] {
        std::array::from_fn(|i| self.float(registers[i]))
    }

    /// Executes from the entry point `entry` on, until an item is needed or the program is over. `set_up` is the state there.
    ///
    /// # Errors
    /// What the program does wrong.
    pub fn run<S: Special>(
        &mut self,
        around: Surroundings<'_, S>,
        entry: EntryId,
        set_up: &SetUp,
        tape: &mut Tape<'_>,
    ) -> Result<Stop, Box<Fault>> {
        let Surroundings { program, .. } = around;
        let graph = &program.graph;
        let mut node: NodeId = graph.entries[usize::from(entry)];
        let mut executed = 0;
        let mut context = Context { around, entry, set_up, tape };
        context.tape.begin();
        loop {
            let here = &graph.nodes[node as usize];
            let body = here.body.start as usize..here.body.end as usize;
            for (at, operation) in (body.start..).zip(&program.operations[body.clone()]) {
                self.execute(at, operation, &mut context)?;
            }
            let mut edge = here.next;
            if let Some(branch) = &here.branch {
                let taken = self.holds(branch.test, branch.a, branch.b);
                let slot = branch.slot as usize;
                self.execute(slot, &program.operations[slot], &mut context)?;
                if taken {
                    edge = branch.taken;
                }
            }
            match edge {
                Edge::Node(next) => node = next,
                Edge::Entry(run, entry) => {
                    context.tape.end(run);
                    executed += u64::from(program.code.runs[run as usize].length);
                    if executed > MOST_INSTRUCTIONS {
                        return Err(self.fault(body.start, Mistake::NoProgress(MOST_INSTRUCTIONS), &context));
                    }
                    node = graph.entries[usize::from(entry)];
                    context.tape.begin();
                }
                Edge::Counter(run, entry) => {
                    context.tape.end(run);
                    return Ok(Stop::Counter(body.end, entry));
                }
                Edge::End(run) => {
                    context.tape.end(run);
                    return Ok(Stop::End(body.end));
                }
            }
        }
    }

    /// A mistake of the operation with index `at`.
    #[cold]
    pub(super) fn fault<S>(&self, at: usize, mistake: Mistake, context: &Context<'_, '_, S>) -> Box<Fault> {
        Fault::new(context.around.program, at, self.item, mistake)
    }

    #[inline(always)]
    fn holds(&self, test: Test, a: Register, b: Register) -> bool {
        let (a, b) = (self.get(a), self.get(b));
        match test {
            Test::Always => true,
            Test::Equal => a == b,
            Test::NotEqual => a != b,
            Test::Negative => (a as i32) < 0,
            Test::NotNegative => (a as i32) >= 0,
            Test::Positive => (a as i32) > 0,
            Test::NotPositive => (a as i32) <= 0,
        }
    }
}

/// What stays the same while an item is executed.
pub(super) struct Context<'a, 'tape, S> {
    pub(super) around: Surroundings<'a, S>,
    /// Where the item began.
    pub(super) entry: EntryId,
    /// The state there.
    pub(super) set_up: &'a SetUp,
    /// Where it is recorded.
    pub(super) tape: &'a mut Tape<'tape>,
}
