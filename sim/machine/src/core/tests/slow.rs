//! The machine of `docs/machine.md` as slow and plain as it can be told: every cycle, every thread in its turn.
//!
//! It shares with the core what is not written for speed: the description, the program, the memory behind the caches, the
//! order in which a quantum's threads have their turn, and the choice of the cycle at which the next quantum begins.
//! Everything else (fetches, units, operands, both caches, requests, and what is counted of them) is here a second time.

use crate::core::dram::{Dram, Read, Requester};
use crate::core::stats::CacheCounts;
use crate::core::{Counts, Tape, Work};
use crate::description::{Cache, MachineDescription};
use crate::program::{BoardEntry, Kind, Program, START, UNLIMITED};
use costs::Unit;
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

/// When something was used. The turn that it was used in counts first, then the thread's rank, then the order of events.
type Use = (u32, usize, u64);

/// A cache's lines.
struct Lines {
    cache: Cache,
    held: HashMap<u32, Use>,
    /// Cycle and line of what is on its way.
    arrivals: Vec<(u32, u32)>,
}

impl Lines {
    fn new(cache: &Cache) -> Self {
        Self { cache: *cache, held: HashMap::new(), arrivals: vec![] }
    }

    fn set(&self, line: u32) -> u32 {
        line % (self.cache.lines() / self.cache.associativity)
    }

    /// Puts what has arrived by cycle `start` in the place of the line of its set that was used longest ago.
    fn fill(&mut self, start: u32, turn: u32, events: &mut u64) {
        self.arrivals.sort_by_key(|(cycle, _)| *cycle);
        while self.arrivals.first().is_some_and(|(cycle, _)| *cycle <= start) {
            let (_, line) = self.arrivals.remove(0);
            if !self.cache.enabled {
                continue;
            }
            let set = self.set(line);
            let rivals = self.held.iter().filter(|(held, _)| self.set(**held) == set && **held != line);
            let full = rivals.clone().count() >= self.cache.associativity as usize;
            let oldest = rivals.min_by_key(|(_, used)| **used).map(|(held, _)| *held);
            if full && !self.held.contains_key(&line) {
                self.held.remove(&oldest.expect("a full set has a line"));
            }
            *events += 1;
            self.held.insert(line, (turn, 0, *events));
        }
    }

    /// Whether `line` is held in cycle `now`. A line that has arrived since the quantum began is held; the line whose place it
    /// takes is gone where that is the only one of its set, and in larger sets goes at the end of the quantum.
    fn hit(&mut self, now: u32, line: u32, used: Use) -> bool {
        let arrived = self.arrivals.iter().filter(|(cycle, _)| *cycle <= now && self.cache.enabled);
        let direct = self.cache.associativity == 1;
        let of_its_set =
            arrived.filter(|(_, other)| *other == line || direct && self.set(*other) == self.set(line));
        let last = of_its_set.max_by_key(|(cycle, _)| *cycle).map(|(_, other)| *other);
        match (last, self.held.get_mut(&line)) {
            (Some(other), _) => other == line,
            (None, Some(last_used)) => {
                *last_used = used;
                true
            }
            (None, None) => false,
        }
    }
}

