//! The chip, quantum by quantum.

mod serve;

use super::ahead::ahead;
use super::plan::{Noted, Plan, loads};
use super::request::Request;
use super::stats::ThreadCycles;
use super::tm::Tm;
use super::work::{Tape, Work};
use crate::description::MachineDescription;
use crate::execute::Fault;
use crate::program::Program;
use memory::{CacheCounts, DramCounts, Memory, Port};

/// Why a simulation stops.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// Cycles are counted in 32 bits.
    #[error(
        "more than {MAX_CYCLES} cycles: lower the size of the image, or give the machine more multiprocessors"
    )]
    TooLong,
    /// Nothing moves any more.
    #[error(
        "since cycle {last_issue}, no thread has executed an instruction: {waiting} threads wait, and of their requests the DRAM has \
         served {reads} reads and {writes} writes between {refreshes} refreshes; give the DRAM shorter times in `dram.timing`, a \
         longer `refresh_interval` or longer queues"
    )]
    Stuck {
        /// The cycle of the last instruction.
        last_issue: u32,
        /// Threads that have not finished.
        waiting: u32,
        /// Reads that the DRAM has served.
        reads: u64,
        /// Writes that the DRAM has served.
        writes: u64,
        /// Refreshes of the DRAM.
        refreshes: u64,
    },
    /// What threads execute at the same time does not fit in memory.
    #[error(
        "the items that are under way take more than {} MiB, as they execute many instructions each: give the machine fewer threads",
        MOST_WORDS >> 18
    )]
    TooMuch,
    /// The program does something wrong.
    #[error(transparent)]
    Fault(#[from] Box<Fault>),
}

/// The longest simulation, with a margin for the longest latency.
pub(crate) const MAX_CYCLES: u32 = u32::MAX - (1 << 20);

/// Cycles without an instruction after which nothing is expected to move any more: several times what the DRAM needs to empty its
/// queues with a row for each line and a refresh between them.
fn most_idle_cycles(machine: &MachineDescription) -> u32 {
    let dram = &machine.dram;
    let line = u64::from(dram.timing.turn() + dram.timing.four_activates + dram.timing.refresh);
    let queues = u64::from(dram.read_queue + dram.write_queue);
    (8 * line * queues).clamp(1 << 20, 1 << 30) as u32
}

/// Most words of the items that are under way.
pub(crate) const MOST_WORDS: usize = 1 << 29;

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

/// A multiprocessor with the work of its threads.
struct Seat {
    tm: Tm,
    /// The item that each thread has got from the counter.
    items: Vec<u32>,
    /// Words of its threads' tapes.
    words: usize,
    /// The most that they may be.
    most_words: usize,
    /// Times that each run was recorded.
    runs: Vec<u64>,
}

struct Chip<'a> {
    program: &'a Program,
    work: &'a dyn Work,
    seats: Vec<Seat>,
    /// With a port for each seat.
    memory: Memory,
    next_item: u32,
    /// Start of the current quantum.
    now: u32,
    /// Cycles of a quantum.
    length: u32,
    /// Room for the requests that are served next.
    tries: Vec<Request>,
    plan: &'a Plan,
    /// Number of the plan's skipped ranges that the counter has passed.
    skips: usize,
    noted: Vec<Noted>,
    /// Times that each run was recorded in items that are not timed.
    skipped_runs: Vec<u64>,
    /// What the program has done wrong.
    fault: Option<SimulationError>,
}

/// Simulates `work` by `program` on `machine`.
///
/// `items_done` is called from time to time with the number of items taken since its last call.
///
/// # Errors
/// See [`SimulationError`].
pub fn simulate<W: Work>(
    machine: &MachineDescription,
    program: &Program,
    work: &W,
    items_done: impl FnMut(u32),
) -> Result<Counts, SimulationError> {
    Ok(simulate_plan(machine, program, work, &Plan::default(), items_done)?.0)
}

