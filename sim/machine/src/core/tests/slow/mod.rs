//! The machine of `docs/machine.md` as slow and plain as it can be told: every cycle, every thread in its turn.
//!
//! It shares with the core what is not written for speed: the description, the program, the memory behind the caches, the
//! order in which a quantum's threads have their turn, and the choice of the cycle at which the next quantum begins.
//! Everything else (fetches, units, operands, both caches, requests, and what is counted of them) is here a second time.

mod chip;
mod l1;
mod lines;

use crate::core::{Counts, Tape, Work};
use crate::description::MachineDescription;
use crate::program::{BoardEntry, Kind, Program, UNLIMITED};
use costs::Unit;
use l1::UnderWay;
use lines::Lines;
use memory::CacheCounts;
use memory::dram::Dram;
use std::collections::HashMap;

/// When a word can be used whose line has no known time of arrival.
const UNKNOWN: u32 = u32::MAX;

/// What one access takes for one cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Resource {
    /// A fetch of a multiprocessor's instruction cache: cache and bank.
    Fetch(usize, u32, u8),
    /// A unit of a multiprocessor: its pool.
    Unit(usize, u8),
    /// A bank of a multiprocessor's data cache.
    L1(usize, u32),
    /// A bank of that cache that a request to the chip takes if the chip serves it.
    Asked(usize, u32),
    /// A bank of a partition's cache.
    L2(usize, u32),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    /// It has its turn in the cycle `time`.
    Runs,
    /// It waits for a line with no known time of arrival.
    Parked,
    /// It waits for the chip.
    Asks,
    Halted,
}

#[derive(Clone, Debug)]
struct Thread {
    state: State,
    time: u32,
    last_issue: u32,
    tape: Vec<u32>,
    /// Where in the tape its run stands.
    at: usize,
    /// Its next operation.
    pc: usize,
    /// Whether that has been fetched.
    fetched: bool,
    /// Words that a wide load has brought already.
    brought: usize,
    /// The cycle from which on each register can be used.
    ready: Vec<u32>,
    item: u32,
}

#[derive(Clone, Copy, Debug)]
struct Request {
    cycle: u32,
    tm: usize,
    thread: usize,
    kind: Kind,
    address: u32,
}

struct Tm {
    partition: usize,
    threads: Vec<Thread>,
    /// Threads in the order of their turns.
    order: Vec<usize>,
    l1: Lines,
    under_way: HashMap<u32, UnderWay>,
    l1_counts: CacheCounts,
    asks: Vec<Request>,
    /// Threads that the chip has answered, and whether they got new work.
    answered: Vec<(usize, bool)>,
}

struct Slow<'a, W> {
    machine: &'a MachineDescription,
    program: &'a Program,
    work: &'a W,
    tms: Vec<Tm>,
    l2s: Vec<Lines>,
    /// By partition, lines that were asked of the memory, with their arrival.
    asked_by_l2: Vec<HashMap<u32, u32>>,
    dram: Dram,
    taken: HashMap<(Resource, u32), u32>,
    next_item: u32,
    /// Counts the turns of threads and of the chip.
    turn: u32,
    events: u64,
    /// Reads whose memory channel was full, with their line.
    blocked: Vec<(u32, Request)>,
    counts: Counts,
}

/// What simulating `work` by `program` on `machine` counts.
pub fn simulate<W: Work>(machine: &MachineDescription, program: &Program, work: &W) -> Counts {
    let mut slow = Slow {
        machine,
        program,
        work,
        tms: (0..machine.chip.tms())
            .map(|tm| Tm {
                partition: (tm / machine.chip.tms_per_partition) as usize,
                threads: vec![],
                order: vec![],
                l1: Lines::new(&machine.l1),
                under_way: HashMap::new(),
                l1_counts: CacheCounts::default(),
                asks: vec![],
                answered: vec![],
            })
            .collect(),
        l2s: (0..machine.chip.l2_partitions).map(|_| Lines::new(&machine.l2)).collect(),
        asked_by_l2: vec![HashMap::new(); machine.chip.l2_partitions as usize],
        dram: Dram::new(&machine.dram),
        taken: HashMap::new(),
        next_item: 0,
        turn: 0,
        events: 0,
        blocked: vec![],
        counts: Counts { runs: vec![0; program.code.runs.len()], ..Counts::default() },
    };
    for tm in &mut slow.tms {
        for _ in 0..machine.tm.threads {
            let mut tape = vec![];
            work.start(&mut Tape::new(&mut tape, &mut slow.counts.runs)).unwrap();
            let pc = program.code.runs[tape[0] as usize].first as usize;
            tm.threads.push(Thread {
                state: State::Runs,
                time: 0,
                last_issue: 0,
                tape,
                at: 0,
                pc,
                fetched: false,
                brought: 0,
                ready: vec![0; crate::program::BOARD_ENTRIES],
                item: 0,
            });
        }
    }
    let mut now = 0;
    while slow.tms.iter().flat_map(|tm| &tm.threads).any(|thread| thread.state != State::Halted) {
        now = slow.quantum(now);
    }
    slow.finish()
}

