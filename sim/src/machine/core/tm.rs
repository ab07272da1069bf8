//! A thread multiprocessor: its threads issue in order, at most one instruction a cycle each.
//!
//! Time advances in quanta of [`QUANTUM`] cycles. Within a quantum, threads run one after another, in ring order from the
//! one that has waited longest, and take fetches, units and cache banks from tables with an entry for each cycle. A
//! thread is never affected by one behind it in this order, so the outcome is that of going cycle by cycle with the
//! order fixed for the quantum; but running on with one thread is several times as fast.
//!
//! What misses the first-level cache, stores and the shared counter are put in an outbox. The thread stands still
//! until the chip has served it, then catches up. A quantum is not longer than the time that memory takes, so
//! that nothing asked for within a quantum arrives from there within it.

use super::l1::{Access, L1};
use super::outstanding::{Arrival, UNKNOWN, Waiter};
use super::stats::ThreadCycles;
use crate::machine::description::MachineDescription;
use crate::machine::program::{COUNTER, Kind, MicroOp, PIPELINE, POOLS, Program, SCOREBOARD, UNLIMITED};
use crate::unit_costs::Unit;

/// Most cycles of a quantum.
pub const QUANTUM: usize = 8;
/// Entries of a scoreboard in memory; a power of two, so that no index needs a check.
const ENTRIES: usize = SCOREBOARD.next_power_of_two();
/// Pools in memory.
const POOL_ENTRIES: usize = POOLS.next_power_of_two();

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
}

/// Where a thread is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    /// It goes on at its own time.
    Runs,
    /// It waits for data whose time is not known.
    Parked,
    /// It has asked the chip.
    Asks,
    /// It has come to the end of its tape.
    Ended,
    /// It has finished.
    Halted,
}

/// A thread.
#[derive(Clone, Debug)]
pub struct Thread {
    /// Cycle from which on each register can be used.
    ready: [u32; ENTRIES],
    /// The next cycle that it has not lived through.
    time: u32,
    last_issue: u32,
    /// Index of its next operation.
    pc: u32,
    /// Whether that has been fetched.
    held: bool,
    state: State,
    /// Runs with their addresses.
    pub tape: Vec<u32>,
    /// Index of the current run.
    pub at: usize,
    /// Index behind the current run's addresses.
    next: usize,
}

/// A multiprocessor.
#[derive(Clone, Debug)]
pub struct Tm {
    number: u16,
    /// The threads.
    pub threads: Vec<Thread>,
    halted: u32,
    icaches: usize,
    icache_banks: usize,
    /// Fetches left, by slot, cache and bank.
    fetches: Vec<u8>,
    fetches_full: Vec<u8>,
    /// Units left, by slot and pool.
    units: [[u8; POOL_ENTRIES]; QUANTUM],
    units_full: [u8; POOL_ENTRIES],
    /// The data cache.
    pub l1: L1,
    /// What the chip has to serve.
    pub outbox: Vec<Request>,
    /// Threads that have come to the end of their tape.
    pub ended: Vec<u8>,
    /// What threads did.
    pub cycles: ThreadCycles,
}

impl Tm {
    pub fn new(number: u16, machine: &MachineDescription) -> Self {
        let mut units_full = [0u8; POOL_ENTRIES];
        for unit in Unit::ALL {
            units_full[unit as usize] = machine.units.pool(unit).count as u8;
        }
        units_full[usize::from(UNLIMITED)] = u8::MAX;
        units_full[usize::from(PIPELINE)] = 1;
        units_full[usize::from(COUNTER)] = 1;
        let icache = &machine.icache;
        let entries = (icache.caches * icache.banks) as usize * QUANTUM;
        let fetches_full = vec![icache.fetches_per_bank as u8; entries];
        let thread = Thread {
            ready: [0; ENTRIES],
            time: 0,
            last_issue: 0,
            pc: 0,
            held: false,
            state: State::Runs,
            tape: vec![],
            at: 0,
            next: 0,
        };
        Self {
            number,
            threads: vec![thread; machine.tm.threads as usize],
            halted: 0,
            icaches: icache.caches as usize,
            icache_banks: icache.banks as usize,
            fetches: fetches_full.clone(),
            fetches_full,
            units: [units_full; QUANTUM],
            units_full,
            l1: L1::new(machine),
            outbox: vec![],
            ended: vec![],
            cycles: ThreadCycles::default(),
        }
    }

