//! Items that have been executed, and wait for the machines to take them.

use crate::core::{MOST_WORDS, SimulationError, Tape, Work};
use crate::execute::Fault;
use crate::program::{EntryId, Program};
use rayon::prelude::*;
use std::collections::VecDeque;
use std::ops::Range;
use std::sync::Arc;

/// What a thread executes, as on a [`Tape`].
pub type Words = Arc<[u32]>;

/// An item in each form in which it is asked for.
#[derive(Clone, Debug, Default)]
struct Item {
    /// As the first one of its thread.
    first: Option<Words>,
    /// As a later one.
    later: Option<Words>,
}

/// The items that not all machines have taken yet.
pub struct Items<'a, W> {
    work: &'a W,
    program: &'a Program,
    entries: (EntryId, EntryId),
    /// Items that are the first one of a thread of some machine.
    firsts: Range<u32>,
    /// Items that are a later one.
    laters: Range<u32>,
    /// What every thread does before its first item, in the place of one if there is none left, and after its last one.
    pub ends: [Words; 3],
    waiting: VecDeque<Item>,
    /// The first of these.
    first: u32,
    words: usize,
    /// The most that they may be.
    pub most_words: usize,
}

impl<'a, W: Work> Items<'a, W> {
    /// The items of `work`, of which none has been executed.
    pub fn new(
        work: &'a W,
        program: &'a Program,
        firsts: Range<u32>,
        laters: Range<u32>,
    ) -> Result<Self, Box<Fault>> {
        let entries = work.entries().expect("work has items");
        let start = record(program, |tape| work.start(tape))?;
        let end = |entry| record(program, |tape| work.record(work.items(), entry, tape));
        let ends = [start, end(entries.0)?, end(entries.1)?];
        Ok(Self {
            work,
            program,
            entries,
            firsts,
            laters,
            ends,
            waiting: VecDeque::new(),
            first: 0,
            words: 0,
            most_words: MOST_WORDS,
        })
    }

    /// The item behind the last that has been executed.
    pub fn end(&self) -> u32 {
        self.first + self.waiting.len() as u32
    }

    /// Number of all items.
    pub fn all(&self) -> u32 {
        self.work.items()
    }

    /// Item `item`, which has been executed, as the first one of its thread or as a later one. It is executed again if it was expected to be the other.
    pub fn get(&self, item: u32, is_first: bool) -> Result<Words, Box<Fault>> {
        let Item { first, later } = &self.waiting[(item - self.first) as usize];
        let (executed, entry) = if is_first { (first, self.entries.0) } else { (later, self.entries.1) };
        match executed {
            Some(words) => Ok(Words::clone(words)),
            None => record(self.program, |tape| self.work.record(item, entry, tape)),
        }
    }

    /// Executes the next `count` items.
    pub fn execute(&mut self, count: u32) -> Result<(), SimulationError> {
        let items = self.end()..self.all().min(self.end() + count);
        let executed = items.into_par_iter().map(|item| {
            let of = |range: &Range<u32>, entry| {
                range
                    .contains(&item)
                    .then(|| record(self.program, |tape| self.work.record(item, entry, tape)))
                    .transpose()
            };
            Ok(Item { first: of(&self.firsts, self.entries.0)?, later: of(&self.laters, self.entries.1)? })
        });
        // Of several faults, the first.
        let executed: Vec<Result<Item, Box<Fault>>> = executed.collect();
        for item in executed {
            let item = item?;
            self.words += item.words();
            self.waiting.push_back(item);
        }
        if self.words > self.most_words { Err(SimulationError::TooMuch) } else { Ok(()) }
    }

    /// Forgets the items before `first`.
    pub fn forget(&mut self, first: u32) {
        while self.first < first
            && let Some(item) = self.waiting.pop_front()
        {
            self.words -= item.words();
            self.first += 1;
        }
    }
}

impl Item {
    fn words(&self) -> usize {
        [&self.first, &self.later].into_iter().flatten().map(|words| words.len()).sum()
    }
}

/// What `execute` puts on a tape.
fn record(
    program: &Program,
    execute: impl FnOnce(&mut Tape<'_>) -> Result<(), Box<Fault>>,
) -> Result<Words, Box<Fault>> {
    let mut words = vec![];
    // The machines count the runs that they take.
    execute(&mut Tape::new(&mut words, &mut vec![0; program.code.runs.len()]))?;
    Ok(words.into())
}