/// A line on its way to a data cache.
struct UnderWay {
    arrival: u32,
    /// Threads and registers that wait for the time of arrival to be known.
    waiters: Vec<(usize, BoardEntry)>,
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
        dram: Dram::new(&machine.dram),
        taken: HashMap::new(),
        next_item: 0,
        turn: 0,
        events: 0,
        blocked: vec![],
        counts: Counts { runs: vec![0; program.code.runs.len()], ..Counts::default() },
    };
    let start = program.entry(START);
    for tm in &mut slow.tms {
        for _ in 0..machine.tm.threads {
            let mut tape = vec![];
            Tape::new(program, start, &mut tape, &mut slow.counts.runs).event(start, 0);
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

    fn is_taken(&self, resource: Resource, now: u32) -> bool {
        self.taken.contains_key(&(resource, now))
    }

    /// One quantum from cycle `start` on; the cycle at which the next one begins.
    fn quantum(&mut self, start: u32) -> u32 {
        let length = crate::core::quantum::cycles(self.machine);
        let end = start + length;
        self.turn += 1;
        self.dram.advance(start);
        let mut arrivals = vec![];
        self.dram.announce(start, |arrival| arrivals.push(arrival));
        for arrival in arrivals {
            let tm = usize::from(arrival.requester.tm);
            self.l2s[self.tms[tm].partition].arrivals.push((arrival.cycle, arrival.line));
            self.arrives(tm, arrival.line, arrival.cycle);
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

    /// The time at which `line` arrives is known.
    fn arrives(&mut self, tm: usize, line: u32, arrival: u32) {
        let tm = &mut self.tms[tm];
        let Some(under_way) = tm.under_way.get_mut(&line) else { return };
        under_way.arrival = arrival;
        for (thread, register) in under_way.waiters.drain(..) {
            let thread = &mut tm.threads[thread];
            thread.ready[usize::from(register)] = arrival;
            if thread.state == State::Parked {
                thread.state = State::Runs;
                let until = arrival.max(thread.time);
                self.counts.thread_cycles.data += u64::from(until - thread.time);
                thread.time = until;
            }
        }
        tm.l1.arrivals.push((arrival, line));
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
            let bank = address % self.machine.l1.banks;
            if !self.is_taken(Resource::Asked(tm, bank), now) {
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

    /// Whether the L1's bank is taken, which it counts.
    fn l1_refuses(&mut self, request: &Request) -> bool {
        let bank = request.address % self.machine.l1.banks;
        let refuses = self.machine.l1.enabled && self.is_taken(Resource::L1(request.tm, bank), request.cycle);
        self.tms[request.tm].l1_counts.bank_conflicts += u64::from(refuses);
        refuses
    }

    /// When the word of a load can be used that finds its line in the L1, or on its way there.
    fn l1_load(&mut self, request: &Request, rank: usize) -> Option<u32> {
        let &Request { cycle: now, tm: number, kind, address, .. } = request;
        if kind != Kind::Load {
            return None;
        }
        let (line, latency) = (address / self.machine.l1.line_words(), self.l1_latency());
        self.events += 1;
        let tm = &mut self.tms[number];
        let ready = if tm.l1.hit(now, line, (self.turn, rank, self.events)) {
            tm.l1_counts.hits += 1;
            now + latency
        } else {
            let arrival = tm.under_way.get(&line).map(|under_way| under_way.arrival);
            let arrival = arrival.filter(|arrival| *arrival > now)?;
            tm.l1_counts.joined += 1;
            if arrival == UNKNOWN {
                self.wait_for(request, line);
                UNKNOWN
            } else {
                arrival + latency
            }
        };
        self.tms[number].l1_counts.loads += 1;
        self.take(Resource::L1(number, address % self.machine.l1.banks), now, 1);
        Some(ready)
    }

    fn l1_latency(&self) -> u32 {
        if self.machine.l1.enabled { self.machine.l1.latency_cycles } else { 0 }
    }

    /// The registers of a load wait until it is known when `line` arrives.
    fn wait_for(&mut self, request: &Request, line: u32) {
        let Tm { threads, under_way, .. } = &mut self.tms[request.tm];
        let registers = threads[request.thread].targets(self.program, self.machine);
        let under_way = under_way.get_mut(&line).expect("it is under way");
        under_way.waiters.extend(registers.into_iter().map(|register| (request.thread, register)));
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
        thread.at += 1 + run.bases.len();
        if thread.at == thread.tape.len() {
            let Some(entry) = run.next else {
                return thread.state = State::Halted;
            };
            thread.tape.clear();
            thread.at = 0;
            let mut tape = Tape::new(program, entry, &mut thread.tape, &mut self.counts.runs);
            if thread.item < self.work.items() {
                tape.event(entry, 0);
                self.work.record(thread.item, &mut tape);
            } else {
                tape.event(entry, program.condition("no_more"));
            }
        }
        thread.pc = program.code.runs[thread.tape[thread.at] as usize].first as usize;
    }

    /// The chip serves what was asked, cycle by cycle; in each cycle multiprocessors have their turn in ring order from another
    /// one each quantum, and of one multiprocessor the newest request comes first.
    fn serve(&mut self, start: u32, length: u32, wakes: bool) {
        let count = self.tms.len();
        let first = (start / length) as usize % count;
        let place = |request: &Request| (request.tm + count - first) % count;
        let asked: Vec<Request> = self.tms.iter_mut().flat_map(|tm| std::mem::take(&mut tm.asks)).collect();
        let wakes = wakes && !self.blocked.is_empty();
        let mut waiting: Vec<Request> = vec![];
        for now in start..start + length {
            let mut tries: Vec<Request> = asked.iter().copied().filter(|ask| ask.cycle == now).collect();
            tries.append(&mut waiting);
            if wakes {
                self.dram.advance(now);
                self.wake(now, &mut tries, place);
            }
            tries.sort_by_key(place);
            for request in tries {
                let request = Request { cycle: now, ..request };
                match self.try_to_serve(request) {
                    Outcome::Served(ready) => {
                        let thread = &mut self.tms[request.tm].threads[request.thread];
                        thread.state = State::Runs;
                        self.retire(request.tm, request.thread, now, ready);
                        let new_work = request.kind == Kind::Counter;
                        self.tms[request.tm].answered.push((request.thread, new_work));
                    }
                    Outcome::Refused => {
                        self.counts.thread_cycles.memory += 1;
                        waiting.push(request);
                    }
                    Outcome::Full(line) => self.blocked.push((line, request)),
                }
            }
        }
        for request in waiting {
            let thread = &mut self.tms[request.tm].threads[request.thread];
            (thread.state, thread.time) = (State::Runs, start + length);
        }
    }

    /// As many reads as a memory channel has room for try again, and behind each those of the same line.
    fn wake(&mut self, now: u32, tries: &mut Vec<Request>, place: impl Fn(&Request) -> usize) {
        for channel in 0..self.machine.dram.channels as usize {
            for _ in 0..self.dram.room(channel) {
                let of_channel = self.blocked.iter().filter(|(line, _)| self.dram.channel(*line) == channel);
                let Some(&(first, _)) = of_channel.min_by_key(|(_, request)| place(request)) else { break };
                let (woken, rest): (Vec<_>, Vec<_>) =
                    self.blocked.drain(..).partition(|(line, _)| *line == first);
                self.blocked = rest;
                for (_, request) in woken {
                    self.counts.thread_cycles.memory += u64::from(now - request.cycle);
                    tries.push(request);
                }
            }
        }
    }

    fn try_to_serve(&mut self, request: Request) -> Outcome {
        let Request { cycle: now, tm: number, thread, kind, address } = request;
        if kind == Kind::Counter {
            self.tms[number].threads[thread].item = self.next_item;
            self.next_item = self.work.items().min(self.next_item + 1);
            return Outcome::Served(now + 1);
        }
        if self.l1_refuses(&request) {
            return Outcome::Refused;
        }
        if let Some(ready) = self.l1_load(&request, 0) {
            return Outcome::Served(ready);
        }
        let partition = self.tms[number].partition;
        let bank = Resource::L2(partition, address % self.machine.l2.banks);
        if self.is_taken(bank, now) {
            self.counts.l2.bank_conflicts += 1;
            return Outcome::Refused;
        }
        let line = address / self.machine.l1.line_words();
        self.dram.advance(now);
        if kind == Kind::Store {
            if !self.dram.write(now, line) {
                return Outcome::Refused;
            }
            self.counts.l2.stores += 1;
            self.tms[number].l1_counts.stores += 1;
            self.take(bank, now, 1);
            self.take(Resource::L1(number, address % self.machine.l1.banks), now, 1);
            return Outcome::Served(now + 1);
        }
        self.events += 1;
        let latency = self.machine.l2.latency_cycles + self.l1_latency();
        let arrival = if self.l2s[partition].hit(now, line, (self.turn, 0, self.events)) {
            self.counts.l2.hits += 1;
            now + latency
        } else {
            match self.dram.read(now, line, Requester { tm: number as u16 }) {
                Read::Refused => return Outcome::Full(line),
                Read::Queued => UNKNOWN,
                Read::Arrives(cycle) => {
                    self.l2s[partition].arrivals.push((cycle, line));
                    cycle + latency
                }
            }
        };
        self.counts.l2.loads += 1;
        self.tms[number].l1_counts.loads += 1;
        self.take(bank, now, 1);
        self.take(Resource::L1(number, address % self.machine.l1.banks), now, 1);
        self.tms[number].under_way.insert(line, UnderWay { arrival, waiters: vec![] });
        if arrival == UNKNOWN {
            self.wait_for(&request, line);
        } else {
            self.tms[number].l1.arrivals.push((arrival, line));
        }
        Outcome::Served(arrival)
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

enum Outcome {
    Served(u32),
    /// It tries again in the next cycle.
    Refused,
    /// It tries again when the memory channel of this line has room.
    Full(u32),
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