    /// Whether all threads have finished.
    pub fn is_halted(&self) -> bool {
        self.halted as usize == self.threads.len()
    }

    /// The first cycle in which some thread goes on by itself.
    pub fn next_time(&self) -> u32 {
        let running = self.threads.iter().filter(|thread| thread.state == State::Runs);
        running.map(|thread| thread.time).min().unwrap_or(u32::MAX)
    }

    /// Puts `thread` at the run that its tape is at.
    #[inline(always)]
    pub fn enter(&mut self, program: &Program, thread: usize) {
        self.threads[thread].enter(program);
    }

    /// It is known now that `line` arrives in cycle `arrival`.
    pub fn arrives(&mut self, line: u32, arrival: u32) {
        let (threads, cycles) = (&mut self.threads, &mut self.cycles);
        self.l1.arrives(line, Arrival::from_memory(arrival), |Waiter { thread, register }| {
            let thread = &mut threads[usize::from(thread)];
            thread.ready[usize::from(register) % ENTRIES] = arrival;
            if thread.state == State::Parked {
                // It looks again whether it can go on.
                thread.state = State::Runs;
                let until = arrival.max(thread.time);
                cycles.data += u64::from(until - thread.time);
                thread.time = until;
            }
        });
    }

    /// Runs all threads from cycle `start` up to `end`, at most [`QUANTUM`] cycles later.
    pub fn quantum(&mut self, program: &Program, start: u32, end: u32) {
        self.fetches.copy_from_slice(&self.fetches_full);
        self.units = [self.units_full; QUANTUM];
        self.l1.begin(start);
        let waiting = self.threads.iter().filter(|thread| thread.state != State::Halted);
        let earliest = waiting.map(|thread| thread.last_issue).min().unwrap_or(0);
        let is_first = |thread: &Thread| thread.state != State::Halted && thread.last_issue == earliest;
        let first = self.threads.iter().position(is_first).unwrap_or(0);
        for thread in (first..self.threads.len()).chain(0..first) {
            self.run(program, thread, start, end);
        }
    }

    /// Runs a thread until the end of the quantum, or until it has to wait for the chip.
    pub fn run(&mut self, program: &Program, number: usize, start: u32, end: u32) {
        let thread = &mut self.threads[number];
        if thread.state != State::Runs {
            return;
        }
        let fetch_stride = self.icaches * self.icache_banks;
        let fetch_base = number % self.icaches * self.icache_banks;
        let (mut now, mut held, mut pc) = (thread.time, thread.held, thread.pc);
        while now < end {
            let op = &program.ops[pc as usize];
            if !held {
                let bank = fetch_base + usize::from(op.bank);
                let left = &mut self.fetches[(now - start) as usize * fetch_stride + bank];
                if *left == 0 {
                    self.cycles.fetch += 1;
                    now += 1;
                    continue;
                }
                *left -= 1;
                held = true;
            }
            let [a, b, c] = op.reads.map(|register| thread.ready[usize::from(register) % ENTRIES]);
            let mut at = a.max(b).max(c);
            if op.more_reads.1 != 0 {
                at = at.max(thread.more_ready(program, op));
            }
            if at > now {
                if at == UNKNOWN {
                    thread.state = State::Parked;
                    break;
                }
                self.cycles.data += u64::from(at - now);
                now = at;
                continue;
            }
            let slot = (now - start) as usize % QUANTUM;
            let left = &mut self.units[slot][usize::from(op.pool) % POOL_ENTRIES];
            if *left == 0 {
                self.cycles.units += 1;
                now += 1;
                continue;
            }
            let ready = match op.kind {
                Kind::Plain => now + u32::from(op.latency),
                Kind::Nop => {
                    self.cycles.nop += 1;
                    self.cycles.issue -= 1;
                    now + 1
                }
                Kind::Counter => {
                    *left -= 1;
                    thread.state = State::Asks;
                    let (tm, thread) = (self.number, number as u8);
                    self.outbox.push(Request { cycle: now, tm, thread, kind: op.kind, address: 0 });
                    break;
                }
                Kind::Load | Kind::Store => {
                    let address = thread.address(op);
                    let access = if op.kind == Kind::Load {
                        self.l1.load(now, slot, address, Waiter { thread: number as u8, register: op.write })
                    } else {
                        self.l1.store(slot, address)
                    };
                    match access {
                        Access::Served(at) => at,
                        Access::Refused => {
                            self.cycles.memory += 1;
                            now += 1;
                            continue;
                        }
                        Access::Ask => {
                            thread.state = State::Asks;
                            let (tm, thread) = (self.number, number as u8);
                            self.outbox.push(Request { cycle: now, tm, thread, kind: op.kind, address });
                            break;
                        }
                    }
                }
            };
            *left -= 1;
            self.cycles.issue += 1;
            thread.ready[usize::from(op.write) % ENTRIES] = ready;
            if op.more_writes.1 != 0 {
                thread.write_more(program, op, ready);
            }
            thread.last_issue = now;
            now += 1;
            held = false;
            pc += 1;
            if op.last {
                if !thread.advance(program) {
                    self.ended.push(number as u8);
                    break;
                }
                pc = thread.pc;
            }
        }
        (thread.time, thread.held, thread.pc) = (now, held, pc);
    }

