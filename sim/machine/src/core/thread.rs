//! A thread: where it is in its program, and the loop that issues its operations.

use super::l1::{Access, L1, Target};
use super::outstanding::UNKNOWN;
use super::prefetch::prefetch;
use super::slots::{COLUMNS, Slots};
use super::stats::ThreadCycles;
use crate::program::{BOARD_ENTRIES, BoardEntry, Issue, MicroOp, Program};
use std::hint::cold_path;

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

/// A thread. What the loop below needs of it lies together, its scoreboard behind that.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct Thread {
    /// The next cycle that it has not lived through.
    pub time: u32,
    pub last_issue: u32,
    /// Index of its next operation, or of what stands behind its run.
    pub pc: u32,
    /// Index of its run's first operation.
    first: u32,
    /// Runs with their addresses.
    pub tape: Vec<u32>,
    /// Index of the current run.
    pub at: u32,
    /// Index behind the current run's addresses.
    next: u32,
    pub state: State,
    /// Whether its next operation has been fetched.
    pub held: bool,
    /// Its instruction cache.
    pub icache: u8,
    /// Words of a load that are under way already, where it reaches into a second line.
    part: u8,
    /// Cycle from which on each register can be used, by its entry.
    ready: [u32; BOARD_ENTRIES],
}

/// What the threads of a multiprocessor take from, cycle by cycle of a quantum.
pub struct Tables<'a> {
    /// Fetches by bank of the thread's instruction cache.
    pub fetches: &'a mut Slots,
    /// Units by pool.
    pub units: &'a mut Slots,
    pub l1: &'a mut L1,
    /// First cycle of the quantum.
    pub start: u32,
    /// Its cycles.
    pub length: u32,
}

/// Why a thread does not go on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The quantum is over, and the next operation has not been fetched.
    Unfetched,
    /// The quantum is over, or an operand has no known time.
    Waits,
    /// The multiprocessor has to issue the operation; it has been fetched, and its first operand is ready.
    Other,
    /// The operation is a load for the chip, as in [`Access::Ask`].
    Asks(u32),
    /// The run is over.
    Over,
}

/// Takes one of `resource` in the first slot behind `slot` in which there is one, and counts the cycles until then; none if
/// there is none before `end`.
#[cold]
fn wait_for(slots: &mut Slots, resource: u8, slot: usize, end: usize, cycles: &mut u64) -> Option<usize> {
    let next = slots.next(resource, slot, end);
    *cycles += (next - slot) as u64;
    slots.take(resource, next).then_some(next)
}

impl Thread {
    /// A thread that fetches from the instruction cache `icache`.
    pub fn new(icache: u8) -> Self {
        Self {
            time: 0,
            last_issue: 0,
            pc: 0,
            first: 0,
            tape: vec![],
            at: 0,
            next: 0,
            state: State::Runs,
            held: false,
            icache,
            part: 0,
            ready: [0; BOARD_ENTRIES],
        }
    }

    /// Asks the host for what it looks at first when it comes by: itself, and the first entries of its scoreboard.
    #[inline(always)]
    pub fn prefetch(&self) {
        prefetch(self, 3);
    }

