//! A thread multiprocessor: its threads issue in order, at most one instruction a cycle each.
//!
//! Time advances in quanta of [`quantum::LONGEST`] cycles. Within a quantum, threads run one after another, in ring order from the
//! one that has waited longest, and take fetches, units and cache banks from tables with an entry for each cycle. A
//! thread is never affected by one behind it in this order, so the outcome is that of going cycle by cycle with the
//! order fixed for the quantum; but running on with one thread is several times as fast.
//!
//! What misses the first-level cache, stores and the shared counter are put in an outbox. The thread stands still
//! until the chip has served it, then catches up. A quantum is not longer than the time that memory takes, so
//! that nothing asked for within a quantum arrives from there within it.

use super::l1::{Access, L1, NOT_LOOKED_UP, Target};
use super::outstanding::Waiter;
use super::quantum;
use super::slots::{self, Slots};
use super::stats::ThreadCycles;
use super::thread::{State, Stop, Tables, Thread};
use crate::description::MachineDescription;
use crate::program::{COUNTER, Issue, Kind, MicroOp, PIPELINE, POOLS, Program, UNLIMITED};
use costs::Unit;

/// What a thread asks of the rest of the chip.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// Cycle in which it asks.
    pub cycle: u32,
    /// The multiprocessor.
    pub tm: u16,
    /// The thread.
    pub thread: u8,
    /// Load, store or counter.
    pub kind: Kind,
    /// Word address.
    pub address: u32,
    /// Lines that the L1 had asked for when it did not have this one, or [`NOT_LOOKED_UP`].
    pub missed: u32,
}

impl Request {
    fn new(cycle: u32, tm: u16, thread: usize, kind: Kind, address: u32, missed: u32) -> Self {
        Self { cycle, tm, thread: thread as u8, kind, address, missed }
    }
}

/// A multiprocessor.
#[derive(Clone, Debug)]
pub struct Tm {
    number: u16,
    /// Whether there are others, whose quanta drive its threads from the host's nearest cache.
    has_others: bool,
    /// The threads.
    pub threads: Vec<Thread>,
    /// Those that have not finished.
    running: usize,
    line_words: u32,
    /// Fetches left by bank, for each instruction cache.
    fetches: Vec<Slots>,
    /// Those of a cache at the start of a quantum.
    all_fetches: Slots,
    icache_banks: usize,
    /// Units left by pool.
    units: Slots,
    /// Units at the start of a quantum.
    all_units: Slots,
    /// The data cache.
    pub l1: L1,
    /// What the chip has to serve.
    pub outbox: Vec<Request>,
    /// Threads that have come to the end of their tape.
    pub ended: Vec<u8>,
    /// Threads that the chip has answered in this quantum.
    answered: Vec<u8>,
    /// What threads did, but for what they issued of runs that are not over.
    pub cycles: ThreadCycles,
}

impl Tm {
    pub fn new(number: u16, machine: &MachineDescription) -> Self {
        let mut units = [0; POOLS];
        for unit in Unit::ALL {
            units[unit as usize] = machine.units.pool(unit).count as u8;
        }
        units[usize::from(UNLIMITED)] = slots::ENOUGH;
        units[usize::from(PIPELINE)] = 1;
        units[usize::from(COUNTER)] = 1;
        let length = quantum::cycles(machine) as usize;
        let all_units = Slots::new(&units, length);
        let icache = &machine.icache;
        let icache_banks = icache.banks as usize;
        let all_fetches = Slots::new(&vec![icache.fetches_per_bank as u8; icache_banks], length);
        let threads = (0..machine.tm.threads).map(|number| Thread::new((number % icache.caches) as u8));
        Self {
            number,
            has_others: machine.chip.tms() > 1,
            threads: threads.collect(),
            running: machine.tm.threads as usize,
            line_words: machine.l1.line_words(),
            fetches: vec![all_fetches.clone(); icache.caches as usize],
            all_fetches,
            icache_banks,
            units: all_units.clone(),
            all_units,
            l1: L1::new(machine),
            outbox: vec![],
            ended: vec![],
            answered: vec![],
            cycles: ThreadCycles::default(),
        }
    }

    /// Whether all threads have finished.
    pub fn is_halted(&self) -> bool {
        self.running == 0
    }

    /// The first cycle in which some thread goes on by itself.
    pub fn next_time(&self) -> u32 {
        let running = self.threads.iter().filter(|thread| thread.state == State::Runs);
        running.map(|thread| thread.time).min().unwrap_or(u32::MAX)
    }

    /// Whether some thread goes on by itself in cycle `end` or before.
    pub fn goes_on_by(&self, end: u32) -> bool {
        self.threads.iter().any(|thread| thread.state == State::Runs && thread.time <= end)
    }

