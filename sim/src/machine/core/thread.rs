//! A thread: where it is in its program, and the loop that issues its operations.

use super::l1::{Access, L1, Target};
use super::outstanding::UNKNOWN;
use super::slots::Slots;
use super::stats::ThreadCycles;
use super::tm::QUANTUM;
use crate::machine::program::{Issue, MicroOp, Program, Register};

/// Entries of a scoreboard in memory: as many as an index can have, so that none needs a check.
pub const ENTRIES: usize = 1 << Register::BITS;

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
    /// Index behind its run's last operation.
    pub end: u32,
    /// Whether that has been fetched.
    pub held: bool,
    pub state: State,
    /// Runs with their addresses.
    pub tape: Vec<u32>,
    /// Index of the current run.
    pub at: usize,
    /// Index behind the current run's addresses.
    pub next: usize,
    /// Its instruction cache.
    pub icache: u8,
    /// Words of a load that are under way already, where it reaches into a second line.
    pub part: u8,
}

/// What the threads of a multiprocessor take from, cycle by cycle of a quantum.
pub struct Tables<'a> {
    /// Fetches by bank of the thread's instruction cache.
    pub fetches: &'a mut Slots,
    /// Units by pool.
    pub units: &'a mut Slots,
    pub l1: &'a mut L1,
    /// The quantum.
    pub start: u32,
    pub end: u32,
}

/// Why a thread does not go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The quantum is over, and the next operation has not been fetched.
    Unfetched,
    /// The quantum is over, or an operand has no known time.
    Waits,
    /// The multiprocessor has to issue the operation; it has been fetched, and its first operands are ready.
    Other,
    /// The operation is a load for the chip.
    Asks,
    /// The run is over.
    Over,
}

/// The first cycle behind `now` in which there is one of a resource, which it takes; or `end`.
#[inline(never)]
fn wait_for(slots: &mut Slots, resource: u8, [start, now, end]: [u32; 3]) -> u32 {
    let next = start + slots.next(resource, now - start, end - start);
    if next < end {
        slots.take(resource, next - start);
    }
    next
}

impl Thread {
    /// Issues operations of thread `number` before the end of the quantum, up to one that is neither plain nor a load that
    /// the L1 serves, or to the end of its tape, which is [`Stop::Over`].
    #[inline(always)]
    pub fn issue(
        &mut self,
        number: u8,
        program: &Program,
        tables: &mut Tables<'_>,
        cycles: &mut ThreadCycles,
    ) -> Stop {
        if self.held {
            // It brings its fetch along.
            let bank = program.ops[self.pc as usize].bank;
            tables.fetches.give(bank, self.time - tables.start);
        }
        loop {
            let first = self.pc as usize;
            let stop = self.issue_run(number, &program.ops[first..self.end as usize], tables, cycles);
            let nops = program.nops_before[self.pc as usize] - program.nops_before[first];
            cycles.issue += u64::from(self.pc - first as u32 - nops);
            cycles.nop += u64::from(nops);
            self.held = !matches!(stop, Stop::Unfetched | Stop::Over);
            if stop != Stop::Over || !self.advance(program) {
                return stop;
            }
            if self.time == tables.end {
                return Stop::Unfetched;
            }
        }
    }

    /// Issues `ops`, which begin with the next operation.
    #[inline(always)]
    fn issue_run(
        &mut self,
        number: u8,
        ops: &[MicroOp],
        tables: &mut Tables<'_>,
        cycles: &mut ThreadCycles,
    ) -> Stop {
        let (start, end) = (tables.start, tables.end);
        let (mut now, mut last_issue) = (self.time, self.last_issue);
        let mut rest = ops.iter();
        let stop = loop {
            let Some(op) = rest.as_slice().first() else { break Stop::Over };
            if now == end {
                break Stop::Unfetched;
            }
            if !tables.fetches.take(op.bank, now - start) {
                let next = wait_for(tables.fetches, op.bank, [start, now, end]);
                cycles.fetch += u64::from(next - now);
                now = next;
                if now == end {
                    break Stop::Unfetched;
                }
            }
            let [a, b, c] = op.reads.map(|register| self.ready[usize::from(register)]);
            let ready = a.max(b).max(c);
            if ready > now {
                if ready == UNKNOWN {
                    self.state = State::Parked;
                    break Stop::Waits;
                }
                cycles.data += u64::from(ready - now);
                now = ready;
                if now >= end {
                    break Stop::Waits;
                }
            }
            let ready = if op.issue == Issue::Plain {
                if !tables.units.take(op.pool, now - start) {
                    let next = wait_for(tables.units, op.pool, [start, now, end]);
                    cycles.units += u64::from(next - now);
                    now = next;
                    if now == end {
                        break Stop::Waits;
                    }
                }
                now + u32::from(op.latency)
            } else if op.issue == Issue::Load {
                let first = now;
                let access = self.load(number, op, tables.l1, &mut now, [start, end]);
                cycles.memory += u64::from(now - first);
                match access {
                    Access::Served(ready) => ready,
                    Access::Ask => break Stop::Asks,
                    Access::Refused => break Stop::Waits,
                }
            } else {
                break Stop::Other;
            };
            self.ready[usize::from(op.write)] = ready;
            last_issue = now;
            now += 1;
            rest.next();
        };
        (self.time, self.last_issue) = (now, last_issue);
        self.pc += (ops.len() - rest.len()) as u32;
        stop
    }

    /// Loads a word from the L1, in the first cycle from `now` on in which it does not refuse; at the end of the quantum it
    /// still does.
    #[inline(never)]
    fn load(&self, number: u8, op: &MicroOp, l1: &mut L1, now: &mut u32, [start, end]: [u32; 2]) -> Access {
        let address = self.tape[self.at + 1 + usize::from(op.base)] + u32::from(op.offset);
        let target = Target { thread: number, registers: std::slice::from_ref(&op.write) };
        loop {
            let access = l1.load(*now, (*now - start) as usize % QUANTUM, address, target);
            if access != Access::Refused {
                return access;
            }
            *now += 1;
            if *now == end {
                return access;
            }
        }
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
        self.end = run.first + run.length;
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
            self.ready[usize::from(register)] = ready;
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
        self.ready[usize::from(op.write)] = ready;
        for &register in &program.operands_of(op).writes {
            self.ready[usize::from(register)] = ready;
        }
    }

    /// When the further registers can be used that an operation waits for.
    pub fn more_ready(&self, program: &Program, op: &MicroOp) -> u32 {
        let reads = &program.operands_of(op).reads;
        reads.iter().map(|register| self.ready[usize::from(*register)]).max().unwrap_or(0)
    }
}
