//! A machine that goes through its windows.

use super::behind::{Behind, Cache};
use super::contention::Contention;
use super::items::{Items, Words};
use super::profile::Profile;
use super::thread::{Machine, Place, Thread};
use crate::core::{Counts, MAX_CYCLES, SimulationError, ThreadCycles, Work};
use crate::description::MachineDescription;
use crate::execute::Fault;
use crate::program::Program;

/// Cycles of a window.
const WINDOW: u32 = 32;
/// Cycles from one update of the waits to the next.
const UPDATE: u32 = 512;

/// A multiprocessor.
#[derive(Clone, Debug)]
struct Seat {
    threads: Vec<Thread>,
    l1: Cache,
}

/// A machine in the middle of a frame.
pub struct Model<'a> {
    machine: Machine<'a>,
    seats: Vec<Seat>,
    /// Multiprocessors of a partition.
    per_partition: usize,
    /// First cycle of the window.
    start: u32,
    /// The cycle in which the waits were updated.
    updated: u32,
    /// Cycles of threads since then.
    thread_cycles: f64,
    /// The first item that no thread has taken.
    pub next_item: u32,
}

impl<'a> Model<'a> {
    /// `machine` before its first window.
    pub fn new<W: Work>(machine: &MachineDescription, program: &'a Program, items: &Items<'_, W>) -> Self {
        let threads = vec![Thread::new(&items.ends[0]); machine.tm.threads as usize];
        let l1 = Cache::new(&machine.l1);
        let seat = Seat { threads, l1: if machine.l1.enabled { l1 } else { l1.without_banks() } };
        let profile = Profile::new(program);
        let contention = Contention::new(machine, &profile);
        Self {
            machine: Machine { program, profile, contention, behind: Behind::new(machine) },
            seats: vec![seat; machine.chip.tms() as usize],
            per_partition: machine.chip.tms_per_partition as usize,
            start: 0,
            updated: 0,
            thread_cycles: 0.0,
            next_item: 0,
        }
    }

    /// Gives threads their first items, to one of each multiprocessor in turn: each has a counter's answer a cycle. Returns false if an
    /// item has not been executed.
    fn begin<W: Work>(&mut self, items: &Items<'_, W>) -> Result<bool, SimulationError> {
        for thread in 0..self.seats[0].threads.len() {
            for (number, seat) in self.seats.iter_mut().enumerate() {
                let thread = &mut seat.threads[thread];
                if thread.place != Place::Start {
                    continue;
                }
                thread.run(&mut self.machine, &mut seat.l1, number / self.per_partition, f64::INFINITY);
                if !next(thread, &mut self.next_item, items)? {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// Goes on until all threads have halted, or one needs an item that has not been executed: then it returns false.
    pub fn advance<W: Work>(&mut self, items: &Items<'_, W>) -> Result<bool, SimulationError> {
        if self.start == 0 && !self.begin(items)? {
            return Ok(false);
        }
        loop {
            let end = f64::from(self.start + WINDOW);
            for (number, seat) in self.seats.iter_mut().enumerate() {
                let l2 = number / self.per_partition;
                for thread in &mut seat.threads {
                    while thread.place != Place::Halted
                        && thread.run(&mut self.machine, &mut seat.l1, l2, end)
                    {
                        if !next(thread, &mut self.next_item, items)? {
                            return Ok(false);
                        }
                    }
                }
            }
            if self.end_window() {
                return Ok(true);
            }
            if self.start > MAX_CYCLES {
                return Err(SimulationError::TooLong);
            }
        }
    }

    /// Goes on to the next window in which something happens. Returns whether there is none.
    fn end_window(&mut self) -> bool {
        let is_running = |thread: &&Thread| thread.place != Place::Halted;
        let (mut all, mut squares, mut first) = (0.0, 0.0, f64::INFINITY);
        for seat in &self.seats {
            let running = seat.threads.iter().filter(is_running).count() as f64;
            all += running;
            squares += running * running;
            first = seat.threads.iter().filter(is_running).map(|thread| thread.time).fold(first, f64::min);
        }
        let behind = if all > 0.0 { first as u32 / WINDOW * WINDOW } else { 0 };
        let next = behind.max(self.start + WINDOW);
        self.thread_cycles += all * f64::from(next - self.start);
        if next - self.updated >= UPDATE || all == 0.0 {
            // The multiprocessor of an average thread.
            let share = if all > 0.0 { squares / all / self.seats[0].threads.len() as f64 } else { 0.0 };
            self.machine.contention.update(&self.machine.profile, self.thread_cycles, share);
            (self.updated, self.thread_cycles) = (next, 0.0);
        }
        self.start = next;
        self.machine.behind.advance(next);
        self.seats.iter_mut().for_each(|seat| seat.l1.advance(next));
        all == 0.0
    }

    /// What has been counted by the end.
    pub fn counts(self) -> Counts {
        let Self { machine: Machine { profile, contention, mut behind, .. }, seats, .. } = self;
        let times: Vec<f64> = seats.iter().flat_map(|seat| &seat.threads).map(|thread| thread.time).collect();
        let cycles = times.iter().copied().fold(0.0, f64::max).ceil() as u32;
        let conflicts = |cache: &memory::CacheCounts| cache.bank_conflicts + cache.register_conflicts;
        let refused = conflicts(&behind.l1) + conflicts(&behind.l2);
        let mut spent = ThreadCycles { memory: refused, ..ThreadCycles::default() };
        for (run, times) in profile.runs.iter().zip(&contention.runs) {
            spent.issue += times * u64::from(run.length - run.nops);
            spent.nop += times * u64::from(run.nops);
        }
        contention.enter(&mut spent);
        spent.halted = times.iter().map(|time| (f64::from(cycles) - time) as u64).sum();
        // Whatever else they did, threads waited for operands.
        spent.data = (u64::from(cycles) * times.len() as u64).saturating_sub(spent.total());
        Counts {
            cycles,
            thread_cycles: spent,
            runs: contention.runs,
            l1: behind.l1,
            l2: behind.l2,
            dram: behind.dram.counts_at(cycles),
        }
    }
}

/// Gives `thread` its next tape, or halts it. Returns false if the item has not been executed.
fn next<W: Work>(thread: &mut Thread, next_item: &mut u32, items: &Items<'_, W>) -> Result<bool, Box<Fault>> {
    if thread.place == Place::End {
        thread.place = Place::Halted;
    } else if *next_item == items.all() {
        let end = if thread.place == Place::Start { &items.ends[1] } else { &items.ends[2] };
        thread.resume(Place::End, Words::clone(end));
    } else if *next_item < items.end() {
        thread.resume(Place::Item, items.get(*next_item, thread.place == Place::Start)?);
        *next_item += 1;
    } else {
        return Ok(false);
    }
    Ok(true)
}
