//! Programs, prepared for the timing core.
//!
//! A program is a listing whose branches are decided by *events*: what the golden traversal did, as a set of named
//! conditions and addresses. From one entry point to the next, conditions determine the path, so each pair of entry point
//! and conditions becomes one straight run of operations, a [`Run`]. The core executes runs; it never computes.

mod isa;
mod listing;
mod run;

pub use isa::{Place, REGISTERS, Register};
pub use listing::{Listing, ListingError};
pub use run::{
    COUNTER, Issue, Kind, MicroOp, Operands, PIPELINE, POOLS, Run, RunId, SCOREBOARD, SINK, UNLIMITED,
    pool_of,
};

use super::description::MachineDescription;
use isa::ZERO;
use listing::{Control, Instruction};

/// Index of an entry point.
pub type EntryId = u8;

/// A set of conditions, one bit each, in the order of [`Program::conditions`].
pub type Conditions = u32;

/// A program, prepared for a machine.
#[derive(Clone, Debug)]
pub struct Program {
    /// Name.
    pub name: String,
    /// Operations of all runs.
    pub ops: Vec<MicroOp>,
    /// Nops before each operation, and before the end.
    pub nops_before: Vec<u32>,
    /// All runs.
    pub runs: Vec<Run>,
    /// Names of addresses.
    pub bases: Vec<String>,
    /// Names of conditions.
    pub conditions: Vec<String>,
    /// Registers of operations that read more than three or write several; the first are those of all others.
    pub operands: Vec<Operands>,
    entries: Vec<Entry>,
    pipeline_latency_cycles: u32,
}

#[derive(Clone, Debug)]
struct Entry {
    name: String,
    /// Conditions that the paths from here depend on, one bit each.
    bits: Vec<Conditions>,
    /// The run for each combination of these conditions.
    runs: Vec<RunId>,
}

