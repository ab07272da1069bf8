//! A thread: where it is in its program, and how it issues its operations.

use super::prefetch::prefetch;
use super::request::{Request, What, access, waiter};
use super::slots::Slots;
use super::stats::ThreadCycles;
use crate::program::{BOARD_ENTRIES, BoardEntry, Kind, MicroOp, Program};
use memory::{LONGEST_QUANTUM as LONGEST, Near, Port};
use std::hint::cold_path;

/// When a register can be used whose line has no known time of arrival.
pub const UNKNOWN: u32 = u32::MAX;

/// Where a thread is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// It goes on at its own time.
    Runs,
    /// It waits for data whose time of arrival is not known.
    Parked,
    /// It has asked the chip.
    Asks,
    /// It has come to the end of its tape.
    Ended,
    /// It has finished.
    Halted,
}

/// A thread. What [`Thread::run`] needs most lies together in a line of the host's cache, the scoreboard behind it.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub struct Thread {
    /// The cycle in which it goes on: it is done with all cycles before.
    pub time: u32,
    pub last_issue: u32,
    /// Index of its next operation.
    pc: u32,
    /// Index behind the last operation of its run.
    behind: u32,
    /// Runs with their addresses.
    pub tape: Vec<u32>,
    /// Where in the tape its run stands.
    pub at: u32,
    pub state: State,
    /// Its number in the multiprocessor.
    number: u8,
    /// Its instruction cache.
    icache: u8,
    /// Whether its next operation has been fetched.
    fetched: bool,
    /// Words that a wide load has brought so far, where it reaches into a second line.
    brought: u8,
    /// Cycle from which on each register can be used, by its entry.
    ready: [u32; BOARD_ENTRIES],
}

/// What the threads of a multiprocessor share.
#[derive(Clone, Debug)]
pub struct Shared {
    /// The multiprocessor.
    pub tm: u16,
    /// First cycle of the quantum.
    pub start: u32,
    /// The cycle behind it.
    pub end: u32,
    /// Fetches left by bank, for each instruction cache.
    pub fetches: Vec<Slots>,
    /// Units left by pool.
    pub units: Slots,
    /// What threads ask of the chip.
    pub asked: Vec<Request>,
    /// What threads did.
    pub cycles: ThreadCycles,
}

impl Thread {
    /// Thread `number`, which fetches from the instruction cache `icache`.
    pub fn new(number: u8, icache: u8) -> Self {
        Self {
            time: 0,
            last_issue: 0,
            pc: 0,
            behind: 0,
            tape: vec![],
            at: 0,
            state: State::Runs,
            number,
            icache,
            fetched: false,
            brought: 0,
            ready: [0; BOARD_ENTRIES],
        }
    }

    /// Asks the host for what it looks at first when it has its turn: itself, and the first entries of its scoreboard.
    #[inline(always)]
    pub fn prefetch(&self) {
        prefetch(self, 3);
    }

    /// Asks the host for its next operations and addresses.
    #[inline(always)]
    pub fn prefetch_operations(&self, program: &Program) {
        prefetch(program.code.ops.as_ptr().wrapping_add(self.pc as usize), 2);
        prefetch(self.tape.as_ptr().wrapping_add(self.at as usize), 1);
    }

    /// Issues operations until the quantum is over, or the thread has to wait for the chip or for new work.
    ///
    /// In each cycle the next operation is fetched, finds its operands, takes a unit and is executed. Where one of these is
    /// not to be had, the thread comes back to the operation in a later cycle.
    #[inline(always)]
    pub fn run(&mut self, program: &Program, port: &mut Port, shared: &mut Shared) {
        while self.state == State::Runs && self.time < shared.end {
            let slot = (self.time - shared.start) as usize % LONGEST;
            let op = &program.code.ops[self.pc as usize];

            // What has been fetched is not fetched again.
            if !self.fetched {
                if !shared.fetches[usize::from(self.icache)].take(op.bank, slot) {
                    cold_path();
                    shared.cycles.fetch += 1;
                    self.time += 1;
                    continue;
                }
                self.fetched = true;
            }

            if !self.has_operands(program, op, &mut shared.cycles) {
                continue;
            }

            if !shared.units.take(op.pool, slot) {
                cold_path();
                shared.cycles.units += 1;
                self.time += 1;
                continue;
            }

            let ready = match op.kind {
                Kind::Plain | Kind::Nop => self.time + u32::from(op.latency),
                Kind::Load | Kind::Store => {
                    let address = self.address(op);
                    match port.ask(access(op.kind), self.time, slot, address) {
                        Near::At(ready) => ready,
                        Near::Later => UNKNOWN,
                        Near::Refused => {
                            shared.cycles.memory += 1;
                            self.time += 1;
                            continue;
                        }
                        Near::Beyond => {
                            self.ask(What::Words(access(op.kind), address), shared);
                            continue;
                        }
                    }
                }
                Kind::Counter => {
                    self.ask(What::Item, shared);
                    continue;
                }
            };
            self.retire(program, ready, port, shared);
        }
    }

