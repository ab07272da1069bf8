//! What threads do: items of work, each a tape of events.

use crate::program::{Conditions, EntryId, Program, RunId};

/// Work for the threads of a machine.
pub trait Work {
    /// Number of items. Threads take them one by one from a shared counter.
    fn items(&self) -> u32;

    /// Writes the events of item `item`.
    fn record(&self, item: u32, tape: &mut Tape<'_>);
}

/// Records events as runs and addresses, in the order in which a thread executes them.
pub struct Tape<'a> {
    program: &'a Program,
    entry: EntryId,
    /// Current value of each of the program's addresses, in words.
    addresses: [u32; MAX_BASES],
    words: &'a mut Vec<u32>,
    /// Times that each run was recorded.
    counts: &'a mut [u64],
    /// Whether the item is timed, not only recorded.
    timed: bool,
}

/// Most addresses of a program.
pub const MAX_BASES: usize = 16;

impl<'a> Tape<'a> {
    /// A tape that begins at `entry`; the runs are appended to `words` and counted in `counts`.
    pub fn new(program: &'a Program, entry: EntryId, words: &'a mut Vec<u32>, counts: &'a mut [u64]) -> Self {
        Self { program, entry, addresses: [0; MAX_BASES], words, counts, timed: true }
    }

    /// The same for an item that is recorded and not timed.
    #[must_use]
    pub fn not_timed(self) -> Self {
        Self { timed: false, ..self }
    }

    /// Whether the item is timed.
    #[must_use]
    pub fn is_timed(&self) -> bool {
        self.timed
    }

    /// The program.
    #[must_use]
    pub fn program(&self) -> &'a Program {
        self.program
    }

    /// Sets an address of the program, in words.
    #[inline(always)]
    pub fn address(&mut self, base: u8, word: u32) {
        self.addresses[usize::from(base) & (MAX_BASES - 1)] = word;
    }

    /// The thread goes on from the entry point `at` under `conditions`.
    ///
    /// # Panics
    /// If the program is at another entry point, which is a mistake in the work or in the program's annotations.
    #[inline]
    pub fn event(&mut self, at: EntryId, conditions: Conditions) {
        assert_eq!(at, self.entry, "{}: event at another entry point", self.program.name);
        let id: RunId = self.program.run(at, conditions);
        let run = &self.program.code.runs[id as usize];
        self.words.push(id);
        self.counts[id as usize] += 1;
        for &base in &run.bases {
            self.words.push(self.addresses[usize::from(base) & (MAX_BASES - 1)]);
        }
        if let Some(next) = run.next {
            self.entry = next;
        }
    }
}