    /// It is known now that `line` arrives in cycle `arrival`.
    pub fn arrives(&mut self, line: u32, arrival: u32) {
        let (threads, cycles) = (&mut self.threads, &mut self.cycles);
        self.l1.arrives(line, arrival, |Waiter { thread, entry }| {
            let thread = &mut threads[usize::from(thread)];
            thread.set_ready(entry, arrival);
            if thread.state == State::Parked {
                // It looks again whether it can go on.
                thread.state = State::Runs;
                let until = arrival.max(thread.time);
                cycles.data += u64::from(until - thread.time);
                thread.time = until;
            }
        });
    }

    /// Runs all threads from cycle `start` up to `end`, at most [`quantum::LONGEST`] cycles later.
    pub fn quantum(&mut self, program: &Program, start: u32, end: u32) {
        if self.is_halted() {
            return;
        }
        self.fetches.iter_mut().for_each(|cache| cache.reset(&self.all_fetches, self.icache_banks));
        self.units.reset(&self.all_units, POOLS);
        self.l1.begin(start);
        let running = self.threads.iter().enumerate().filter(|(_, thread)| thread.state != State::Halted);
        // Of several, the first.
        let first = running.min_by_key(|(_, thread)| thread.last_issue).map_or(0, |(number, _)| number);
        let count = self.threads.len();
        let mut number = first;
        for _ in 0..count {
            if self.has_others {
                if let Some(later) = self.threads.get(number + 2) {
                    later.prefetch();
                }
                if let Some(next) = self.threads.get(number + 1) {
                    next.prefetch_operations(program);
                }
            }
            self.run_inline(program, number, start, end);
            number += 1;
            if number == count {
                number = 0;
            }
        }
    }

    /// Lets the threads that the chip has answered live through the rest of the quantum.
    #[inline]
    pub fn catch_up(&mut self, program: &Program, start: u32, end: u32) {
        if self.answered.is_empty() {
            return;
        }
        let mut answered = std::mem::take(&mut self.answered);
        for thread in answered.drain(..) {
            self.run(program, thread.into(), start, end);
        }
        self.answered = answered;
    }

    /// Runs a thread until the end of the quantum, or until it has to wait for the chip.
    pub fn run(&mut self, program: &Program, number: usize, start: u32, end: u32) {
        self.run_inline(program, number, start, end);
    }

    #[inline(always)]
    fn run_inline(&mut self, program: &Program, number: usize, start: u32, end: u32) {
        loop {
            let thread = &mut self.threads[number];
            if thread.state != State::Runs || thread.time >= end {
                return;
            }
            let fetches = &mut self.fetches[usize::from(thread.icache)];
            let length = end - start;
            let mut tables = Tables { fetches, units: &mut self.units, l1: &mut self.l1, start, length };
            match thread.issue(number as u8, program, &mut tables, &mut self.cycles) {
                Stop::Unfetched | Stop::Waits => return,
                Stop::Other => {
                    if !self.other_op(program, number, start, end) {
                        return;
                    }
                }
                Stop::Asks(missed) => {
                    let op = &program.code.ops[thread.pc as usize];
                    let (now, address) = (thread.time, thread.address(op));
                    let request = Request::new(now, self.number, number, op.kind, address, missed);
                    thread.state = State::Asks;
                    self.outbox.push(request);
                    return;
                }
                Stop::Over => {
                    self.ended.push(number as u8);
                    return;
                }
            }
        }
    }