    /// Whether all operands of `op` are ready: the first, and then the others. If not, the thread waits for them.
    #[inline(always)]
    fn has_operands(&mut self, program: &Program, op: &MicroOp, cycles: &mut ThreadCycles) -> bool {
        let [first, second] = op.reads.map(|entry| self.ready[usize::from(entry)]);
        let mut others = second;
        if op.operands != 0 {
            let further = program.operands_of(op).reads.iter().map(|entry| self.ready[usize::from(*entry)]);
            others = further.fold(second, u32::max);
        }
        self.is_ready(first, cycles) && self.is_ready(others, cycles)
    }

    /// Whether what can be used from cycle `ready` on can be used now. If not, the thread waits for it.
    #[inline(always)]
    fn is_ready(&mut self, ready: u32, cycles: &mut ThreadCycles) -> bool {
        if ready <= self.time {
            return true;
        }
        cold_path();
        if ready == UNKNOWN {
            self.state = State::Parked;
        } else {
            cycles.data += u64::from(ready - self.time);
            self.time = ready;
        }
        false
    }

    /// Asks the chip to serve its operation.
    fn ask(&mut self, what: What, shared: &mut Shared) {
        self.state = State::Asks;
        shared.asked.push(Request { cycle: self.time, tm: shared.tm, thread: self.number, what });
    }

    /// Its operation is issued in this cycle, and what it writes can be used from cycle `ready` on.
    #[inline(always)]
    pub fn retire(&mut self, program: &Program, ready: u32, port: &mut Port, shared: &mut Shared) {
        let op = &program.code.ops[self.pc as usize];
        let now = self.time;
        self.time += 1;
        if op.operands == 0 && ready != UNKNOWN {
            self.set_ready(op.write, ready);
        } else if !self.write(program, op, ready, port) {
            // The rest of what it loads is in the next line.
            shared.cycles.memory += 1;
            return;
        }
        match op.kind {
            Kind::Nop => shared.cycles.nop += 1,
            _ => shared.cycles.issue += 1,
        }
        self.last_issue = now;
        self.fetched = false;
        self.pc += 1;
        if self.pc == self.behind {
            self.end_run(program);
        }
    }

    /// What `op` writes can be used from cycle `ready` on, or when the line arrives that brings it. Returns false if a load has to
    /// bring more from the next line.
    #[inline(never)]
    fn write(&mut self, program: &Program, op: &MicroOp, ready: u32, port: &mut Port) -> bool {
        let writes = match &program.operands_of(op).writes[..] {
            [] => std::slice::from_ref(&op.write),
            several => several,
        };
        let mut entries = &writes[usize::from(self.brought)..];
        if op.kind == Kind::Load {
            let address = self.address(op);
            entries = &entries[..port.within_line(address, entries.len() as u32) as usize];
            if ready == UNKNOWN {
                entries.iter().for_each(|entry| port.wait(address, waiter(self.number, *entry)));
            }
        }
        entries.iter().for_each(|entry| self.set_ready(*entry, ready));
        self.brought += entries.len() as u8;
        let all = usize::from(self.brought) == writes.len();
        if all {
            self.brought = 0;
        }
        all
    }

    /// The register of `entry` can be used from cycle `ready` on.
    #[inline(always)]
    fn set_ready(&mut self, entry: BoardEntry, ready: u32) {
        self.ready[usize::from(entry)] = ready;
    }

    /// The line that brings the register of `entry` arrives in cycle `arrival`. A thread that is parked looks again whether it
    /// can go on.
    pub fn arrives(&mut self, entry: BoardEntry, arrival: u32, cycles: &mut ThreadCycles) {
        self.set_ready(entry, arrival);
        if self.state == State::Parked {
            self.state = State::Runs;
            let until = arrival.max(self.time);
            cycles.data += u64::from(until - self.time);
            self.time = until;
        }
    }

    /// Goes on with the run that its tape is at.
    #[inline(always)]
    pub fn enter(&mut self, program: &Program) {
        let run = &program.code.runs[self.tape[self.at as usize] as usize];
        (self.pc, self.behind) = (run.first, run.first + run.length);
    }

    /// Goes on with the next run of its tape, if there is one.
    #[inline(always)]
    fn end_run(&mut self, program: &Program) {
        let run = &program.code.runs[self.tape[self.at as usize] as usize];
        let next = self.at + 1 + u32::from(run.addresses);
        if next as usize == self.tape.len() {
            self.state = State::Ended;
            return;
        }
        self.at = next;
        self.enter(program);
    }

    /// The word address that its load or store accesses next.
    #[inline(always)]
    fn address(&self, op: &MicroOp) -> u32 {
        self.tape[self.at as usize + 1 + usize::from(op.base)]
            .wrapping_add(u32::from(op.offset) + u32::from(self.brought))
    }
}
