//! Execution: what a program computes, item by item, ahead of the timing core.
//!
//! The threads of the machine take items of work from a counter, so which thread executes an item is a matter of timing. An item is
//! therefore executed by itself, from the state in which a thread comes to its first or to a later item. [`Executor`] finds these
//! states once, and compares them with the state that every item leaves. What items leave otherwise holds a poisonous value for the
//! next one: a program that reads it computes something else, and is found out ([`Fault`]). Likewise for a word of global memory that
//! another item has written ([`Memory`]).
//!
//! Executing gives the picture, and the runs and addresses that the timing core takes. Items can be executed in any order and on
//! several threads of the host.

mod accesses;
mod fault;
mod independence;
mod interpreter;
mod local_store;
mod memory;
mod pipelines;
mod set_up;
mod special;
#[cfg(test)]
mod tests;
mod thread;

pub use fault::{Difference, Fault, Mistake};
pub use local_store::{LOCAL_STORE_BYTES, Misplaced};
pub use memory::{Denied, Memory};
pub use special::Special;

use crate::core::Tape;
use crate::program::{EntryId, Program, START};
use independence::Left;
use set_up::SetUp;
use std::sync::{Arc, Mutex};
use thread::{Stop, Surroundings, Thread};

/// Places at which a program may ask for items: for the first, and for all others.
const MOST_PLACES: usize = 2;

/// Executes the items of a program.
pub struct Executor<S> {
    program: Arc<Program>,
    memory: Memory,
    special: S,
    items: u32,
    /// The state by entry point; none where no item begins.
    set_ups: Vec<Option<SetUp>>,
    /// Where items begin, in the order in which a thread comes to them.
    entries: Vec<EntryId>,
    /// Threads that execute nothing at the moment.
    idle: Mutex<Vec<Thread>>,
    left: Mutex<Left>,
}

impl<S: Special> Executor<S> {
    /// Executes `program` up to its first item, and some items to find where others begin and in which state.
    ///
    /// # Errors
    /// What the program does wrong.
    pub fn new(program: Arc<Program>, memory: Memory, special: S, items: u32) -> Result<Self, Box<Fault>> {
        let mut executor = Self {
            set_ups: program.graph.entries.iter().map(|_| None).collect(),
            entries: vec![],
            idle: Mutex::default(),
            left: Mutex::default(),
            program: Arc::clone(&program),
            memory,
            special,
            items,
        };
        let mut thread = Thread::new(&program);
        let (mut set_up, mut entry) = (SetUp::start(), START);
        set_up.restore(&mut thread);
        let (mut words, mut counts) = (vec![], vec![0; program.code.runs.len()]);
        loop {
            let mut tape = Tape::new(&mut words, &mut counts);
            let stop = thread.run(executor.around(&executor.special), entry, &set_up, &mut tape);
            let (at, next) = match stop.map_err(|fault| executor.explained(fault, entry))? {
                Stop::Counter(at, next) => (at, next),
                Stop::End(at) if executor.entries.is_empty() => {
                    return Err(Fault::new(&program, at, 0, Mistake::NoItems));
                }
                Stop::End(_) => break,
            };
            if executor.set_ups[usize::from(next)].is_some() || items == 0 {
                break;
            }
            if executor.entries.len() == MOST_PLACES {
                return Err(Fault::new(&program, at, 0, Mistake::AsksElsewhere));
            }
            set_up = set_up.after(&thread, program.operations[at].d);
            executor.set_ups[usize::from(next)] = Some(set_up.clone());
            executor.entries.push(next);
            thread.registers[usize::from(set_up.item)] = 0;
            thread.begin(0);
            entry = next;
        }
        executor.probe()?;
        Ok(executor)
    }

    fn around<'b>(&'b self, special: &'b S) -> Surroundings<'b, S> {
        Surroundings { program: &self.program, memory: &self.memory, special }
    }

    fn set_up(&self, entry: EntryId) -> &SetUp {
        self.set_ups[usize::from(entry)].as_ref().expect("an item begins here")
    }

    /// Where the first item of a thread begins, and where all later ones do; none if there are no items.
    #[must_use]
    pub fn entries(&self) -> Option<(EntryId, EntryId)> {
        self.entries.first().copied().zip(self.entries.last().copied())
    }

    /// Number of items.
    #[must_use]
    pub fn items(&self) -> u32 {
        self.items
    }

    /// Global memory.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// Records what a thread does from its start until it asks for an item.
    ///
    /// # Errors
    /// What the program does wrong.
    pub fn start(&self, tape: &mut Tape<'_>) -> Result<(), Box<Fault>> {
        let set_up = SetUp::start();
        let mut thread = Thread::new(&self.program);
        set_up.restore(&mut thread);
        thread.run(self.around(&self.special), START, &set_up, tape)?;
        Ok(())
    }

    /// Executes item `item` on a thread that has asked for it and goes on at `entry`, and records what the thread does until it asks
    /// for the next one; returns the number of exact triangle tests. From item number [`Self::items`] on, there is no more.
    ///
    /// # Errors
    /// What the program does wrong.
    ///
    /// # Panics
    /// If no item begins at `entry`.
    pub fn record(&self, item: u32, entry: EntryId, tape: &mut Tape<'_>) -> Result<u64, Box<Fault>> {
        self.record_with(&self.special, item, entry, tape)
    }

    /// [`Self::record`] with other operations that compute the same.
    ///
    /// # Errors
    /// What the program does wrong.
    ///
    /// # Panics
    /// If no item begins at `entry`.
    pub fn record_with(
        &self,
        special: &S,
        item: u32,
        entry: EntryId,
        tape: &mut Tape<'_>,
    ) -> Result<u64, Box<Fault>> {
        let idle = self.idle.lock().expect("no panic while it was held").pop();
        let mut thread = idle.unwrap_or_else(|| Thread::new(&self.program));
        let stop = self.run(&mut thread, special, item, (entry, self.set_up(entry)), tape);
        let stop = stop.map_err(|fault| self.explained(fault, entry))?;
        let mistake = match stop {
            Stop::Counter(at, _) if item >= self.items => Some((at, Mistake::AsksOn)),
            Stop::Counter(at, next) if self.set_ups[usize::from(next)].is_none() => {
                Some((at, Mistake::AsksElsewhere))
            }
            Stop::Counter(_, next) => {
                self.compare(&thread, item, entry, next);
                None
            }
            Stop::End(at) => (item < self.items).then_some((at, Mistake::EndsEarly)),
        };
        if let Some((at, mistake)) = mistake {
            return Err(self.explained(Fault::new(&self.program, at, item, mistake), entry));
        }
        let exact_tests = thread.exact_tests;
        self.idle.lock().expect("no panic while it was held").push(thread);
        Ok(exact_tests)
    }

    fn run(
        &self,
        thread: &mut Thread,
        special: &S,
        item: u32,
        (entry, set_up): (EntryId, &SetUp),
        tape: &mut Tape<'_>,
    ) -> Result<Stop, Box<Fault>> {
        set_up.restore(thread);
        thread.registers[usize::from(set_up.item)] = item;
        thread.exact_tests = 0;
        thread.begin(item);
        thread.run(self.around(special), entry, set_up, tape)
    }
}
