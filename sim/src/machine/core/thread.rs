//! A thread: where it is in its program, and the loop that issues its simple operations.

use super::outstanding::UNKNOWN;
use super::stats::ThreadCycles;
use super::tm::QUANTUM;
use crate::machine::program::{Kind, MicroOp, POOLS, Program, Register, SCOREBOARD};

/// Entries of a scoreboard in memory; a power of two, so that no index needs a check.
pub const ENTRIES: usize = SCOREBOARD.next_power_of_two();
/// Pools in memory.
pub const POOL_ENTRIES: usize = POOLS.next_power_of_two();

/// Where a thread is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
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
    pub ready: [u32; ENTRIES],
    /// The next cycle that it has not lived through.
    pub time: u32,
    pub last_issue: u32,
    /// Index of its next operation.
    pub pc: u32,
    /// Whether that has been fetched.
    pub held: bool,
    pub state: State,
    /// Runs with their addresses.
    pub tape: Vec<u32>,
    /// Index of the current run.
    pub at: usize,
    /// Index behind the current run's addresses.
    pub next: usize,
    /// First entry of its instruction cache in a slot of [`Tm::fetches`].
    pub fetch_base: u16,
    /// Words of a load that are under way already, where it reaches into a second line.
    pub part: u8,
}

/// What the threads of a multiprocessor take from, cycle by cycle of a quantum.
pub struct Tables<'a> {
    /// Fetches left; slots are `1 << fetch_shift` apart.
    pub fetches: &'a mut [u8],
    pub fetch_shift: u32,
    /// Units left, by slot and pool.
    pub units: &'a mut [[u8; POOL_ENTRIES]; QUANTUM],
    /// The quantum.
    pub start: u32,
    pub end: u32,
}

impl Thread {
    /// Issues simple operations, up to one that is not. Returns whether there is one that has been fetched, whose
    /// operands are ready and whose unit is free before the end of the quantum.
    #[inline(always)]
    pub fn simple_ops(&mut self, ops: &[MicroOp], tables: Tables<'_>, cycles: &mut ThreadCycles) -> bool {
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
    pub fn waits(&mut self, at: u32, cycles: &mut ThreadCycles) -> bool {
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
    pub fn enter(&mut self, program: &Program) {
        let run = &program.runs[self.tape[self.at] as usize];
        self.next = self.at + 1 + run.bases.len();
        self.pc = run.first;
    }

    /// Goes to the next run; false, and an end, if there is none.
    #[inline(always)]
    pub fn advance(&mut self, program: &Program) -> bool {
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
    pub fn address(&self, op: &MicroOp) -> u32 {
        self.tape[self.at + 1 + usize::from(op.base)] + u32::from(op.offset) + u32::from(self.part)
    }

    /// Registers of the words that an access at `address` brings: those up to the end of the line.
    #[inline(always)]
    pub fn targets<'p>(
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
    pub fn loaded(
        &mut self,
        program: &Program,
        op: &MicroOp,
        address: u32,
        line_words: u32,
        ready: u32,
    ) -> bool {
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
    pub fn write_all(&mut self, program: &Program, op: &MicroOp, ready: u32) {
        self.ready[usize::from(op.write) % ENTRIES] = ready;
        for &register in &program.operands_of(op).writes {
            self.ready[usize::from(register) % ENTRIES] = ready;
        }
    }

    /// When the further registers can be used that an operation waits for.
    pub fn more_ready(&self, program: &Program, op: &MicroOp) -> u32 {
        let reads = &program.operands_of(op).reads;
        reads.iter().map(|register| self.ready[usize::from(*register) % ENTRIES]).max().unwrap_or(0)
    }
}
