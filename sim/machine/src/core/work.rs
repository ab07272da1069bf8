//! What threads do: items of work, each a tape of runs.

use crate::execute::Fault;
use crate::program::{EntryId, RunId};

/// Work for the threads of a machine.
pub trait Work: Sync {
    /// Number of items. Threads take them one by one from a shared counter.
    fn items(&self) -> u32;

    /// Where the first item of a thread begins, and where all later ones do. None if that is not known before they are asked for.
    fn entries(&self) -> Option<(EntryId, EntryId)>;

    /// Records what every thread does from the start of the program until it asks for an item.
    ///
    /// # Errors
    /// What the program does wrong.
    fn start(&self, tape: &mut Tape<'_>) -> Result<(), Box<Fault>>;

    /// Records what a thread does that has got item `item` and goes on at `entry`, until it asks for the next one. With the number
    /// of all items, there is no more to do.
    ///
    /// # Errors
    /// What the program does wrong.
    fn record(&self, item: u32, entry: EntryId, tape: &mut Tape<'_>) -> Result<(), Box<Fault>>;
}

/// Runs and addresses, in the order in which a thread executes them: each run, then the addresses that its operations are relative
/// to, in words.
pub struct Tape<'a> {
    words: &'a mut Vec<u32>,
    /// Times that each run was recorded.
    counts: &'a mut [u64],
    /// Where the run lies that is being recorded.
    run_at: usize,
    /// Whether the item is timed, not only recorded.
    timed: bool,
}

impl<'a> Tape<'a> {
    /// Runs are appended to `words` and counted in `counts`.
    pub fn new(words: &'a mut Vec<u32>, counts: &'a mut [u64]) -> Self {
        Self { words, counts, run_at: 0, timed: true }
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

    /// A run begins. Which one it is will be known at its end.
    #[inline(always)]
    pub fn begin(&mut self) {
        self.run_at = self.words.len();
        self.words.push(0);
    }

    /// The run's next address.
    #[inline(always)]
    pub fn address(&mut self, word: u32) {
        self.words.push(word);
    }

    /// Appends `words` of another tape; `addresses` tells the number of a run's addresses.
    pub fn append(&mut self, words: Vec<u32>, addresses: impl Fn(RunId) -> u8) {
        let mut at = 0;
        while at < words.len() {
            let run: RunId = words[at];
            self.counts[run as usize] += 1;
            at += 1 + usize::from(addresses(run));
        }
        if self.words.is_empty() {
            *self.words = words;
        } else {
            self.words.extend(words);
        }
    }

    /// The run has been `run`.
    #[inline(always)]
    pub fn end(&mut self, run: RunId) {
        self.words[self.run_at] = run;
        self.counts[run as usize] += 1;
    }
}
