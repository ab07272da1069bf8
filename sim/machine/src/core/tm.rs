//! A thread multiprocessor: its threads issue in order, at most one instruction a cycle each.
//!
//! Within a quantum, threads run one after another, in ring order from the one that has waited
//! longest, and take fetches, units and cache banks from tables with an entry for each cycle. A thread is never affected
//! by one behind it in this order, so the outcome is that of going cycle by cycle with the order fixed for the
//! quantum, as the slow model in the tests does; but running on with one thread is several times as fast.
//!
//! A thread that asks the chip stands still until the chip has served it, then lives through the rest of the quantum.

use super::request::{Request, waiting};
use super::slots::{self, Slots};
use super::stats::ThreadCycles;
use super::thread::{Shared, State, Thread};
use crate::description::MachineDescription;
use crate::program::{COUNTER, PIPELINE, POOLS, Program, UNLIMITED};
use costs::Unit;
use memory::Port;

/// A multiprocessor.
#[derive(Clone, Debug)]
pub struct Tm {
    /// The threads.
    pub threads: Vec<Thread>,
    /// What they share.
    pub shared: Shared,
    /// Fetches of each bank in a cycle.
    fetches: Vec<u8>,
    /// Units of each pool.
    units: [u8; POOLS],
    /// Requests that the chip has not served yet, and tries again in the next cycle.
    pub waiting: Vec<Request>,
    /// Threads that have come to the end of their tape.
    pub ended: Vec<u8>,
    /// Threads that the chip has answered in this quantum.
    answered: Vec<u8>,
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
        let icache = &machine.icache;
        let fetches = vec![icache.fetches_per_bank as u8; icache.banks as usize];
        let threads =
            (0..machine.tm.threads).map(|number| Thread::new(number as u8, (number % icache.caches) as u8));
        Self {
            threads: threads.collect(),
            shared: Shared {
                tm: number,
                start: 0,
                end: 0,
                fetches: vec![Slots::new(&fetches); icache.caches as usize],
                units: Slots::new(&units),
                asked: vec![],
                cycles: ThreadCycles::default(),
            },
            fetches,
            units,
            waiting: vec![],
            ended: vec![],
            answered: vec![],
        }
    }

    /// Whether all threads have finished.
    pub fn is_halted(&self) -> bool {
        self.threads.iter().all(|thread| thread.state == State::Halted)
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

    /// What waits under `number` can be used from cycle `arrival` on.
    pub fn arrives(&mut self, number: u16, arrival: u32) {
        let (thread, entry) = waiting(number);
        self.threads[usize::from(thread)].arrives(entry, arrival, &mut self.shared.cycles);
    }

    /// Runs all threads through the quantum from cycle `start` up to `end`.
    pub fn quantum(&mut self, program: &Program, port: &mut Port, start: u32, end: u32) {
        let running = self.threads.iter().enumerate().filter(|(_, thread)| thread.state != State::Halted);
        // Of several, the first.
        let Some((first, _)) = running.min_by_key(|(_, thread)| thread.last_issue) else {
            return;
        };
        (self.shared.start, self.shared.end) = (start, end);
        self.shared.fetches.iter_mut().for_each(|cache| cache.reset(&self.fetches));
        self.shared.units.reset(&self.units);
        for number in (first..self.threads.len()).chain(0..first) {
            if let Some(later) = self.threads.get(number + 2) {
                later.prefetch();
            }
            if let Some(next) = self.threads.get(number + 1) {
                next.prefetch_operations(program);
            }
            self.run(program, port, number);
        }
    }

    /// Lets the threads that the chip has answered live through the rest of the quantum.
    pub fn catch_up(&mut self, program: &Program, port: &mut Port) {
        let mut answered = std::mem::take(&mut self.answered);
        for thread in answered.drain(..) {
            self.run(program, port, thread.into());
        }
        self.answered = answered;
    }

    /// Runs a thread until the end of the quantum, or until it has to wait for the chip or for new work.
    pub fn run(&mut self, program: &Program, port: &mut Port, number: usize) {
        let thread = &mut self.threads[number];
        thread.run(program, port, &mut self.shared);
        if thread.state == State::Ended {
            self.ended.push(number as u8);
        }
    }

    /// The chip has served a request: the thread's result can be used from cycle `ready` on.
    pub fn served(&mut self, program: &Program, port: &mut Port, request: Request, ready: u32) {
        let thread = &mut self.threads[usize::from(request.thread)];
        thread.state = State::Runs;
        thread.time = request.cycle;
        thread.retire(program, ready, port, &mut self.shared);
        self.answered.push(request.thread);
        if thread.state == State::Ended {
            self.ended.push(request.thread);
        }
    }

    /// The quantum is over: threads whose requests still wait try again in the next one.
    pub fn give_up(&mut self) {
        for request in self.waiting.drain(..) {
            let thread = &mut self.threads[usize::from(request.thread)];
            thread.state = State::Runs;
            thread.time = self.shared.end;
        }
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
    }

    /// Threads that have not finished.
    pub fn running(&self) -> u32 {
        self.threads.iter().filter(|thread| thread.state != State::Halted).count() as u32
    }

    /// The cycle in which the last thread to finish issued its last instruction.
    pub fn last_issue(&self) -> u32 {
        self.threads.iter().map(|thread| thread.last_issue).max().unwrap_or(0)
    }

    /// Counts the cycles from its last instruction to cycle `end` of every thread.
    pub fn finish(&mut self, end: u32) {
        self.shared.cycles.halted =
            self.threads.iter().map(|thread| u64::from(end - thread.last_issue - 1)).sum();
    }
}
