//! The chip, cycle by cycle.

mod serve;

use super::blocked::Blocked;
use super::dram::Dram;
use super::l2::L2;
use super::plan::{Noted, Plan, loads};
use super::quantum;
use super::stats::{CacheCounts, DramCounts, ThreadCycles};
use super::tm::{Request, Tm};
use super::work::{Tape, Work};
use crate::description::MachineDescription;
use crate::program::{Conditions, EntryId, Program, START};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Why a simulation stops.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SimulationError {
    /// Cycles are counted in 32 bits.
    #[error(
        "more than {MAX_CYCLES} cycles: lower the size of the image, or give the machine more multiprocessors"
    )]
    TooLong,
}

/// The longest simulation, with a margin for the longest latency.
const MAX_CYCLES: u32 = u32::MAX - (1 << 20);

/// What a simulation counted.
#[derive(Clone, Debug, Default)]
pub struct Counts {
    /// Cycles until the last thread finished.
    pub cycles: u32,
    /// What threads did.
    pub thread_cycles: ThreadCycles,
    /// Times that each run was executed.
    pub runs: Vec<u64>,
    /// All first-level caches.
    pub l1: CacheCounts,
    /// All second-level caches.
    pub l2: CacheCounts,
    /// The memory.
    pub dram: DramCounts,
}

/// A multiprocessor with what its threads are at.
struct Seat {
    tm: Tm,
    /// Its partition.
    partition: usize,
    /// The item that each thread has got from the counter.
    items: Vec<u32>,
    /// Times that each run was recorded.
    runs: Vec<u64>,
}

/// Multiprocessors from which on a quantum is shared out among the host's threads; fewer take less time than sharing.
const PARALLEL_TMS: usize = 8;

/// Says so when it is over, also when by a panic.
struct Over<'a>(&'a AtomicBool);

impl Drop for Over<'_> {
    fn drop(&mut self) {
        self.0.store(true, Relaxed);
    }
}

struct Chip<'a, W> {
    machine: &'a MachineDescription,
    program: &'a Program,
    work: &'a W,
    seats: Vec<Seat>,
    l2s: Vec<L2>,
    dram: Dram,
    next_item: u32,
    /// Start of the current quantum.
    now: u32,
    /// Cycles of a quantum.
    length: u32,
    /// Threads of the host.
    host_threads: usize,
    /// What is asked of the chip, by slot of the quantum.
    requests: [Vec<Request>; quantum::LONGEST],
    /// Room for what is asked by the current slot and not yet served, in order of place, of one place the newest first.
    waiting: Vec<Request>,
    /// Reads that found their memory channel full.
    blocked: Blocked,
    no_more: Conditions,
    line_shift: u32,
    plan: &'a Plan,
    /// Number of skipped ranges behind the counter.
    skips: usize,
    noted: Vec<Noted>,
    /// Times that runs of items were recorded that are not timed.
    skipped_runs: Vec<u64>,
}

/// Simulates `work` by `program` on `machine`.
///
/// `items_done` is called with the number of items taken since its last call, now and then.
///
/// # Errors
/// See [`SimulationError`].
pub fn simulate<W: Work>(
    machine: &MachineDescription,
    program: &Program,
    work: &W,
    items_done: impl FnMut(u32) + Send,
) -> Result<Counts, SimulationError> {
    Ok(simulate_plan(machine, program, work, &Plan::default(), items_done)?.0)
}