impl<W: Work> Slow<'_, W> {
    /// Takes one of `resource` in cycle `now`, of which there are so many.
    fn take(&mut self, resource: Resource, now: u32, many: u32) -> bool {
        let taken = self.taken.entry((resource, now)).or_default();
        *taken += 1;
        *taken <= many
    }

    fn is_taken(&self, resource: Resource, now: u32, many: u32) -> bool {
        self.taken.get(&(resource, now)).is_some_and(|taken| *taken >= many)
    }

    /// One quantum from cycle `start` on; the cycle at which the next one begins.
    fn quantum(&mut self, start: u32) -> u32 {
        let length = memory::quantum(&self.machine.dram);
        let end = start + length;
        self.turn += 1;
        self.dram.advance(start);
        let mut arrivals = vec![];
        self.dram.announce(start, |arrival| arrivals.push(arrival));
        for arrival in arrivals {
            let tm = usize::from(arrival.requester.port);
            self.l2_arrives(self.tms[tm].partition, arrival.line, arrival.cycle);
            self.arrives(tm, arrival.line, arrival.cycle + 2 * self.machine.network.latency_cycles);
        }
        for l2 in &mut self.l2s {
            l2.fill(start, self.turn, &mut self.events);
        }
        for tm in &mut self.tms {
            tm.l1.fill(start, self.turn, &mut self.events);
            let running = (0..tm.threads.len()).filter(|thread| tm.threads[*thread].state != State::Halted);
            let first = running.min_by_key(|thread| tm.threads[*thread].last_issue).unwrap_or(0);
            tm.order = (0..tm.threads.len()).map(|turn| (first + turn) % tm.threads.len()).collect();
        }
        let mut wakes = !self.blocked.is_empty();
        loop {
            self.turn += 1;
            for cycle in start..end {
                for tm in 0..self.tms.len() {
                    for rank in 0..self.tms[tm].order.len() {
                        self.step(tm, rank, cycle);
                    }
                }
            }
            if !wakes && self.tms.iter().all(|tm| tm.asks.is_empty()) {
                break;
            }
            self.turn += 1;
            self.serve(start, length, wakes);
            wakes = false;
            // Those that the chip has answered live through the rest of the quantum, those with new work first, the last one
            // of them before the others.
            for tm in &mut self.tms {
                let (new, old): (Vec<_>, Vec<_>) = tm.answered.drain(..).partition(|(_, new_work)| *new_work);
                tm.order = new.into_iter().rev().chain(old).map(|(thread, _)| thread).collect();
            }
        }
        self.next_start(end)
    }

    fn next_start(&self, end: u32) -> u32 {
        let runs = self.tms.iter().flat_map(|tm| &tm.threads).filter(|thread| thread.state == State::Runs);
        let next = runs.map(|thread| thread.time).min().unwrap_or(UNKNOWN);
        let room = |(line, _): &(u32, Request)| self.dram.room(self.dram.channel(*line)) > 0;
        if next <= end || self.dram.has_news() || self.blocked.iter().any(room) {
            return end;
        }
        match next.min(self.dram.next_command()) {
            UNKNOWN => end,
            next => next.max(end),
        }
    }

    /// What a thread does in one cycle.
    fn step(&mut self, tm: usize, rank: usize, now: u32) {
        let number = self.tms[tm].order[rank];
        let program = self.program;
        let Thread { state, time, pc, fetched, .. } = self.tms[tm].threads[number];
        if state != State::Runs || time != now {
            return;
        }
        let op = &program.code.ops[pc];

        let icache = &self.machine.icache;
        if !fetched {
            let fetch = Resource::Fetch(tm, number as u32 % icache.caches, op.bank);
            if !self.take(fetch, now, icache.fetches_per_bank) {
                self.counts.thread_cycles.fetch += 1;
                return self.tms[tm].threads[number].time += 1;
            }
            self.tms[tm].threads[number].fetched = true;
        }

        let thread = &mut self.tms[tm].threads[number];
        let ready = |register: &BoardEntry| thread.ready[usize::from(*register)];
        let further = program.operands_of(op).reads.iter().map(ready).max();
        let others = ready(&op.reads[1]).max(further.unwrap_or(0));
        for ready in [ready(&op.reads[0]), others] {
            if ready == UNKNOWN {
                return thread.state = State::Parked;
            }
            if ready > now {
                self.counts.thread_cycles.data += u64::from(ready - now);
                return thread.time = ready;
            }
        }

        if op.pool != UNLIMITED {
            let unit = Unit::ALL.get(usize::from(op.pool));
            let many = unit.map_or(1, |unit| self.machine.units.pool(*unit).count);
            if !self.take(Resource::Unit(tm, op.pool), now, many) {
                self.counts.thread_cycles.units += 1;
                return self.tms[tm].threads[number].time += 1;
            }
        }

        if matches!(op.kind, Kind::Plain | Kind::Nop) {
            return self.retire(tm, number, now, now + u32::from(op.latency));
        }
        let address =
            if op.kind == Kind::Counter { 0 } else { self.tms[tm].threads[number].address(program) };
        let request = Request { cycle: now, tm, thread: number, kind: op.kind, address };
        if op.kind != Kind::Counter {
            let bank = lines::bank(&self.machine.l1, address);
            if !self.is_taken(Resource::Asked(tm, bank), now, 1) {
                if self.l1_refuses(&request) {
                    self.counts.thread_cycles.memory += 1;
                    return self.tms[tm].threads[number].time += 1;
                }
                if let Some(ready) = self.l1_load(&request, rank) {
                    return self.retire(tm, number, now, ready);
                }
                self.take(Resource::Asked(tm, bank), now, 1);
            }
        }
        self.tms[tm].threads[number].state = State::Asks;
        self.tms[tm].asks.push(request);
    }

    /// The operation of a thread is issued in cycle `now`, and its results can be used from cycle `ready` on.
    fn retire(&mut self, tm: usize, number: usize, now: u32, ready: u32) {
        let program = self.program;
        let thread = &mut self.tms[tm].threads[number];
        let op = &program.code.ops[thread.pc];
        let registers = thread.targets(program, self.machine);
        for register in &registers {
            thread.ready[usize::from(*register)] = ready;
        }
        thread.time = now + 1;
        if op.kind == Kind::Load {
            thread.brought += registers.len();
            if thread.brought < program.operands_of(op).writes.len() {
                // The rest is in the next line.
                self.counts.thread_cycles.memory += 1;
                return;
            }
        }
        thread.brought = 0;
        thread.last_issue = now;
        thread.fetched = false;
        let cycles = &mut self.counts.thread_cycles;
        *(if op.kind == Kind::Nop { &mut cycles.nop } else { &mut cycles.issue }) += 1;
        thread.pc += 1;

        let run = &program.code.runs[thread.tape[thread.at] as usize];
        if thread.pc < (run.first + run.length) as usize {
            return;
        }
        thread.at += 1 + usize::from(run.addresses);
        if thread.at == thread.tape.len() {
            let Some(entry) = run.next else {
                return thread.state = State::Halted;
            };
            thread.tape.clear();
            thread.at = 0;
            let mut tape = Tape::new(&mut thread.tape, &mut self.counts.runs);
            self.work.record(thread.item, entry, &mut tape).unwrap();
        }
        thread.pc = program.code.runs[thread.tape[thread.at] as usize].first as usize;
    }

    fn finish(mut self) -> Counts {
        let threads = || self.tms.iter().flat_map(|tm| &tm.threads);
        let cycles = threads().map(|thread| thread.last_issue).max().unwrap_or(0) + 1;
        self.counts.cycles = cycles;
        self.counts.thread_cycles.halted =
            threads().map(|thread| u64::from(cycles - thread.last_issue - 1)).sum();
        self.tms.iter().for_each(|tm| self.counts.l1.merge(&tm.l1_counts));
        self.counts.dram = self.dram.counts(cycles);
        self.counts
    }
}

impl Thread {
    /// The word that its load or store accesses next.
    fn address(&self, program: &Program) -> u32 {
        let op = &program.code.ops[self.pc];
        self.tape[self.at + 1 + usize::from(op.base)] + u32::from(op.offset) + self.brought as u32
    }

    /// The registers that its operation writes; of a load those whose words lie in one line with the next.
    fn targets(&self, program: &Program, machine: &MachineDescription) -> Vec<BoardEntry> {
        let op = &program.code.ops[self.pc];
        let writes = &program.operands_of(op).writes;
        if writes.is_empty() {
            return vec![op.write];
        }
        if op.kind != Kind::Load {
            return writes.clone();
        }
        let line_words = machine.l1.line_words();
        let to_the_end = line_words - self.address(program) % line_words;
        writes[self.brought..].iter().copied().take(to_the_end as usize).collect()
    }
}