    /// The chip has served a request: the thread's result can be used from cycle `ready` on.
    pub fn served(&mut self, program: &Program, request: Request, ready: u32) {
        let thread = &mut self.threads[usize::from(request.thread)];
        let op = &program.ops[thread.pc as usize];
        self.cycles.issue += 1;
        thread.ready[usize::from(op.write) % ENTRIES] = ready;
        if op.more_writes.1 != 0 {
            thread.write_more(program, op, ready);
        }
        thread.last_issue = request.cycle;
        thread.time = request.cycle + 1;
        thread.held = false;
        thread.state = State::Runs;
        thread.pc += 1;
        if op.last && !thread.advance(program) {
            self.ended.push(request.thread);
        }
    }

    /// The chip or a cache bank has refused; the thread tries again in the next cycle.
    pub fn refused(&mut self, request: Request) {
        self.cycles.memory += 1;
        let thread = &mut self.threads[usize::from(request.thread)];
        thread.time = request.cycle + 1;
        thread.state = State::Runs;
    }

    /// The register that a request's result goes to.
    pub fn waiter(&self, program: &Program, request: Request) -> Waiter {
        let op = &program.ops[self.threads[usize::from(request.thread)].pc as usize];
        Waiter { thread: request.thread, register: op.write }
    }

    /// The thread has got a new tape.
    pub fn resume(&mut self, program: &Program, number: usize) {
        let thread = &mut self.threads[number];
        thread.state = State::Runs;
        thread.enter(program);
    }

    /// The thread has finished.
    pub fn halt(&mut self, number: usize) {
        self.threads[number].state = State::Halted;
        self.halted += 1;
    }

    /// The cycle in which the last thread to finish issued its last instruction.
    pub fn last_issue(&self) -> u32 {
        self.threads.iter().map(|thread| thread.last_issue).max().unwrap_or(0)
    }

    /// Counts what threads that have finished did not do until cycle `end`.
    pub fn finish(&mut self, end: u32) {
        let all = u64::from(end) * self.threads.len() as u64;
        self.cycles.halted = all - self.cycles.total();
    }
}

impl Thread {
    /// Goes to the run that the tape is at.
    #[inline(always)]
    fn enter(&mut self, program: &Program) {
        let run = &program.runs[self.tape[self.at] as usize];
        self.next = self.at + 1 + run.bases.len();
        self.pc = run.first;
    }

    /// Goes to the next run; false, and an end, if there is none.
    #[inline(always)]
    fn advance(&mut self, program: &Program) -> bool {
        if self.next >= self.tape.len() {
            self.state = State::Ended;
            return false;
        }
        self.at = self.next;
        self.enter(program);
        true
    }

    /// The word address of a memory operation.
    #[inline(always)]
    fn address(&self, op: &MicroOp) -> u32 {
        self.tape[self.at + 1 + usize::from(op.base)] + u32::from(op.offset)
    }

    #[cold]
    fn write_more(&mut self, program: &Program, op: &MicroOp, ready: u32) {
        for &register in program.kept(op.more_writes) {
            self.ready[usize::from(register) % ENTRIES] = ready;
        }
    }

    /// When the further registers can be used that an operation waits for.
    fn more_ready(&self, program: &Program, op: &MicroOp) -> u32 {
        let ready =
            program.kept(op.more_reads).iter().map(|register| self.ready[usize::from(*register) % ENTRIES]);
        ready.max().unwrap_or(0)
    }
}
