//! Programs, prepared for the timing core.
//!
//! A program is a listing whose branches are decided by *events*: what the golden traversal did, as a set of named
//! conditions and addresses. From one entry point to the next, conditions determine the path, so each pair of entry point
//! and conditions becomes one straight run of operations, a [`Run`]. The core executes runs; it never computes.

mod code;
mod isa;
mod listing;
mod paths;
mod run;
mod scoreboard;

pub use code::Code;
pub use isa::Place;
pub use listing::{Listing, ListingError};
pub use run::{COUNTER, Kind, MicroOp, Operands, PIPELINE, POOLS, Run, RunId, UNLIMITED};
pub use scoreboard::{BOARD_ENTRIES, BoardEntry};

use super::description::MachineDescription;
use code::Source;
use listing::Control;
use paths::{Entry, Paths};

/// Index of an entry point.
pub type EntryId = u8;

/// A set of conditions, one bit each, in the order of [`Program::conditions`].
pub type Conditions = u32;

/// A program, prepared for a machine.
#[derive(Clone, Debug)]
pub struct Program {
    /// Name.
    pub name: String,
    /// What it executes.
    pub code: Code,
    /// Names of addresses.
    pub bases: Vec<String>,
    /// Names of conditions.
    pub conditions: Vec<String>,
    entries: Vec<Entry>,
}

/// The name of the entry point at which every thread starts.
pub const START: &str = "start";
/// The entry point behind every use of the shared counter.
const ITEM: &str = "item";
/// Most conditions of a program.
const MAX_CONDITIONS: usize = 32;

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
        let (mut bases, mut conditions) = (vec![], vec![]);
        for instruction in &listing.instructions {
            if let Some((base, _)) = &instruction.address {
                intern(&mut bases, base);
            }
            if let Control::Branch(_, condition, _) = &instruction.control {
                intern(&mut conditions, condition);
            }
        }
        if conditions.len() > MAX_CONDITIONS {
            let message = format!("{} conditions, more than {MAX_CONDITIONS}", conditions.len());
            return Err(ListingError { program: name.to_owned(), line: 0, message });
        }
        let paths = Paths::new(name, &listing, &conditions);
        let (mut entries, mut routes) = (vec![], vec![]);
        for (&at, name) in &listing.entries {
            entries.push(paths.entry(name, at, &mut routes)?);
        }
        let source = Source {
            listing: &listing,
            machine,
            pipeline_latency_cycles,
            routes: &routes,
            entries: entries.len(),
            bases: &bases,
        };
        Ok(Self { name: name.to_owned(), code: Code::new(&source), bases, conditions, entries })
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
        self.entries[usize::from(entry)].run(conditions)
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

fn intern(names: &mut Vec<String>, name: &str) {
    if !names.iter().any(|known| known == name) {
        names.push(name.to_owned());
    }
}
