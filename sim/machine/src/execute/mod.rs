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
use crate::program::{EntryId, Program, Register, START};
use set_up::SetUp;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex};
use thread::{Stop, Surroundings, Thread};

/// Items that are executed beforehand to find what items leave; one in eight of them is asked whether it reads that.
const PROBES: u32 = 64;

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

/// What items that have been executed have read and left.
#[derive(Debug, Default)]
struct Left {
    /// The items, with the entry points where they began.
    items: Vec<(u32, EntryId)>,
    /// Places that items have left otherwise, and that were not known of before.
    changed: BTreeSet<(EntryId, Place)>,
}

/// Where an item can leave something to the next one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    /// A register.
    Register(u8),
    /// A word of the local store.
    Word(usize),
}

/// What an item has done.
#[derive(PartialEq)]
struct Trace {
    tape: Vec<u32>,
    stored: Vec<[u32; 2]>,
    fault: Option<Box<Fault>>,
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

    /// Executes items from all over the work, and poisons what they leave otherwise.
    fn probe(&mut self) -> Result<(), Box<Fault>> {
        let stride = (self.items / PROBES).max(1);
        let mut counts = vec![0; self.program.code.runs.len()];
        for item in (0..self.items).step_by(stride as usize) {
            for entry in self.entries.clone() {
                self.record(item, entry, &mut Tape::new(&mut vec![], &mut counts))?;
                self.poison();
            }
        }
        self.left = Mutex::default();
        for item in (0..self.items).step_by(stride as usize * 8) {
            for entry in &self.entries {
                self.blame(item, *entry).map_or(Ok(()), Err)?;
            }
        }
        Ok(())
    }

    /// Poisons the places that items have left otherwise; whether there were any.
    fn poison(&mut self) -> bool {
        let changed = std::mem::take(&mut self.left.get_mut().expect("no panic while it was held").changed);
        let any = !changed.is_empty();
        for (entry, place) in changed {
            let set_up = self.set_ups[usize::from(entry)].as_mut().expect("an item begins here");
            match place {
                Place::Register(register) => _ = set_up.poisoned.insert(register),
                Place::Word(at) => set_up.local[at] = None,
            }
        }
        any
    }

    fn around<'b>(&'b self, special: &'b S) -> Surroundings<'b, S> {
        Surroundings { program: &self.program, memory: &self.memory, special }
    }

    fn set_up(&self, entry: EntryId) -> &SetUp {
        self.set_ups[usize::from(entry)].as_ref().expect("an item begins here")
    }

    /// Where items begin, in the order in which a thread comes to them; none if there are no items.
    #[must_use]
    pub fn entries(&self) -> &[EntryId] {
        &self.entries
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

    /// Compares the state that an item has left with the one in which others begin.
    fn compare(&self, thread: &Thread, item: u32, entry: EntryId, next: EntryId) {
        let set_up = self.set_up(next);
        let read = &self.program.read_first[usize::from(next)];
        let registers = set_up.other_registers(thread, read).map(Place::Register);
        let changed = registers.chain(set_up.other_words(thread).map(Place::Word));
        let mut left = self.left.lock().expect("no panic while it was held");
        left.items.push((item, entry));
        left.changed.extend(changed.map(|place| (next, place)));
    }

    /// `fault` of an item that began at `entry`, or what has led to it.
    fn explained(&self, fault: Box<Fault>, entry: EntryId) -> Box<Fault> {
        match fault.mistake {
            // To execute the item again would take as long.
            Mistake::NoProgress(_) => fault,
            _ => self.blame(fault.item, entry).unwrap_or(fault),
        }
    }

    /// The place that nothing or an earlier item has written and that decides what item `item` does, if there is one.
    #[must_use]
    pub fn blame(&self, item: u32, entry: EntryId) -> Option<Box<Fault>> {
        let set_up = self.set_ups[usize::from(entry)].as_ref()?;
        let (poisoned, reads) = self.trace(item, entry, set_up);
        let decides = |other: &SetUp| self.trace(item, entry, other).0 != poisoned;
        for register in &set_up.poisoned {
            let mut other = set_up.clone();
            other.poisoned.remove(register);
            if decides(&other) {
                let at = self.first_read(entry, *register);
                return Some(Fault::new(&self.program, at, item, Mistake::RegisterLeft(*register)));
            }
        }
        for (word, at) in reads {
            let mut other = set_up.clone();
            other.local[word] = Some(0);
            if decides(&other) {
                return Some(Fault::new(&self.program, at, item, Mistake::LocalLeft(4 * word as u32)));
            }
        }
        None
    }

    /// The first operation that reads `register`, in the order of addresses from `entry` on and round.
    fn first_read(&self, entry: EntryId, register: Register) -> usize {
        let program = &*self.program;
        let from =
            program.graph.nodes[program.graph.entries[usize::from(entry)] as usize].body.start as usize;
        let reads = |at: &usize| program.operations[*at].accesses(&program.lists).0.contains(&register);
        (from..program.operations.len()).chain(0..from).find(reads).unwrap_or(from)
    }

    /// What item `item` does from `set_up` on, and its reads of poisoned words of the local store.
    fn trace(&self, item: u32, entry: EntryId, set_up: &SetUp) -> (Trace, BTreeMap<usize, usize>) {
        let mut thread = Thread::new(&self.program);
        let (mut words, mut counts) = (vec![], vec![0; self.program.code.runs.len()]);
        let mut tape = Tape::new(&mut words, &mut counts);
        let stop = self.run(&mut thread, &self.special, item, (entry, set_up), &mut tape);
        let trace = Trace { tape: words, stored: thread.stored, fault: stop.err() };
        (trace, thread.poisoned_reads)
    }

    /// Executes again what was executed before it was known that others change what it may read.
    ///
    /// # Errors
    /// What an item has read that another one has left.
    ///
    /// # Panics
    /// If executing an item has panicked.
    pub fn check(&mut self) -> Result<(), Box<Fault>> {
        let idle = self.idle.get_mut().expect("no panic while it was held");
        let left = self.left.get_mut().expect("no panic while it was held");
        left.changed.retain(|(entry, place)| match place {
            Place::Register(_) => true,
            Place::Word(at) => idle.iter().any(|thread| thread.inherited[usize::from(*entry)].contains(at)),
        });
        let items = std::mem::take(&mut left.items);
        if !self.poison() {
            return Ok(());
        }
        let before = self.memory.all_written();
        for (item, entry) in items {
            let (trace, _) = self.trace(item, entry, self.set_up(entry));
            let differs = |[address, _]: &[u32; 2]| {
                let at = (address - self.memory.written_range().start) as usize;
                self.memory.written(*address) != before[at]
            };
            if (trace.fault.is_some() || trace.stored.iter().any(differs))
                && let Some(fault) = self.blame(item, entry)
            {
                return Err(fault);
            }
        }
        Ok(())
    }
}
