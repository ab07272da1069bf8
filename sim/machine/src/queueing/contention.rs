//! How long the threads of a multiprocessor wait for fetches and units.

use super::population::{Bursts, train_wait};
use super::profile::Profile;
use crate::core::ThreadCycles;
use crate::description::MachineDescription;
use crate::program::{COUNTER, PIPELINE, POOLS};
use costs::Unit;
use std::sync::Arc;

/// Units of a kind, which threads ask for in bursts.
#[derive(Clone, Debug)]
struct Pool {
    /// Threads that share it.
    population: u32,
    bursts: Arc<Bursts>,
    /// Uses lately.
    uses: f64,
    /// The same, each times the chance of a use in its run.
    chances: f64,
    /// Cycles that a use waits.
    wait: f64,
}

/// Fetches from the banks of an instruction cache, which threads go through in trains.
#[derive(Clone, Debug)]
struct Fetches {
    /// Threads that share the cache.
    population: u32,
    /// Fetches from a bank in a cycle.
    capacity: u32,
    /// Number of banks.
    banks: f64,
    /// Fetches lately.
    fetches: f64,
    /// Cycles that a train waits.
    wait: f64,
}

/// The waits of the machine's multiprocessors, which are taken to be equally busy.
#[derive(Clone, Debug)]
pub struct Contention {
    /// Cycles that each run waits.
    pub waits: Vec<f32>,
    /// How often each run has been executed since the last update.
    pub executed: Vec<u32>,
    fetch: Fetches,
    pools: [Option<Pool>; POOLS],
    /// Cycles of all threads lately.
    thread_cycles: f64,
    /// How often each run has been executed.
    pub runs: Vec<u64>,
    /// Cycles waited for units and fetches.
    pub waited: [f64; 2],
}

/// What threads did lately.
#[derive(Clone, Copy, Debug)]
struct Lately {
    /// Cycles of those that run.
    thread_cycles: f64,
    /// The share of a multiprocessor's threads that run.
    running: f64,
}

/// The part of earlier requests that counts as lately, from update to update.
const MEMORY: f64 = 0.75;

impl Pool {
    /// Finds the wait, after so many more `uses`.
    fn update(&mut self, uses: f64, chances: f64, lately: Lately) {
        self.uses = MEMORY * self.uses + uses;
        self.chances = MEMORY * self.chances + chances;
        if self.uses > 0.0 {
            let free = (lately.thread_cycles - self.uses * self.wait).max(self.uses);
            let population = (lately.running * f64::from(self.population)).ceil() as u32;
            self.wait = self.bursts.wait(population, self.uses / free, self.chances / self.uses);
        }
    }
}

impl Fetches {
    /// Finds the wait, after so many more `fetches`.
    fn update(&mut self, fetches: f64, lately: Lately) {
        self.fetches = MEMORY * self.fetches + fetches;
        let chance = self.fetches / self.banks / lately.thread_cycles;
        let population = (lately.running * f64::from(self.population)).ceil() as u32;
        self.wait = train_wait(population, self.capacity, chance);
    }
}

impl Contention {
    /// No waits yet.
    pub fn new(machine: &MachineDescription, profile: &Profile) -> Self {
        let threads = machine.tm.threads;
        let pool = |pool: usize| {
            let unit = Unit::ALL.into_iter().find(|unit| *unit as usize == pool);
            let count = match unit {
                Some(unit) => machine.units.pool(unit).count,
                None if [PIPELINE, COUNTER].contains(&(pool as u8)) => 1,
                None => return None,
            };
            Some(Pool {
                population: threads,
                bursts: Bursts::new(threads, count),
                uses: 0.0,
                chances: 0.0,
                wait: 0.0,
            })
        };
        let icache = &machine.icache;
        Self {
            waits: vec![0.0; profile.runs.len()],
            executed: vec![0; profile.runs.len()],
            fetch: Fetches {
                population: threads.div_ceil(icache.caches),
                capacity: icache.fetches_per_bank,
                banks: icache.banks.into(),
                fetches: 0.0,
                wait: 0.0,
            },
            pools: std::array::from_fn(pool),
            thread_cycles: 0.0,
            runs: vec![0; profile.runs.len()],
            waited: [0.0; 2],
        }
    }

    /// Finds the waits anew from what has been executed in `thread_cycles` of all threads since the last update. `running` is the share
    /// of a multiprocessor's threads that run.
    pub fn update(&mut self, profile: &Profile, thread_cycles: f64, running: f64) {
        self.thread_cycles = MEMORY * self.thread_cycles + thread_cycles;
        let (mut fetches, mut uses, mut chances) = (0.0, [0.0; POOLS], [0.0; POOLS]);
        for (number, run) in profile.runs.iter().enumerate() {
            let times = f64::from(self.executed[number]);
            self.runs[number] += u64::from(self.executed[number]);
            let waits = self.waits_of(run);
            self.waited.iter_mut().zip(waits).for_each(|(waited, wait)| *waited += times * wait);
            fetches += times * f64::from(run.length);
            for pool in 0..POOLS {
                let uses_of_run = f64::from(run.uses[pool]);
                uses[pool] += times * uses_of_run;
                chances[pool] += times * uses_of_run * uses_of_run / f64::from(run.length);
            }
        }
        self.executed.fill(0);
        let lately = Lately { thread_cycles: self.thread_cycles, running };
        self.fetch.update(fetches, lately);
        for ((pool, uses), chances) in self.pools.iter_mut().zip(uses).zip(chances) {
            pool.iter_mut().for_each(|pool| pool.update(uses, chances, lately));
        }
        for (number, run) in profile.runs.iter().enumerate() {
            self.waits[number] = self.waits_of(run).iter().sum::<f64>() as f32;
        }
    }

    /// Cycles that `run` waits for units and fetches.
    fn waits_of(&self, run: &super::profile::RunProfile) -> [f64; 2] {
        let of = |(pool, uses): (&Option<Pool>, &u32)| {
            f64::from(*uses) * pool.as_ref().map_or(0.0, |pool| pool.wait)
        };
        let units = self.pools.iter().zip(&run.uses).map(of).sum();
        [units, f64::from(run.fetch_trains) * self.fetch.wait]
    }

    /// Enters the cycles waited into `cycles`.
    pub fn enter(&self, cycles: &mut ThreadCycles) {
        let [units, fetch] = self.waited.map(|cycles| cycles.round() as u64);
        (cycles.units, cycles.fetch) = (units, fetch);
    }
}