/// [`simulate`], timing what `plan` says. Runs are counted of all items, cycles and accesses of those that are timed; beside
/// them what was noted at the plan's marks.
///
/// # Errors
/// See [`SimulationError`].
pub fn simulate_plan<W: Work>(
    machine: &MachineDescription,
    program: &Program,
    work: &W,
    plan: &Plan,
    mut items_done: impl FnMut(u32) + Send,
) -> Result<(Counts, Vec<Noted>), SimulationError> {
    let tms = machine.chip.tms();
    let mut chip = Chip {
        machine,
        program,
        work,
        seats: (0..tms as u16)
            .map(|tm| Seat {
                tm: Tm::new(tm, machine),
                partition: usize::from(tm) / machine.chip.tms_per_partition as usize,
                items: vec![0; machine.tm.threads as usize],
                runs: vec![0; program.code.runs.len()],
            })
            .collect(),
        l2s: (0..machine.chip.l2_partitions).map(|_| L2::new(&machine.l2)).collect(),
        dram: Dram::new(&machine.dram),
        next_item: 0,
        now: 0,
        length: quantum::cycles(machine),
        host_threads: rayon::current_num_threads(),
        requests: Default::default(),
        waiting: vec![],
        blocked: Blocked::new(machine.dram.channels),
        no_more: program.condition("no_more"),
        line_shift: machine.l1.line_words().trailing_zeros(),
        plan,
        skips: 0,
        noted: Vec::with_capacity(plan.marks.len()),
        skipped_runs: vec![0; program.code.runs.len()],
    };
    let start = program.entry(START);
    for seat in &mut chip.seats {
        (0..machine.tm.threads as usize).for_each(|thread| seat.start(program, thread, start));
    }
    chip.with_help(|chip| {
        let mut reported = 0;
        while !chip.seats.iter().all(|seat| seat.tm.is_halted()) {
            chip.quantum();
            if chip.now > MAX_CYCLES {
                return Err(SimulationError::TooLong);
            }
            if chip.next_item - reported >= 256 {
                items_done(chip.next_item - reported);
                reported = chip.next_item;
            }
        }
        Ok(())
    })?;
    let counts = chip.counts();
    Ok((counts, chip.noted))
}

impl Seat {
    /// Puts a thread at the start of the program.
    fn start(&mut self, program: &Program, thread: usize, entry: EntryId) {
        let words = &mut self.tm.threads[thread].tape;
        Tape::new(program, entry, words, &mut self.runs).event(entry, 0);
        self.tm.resume(program, thread);
    }

    /// Gives new tapes to the threads that need them and lets them catch up.
    #[inline]
    fn change_tapes<W: Work>(&mut self, program: &Program, work: &W, no_more: Conditions, quantum: [u32; 2]) {
        while let Some(thread) = self.tm.ended.pop() {
            let thread = usize::from(thread);
            self.change_tape(program, work, no_more, thread);
            self.tm.run(program, thread, quantum[0], quantum[1]);
        }
    }

    /// A thread has come to the end of its tape: behind the counter, or at the end of the program.
    #[inline(never)]
    fn change_tape<W: Work>(&mut self, program: &Program, work: &W, no_more: Conditions, thread: usize) {
        let place = &mut self.tm.threads[thread];
        let Some(entry) = program.code.runs[place.tape[place.at as usize] as usize].next else {
            self.tm.halt(thread);
            return;
        };
        let item = self.items[thread];
        place.tape.clear();
        place.at = 0;
        let mut tape = Tape::new(program, entry, &mut place.tape, &mut self.runs);
        if item < work.items() {
            tape.event(entry, 0);
            work.record(item, &mut tape);
        } else {
            tape.event(entry, no_more);
        }
        self.tm.resume(program, thread);
    }
}

