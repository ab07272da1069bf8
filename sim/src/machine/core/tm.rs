//! A thread multiprocessor: its threads issue in order, at most one instruction a cycle each.
//!
//! A cycle of a multiprocessor depends on nothing outside it: what misses the first-level cache, stores and the shared
//! counter are put in an outbox, which the chip serves at the end of the same cycle.

use super::outstanding::{Outstanding, UNKNOWN, Waiter};
use super::stats::{CacheCounts, ThreadCycles};
use super::tags::Tags;
use crate::machine::description::MachineDescription;
use crate::machine::program::{COUNTER, Kind, MicroOp, PIPELINE, POOLS, Program, SCOREBOARD, UNLIMITED};
use crate::unit_costs::Unit;
use std::collections::VecDeque;

/// Cycles that a thread can be put to sleep for at once.
const WHEEL: usize = 64;
const BITS: usize = 64;

/// What a thread asks of the rest of the chip.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// The thread.
    pub thread: u8,
    /// Load, store or counter.
    pub kind: Kind,
    /// Word address.
    pub address: u32,
}

/// Where a thread is on its tape.
#[derive(Clone, Debug, Default)]
pub struct Place {
    /// Runs with their addresses.
    pub tape: Vec<u32>,
    /// Index of the current run.
    pub at: usize,
    /// Index behind the current run's addresses.
    pub next: usize,
}

/// A multiprocessor.
#[derive(Clone, Debug)]
pub struct Tm {
    threads: u32,
    /// Threads that try to issue.
    active: u64,
    /// Threads that have fetched the instruction that they are at.
    held: u64,
    /// Threads that wait for data whose time is not known.
    parked: u64,
    /// Threads that have finished.
    pub halted: u64,
    /// Threads that wake, by cycle modulo [`WHEEL`].
    wheel: [u64; WHEEL],
    /// Index of each thread's next operation.
    pc: [u32; BITS],
    last_issue: [u32; BITS],
    parked_since: [u32; BITS],
    /// Cycle from which on each thread's registers can be used.
    ready: Vec<[u32; SCOREBOARD]>,
    /// Each thread's place on its tape.
    pub places: Vec<Place>,
    /// The thread that comes first.
    first: u32,

    icaches: u32,
    icache_banks: usize,
    /// Fetches left in this cycle, by cache and bank.
    fetches: Vec<u8>,
    fetches_full: Vec<u8>,
    /// Threads that were refused a fetch, by cache and bank.
    fetch_blocked: Vec<u64>,
    units: [u8; 16],
    units_full: [u8; 16],
    unit_blocked: [u64; 16],

    tags: Tags,
    l1_enabled: bool,
    l1_latency: u32,
    l1_bank_mask: u32,
    line_shift: u32,
    l1_busy: u64,
    /// Banks that a request in the outbox takes if the chip serves it.
    l1_asked: u64,
    outstanding: Outstanding,
    /// Lines that the second-level cache sends, in order of time.
    fills: VecDeque<(u32, u32)>,

    /// What the chip has to serve at the end of this cycle.
    pub outbox: Vec<Request>,
    /// What threads did.
    pub cycles: ThreadCycles,
    /// First-level cache.
    pub l1: CacheCounts,
}

/// What the first-level cache says to an access.
enum FirstLevel {
    /// It serves it.
    Taken,
    /// The bank is taken.
    Refused,
    /// The chip has to serve it.
    Misses,
}

