//! The chip, cycle by cycle.

use super::dram::{Dram, Requester};
use super::l2::L2;
use super::outstanding::UNKNOWN;
use super::stats::{CacheCounts, DramCounts, ThreadCycles};
use super::tm::{Request, Tm};
use super::work::{Tape, Work};
use crate::machine::description::MachineDescription;
use crate::machine::program::{EntryId, Kind, Program, START};

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

struct Chip<'a, W> {
    machine: &'a MachineDescription,
    program: &'a Program,
    work: &'a W,
    tms: Vec<Tm>,
    /// The item that each thread of each multiprocessor has got from the counter.
    items: Vec<Vec<u32>>,
    l2s: Vec<L2>,
    dram: Dram,
    next_item: u32,
    now: u32,
    /// The cycle after `now` in which something can happen.
    next: u32,
    runs: Vec<u64>,
    ended: Vec<u8>,
    no_more: u32,
    line_shift: u32,
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
    mut items_done: impl FnMut(u32),
) -> Result<Counts, SimulationError> {
    let tms = machine.chip.tms();
    let mut chip = Chip {
        machine,
        program,
        work,
        tms: (0..tms).map(|_| Tm::new(machine)).collect(),
        items: vec![vec![0; machine.tm.threads as usize]; tms as usize],
        l2s: (0..machine.chip.l2_partitions).map(|_| L2::new(&machine.l2)).collect(),
        dram: Dram::new(&machine.dram),
        next_item: 0,
        now: 0,
        next: 0,
        runs: vec![0; program.runs.len()],
        ended: vec![],
        no_more: program.condition("no_more"),
        line_shift: machine.l1.line_words().trailing_zeros(),
    };
    let start = program.entry(START);
    for tm in 0..tms as usize {
        for thread in 0..machine.tm.threads as usize {
            chip.start(tm, thread, start);
        }
    }
    let mut reported = 0;
    while !chip.tms.iter().all(Tm::is_halted) {
        chip.now = chip.next;
        chip.cycle();
        if chip.now > MAX_CYCLES {
            return Err(SimulationError::TooLong);
        }
        if chip.next_item - reported >= 256 {
            items_done(chip.next_item - reported);
            reported = chip.next_item;
        }
    }
    Ok(chip.counts())
}

impl<W: Work> Chip<'_, W> {
    /// Puts a thread at the start of the program.
    fn start(&mut self, tm: usize, thread: usize, entry: EntryId) {
        let place = &mut self.tms[tm].places[thread];
        Tape::new(self.program, entry, &mut place.tape, &mut self.runs).event(entry, 0);
        self.tms[tm].enter(self.program, thread);
    }

    fn cycle(&mut self) {
        let now = self.now;
        if now > 0 {
            self.dram.advance(now - 1);
        }
        while let Some(arrival) = self.dram.arrival(now) {
            let tm = usize::from(arrival.requester.tm);
            let partition = tm / self.machine.chip.tms_per_partition as usize;
            self.l2s[partition].fill(arrival.line);
            self.tms[tm].arrive(now, arrival.line);
        }
        let mut ended = std::mem::take(&mut self.ended);
        let mut asked = false;
        for tm in 0..self.tms.len() {
            if self.tms[tm].is_awake(now) {
                self.tms[tm].cycle(self.program, now, &mut ended);
                asked |= !self.tms[tm].outbox.is_empty();
                ended.drain(..).for_each(|thread| self.tape_ended(tm, thread.into()));
            }
        }
        if asked {
            self.serve(now, &mut ended);
        }
        self.ended = ended;
        self.next = self.next_cycle();
    }

    /// The next cycle in which anything can happen.
    fn next_cycle(&self) -> u32 {
        let mut next = u32::MAX;
        for tm in &self.tms {
            next = next.min(tm.next_wake(self.now));
            if next == self.now + 1 {
                return next;
            }
        }
        next.min(self.dram.next_event(self.now))
    }

    /// Serves what multiprocessors ask, beginning with the one whose thread has waited longest.
    fn serve(&mut self, now: u32, ended: &mut Vec<u8>) {
        let count = self.tms.len();
        let first = (0..count).min_by_key(|tm| self.tms[*tm].longest_wait()).unwrap_or(0);
        for tm in (first..count).chain(0..first) {
            if self.tms[tm].outbox.is_empty() {
                continue;
            }
            let mut outbox = std::mem::take(&mut self.tms[tm].outbox);
            for request in outbox.drain(..) {
                self.serve_one(tm, request, now, ended);
                ended.drain(..).for_each(|thread| self.tape_ended(tm, thread.into()));
            }
            self.tms[tm].outbox = outbox;
        }
    }

    fn serve_one(&mut self, number: usize, request: Request, now: u32, ended: &mut Vec<u8>) {
        let (tm, program) = (&mut self.tms[number], self.program);
        if request.kind == Kind::Counter {
            let item = self.next_item;
            // Threads that find nothing left leave the counter where it is.
            self.next_item = self.work.items().min(item + 1);
            self.items[number][usize::from(request.thread)] = item;
            return tm.done(program, request, now, ended);
        }
        if tm.settles(program, request, now, ended) {
            return;
        }
        let l2 = &mut self.l2s[number / self.machine.chip.tms_per_partition as usize];
        if !l2.take_bank(now, request.address) {
            return tm.refused();
        }
        let line = request.address >> self.line_shift;
        if request.kind == Kind::Store {
            if !self.dram.write(now, line) {
                return tm.refused();
            }
            l2.counts.stores += 1;
            return tm.done(program, request, now, ended);
        }
        if l2.hit(line) {
            l2.counts.loads += 1;
            l2.counts.hits += 1;
            let arrival = now + self.machine.l1.latency_cycles + self.machine.l2.latency_cycles;
            return tm.taken(program, request, now, arrival, ended);
        }
        if !self.dram.read(now, line, Requester { tm: number as u16 }) {
            return tm.refused();
        }
        l2.counts.loads += 1;
        tm.taken(program, request, now, UNKNOWN, ended);
    }

    /// A thread has come to the end of its tape: behind the counter, or at the end of the program.
    fn tape_ended(&mut self, tm: usize, thread: usize) {
        let program = self.program;
        let place = &mut self.tms[tm].places[thread];
        let Some(entry) = program.runs[place.tape[place.at] as usize].next else {
            self.tms[tm].halt(thread);
            return;
        };
        let item = self.items[tm][thread];
        place.tape.clear();
        place.at = 0;
        if item < self.work.items() {
            let mut tape = Tape::new(program, entry, &mut place.tape, &mut self.runs);
            tape.event(entry, 0);
            self.work.record(item, &mut tape);
        } else {
            Tape::new(program, entry, &mut place.tape, &mut self.runs).event(entry, self.no_more);
        }
        self.tms[tm].enter(program, thread);
    }

    fn counts(&mut self) -> Counts {
        let cycles = self.now + 1;
        let mut counts = Counts { cycles, runs: self.runs.clone(), ..Counts::default() };
        for tm in &mut self.tms {
            tm.finish(cycles);
            counts.thread_cycles.merge(&tm.cycles);
            counts.l1.merge(&tm.l1);
        }
        self.l2s.iter().for_each(|l2| counts.l2.merge(&l2.counts));
        counts.dram = self.dram.counts(cycles);
        counts
    }
}