/// The name of the entry point at which every thread starts.
pub const START: &str = "start";
/// The entry point behind every use of the shared counter.
const ITEM: &str = "item";
/// Most conditions of a program.
const MAX_CONDITIONS: usize = 32;
/// Longest path between entry points.
const MAX_RUN: usize = 4096;

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
        // A thread learns which item it has got when the counter answers.
        let after_counter: Vec<usize> = (listing.instructions.iter().enumerate())
            .filter(|(_, i)| i.decoded.place == Place::Counter)
            .map(|(at, _)| at + 1)
            .collect();
        for (number, at) in after_counter.into_iter().enumerate() {
            listing.entries.insert(at, format!("{ITEM}{number}"));
        }
        let mut program = Self {
            name: name.to_owned(),
            ops: vec![],
            nops_before: vec![0],
            runs: vec![],
            bases: vec![],
            conditions: vec![],
            operands: vec![Operands::default()],
            entries: vec![],
            pipeline_latency_cycles,
        };
        for instruction in &listing.instructions {
            if let Some((base, _)) = &instruction.address {
                intern(&mut program.bases, base);
            }
            if let Control::Branch(_, condition, _) = &instruction.control {
                intern(&mut program.conditions, condition);
            }
        }
        if program.conditions.len() > MAX_CONDITIONS {
            let message = format!("{} conditions, more than {MAX_CONDITIONS}", program.conditions.len());
            return Err(ListingError { program: name.to_owned(), line: 0, message });
        }
        let points: Vec<usize> = listing.entries.keys().copied().collect();
        for (&at, name) in &listing.entries {
            let mut entry = Entry { name: name.clone(), bits: vec![], runs: vec![] };
            program.prepare(&listing, &points, machine, at, &mut entry)?;
            program.entries.push(entry);
        }
        Ok(program)
    }

    /// Makes the runs of `entry` at instruction `at`.
    fn prepare(
        &mut self,
        listing: &Listing,
        points: &[usize],
        machine: &MachineDescription,
        at: usize,
        entry: &mut Entry,
    ) -> Result<(), ListingError> {
        // Paths that are still to be followed: conditions decided so far, and their values.
        let mut open = vec![(0, 0)];
        let mut complete = vec![];
        let mut mask = 0;
        while let Some((decided, values)) = open.pop() {
            match self.path(listing, points, at, decided, values)? {
                Path::Undecided(condition) => {
                    open.push((decided | condition, values));
                    open.push((decided | condition, values | condition));
                }
                Path::Complete { instructions, next } => {
                    let next =
                        next.map(|at| points.iter().position(|p| *p == at).expect("an entry") as EntryId);
                    let run = self.emit(listing, machine, &instructions, next);
                    mask |= decided;
                    complete.push((decided, values, run));
                }
            }
        }
        let run = |all: Conditions| {
            let found = complete.iter().find(|(decided, values, _)| all & decided == *values);
            found.expect("paths cover all values").2
        };
        entry.bits = (0..Conditions::BITS).map(|bit| 1 << bit).filter(|bit| mask & bit != 0).collect();
        let conditions = |index: u32| {
            let bits = entry.bits.iter().enumerate();
            bits.map(|(at, bit)| if index >> at & 1 != 0 { *bit } else { 0 }).sum::<Conditions>()
        };
        entry.runs = (0..1 << entry.bits.len()).map(|index| run(conditions(index))).collect();
        Ok(())
    }

    /// The path from instruction `at` to the next entry point.
    fn path(
        &self,
        listing: &Listing,
        points: &[usize],
        at: usize,
        decided: Conditions,
        values: Conditions,
    ) -> Result<Path, ListingError> {
        let mut instructions = vec![];
        let mut here = at;
        loop {
            let fail = |message: &str| ListingError {
                program: self.name.clone(),
                line: listing.instructions.get(here).map_or(0, |i| i.line),
                message: message.to_owned(),
            };
            let instruction =
                listing.instructions.get(here).ok_or_else(|| fail("the program does not end"))?;
            instructions.push(here);
            if instructions.len() > MAX_RUN {
                return Err(fail("a loop without entry point"));
            }
            let next = match &instruction.control {
                Control::Next => {
                    here += 1;
                    if points.contains(&here) {
                        return Ok(Path::Complete { instructions, next: Some(here) });
                    }
                    continue;
                }
                Control::End => None,
                Control::Jump(target) => Some(*target),
                Control::Branch(target, condition, taken_if) => {
                    let bit = 1 << self.conditions.iter().position(|c| c == condition).expect("interned");
                    if decided & bit == 0 {
                        return Ok(Path::Undecided(bit));
                    }
                    Some(if (values & bit != 0) == *taken_if { *target } else { here + 2 })
                }
            };
            // The delay slot.
            if points.contains(&(here + 1)) {
                return Err(fail("an entry point in a delay slot"));
            }
            instructions.push(here + 1);
            match next {
                None => return Ok(Path::Complete { instructions, next: None }),
                Some(target) if points.contains(&target) => {
                    return Ok(Path::Complete { instructions, next: Some(target) });
                }
                Some(target) => here = target,
            }
        }
    }

    fn emit(
        &mut self,
        listing: &Listing,
        machine: &MachineDescription,
        path: &[usize],
        next: Option<EntryId>,
    ) -> RunId {
        let first = self.ops.len() as u32;
        let mut bases: Vec<u8> = vec![];
        for &at in path {
            let instruction = &listing.instructions[at];
            let mut op = self.micro_op(instruction, at, machine);
            if let Some((base, offset)) = &instruction.address {
                let base = self.bases.iter().position(|b| b == base).expect("interned") as u8;
                let slot = bases.iter().position(|b| *b == base).unwrap_or_else(|| {
                    bases.push(base);
                    bases.len() - 1
                });
                op.base = slot as u8;
                op.offset = *offset as u16;
            }
            self.ops.push(op);
        }
        let length = self.ops.len() as u32 - first;
        for op in &self.ops[first as usize..] {
            let before = self.nops_before.last().expect("it begins with one");
            self.nops_before.push(before + u32::from(op.kind == Kind::Nop));
        }
        self.runs.push(Run { first, length, bases, next });
        self.runs.len() as RunId - 1
    }

    fn micro_op(&mut self, instruction: &Instruction, at: usize, machine: &MachineDescription) -> MicroOp {
        let decoded = &instruction.decoded;
        let latency = match decoded.place {
            Place::Unit(unit) => machine.units.pool(unit).latency_cycles,
            Place::Load => machine.l1.latency_cycles,
            Place::Pipeline => self.pipeline_latency_cycles,
            _ => 1,
        };
        let mut reads = [ZERO; 3];
        reads.iter_mut().zip(&decoded.reads).for_each(|(slot, register)| *slot = *register);
        let further = Operands {
            writes: if decoded.writes.len() > 1 { decoded.writes.clone() } else { vec![] },
            reads: decoded.reads.get(reads.len()..).unwrap_or_default().to_vec(),
        };
        let operands = self.operands.iter().position(|known| *known == further).unwrap_or_else(|| {
            self.operands.push(further);
            self.operands.len() - 1
        });
        let kind = match decoded.place {
            Place::Nop => Kind::Nop,
            Place::Load => Kind::Load,
            Place::Store => Kind::Store,
            Place::Counter => Kind::Counter,
            _ => Kind::Plain,
        };
        MicroOp {
            issue: match kind {
                _ if operands != 0 => Issue::Other,
                Kind::Plain | Kind::Nop => Issue::Plain,
                Kind::Load => Issue::Load,
                Kind::Store | Kind::Counter => Issue::Other,
            },
            pool: pool_of(decoded.place),
            kind,
            local_store: decoded.place == Place::LocalStore,
            bank: (at as u32 & (machine.icache.banks - 1)) as u8,
            reads,
            write: decoded.writes.first().copied().unwrap_or(SINK),
            latency: latency as u8,
            base: 0,
            offset: 0,
            operands: operands as u16,
        }
    }

    /// The entry point `name`.
    ///
    /// # Panics
    /// If there is none, which is a mistake in the program.
    #[must_use]
    pub fn entry(&self, name: &str) -> EntryId {
        self.find_entry(name).unwrap_or_else(|| panic!("{} has no entry point `{name}`", self.name))
    }

    /// The entry point `name`, if there is one.
    #[must_use]
    pub fn find_entry(&self, name: &str) -> Option<EntryId> {
        self.entries.iter().position(|entry| entry.name == name).map(|at| at as EntryId)
    }

    /// The bit of the condition `name`; 0 if the program does not ask for it.
    #[must_use]
    pub fn condition(&self, name: &str) -> Conditions {
        self.conditions.iter().position(|condition| condition == name).map_or(0, |at| 1 << at)
    }

    /// The index of the address `name`, if the program uses it.
    #[must_use]
    pub fn base(&self, name: &str) -> Option<u8> {
        self.bases.iter().position(|base| base == name).map(|at| at as u8)
    }

    /// The run from `entry` under `conditions`.
    #[must_use]
    pub fn run(&self, entry: EntryId, conditions: Conditions) -> RunId {
        let entry = &self.entries[usize::from(entry)];
        let index =
            entry.bits.iter().rev().fold(0, |index, bit| index << 1 | usize::from(conditions & bit != 0));
        entry.runs[index]
    }

    /// The further operands of `op`.
    #[inline(always)]
    #[must_use]
    pub fn operands_of(&self, op: &MicroOp) -> &Operands {
        &self.operands[usize::from(op.operands)]
    }

    /// The operations of a run.
    #[must_use]
    pub fn ops_of(&self, run: RunId) -> &[MicroOp] {
        let run = &self.runs[run as usize];
        &self.ops[run.first as usize..(run.first + run.length) as usize]
    }
}

enum Path {
    /// Depends on a condition that is not decided yet.
    Undecided(Conditions),
    Complete {
        instructions: Vec<usize>,
        next: Option<usize>,
    },
}

fn intern(names: &mut Vec<String>, name: &str) {
    if !names.iter().any(|known| known == name) {
        names.push(name.to_owned());
    }
}