impl Tm {
    pub fn new(machine: &MachineDescription) -> Self {
        let threads = machine.tm.threads;
        let all = if threads == 64 { u64::MAX } else { (1 << threads) - 1 };
        let mut units_full = [0; 16];
        for unit in Unit::ALL {
            units_full[unit as usize] = machine.units.pool(unit).count as u8;
        }
        units_full[usize::from(UNLIMITED)] = u8::MAX;
        units_full[usize::from(PIPELINE)] = 1;
        units_full[usize::from(COUNTER)] = 1;
        const { assert!(POOLS <= 16, "pools fit the array") };
        let banks = (machine.icache.caches * machine.icache.banks) as usize;
        let fetches_full = vec![machine.icache.fetches_per_bank as u8; banks];
        Self {
            threads,
            active: all,
            held: 0,
            parked: 0,
            halted: 0,
            wheel: [0; WHEEL],
            pc: [0; BITS],
            last_issue: [0; BITS],
            parked_since: [0; BITS],
            ready: vec![[0; SCOREBOARD]; threads as usize],
            places: vec![Place::default(); threads as usize],
            first: 0,
            icaches: machine.icache.caches,
            icache_banks: machine.icache.banks as usize,
            fetches: fetches_full.clone(),
            fetches_full,
            fetch_blocked: vec![0; banks],
            units: units_full,
            units_full,
            unit_blocked: [0; 16],
            tags: Tags::new(&machine.l1),
            l1_enabled: machine.l1.enabled,
            l1_latency: machine.l1.latency_cycles,
            l1_bank_mask: machine.l1.banks - 1,
            line_shift: machine.l1.line_words().trailing_zeros(),
            l1_busy: 0,
            l1_asked: 0,
            outstanding: Outstanding::default(),
            fills: VecDeque::new(),
            outbox: vec![],
            cycles: ThreadCycles::default(),
            l1: CacheCounts::default(),
        }
    }

    /// Whether all threads have finished.
    pub fn is_halted(&self) -> bool {
        self.halted.count_ones() == self.threads
    }

    /// Whether some thread may do something in cycle `now`.
    #[inline(always)]
    pub fn is_awake(&self, now: u32) -> bool {
        self.active | self.wheel[now as usize % WHEEL] != 0
    }

    /// The first cycle after `now` in which some thread wakes by itself.
    pub fn next_wake(&self, now: u32) -> u32 {
        if self.active != 0 {
            return now + 1;
        }
        let sleep = (1..=WHEEL as u32).find(|delay| self.wheel[(now + delay) as usize % WHEEL] != 0);
        sleep.map_or(u32::MAX, |delay| now + delay)
    }

    /// The cycle in which the thread that has waited longest last issued.
    pub fn longest_wait(&self) -> u32 {
        self.last_issue[self.first as usize % BITS]
    }

    /// Puts `thread` at the run that its place says.
    #[inline(always)]
    pub fn enter(&mut self, program: &Program, thread: usize) {
        let place = &mut self.places[thread];
        let run = &program.runs[place.tape[place.at] as usize];
        place.next = place.at + 1 + run.bases.len();
        self.pc[thread % BITS] = run.first;
    }

    /// A line has arrived from memory.
    pub fn arrive(&mut self, now: u32, line: u32) {
        self.fill_until(now);
        self.tags.fill(line);
        let (ready, parked) = (&mut self.ready, &mut self.parked);
        let (active, cycles, since) = (&mut self.active, &mut self.cycles, &self.parked_since);
        self.outstanding.remove(line, |Waiter { thread, register }| {
            let thread = usize::from(thread);
            ready[thread][usize::from(register)] = now;
            let bit = 1 << thread;
            if *parked & bit != 0 {
                // It looks again whether it can go on.
                *parked &= !bit;
                *active |= bit;
                cycles.data += u64::from(now - since[thread % BITS]);
            }
        });
    }

    /// Fills the lines that the second-level cache has sent.
    #[inline(always)]
    fn fill_until(&mut self, now: u32) {
        while let Some(&(time, line)) = self.fills.front() {
            if time > now {
                break;
            }
            self.fills.pop_front();
            self.tags.fill(line);
            self.outstanding.remove(line, |_| {});
        }
    }

