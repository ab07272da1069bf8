//! Executes items ahead of their timing, on a thread of its own.
//!
//! The timing core needs what a thread executes when that thread has got an item. Which items there are, and where they begin but
//! for the first of each thread, is known beforehand: so they are executed in order while the core times earlier ones. Results do not
//! depend on it.

use super::plan::Plan;
use super::work::{Tape, Work};
use crate::execute::Fault;
use crate::program::{EntryId, Program, RunId};
use std::collections::HashMap;
use std::sync::Mutex;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};

/// Most items that are executed and not yet timed.
const MOST_AHEAD: usize = 256;

/// An item with more words is not followed by others ahead of time, so that those that wait do not fill the memory.
const MOST_WORDS: usize = 1 << 20;

/// An item that has been executed.
struct Executed {
    item: u32,
    entry: EntryId,
    tape: Result<Vec<u32>, Box<Fault>>,
}

/// Work whose items are executed ahead.
struct Ahead<'a, W> {
    work: &'a W,
    program: &'a Program,
    state: Mutex<State>,
}

struct State {
    executed: Receiver<Executed>,
    /// Items that came before they were asked for.
    early: HashMap<u32, Executed>,
}

/// Calls `time` with `work`, whose items are executed ahead of being asked for. The first `threads` items that `plan` times are those
/// with which threads begin.
pub fn ahead<W: Work, T>(
    work: &W,
    program: &Program,
    plan: &Plan,
    threads: u32,
    time: impl FnOnce(&dyn Work) -> T,
) -> T {
    let (sender, executed) = sync_channel(MOST_AHEAD);
    std::thread::scope(|scope| {
        // The sender goes when an item has failed, so that nobody waits for those behind it.
        scope.spawn(move || execute(work, program, plan, threads, &sender));
        // The receiver goes when timing is over or has failed, and with it whoever sends.
        let state = Mutex::new(State { executed, early: HashMap::new() });
        time(&Ahead { work, program, state })
    })
}

/// Executes all items in order, and sends them.
fn execute<W: Work>(work: &W, program: &Program, plan: &Plan, threads: u32, sender: &SyncSender<Executed>) {
    let Some((first, later)) = work.entries() else {
        return;
    };
    let mut counts = vec![0; program.code.runs.len()];
    let (mut timed, mut skips) = (0, plan.skipped.iter().peekable());
    for item in 0..work.items() {
        while skips.next_if(|range| range.end <= item).is_some() {}
        let is_skipped = skips.peek().is_some_and(|range| range.contains(&item));
        // An item that is not timed begins where the thread is that passes over it.
        let entry = if timed < threads { first } else { later };
        timed += u32::from(!is_skipped);
        let mut words = vec![];
        let tape = Tape::new(&mut words, &mut counts);
        let recorded = work.record(item, entry, &mut if is_skipped { tape.not_timed() } else { tape });
        let is_last = recorded.is_err() || words.len() > MOST_WORDS;
        let executed = Executed { item, entry, tape: recorded.map(|()| words) };
        if sender.send(executed).is_err() || is_last {
            return;
        }
    }
}

impl<W: Work> Work for Ahead<'_, W> {
    fn items(&self) -> u32 {
        self.work.items()
    }

    fn entries(&self) -> Option<(EntryId, EntryId)> {
        self.work.entries()
    }

    fn start(&self, tape: &mut Tape<'_>) -> Result<(), Box<Fault>> {
        self.work.start(tape)
    }

    fn record(&self, item: u32, entry: EntryId, tape: &mut Tape<'_>) -> Result<(), Box<Fault>> {
        let executed = if item < self.items() { self.wait(item) } else { None };
        match executed {
            Some(executed) if executed.entry == entry => {
                let words = executed.tape?;
                tape.append(words, |run: RunId| self.program.code.runs[run as usize].addresses);
                Ok(())
            }
            _ => self.work.record(item, entry, tape),
        }
    }
}

impl<W> Ahead<'_, W> {
    /// Item `item`, once it has been executed; none if there was a fault before.
    fn wait(&self, item: u32) -> Option<Executed> {
        let mut state = self.state.lock().expect("one thread times");
        let State { executed, early } = &mut *state;
        loop {
            if let Some(found) = early.remove(&item) {
                return Some(found);
            }
            let next = executed.recv().ok()?;
            early.insert(next.item, next);
        }
    }
}