impl<W: Work> Chip<'_, W> {
    /// Does `all` while the host's other threads stand by: a quantum is over before a sleeping one is awake.
    fn with_help<R: Send>(&mut self, all: impl FnOnce(&mut Self) -> R + Send) -> R {
        // Who is a thread of the pool already has others of its kind beside it, with work of their own.
        if self.seats.len() < PARALLEL_TMS || rayon::current_thread_index().is_some() {
            return all(self);
        }
        let over = &AtomicBool::new(false);
        rayon::scope(|scope| {
            let own = rayon::current_thread_index();
            for _ in 1..rayon::current_num_threads() {
                // On the thread that the work itself runs on, it would never be over.
                scope.spawn(move |_| {
                    while !over.load(Relaxed) && rayon::current_thread_index() != own {
                        if rayon::yield_now() != Some(rayon::Yield::Executed) {
                            std::hint::spin_loop();
                        }
                    }
                });
            }
            let _over = Over(over);
            all(self)
        })
    }

    /// Does `step` for every multiprocessor; they do not depend on each other.
    fn each(&mut self, step: impl Fn(&mut Seat) + Sync + Send) {
        let threads = self.host_threads;
        if self.seats.len() >= PARALLEL_TMS && threads > 1 {
            let share = self.seats.len().div_ceil(4 * threads).max(PARALLEL_TMS / 2);
            self.seats.par_iter_mut().with_min_len(share).for_each(step);
        } else {
            self.seats.iter_mut().for_each(step);
        }
    }

    fn quantum(&mut self) {
        let (start, end) = (self.now, self.now + self.length);
        self.dram.advance(start);
        let (seats, l2s) = (&mut self.seats, &mut self.l2s);
        self.dram.announce(start, |arrival| {
            let seat = &mut seats[usize::from(arrival.requester.tm)];
            l2s[seat.partition].arrives(arrival.line, arrival.cycle);
            seat.tm.arrives(arrival.line, arrival.cycle);
        });
        self.l2s.iter_mut().for_each(|l2| l2.begin(start));
        let (program, work, no_more) = (self.program, self.work, self.no_more);
        self.each(|seat| {
            seat.tm.quantum(program, start, end);
            seat.change_tapes(program, work, no_more, [start, end]);
        });
        let mut wakes = !self.blocked.is_empty();
        while wakes || self.seats.iter().any(|seat| !seat.tm.outbox.is_empty()) {
            self.serve(start, wakes);
            wakes = false;
            self.each(|seat| {
                seat.change_tapes(program, work, no_more, [start, end]);
                seat.tm.catch_up(program, start, end);
                seat.change_tapes(program, work, no_more, [start, end]);
            });
        }
        self.now = self.next_start(end);
    }

    /// The first cycle from `end` on in which anything can happen, at the start of a quantum.
    fn next_start(&self, end: u32) -> u32 {
        let goes_on = self.seats.iter().any(|seat| seat.tm.goes_on_by(end));
        // A line whose time is known is announced before it arrives.
        if goes_on || self.dram.has_news() || self.blocked.could_go_on(&self.dram) {
            return end;
        }
        let next = self.seats.iter().map(|seat| seat.tm.next_time()).min().unwrap_or(end);
        let next = next.min(self.dram.next_command());
        if next == u32::MAX { end } else { next.max(end) }
    }

    /// The next item that is timed; threads that find nothing left leave the counter where it is.
    fn take_item(&mut self, request: Request) -> u32 {
        self.note(request.cycle);
        while let Some(range) = self.plan.skipped.get(self.skips).filter(|r| r.start == self.next_item) {
            self.skip(range.clone(), request);
            self.next_item = range.end;
            self.skips += 1;
            self.note(request.cycle);
        }
        let item = self.next_item;
        self.next_item = self.work.items().min(item + 1);
        item
    }

    /// Notes counts if the counter has come to a mark.
    fn note(&mut self, now: u32) {
        while self.plan.marks.get(self.noted.len()).is_some_and(|mark| *mark <= self.next_item) {
            let mut noted = Noted { cycles: now, dram: self.dram.counts(now), ..Noted::default() };
            for seat in &self.seats {
                noted.thread_cycles.merge(&seat.tm.thread_cycles(self.program));
                noted.l1.merge(&seat.tm.l1.counts());
            }
            self.l2s.iter().for_each(|l2| noted.l2.merge(&l2.counts));
            self.noted.push(noted);
        }
    }

    /// Records the items of `range`, which the thread of `request` has come to; the last of them warm the caches.
    fn skip(&mut self, range: std::ops::Range<u32>, request: Request) {
        let thread = &self.seats[usize::from(request.tm)].tm.threads[usize::from(request.thread)];
        let run = &self.program.code.runs[thread.tape[thread.at as usize] as usize];
        let entry = run.next.expect("the program goes on behind the counter");
        let cold = range.end - range.end.min(self.plan.warming).min(range.len() as u32);
        let mut words = vec![];
        for item in range {
            words.clear();
            let mut tape = Tape::new(self.program, entry, &mut words, &mut self.skipped_runs).not_timed();
            tape.event(entry, 0);
            self.work.record(item, &mut tape);
            if item < cold {
                continue;
            }
            let number = item as usize % self.seats.len();
            let seat = &mut self.seats[number];
            let (l1, l2) = (&mut seat.tm.l1, &mut self.l2s[seat.partition]);
            loads(self.program, &words, |word| {
                let line = word >> self.line_shift;
                if !l1.warm(line) {
                    l2.warm(line);
                }
            });
        }
    }

    fn counts(&mut self) -> Counts {
        let cycles = self.seats.iter().map(|seat| seat.tm.last_issue()).max().unwrap_or(0) + 1;
        let mut counts = Counts { cycles, runs: self.skipped_runs.clone(), ..Counts::default() };
        for seat in &mut self.seats {
            seat.tm.finish(cycles);
            counts.thread_cycles.merge(&seat.tm.thread_cycles(self.program));
            counts.l1.merge(&seat.tm.l1.counts());
            counts.runs.iter_mut().zip(&seat.runs).for_each(|(sum, times)| *sum += times);
        }
        self.l2s.iter().for_each(|l2| counts.l2.merge(&l2.counts));
        counts.dram = self.dram.counts(cycles);
        counts
    }
}