    /// Asks the host for its next operations and addresses.
    #[inline(always)]
    pub fn prefetch_operations(&self, program: &Program) {
        prefetch(program.code.steps.as_ptr().wrapping_add(self.pc as usize), 2);
        prefetch(self.tape.as_ptr().wrapping_add(self.at as usize), 1);
    }

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
        let steps = &program.code.steps[..];
        let (start, end) = (tables.start, tables.start + tables.length);
        let slots = tables.length as usize;
        let first = (self.time - start) as usize % COLUMNS;
        let mut slot = first;
        // The one behind that of the last operation issued.
        let mut behind;
        let mut rest = &steps[self.pc as usize..];
        if self.held {
            // It brings its fetch along.
            tables.fetches.give(rest[0].bank, slot);
        }
        let stop = loop {
            let [step, next @ ..] = rest else { unreachable!("behind every run stands its end") };
            behind = slot;
            // There is none behind the quantum, nor for what stands behind a run.
            if !tables.fetches.take(step.bank, slot) {
                cold_path();
                if step.issue == Issue::End {
                    self.pc = (steps.len() - rest.len()) as u32;
                    if !self.advance(program, cycles) {
                        self.time = start + slot as u32;
                        break Stop::Over;
                    }
                    rest = &steps[self.pc as usize..];
                    continue;
                }
                let waits = slot < slots;
                let next = waits
                    .then(|| wait_for(tables.fetches, step.bank, slot, slots, &mut cycles.fetch))
                    .flatten();
                let Some(next) = next else {
                    self.time = end;
                    break Stop::Unfetched;
                };
                slot = next;
            }
            let mut now = start + slot as u32;
            let ready = self.ready[usize::from(step.read)];
            if ready > now {
                cold_path();
                if !self.is_ready_by(now, ready, end, cycles) {
                    break Stop::Waits;
                }
                now = ready;
                slot = (now - start) as usize % COLUMNS;
            }
            let ready = if let Issue::Plain { pool, latency } = step.issue {
                if !tables.units.take(pool, slot) {
                    cold_path();
                    let Some(next) = wait_for(tables.units, pool, slot, slots, &mut cycles.units) else {
                        self.time = end;
                        break Stop::Waits;
                    };
                    (slot, now) = (next, start + next as u32);
                }
                now + u32::from(latency)
            } else if let Issue::Load { base, offset } = step.issue {
                let address = self.word(base, offset);
                if let Some(ready) = tables.l1.hit(now, slot, address) {
                    ready
                } else {
                    cold_path();
                    let target = Target { thread: number, entries: std::slice::from_ref(&step.write) };
                    let access;
                    (access, slot) = tables.l1.load(start, slot..slots, address, target);
                    slot %= COLUMNS;
                    self.time = start + slot as u32;
                    cycles.memory += u64::from(self.time - now);
                    match access {
                        Access::Served(ready) => ready,
                        Access::Ask(missed) => break Stop::Asks(missed),
                        Access::Refused => break Stop::Waits,
                    }
                }
            } else if let Issue::Pair { pool, latency, second } = step.issue {
                // Apart from plain ones, so that those need not look whether there is a second operand.
                cold_path();
                let ready = self.ready[usize::from(second)];
                if ready > now {
                    if !self.is_ready_by(now, ready, end, cycles) {
                        break Stop::Waits;
                    }
                    now = ready;
                    slot = (now - start) as usize % COLUMNS;
                }
                if !tables.units.take(pool, slot) {
                    cold_path();
                    let Some(next) = wait_for(tables.units, pool, slot, slots, &mut cycles.units) else {
                        self.time = end;
                        break Stop::Waits;
                    };
                    (slot, now) = (next, start + next as u32);
                }
                now + u32::from(latency)
            } else {
                cold_path();
                self.time = now;
                break Stop::Other;
            };
            self.set_ready(step.write, ready);
            slot = (slot + 1) % COLUMNS;
            rest = next;
        };
        if behind != first {
            self.last_issue = start + behind as u32 - 1;
        }
        self.held = !matches!(stop, Stop::Unfetched | Stop::Over);
        self.pc = (steps.len() - rest.len()) as u32;
        stop
    }

    /// Waits from cycle `now` until `ready` for an operand; whether that is known and before cycle `end`.
    #[cold]
    fn is_ready_by(&mut self, now: u32, ready: u32, end: u32, cycles: &mut ThreadCycles) -> bool {
        self.time = now;
        self.waits(ready, cycles) && ready < end
    }

    /// The register of `entry` can be used from cycle `ready` on.
    #[inline(always)]
    pub fn set_ready(&mut self, entry: BoardEntry, ready: u32) {
        self.ready[usize::from(entry)] = ready;
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
    pub fn enter(&mut self, program: &Program, cycles: &mut ThreadCycles) {
        self.count_issued(program, cycles);
        let run = &program.code.runs[self.tape[self.at as usize] as usize];
        self.next = self.at + 1 + run.bases.len() as u32;
        self.first = run.first;
        self.pc = run.first;
    }

    /// Counts what it has issued of its run so far.
    pub fn count_issued(&self, program: &Program, cycles: &mut ThreadCycles) {
        let nops = program.code.nops(self.first, self.pc);
        cycles.issue += u64::from(self.pc - self.first - nops);
        cycles.nop += u64::from(nops);
    }

    /// Goes to the next run; false, and an end, if there is none.
    #[inline(always)]
    pub fn advance(&mut self, program: &Program, cycles: &mut ThreadCycles) -> bool {
        if self.next as usize >= self.tape.len() {
            self.state = State::Ended;
            return false;
        }
        self.at = self.next;
        self.enter(program, cycles);
        true
    }

    /// The word address that stands so far behind one of the event's.
    #[inline(always)]
    fn word(&self, base: u8, offset: u16) -> u32 {
        self.tape[self.at as usize + 1 + usize::from(base)] + u32::from(offset)
    }

    /// The word address that a memory operation accesses next.
    pub fn address(&self, op: &MicroOp) -> u32 {
        self.word(op.base, op.offset) + u32::from(self.part)
    }

    /// Entries of the words that an access at `address` brings: those up to the end of the line.
    #[inline(always)]
    pub fn targets<'p>(
        &self,
        program: &'p Program,
        op: &'p MicroOp,
        address: u32,
        line_words: u32,
    ) -> &'p [BoardEntry] {
        if op.operands == 0 {
            return std::slice::from_ref(&op.write);
        }
        let entries = &program.operands_of(op).writes[usize::from(self.part)..];
        let to_the_end = (line_words - address % line_words) as usize;
        &entries[..entries.len().min(to_the_end)]
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
        let entries = self.targets(program, op, address, line_words);
        for &entry in entries {
            self.set_ready(entry, ready);
        }
        self.part += entries.len() as u8;
        if usize::from(self.part) < program.operands_of(op).writes.len() {
            return false;
        }
        self.part = 0;
        true
    }

    #[cold]
    pub fn write_all(&mut self, program: &Program, op: &MicroOp, ready: u32) {
        self.set_ready(op.write, ready);
        for &entry in &program.operands_of(op).writes {
            self.set_ready(entry, ready);
        }
    }

    /// When the further registers can be used that an operation waits for.
    pub fn more_ready(&self, program: &Program, op: &MicroOp) -> u32 {
        let reads = &program.operands_of(op).reads;
        reads.iter().map(|entry| self.ready[usize::from(*entry)]).max().unwrap_or(0)
    }
}