    /// All threads that can, issue one instruction.
    pub fn cycle(&mut self, program: &Program, now: u32, ended: &mut Vec<u8>) {
        let slot = now as usize % WHEEL;
        self.active |= std::mem::take(&mut self.wheel[slot]);
        if self.active == 0 {
            return;
        }
        self.fill_until(now);
        self.fetches.copy_from_slice(&self.fetches_full);
        self.units = self.units_full;
        self.l1_busy = 0;
        self.l1_asked = 0;
        let first = self.first;
        // Threads in ring order: bit k is thread first + k.
        let mut todo = self.active.rotate_right(first);
        let mut first_issued = false;
        while todo != 0 {
            let position = todo.trailing_zeros();
            todo &= todo - 1;
            let thread = ((position + first) % BITS as u32) as usize;
            let bit = 1u64 << thread;
            let op = &program.ops[self.pc[thread] as usize];
            if self.held & bit == 0 {
                let bank = thread % self.icaches as usize * self.icache_banks + usize::from(op.bank);
                if self.fetches[bank] == 0 {
                    // So are all that were refused before and have not had their turn yet.
                    self.fetch_blocked[bank] |= bit;
                    let others = self.fetch_blocked[bank].rotate_right(first) & todo;
                    todo &= !others;
                    self.cycles.fetch += 1 + u64::from(others.count_ones());
                    continue;
                }
                self.fetches[bank] -= 1;
                self.fetch_blocked[bank] &= !bit;
                self.held |= bit;
            }
            let ready = &self.ready[thread];
            let [a, b, c] = op.reads.map(|register| ready[usize::from(register)]);
            let at = a.max(b).max(c);
            if at > now {
                self.sleep(thread, now, at);
                continue;
            }
            let pool = usize::from(op.pool % 16);
            if self.units[pool] == 0 {
                self.unit_blocked[pool] |= bit;
                let others = self.unit_blocked[pool].rotate_right(first) & todo;
                todo &= !others;
                self.cycles.units += 1 + u64::from(others.count_ones());
                continue;
            }
            if op.kind >= Kind::Load && !self.memory(op, thread, now) {
                continue;
            }
            self.units[pool] -= 1;
            self.unit_blocked[pool] &= !bit;
            first_issued |= position == 0;
            let op = *op;
            self.issue(program, &op, thread, now, ended);
        }
        if first_issued {
            self.choose_first();
        }
    }

    /// The thread waits for an operand.
    #[inline(always)]
    fn sleep(&mut self, thread: usize, now: u32, until: u32) {
        let bit = 1 << thread;
        self.active &= !bit;
        if until == UNKNOWN {
            self.parked |= bit;
            self.parked_since[thread % BITS] = now;
            return;
        }
        let delay = (until - now).min(WHEEL as u32 - 1);
        self.cycles.data += u64::from(delay);
        self.wheel[(now + delay) as usize % WHEEL] |= bit;
    }

    /// The thread has issued `op`.
    #[inline(always)]
    fn issue(&mut self, program: &Program, op: &MicroOp, thread: usize, now: u32, ended: &mut Vec<u8>) {
        if op.kind == Kind::Nop {
            self.cycles.nop += 1;
        } else {
            self.cycles.issue += 1;
        }
        if op.kind != Kind::Load {
            let ready = &mut self.ready[thread];
            ready[usize::from(op.write)] = now + u32::from(op.latency);
            if op.more_writes.1 != 0 {
                for &register in program.more_writes(op) {
                    ready[usize::from(register)] = now + u32::from(op.latency);
                }
            }
        }
        self.held &= !(1 << thread);
        self.last_issue[thread % BITS] = now;
        self.pc[thread % BITS] += 1;
        if op.last {
            let place = &mut self.places[thread];
            if place.next < place.tape.len() {
                place.at = place.next;
                self.enter(program, thread);
            } else {
                ended.push(thread as u8);
            }
        }
    }

    /// Tries an operation on global memory; false if it was not issued, or will be by the chip.
    #[inline(always)]
    fn memory(&mut self, op: &MicroOp, thread: usize, now: u32) -> bool {
        if op.kind == Kind::Counter {
            self.units[usize::from(COUNTER)] = 0;
            self.outbox.push(Request { thread: thread as u8, kind: Kind::Counter, address: 0 });
            return false;
        }
        let place = &self.places[thread];
        let address = place.tape[place.at + 1 + usize::from(op.base)] + u32::from(op.offset);
        let bank = 1 << (address & self.l1_bank_mask);
        if self.l1_asked & bank == 0 {
            match self.first_level(op, thread, now, address) {
                FirstLevel::Taken => return true,
                FirstLevel::Refused => return false,
                FirstLevel::Misses => self.l1_asked |= bank,
            }
        }
        self.outbox.push(Request { thread: thread as u8, kind: op.kind, address });
        false
    }

    /// Tries an access in the first-level cache. A bank is taken only if the access is served, here or by the chip.
    #[inline(always)]
    fn first_level(&mut self, op: &MicroOp, thread: usize, now: u32, address: u32) -> FirstLevel {
        let bank = 1 << (address & self.l1_bank_mask);
        if self.l1_enabled && self.l1_busy & bank != 0 {
            self.l1.bank_conflicts += 1;
            self.cycles.memory += 1;
            return FirstLevel::Refused;
        }
        if op.kind == Kind::Load {
            let line = address >> self.line_shift;
            if self.tags.hit(line) {
                self.l1.loads += 1;
                self.l1.hits += 1;
                self.l1_busy |= bank;
                self.ready[thread][usize::from(op.write)] = now + self.l1_latency;
                return FirstLevel::Taken;
            }
            if let Some(arrival) = self.outstanding.arrival(line) {
                self.l1.loads += 1;
                self.l1.joined += 1;
                self.l1_busy |= bank;
                self.wait(op, thread, now, line, arrival);
                return FirstLevel::Taken;
            }
        }
        FirstLevel::Misses
    }

