//! Whether items are independent: what one leaves in a register or in the local store must not decide what another one does.

use super::Executor;
use super::fault::{Fault, Mistake};
use super::set_up::SetUp;
use super::special::Special;
use super::thread::Thread;
use crate::core::Tape;
use crate::program::{EntryId, Register};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Mutex;

/// Items that are executed beforehand to find what items leave; one in eight of them is asked whether it reads that.
const PROBES: u32 = 64;

/// What items that have been executed have read and left.
#[derive(Debug, Default)]
pub(super) struct Left {
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
    /// Executes items from all over the work, and poisons what they leave otherwise.
    pub(super) fn probe(&mut self) -> Result<(), Box<Fault>> {
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

    /// Poisons the places that items have left otherwise.
    fn poison(&mut self) {
        let changed = std::mem::take(&mut self.left.get_mut().expect("no panic while it was held").changed);
        for (entry, place) in changed {
            let set_up = self.set_ups[usize::from(entry)].as_mut().expect("an item begins here");
            match place {
                Place::Register(register) => _ = set_up.poisoned.insert(register),
                Place::Word(at) => set_up.local[at] = None,
            }
        }
    }

    /// Compares the state that an item has left with the one in which others begin.
    pub(super) fn compare(&self, thread: &Thread, item: u32, entry: EntryId, next: EntryId) {
        let set_up = self.set_up(next);
        let read = &self.program.read_first[usize::from(next)];
        let registers = set_up.other_registers(thread, read).map(Place::Register);
        let changed = registers.chain(set_up.other_words(thread).map(Place::Word));
        let mut left = self.left.lock().expect("no panic while it was held");
        left.items.push((item, entry));
        left.changed.extend(changed.map(|place| (next, place)));
    }

    /// `fault` of an item that began at `entry`, or what has led to it.
    pub(super) fn explained(&self, fault: Box<Fault>, entry: EntryId) -> Box<Fault> {
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
                return Some(self.left_fault(item, entry, Place::Register(*register)));
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

    /// The fault of item `item` that it reads `place`.
    fn left_fault(&self, item: u32, entry: EntryId, place: Place) -> Box<Fault> {
        let (at, mistake) = match place {
            Place::Register(register) => (self.first_read(entry, register), Mistake::RegisterLeft(register)),
            Place::Word(word) => (self.entry_at(entry), Mistake::LocalLeft(4 * word as u32)),
        };
        Fault::new(&self.program, at, item, mistake)
    }

    /// The operation at an entry point.
    fn entry_at(&self, entry: EntryId) -> usize {
        let graph = &self.program.graph;
        graph.nodes[graph.entries[usize::from(entry)] as usize].body.start as usize
    }

    /// The first operation that reads `register`, in the order of addresses from `entry` on and round.
    fn first_read(&self, entry: EntryId, register: Register) -> usize {
        let (program, from) = (&*self.program, self.entry_at(entry));
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
        let Some(&(_, first)) = left.changed.first() else { return Ok(()) };
        let items = std::mem::take(&mut left.items);
        let before = self.set_ups.clone();
        self.poison();
        for (item, entry) in items {
            let unpoisoned = before[usize::from(entry)].as_ref().expect("an item begins here");
            if self.trace(item, entry, unpoisoned).0 != self.trace(item, entry, self.set_up(entry)).0 {
                return Err(self.blame(item, entry).unwrap_or_else(|| self.left_fault(item, entry, first)));
            }
        }
        Ok(())
    }
}