/// [`simulate`] for the items that `plan` times. Runs are counted for all items, cycles and accesses for those that are timed. The
/// second result holds the counts at the plan's marks.
///
/// # Errors
/// See [`SimulationError`].
pub fn simulate_plan<W: Work>(
    machine: &MachineDescription,
    program: &Program,
    work: &W,
    plan: &Plan,
    items_done: impl FnMut(u32),
) -> Result<(Counts, Vec<Noted>), SimulationError> {
    if rayon::current_num_threads() == 1 {
        return time(machine, program, work, plan, items_done);
    }
    let threads = machine.chip.tms() * machine.tm.threads;
    ahead(work, program, plan, threads, |work| time(machine, program, work, plan, items_done))
}

/// [`simulate_plan`] on this thread of the host.
fn time(
    machine: &MachineDescription,
    program: &Program,
    work: &dyn Work,
    plan: &Plan,
    mut items_done: impl FnMut(u32),
) -> Result<(Counts, Vec<Noted>), SimulationError> {
    let (tms, memory) = (machine.chip.tms(), Memory::new(&machine.memory()));
    let mut chip = Chip {
        program,
        work,
        seats: (0..tms as u16)
            .map(|tm| Seat {
                tm: Tm::new(tm, machine),
                items: vec![0; machine.tm.threads as usize],
                words: 0,
                most_words: MOST_WORDS / tms as usize,
                runs: vec![0; program.code.runs.len()],
            })
            .collect(),
        length: memory.quantum(),
        memory,
        next_item: 0,
        now: 0,
        tries: vec![],
        plan,
        skips: 0,
        noted: Vec::with_capacity(plan.marks.len()),
        skipped_runs: vec![0; program.code.runs.len()],
        fault: None,
    };
    for seat in &mut chip.seats {
        for thread in 0..machine.tm.threads as usize {
            seat.start(program, work, thread)?;
        }
    }
    let (mut reported, mut looked, most_idle) = (0, 0, most_idle_cycles(machine));
    while !chip.seats.iter().all(|seat| seat.tm.is_halted()) {
        chip.quantum();
        if let Some(fault) = chip.fault {
            return Err(fault);
        }
        if chip.now > MAX_CYCLES {
            return Err(SimulationError::TooLong);
        }
        if chip.now - looked > most_idle {
            looked = chip.now;
            chip.check_moves(most_idle)?;
        }
        if chip.next_item - reported >= 256 {
            items_done(chip.next_item - reported);
            reported = chip.next_item;
        }
    }
    let counts = chip.counts();
    Ok((counts, chip.noted))
}

impl Seat {
    /// Puts a thread at the start of the program.
    fn start(&mut self, program: &Program, work: &dyn Work, thread: usize) -> Result<(), Box<Fault>> {
        let words = &mut self.tm.threads[thread].tape;
        work.start(&mut Tape::new(words, &mut self.runs))?;
        self.words += words.len();
        self.tm.resume(program, thread);
        Ok(())
    }

    /// Gives new tapes to the threads that need them and lets them catch up.
    fn change_tapes(
        &mut self,
        program: &Program,
        work: &dyn Work,
        port: &mut Port,
        fault: &mut Option<SimulationError>,
    ) {
        while let Some(thread) = self.tm.ended.pop() {
            let thread = usize::from(thread);
            if let Err(found) = self.change_tape(program, work, thread) {
                // Of several, the first; the simulation ends with the quantum.
                fault.get_or_insert(found);
                self.tm.halt(thread);
            }
            self.tm.run(program, port, thread);
        }
    }

    /// A thread has come to the end of its tape: behind the counter, or at the end of the program.
    fn change_tape(
        &mut self,
        program: &Program,
        work: &dyn Work,
        thread: usize,
    ) -> Result<(), SimulationError> {
        let place = &mut self.tm.threads[thread];
        let Some(entry) = program.code.runs[place.tape[place.at as usize] as usize].next else {
            self.tm.halt(thread);
            return Ok(());
        };
        self.words -= place.tape.len();
        place.tape.clear();
        place.at = 0;
        work.record(self.items[thread], entry, &mut Tape::new(&mut place.tape, &mut self.runs))?;
        self.words += place.tape.len();
        if self.words > self.most_words {
            return Err(SimulationError::TooMuch);
        }
        self.tm.resume(program, thread);
        Ok(())
    }
}