    fn wait(&mut self, op: &MicroOp, thread: usize, now: u32, line: u32, arrival: u32) {
        if arrival == UNKNOWN {
            self.outstanding.wait(line, Waiter { thread: thread as u8, register: op.write });
        }
        let at = if arrival == UNKNOWN { UNKNOWN } else { arrival.max(now + self.l1_latency) };
        self.ready[thread][usize::from(op.write)] = at;
    }

    /// The operation of `thread` that waits for the chip.
    fn pending<'p>(&self, program: &'p Program, thread: usize) -> &'p MicroOp {
        &program.ops[self.pc[thread % BITS] as usize]
    }

    /// Tries a request from the outbox again in the first-level cache, as those before it may have changed what it holds and
    /// which banks are taken. Returns whether that settled it.
    pub fn settles(&mut self, program: &Program, request: Request, now: u32, ended: &mut Vec<u8>) -> bool {
        let (op, thread) = (self.pending(program, request.thread.into()), usize::from(request.thread));
        match self.first_level(op, thread, now, request.address) {
            FirstLevel::Taken => {
                self.issue_served(program, op, thread, now, ended);
                true
            }
            FirstLevel::Refused => true,
            FirstLevel::Misses => false,
        }
    }

    /// The chip has taken a load; its line arrives in cycle `arrival`, or [`UNKNOWN`].
    pub fn taken(
        &mut self,
        program: &Program,
        request: Request,
        now: u32,
        arrival: u32,
        ended: &mut Vec<u8>,
    ) {
        let (op, thread) = (self.pending(program, request.thread.into()), usize::from(request.thread));
        let line = request.address >> self.line_shift;
        self.l1.loads += 1;
        self.l1_busy |= 1 << (request.address & self.l1_bank_mask);
        self.outstanding.insert(line, arrival);
        if arrival != UNKNOWN {
            self.fills.push_back((arrival, line));
        }
        self.wait(op, thread, now, line, arrival);
        self.issue_served(program, op, thread, now, ended);
    }

    /// The chip has taken a store or answered the counter.
    pub fn done(&mut self, program: &Program, request: Request, now: u32, ended: &mut Vec<u8>) {
        let (op, thread) = (self.pending(program, request.thread.into()), usize::from(request.thread));
        if request.kind == Kind::Store {
            self.l1.stores += 1;
            self.l1_busy |= 1 << (request.address & self.l1_bank_mask);
        }
        self.issue_served(program, op, thread, now, ended);
    }

    /// The chip has refused; the thread tries again in the next cycle.
    pub fn refused(&mut self) {
        self.cycles.memory += 1;
    }

    fn issue_served(
        &mut self,
        program: &Program,
        op: &MicroOp,
        thread: usize,
        now: u32,
        ended: &mut Vec<u8>,
    ) {
        let was_first = thread as u32 == self.first;
        self.issue(program, op, thread, now, ended);
        if was_first {
            self.choose_first();
        }
    }

    /// The thread has finished.
    pub fn halt(&mut self, thread: usize) {
        let bit = 1 << thread;
        self.active &= !bit;
        self.halted |= bit;
        self.last_issue[thread % BITS] = u32::MAX;
        if thread as u32 == self.first {
            self.choose_first();
        }
    }

    /// Counts what threads that have finished did not do until cycle `end`.
    pub fn finish(&mut self, end: u32) {
        let all = u64::from(end) * u64::from(self.threads);
        self.cycles.halted = all - self.cycles.total();
    }

    /// The thread that has waited longest goes first, the lowest among equals.
    fn choose_first(&mut self) {
        let mut first = 0;
        let mut earliest = u32::MAX;
        for (thread, &cycle) in self.last_issue[..self.threads as usize].iter().enumerate() {
            if cycle < earliest {
                (first, earliest) = (thread as u32, cycle);
            }
        }
        self.first = first;
    }
}
