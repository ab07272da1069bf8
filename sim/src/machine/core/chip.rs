//! The chip, cycle by cycle.

use super::dram::{Dram, Read, Requester};
use super::l1::Access;
use super::l2::L2;
use super::outstanding::Arrival;
use super::stats::{CacheCounts, DramCounts, ThreadCycles};
use super::tm::{QUANTUM, Request, Tm};
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
    /// Start of the current quantum.
    now: u32,
    /// Cycles of a quantum.
    length: u32,
    runs: Vec<u64>,
    requests: Vec<Request>,
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
        tms: (0..tms as u16).map(|tm| Tm::new(tm, machine)).collect(),
        items: vec![vec![0; machine.tm.threads as usize]; tms as usize],
        l2s: (0..machine.chip.l2_partitions).map(|_| L2::new(&machine.l2)).collect(),
        dram: Dram::new(&machine.dram),
        next_item: 0,
        now: 0,
        length: Dram::least_latency(&machine.dram).clamp(1, QUANTUM as u32),
        requests: vec![],
        runs: vec![0; program.runs.len()],
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
        chip.quantum();
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
        let place = &mut self.tms[tm].threads[thread];
        Tape::new(self.program, entry, &mut place.tape, &mut self.runs).event(entry, 0);
        self.tms[tm].enter(self.program, thread);
    }

    fn quantum(&mut self) {
        let (start, end) = (self.now, self.now + self.length);
        self.dram.advance(start);
        let per_partition = self.machine.chip.tms_per_partition as usize;
        let (tms, l2s) = (&mut self.tms, &mut self.l2s);
        self.dram.announce(start, |arrival| {
            let tm = usize::from(arrival.requester.tm);
            l2s[tm / per_partition].arrives(arrival.line, arrival.cycle);
            tms[tm].arrives(arrival.line, arrival.cycle);
        });
        self.l2s.iter_mut().for_each(|l2| l2.begin(start));
        for tm in 0..self.tms.len() {
            self.tms[tm].quantum(self.program, start, end);
        }
        loop {
            self.change_tapes(start, end);
            if self.tms.iter().all(|tm| tm.outbox.is_empty()) {
                break;
            }
            self.serve(start, end);
        }
        self.now = self.next_start(end);
    }

    /// The first cycle from `end` on in which anything can happen, at the start of a quantum.
    fn next_start(&self, end: u32) -> u32 {
        let next = self.tms.iter().map(Tm::next_time).min().unwrap_or(end);
        if next <= end {
            return end;
        }
        let next = next.min(self.dram.next_command());
        if next == u32::MAX { end } else { next.max(end) }
    }

    /// Gives new tapes to the threads that need them and lets them catch up.
    fn change_tapes(&mut self, start: u32, end: u32) {
        for tm in 0..self.tms.len() {
            while let Some(thread) = self.tms[tm].ended.pop() {
                self.tape_ended(tm, thread.into());
                self.tms[tm].run(self.program, thread.into(), start, end);
            }
        }
    }

    /// Serves what multiprocessors ask in the order of time, and lets the threads that asked catch up.
    fn serve(&mut self, start: u32, end: u32) {
        let mut requests = std::mem::take(&mut self.requests);
        self.tms.iter_mut().for_each(|tm| requests.append(&mut tm.outbox));
        // In one cycle, multiprocessors come in ring order from another one each time.
        let (count, first) = (self.tms.len() as u32, start / self.length);
        requests
            .sort_by_key(|request| (request.cycle, (u32::from(request.tm) + count - first % count) % count));
        for &request in &requests {
            self.serve_one(request, start);
        }
        for &request in &requests {
            self.tms[usize::from(request.tm)].run(self.program, request.thread.into(), start, end);
        }
        requests.clear();
        self.requests = requests;
    }

    fn serve_one(&mut self, request: Request, start: u32) {
        let (number, program, now) = (usize::from(request.tm), self.program, request.cycle);
        let tm = &mut self.tms[number];
        let slot = (now - start) as usize;
        let waiter = tm.waiter(program, request);
        let again = match request.kind {
            Kind::Load => tm.l1.load_now(now, slot, request.address, waiter),
            Kind::Store => tm.l1.store_now(slot, request.address),
            _ => {
                // Threads that find nothing left leave the counter where it is.
                let item = self.next_item;
                self.next_item = self.work.items().min(item + 1);
                self.items[number][usize::from(request.thread)] = item;
                return tm.served(program, request, now + 1);
            }
        };
        match again {
            Access::Served(ready) => return tm.served(program, request, ready),
            Access::Refused => return tm.refused(request),
            Access::Ask => {}
        }
        let l2 = &mut self.l2s[number / self.machine.chip.tms_per_partition as usize];
        if !l2.is_free(slot, request.address) {
            return tm.refused(request);
        }
        let line = request.address >> self.line_shift;
        self.dram.advance(now);
        if request.kind == Kind::Store {
            if !self.dram.write(now, line) {
                return tm.refused(request);
            }
            l2.take(slot, request.address);
            l2.counts.stores += 1;
            tm.l1.stored(slot, request.address);
            return tm.served(program, request, now + 1);
        }
        let hit = l2.hit(line);
        let arrival = if hit {
            let filled = now + self.machine.l2.latency_cycles;
            Arrival { filled, usable: filled + self.machine.l1.latency_cycles }
        } else {
            match self.dram.read(now, line, Requester { tm: number as u16 }) {
                Read::Refused => return tm.refused(request),
                Read::Queued => Arrival::NOT_KNOWN,
                Read::Arrives(cycle) => {
                    l2.arrives(line, cycle);
                    Arrival::from_memory(cycle)
                }
            }
        };
        l2.take(slot, request.address);
        l2.counts.loads += 1;
        l2.counts.hits += u64::from(hit);
        let ready = tm.l1.taken(now, slot, request.address, arrival, waiter);
        tm.served(program, request, ready);
    }

    /// A thread has come to the end of its tape: behind the counter, or at the end of the program.
    fn tape_ended(&mut self, tm: usize, thread: usize) {
        let program = self.program;
        let place = &mut self.tms[tm].threads[thread];
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
        self.tms[tm].resume(program, thread);
    }

    fn counts(&mut self) -> Counts {
        let cycles = self.tms.iter().map(Tm::last_issue).max().unwrap_or(0) + 1;
        let mut counts = Counts { cycles, runs: self.runs.clone(), ..Counts::default() };
        for tm in &mut self.tms {
            tm.finish(cycles);
            counts.thread_cycles.merge(&tm.cycles);
            counts.l1.merge(&tm.l1.counts);
        }
        self.l2s.iter().for_each(|l2| counts.l2.merge(&l2.counts));
        counts.dram = self.dram.counts(cycles);
        counts
    }
}