impl Chip<'_> {
    fn quantum(&mut self) {
        let (start, end) = (self.now, self.now + self.length);
        let (program, work, seats) = (self.program, self.work, &mut self.seats);
        self.memory
            .begin(start, |client, cycle| seats[usize::from(client.port)].tm.arrives(client.number, cycle));
        for (seat, port) in seats.iter_mut().zip(self.memory.ports()) {
            seat.tm.quantum(program, port, start, end);
            seat.change_tapes(program, work, port, &mut self.fault);
        }
        let mut wakes = self.memory.keeps();
        while wakes || self.seats.iter().any(|seat| !seat.tm.shared.asked.is_empty()) {
            self.serve(start, wakes);
            wakes = false;
            for (seat, port) in self.seats.iter_mut().zip(self.memory.ports()) {
                seat.change_tapes(program, work, port, &mut self.fault);
                seat.tm.catch_up(program, port);
                seat.change_tapes(program, work, port, &mut self.fault);
            }
        }
        self.now = self.next_start(end);
    }

    /// Whether a thread has executed an instruction in the last `most_idle` cycles.
    fn check_moves(&mut self, most_idle: u32) -> Result<(), SimulationError> {
        let running = self.seats.iter().filter(|seat| !seat.tm.is_halted());
        let last_issue = running.map(|seat| seat.tm.last_issue()).max().unwrap_or(self.now);
        if self.now - last_issue.min(self.now) <= most_idle {
            return Ok(());
        }
        let DramCounts { reads, writes, refreshes, .. } = self.memory.dram_counts(self.now);
        let waiting = self.seats.iter().map(|seat| seat.tm.running()).sum();
        Err(SimulationError::Stuck { last_issue, waiting, reads, writes, refreshes })
    }

    /// The first cycle from `end` on in which anything can happen, at the start of a quantum.
    fn next_start(&self, end: u32) -> u32 {
        let goes_on = self.seats.iter().any(|seat| seat.tm.goes_on_by(end));
        // A line whose time is known is announced before it arrives.
        if goes_on || self.memory.has_news() {
            return end;
        }
        let next = self.seats.iter().map(|seat| seat.tm.next_time()).min().unwrap_or(end);
        let next = next.min(self.memory.next_command());
        if next == u32::MAX { end } else { next.max(end) }
    }

    /// The next item that is timed. The counter stays at the number of items once they are all taken.
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
            let (l1, l2) = (self.memory.l1_counts(), self.memory.l2_counts());
            let dram = self.memory.dram_counts(now);
            let mut noted = Noted { cycles: now, l1, l2, dram, ..Noted::default() };
            self.seats.iter().for_each(|seat| noted.thread_cycles.merge(&seat.tm.shared.cycles));
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
            let mut tape = Tape::new(&mut words, &mut self.skipped_runs).not_timed();
            if let Err(fault) = self.work.record(item, entry, &mut tape) {
                self.fault.get_or_insert(fault.into());
                return;
            }
            if item < cold {
                continue;
            }
            let port = (item as usize % self.seats.len()) as u16;
            loads(self.program, &words, |word| self.memory.warm(port, word));
        }
    }

    fn counts(&mut self) -> Counts {
        let cycles = self.seats.iter().map(|seat| seat.tm.last_issue()).max().unwrap_or(0) + 1;
        let mut counts = Counts { cycles, runs: self.skipped_runs.clone(), ..Counts::default() };
        for seat in &mut self.seats {
            seat.tm.finish(cycles);
            counts.thread_cycles.merge(&seat.tm.shared.cycles);
            counts.runs.iter_mut().zip(&seat.runs).for_each(|(sum, times)| *sum += times);
        }
        (counts.l1, counts.l2) = (self.memory.l1_counts(), self.memory.l2_counts());
        counts.dram = self.memory.dram_counts(cycles);
        counts
    }
}