    /// Issues the operation that a thread has stopped at. Returns whether the thread goes on.
    #[inline(never)]
    fn other_op(&mut self, program: &Program, number: usize, start: u32, end: u32) -> bool {
        let (thread, cycles) = (&mut self.threads[number], &mut self.cycles);
        let now = thread.time;
        let slot = (now - start) as usize % quantum::LONGEST;
        let op = &program.code.ops[thread.pc as usize];
        let at = thread.more_ready(program, op);
        if at > now {
            return thread.waits(at, cycles);
        }
        if !self.units.take(op.pool, slot) {
            let next = start + self.units.next(op.pool, slot, (end - start) as usize) as u32;
            cycles.units += u64::from(next - now);
            thread.time = next;
            return true;
        }
        let ready = match op.kind {
            Kind::Plain | Kind::Nop => now + u32::from(op.latency),
            Kind::Counter => {
                thread.state = State::Asks;
                self.outbox.push(Request::new(now, self.number, number, op.kind, 0, NOT_LOOKED_UP));
                return false;
            }
            Kind::Load | Kind::Store => {
                let address = thread.address(op);
                let access = if op.kind == Kind::Load {
                    let entries = thread.targets(program, op, address, self.line_words);
                    self.l1.load(start, slot..slot + 1, address, Target { thread: number as u8, entries }).0
                } else {
                    self.l1.store(slot, address)
                };
                match access {
                    Access::Served(at) => {
                        let wide = op.kind == Kind::Load && op.operands != 0;
                        if wide && !thread.loaded(program, op, address, self.line_words, at) {
                            // The rest is in the next line.
                            cycles.memory += 1;
                            thread.time += 1;
                            return true;
                        }
                        at
                    }
                    Access::Refused => {
                        cycles.memory += 1;
                        thread.time += 1;
                        return true;
                    }
                    Access::Ask(missed) => {
                        thread.state = State::Asks;
                        let request = Request::new(now, self.number, number, op.kind, address, missed);
                        self.outbox.push(request);
                        return false;
                    }
                }
            }
        };
        if op.operands == 0 {
            thread.set_ready(op.write, ready);
        } else if op.kind != Kind::Load {
            thread.write_all(program, op, ready);
        }
        thread.last_issue = now;
        thread.time += 1;
        thread.held = false;
        thread.pc += 1;
        if program.code.steps[thread.pc as usize].issue == Issue::End && !thread.advance(program, cycles) {
            self.ended.push(number as u8);
            return false;
        }
        true
    }

    /// The chip has served a request: the thread's result can be used from cycle `ready` on.
    pub fn served(&mut self, program: &Program, request: Request, ready: u32) {
        let thread = &mut self.threads[usize::from(request.thread)];
        let op = &program.code.ops[thread.pc as usize];
        self.answered.push(request.thread);
        thread.time = request.cycle + 1;
        thread.state = State::Runs;
        if op.kind == Kind::Load && op.operands != 0 {
            if !thread.loaded(program, op, request.address, self.line_words, ready) {
                self.cycles.memory += 1;
                return;
            }
        } else {
            thread.set_ready(op.write, ready);
        }
        thread.last_issue = request.cycle;
        thread.held = false;
        thread.pc += 1;
        if program.code.steps[thread.pc as usize].issue == Issue::End
            && !thread.advance(program, &mut self.cycles)
        {
            self.ended.push(request.thread);
        }
    }

    /// The chip or a cache bank has refused until the end of the quantum, cycles that are counted; the thread tries again in the
    /// next one.
    pub fn refused(&mut self, request: Request) {
        self.answered.push(request.thread);
        let thread = &mut self.threads[usize::from(request.thread)];
        thread.time = request.cycle + 1;
        thread.state = State::Runs;
    }

    /// Loads a request's address now that all earlier requests to the chip have been served.
    pub fn load_now(&mut self, program: &Program, request: Request, slot: usize) -> Access {
        let (thread, op) = self.asking(program, request);
        let entries = thread.targets(program, op, request.address, self.line_words);
        let target = Target { thread: request.thread, entries };
        self.l1.load_now(request.cycle, slot, request.address, target)
    }

    /// The chip has taken the load of a request, whose line arrives in cycle `arrival`.
    pub fn taken(&mut self, program: &Program, request: Request, slot: usize, arrival: u32) {
        let (thread, op) = self.asking(program, request);
        let entries = thread.targets(program, op, request.address, self.line_words);
        let target = Target { thread: request.thread, entries };
        self.l1.taken(request.cycle, slot, request.address, arrival, target);
    }

    fn asking<'p>(&self, program: &'p Program, request: Request) -> (&Thread, &'p MicroOp) {
        let thread = &self.threads[usize::from(request.thread)];
        (thread, &program.code.ops[thread.pc as usize])
    }

    /// The thread has got a new tape.
    pub fn resume(&mut self, program: &Program, number: usize) {
        let thread = &mut self.threads[number];
        thread.state = State::Runs;
        thread.enter(program, &mut self.cycles);
    }

    /// The thread has finished.
    pub fn halt(&mut self, number: usize) {
        self.threads[number].state = State::Halted;
        self.running -= 1;
    }

    /// The cycle in which the last thread to finish issued its last instruction.
    pub fn last_issue(&self) -> u32 {
        self.threads.iter().map(|thread| thread.last_issue).max().unwrap_or(0)
    }

    /// What threads did so far.
    pub fn thread_cycles(&self, program: &Program) -> ThreadCycles {
        let mut cycles = self.cycles;
        self.threads.iter().for_each(|thread| thread.count_issued(program, &mut cycles));
        cycles
    }

    /// Counts the cycles from its last instruction to cycle `end` of every thread.
    pub fn finish(&mut self, end: u32) {
        self.cycles.halted = self.threads.iter().map(|thread| u64::from(end - thread.last_issue - 1)).sum();
    }
}
