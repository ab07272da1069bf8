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

use super::l1::{Access, L1, Target};
use super::outstanding::{UNKNOWN, Waiter};
use super::stats::ThreadCycles;
use crate::machine::description::MachineDescription;
use crate::machine::program::{
    COUNTER, Kind, MicroOp, PIPELINE, POOLS, Program, Register, SCOREBOARD, UNLIMITED,
};
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
    /// First entry of its instruction cache in a slot of [`Tm::fetches`].
    fetch_base: u16,
    /// Words of a load that are under way already, where it reaches into a second line.
    part: u8,
}

/// A multiprocessor.
#[derive(Clone, Debug)]
pub struct Tm {
    number: u16,
    /// The threads.
    pub threads: Vec<Thread>,
    halted: u32,
    /// Binary logarithm of the entries of `fetches` for a slot.
    fetch_shift: u32,
    line_words: u32,
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
    /// Threads that the chip has answered in this quantum.
    answered: Vec<u8>,
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
        let fetch_shift = (icache.caches * icache.banks).next_power_of_two().trailing_zeros();
        let entries = QUANTUM << fetch_shift;
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
            fetch_base: 0,
            part: 0,
        };
        let mut threads = vec![thread; machine.tm.threads as usize];
        for (number, thread) in threads.iter_mut().enumerate() {
            thread.fetch_base = (number as u32 % icache.caches * icache.banks) as u16;
        }
        Self {
            number,
            threads,
            halted: 0,
            fetch_shift,
            line_words: machine.l1.line_words(),
            fetches: fetches_full.clone(),
            fetches_full,
            units: [units_full; QUANTUM],
            units_full,
            l1: L1::new(machine),
            outbox: vec![],
            ended: vec![],
            answered: vec![],
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

    /// It is known now that `line` arrives in cycle `arrival`.
    pub fn arrives(&mut self, line: u32, arrival: u32) {
        let (threads, cycles) = (&mut self.threads, &mut self.cycles);
        self.l1.arrives(line, arrival, |Waiter { thread, register }| {
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

    /// Lets the threads that the chip has answered live through the rest of the quantum.
    pub fn catch_up(&mut self, program: &Program, start: u32, end: u32) {
        let mut answered = std::mem::take(&mut self.answered);
        for thread in answered.drain(..) {
            self.run(program, thread.into(), start, end);
        }
        self.answered = answered;
    }

    /// Runs a thread until the end of the quantum, or until it has to wait for the chip.
    #[inline]
    pub fn run(&mut self, program: &Program, number: usize, start: u32, end: u32) {
        let thread = &self.threads[number];
        if thread.state != State::Runs || thread.time >= end {
            return;
        }
        loop {
            let tables = Tables {
                fetches: &mut self.fetches,
                fetch_shift: self.fetch_shift,
                units: &mut self.units,
                start,
                end,
            };
            if !self.threads[number].simple_ops(&program.ops, tables, &mut self.cycles)
                || !self.other_op(program, number, start)
            {
                break;
            }
        }
    }

    /// Issues the operation that a thread has fetched, whose operands are ready and whose unit is free; it is not a simple
    /// one. Returns whether the thread goes on.
    #[inline(never)]
    fn other_op(&mut self, program: &Program, number: usize, start: u32) -> bool {
        let (thread, cycles) = (&mut self.threads[number], &mut self.cycles);
        let now = thread.time;
        let slot = (now - start) as usize % QUANTUM;
        let op = &program.ops[thread.pc as usize];
        let left = &mut self.units[slot][usize::from(op.pool) % POOL_ENTRIES];
        let ready = match op.kind {
            Kind::Plain | Kind::Nop => {
                let at = thread.more_ready(program, op);
                if at > now {
                    return thread.waits(at, cycles);
                }
                now + u32::from(op.latency)
            }
            Kind::Counter => {
                *left -= 1;
                thread.state = State::Asks;
                let (tm, thread) = (self.number, number as u8);
                self.outbox.push(Request { cycle: now, tm, thread, kind: op.kind, address: 0 });
                return false;
            }
            Kind::Load | Kind::Store => {
                let address = thread.address(op);
                let access = if op.kind == Kind::Load {
                    let registers = thread.targets(program, op, address, self.line_words);
                    self.l1.load(now, slot, address, Target { thread: number as u8, registers })
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
                    Access::Ask => {
                        thread.state = State::Asks;
                        let (tm, thread) = (self.number, number as u8);
                        self.outbox.push(Request { cycle: now, tm, thread, kind: op.kind, address });
                        return false;
                    }
                }
            }
        };
        *left -= 1;
        if op.kind == Kind::Nop {
            cycles.nop += 1;
        } else {
            cycles.issue += 1;
        }
        if op.operands == 0 {
            thread.ready[usize::from(op.write) % ENTRIES] = ready;
        } else if op.kind != Kind::Load {
            thread.write_all(program, op, ready);
        }
        thread.last_issue = now;
        thread.time += 1;
        thread.held = false;
        thread.pc += 1;
        if op.last && !thread.advance(program) {
            self.ended.push(number as u8);
            return false;
        }
        true
    }

    /// The chip has served a request: the thread's result can be used from cycle `ready` on.
    pub fn served(&mut self, program: &Program, request: Request, ready: u32) {
        let thread = &mut self.threads[usize::from(request.thread)];
        let op = &program.ops[thread.pc as usize];
        self.answered.push(request.thread);
        thread.time = request.cycle + 1;
        thread.state = State::Runs;
        if op.kind == Kind::Load && op.operands != 0 {
            if !thread.loaded(program, op, request.address, self.line_words, ready) {
                self.cycles.memory += 1;
                return;
            }
        } else {
            thread.ready[usize::from(op.write) % ENTRIES] = ready;
        }
        self.cycles.issue += 1;
        thread.last_issue = request.cycle;
        thread.held = false;
        thread.pc += 1;
        if op.last && !thread.advance(program) {
            self.ended.push(request.thread);
        }
    }

    /// The chip or a cache bank has refused; the thread tries again in the next cycle.
    pub fn refused(&mut self, request: Request) {
        self.cycles.memory += 1;
        self.answered.push(request.thread);
        let thread = &mut self.threads[usize::from(request.thread)];
        thread.time = request.cycle + 1;
        thread.state = State::Runs;
    }

    /// Loads a request's address now that all earlier requests to the chip have been served.
    pub fn load_now(&mut self, program: &Program, request: Request, slot: usize) -> Access {
        let (thread, op) = self.asking(program, request);
        let registers = thread.targets(program, op, request.address, self.line_words);
        let target = Target { thread: request.thread, registers };
        self.l1.load_now(request.cycle, slot, request.address, target)
    }

    /// The chip has taken the load of a request, whose line arrives in cycle `arrival`.
    pub fn taken(&mut self, program: &Program, request: Request, slot: usize, arrival: u32) {
        let (thread, op) = self.asking(program, request);
        let registers = thread.targets(program, op, request.address, self.line_words);
        let target = Target { thread: request.thread, registers };
        self.l1.taken(request.cycle, slot, request.address, arrival, target);
    }

    fn asking<'p>(&self, program: &'p Program, request: Request) -> (&Thread, &'p MicroOp) {
        let thread = &self.threads[usize::from(request.thread)];
        (thread, &program.ops[thread.pc as usize])
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

/// What the threads of a multiprocessor take from, cycle by cycle of a quantum.
struct Tables<'a> {
    /// Fetches left; slots are `1 << fetch_shift` apart.
    fetches: &'a mut [u8],
    fetch_shift: u32,
    /// Units left, by slot and pool.
    units: &'a mut [[u8; POOL_ENTRIES]; QUANTUM],
    /// The quantum.
    start: u32,
    end: u32,
}

impl Thread {
    /// Issues simple operations, up to one that is not. Returns whether there is one that has been fetched, whose
    /// operands are ready and whose unit is free before the end of the quantum.
    #[inline(always)]
    fn simple_ops(&mut self, ops: &[MicroOp], tables: Tables<'_>, cycles: &mut ThreadCycles) -> bool {
        let Tables { fetches, fetch_shift, units, start, end } = tables;
        let (mut now, mut held, mut pc) = (self.time, self.held, self.pc as usize);
        let (mut issued, mut nops) = (0u32, 0u32);
        let fetch_base = usize::from(self.fetch_base);
        let found = loop {
            if now >= end {
                break false;
            }
            let op = &ops[pc];
            let slot = (now - start) as usize % QUANTUM;
            if !held {
                let left = &mut fetches[(slot << fetch_shift) + fetch_base + usize::from(op.bank)];
                if *left == 0 {
                    cycles.fetch += 1;
                    now += 1;
                    continue;
                }
                *left -= 1;
                held = true;
            }
            let [a, b, c] = op.reads.map(|register| self.ready[usize::from(register) % ENTRIES]);
            let at = a.max(b).max(c);
            if at > now {
                if at == UNKNOWN {
                    self.state = State::Parked;
                    break false;
                }
                cycles.data += u64::from(at - now);
                now = at;
                continue;
            }
            let left = &mut units[slot][usize::from(op.pool) % POOL_ENTRIES];
            if *left == 0 {
                cycles.units += 1;
                now += 1;
                continue;
            }
            if !op.simple {
                break true;
            }
            *left -= 1;
            issued += 1;
            nops += u32::from(op.kind == Kind::Nop);
            self.ready[usize::from(op.write) % ENTRIES] = now + u32::from(op.latency);
            self.last_issue = now;
            now += 1;
            held = false;
            pc += 1;
        };
        (self.time, self.held, self.pc) = (now, held, pc as u32);
        cycles.issue += u64::from(issued - nops);
        cycles.nop += u64::from(nops);
        found
    }

    /// The thread waits for an operand until cycle `at`; whether that is known.
    fn waits(&mut self, at: u32, cycles: &mut ThreadCycles) -> bool {
        if at == UNKNOWN {
            self.state = State::Parked;
            return false;
        }
        cycles.data += u64::from(at - self.time);
        self.time = at;
        true
    }

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
        self.tape[self.at + 1 + usize::from(op.base)] + u32::from(op.offset) + u32::from(self.part)
    }

    /// Registers of the words that an access at `address` brings: those up to the end of the line.
    #[inline(always)]
    fn targets<'p>(
        &self,
        program: &'p Program,
        op: &'p MicroOp,
        address: u32,
        line_words: u32,
    ) -> &'p [Register] {
        if op.operands == 0 {
            return std::slice::from_ref(&op.write);
        }
        let registers = &program.operands_of(op).writes[usize::from(self.part)..];
        let to_the_end = (line_words - address % line_words) as usize;
        &registers[..registers.len().min(to_the_end)]
    }

    /// The words that an access at `address` brought can be used from cycle `ready` on; whether these were the last.
    fn loaded(&mut self, program: &Program, op: &MicroOp, address: u32, line_words: u32, ready: u32) -> bool {
        let registers = self.targets(program, op, address, line_words);
        for &register in registers {
            self.ready[usize::from(register) % ENTRIES] = ready;
        }
        self.part += registers.len() as u8;
        if usize::from(self.part) < program.operands_of(op).writes.len() {
            return false;
        }
        self.part = 0;
        true
    }

    #[cold]
    fn write_all(&mut self, program: &Program, op: &MicroOp, ready: u32) {
        self.ready[usize::from(op.write) % ENTRIES] = ready;
        for &register in &program.operands_of(op).writes {
            self.ready[usize::from(register) % ENTRIES] = ready;
        }
    }

    /// When the further registers can be used that an operation waits for.
    fn more_ready(&self, program: &Program, op: &MicroOp) -> u32 {
        let reads = &program.operands_of(op).reads;
        reads.iter().map(|register| self.ready[usize::from(*register) % ENTRIES]).max().unwrap_or(0)
    }
}
