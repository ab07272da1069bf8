//! How long threads wait for each other at what they share.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

/// Chances of a request for which a chain is solved.
const CHANCES: usize = 16;
/// Steps by which the chain of one chance comes from the balance of the one before to its own.
const STEPS: usize = 30;

/// Threads that share slots, so many in each cycle, and ask for them in bursts.
///
/// In a burst, a thread that does not wait asks in each cycle with the same chance. Those ask that wait, and each of the others by
/// chance; so many as there are slots are served, and the rest waits for the next cycle. The number of those that wait is a Markov
/// chain, solved for each number of threads in a burst. Bursts are long compared with waits, and threads begin them independently
/// of each other: the number of threads in a burst is that of a closed queue with exponential times, which is slowed down by the waits
/// (Bolch, Greiner, de Meer, Trivedi, "Queueing Networks and Markov Chains", 2nd ed. 2006, section 6.2).
#[derive(Clone, Debug)]
pub struct Bursts {
    /// By threads in a burst and by chance, in equal steps from 0 to 1: how many wait, and how many are served in a cycle.
    balance: Vec<Vec<(f64, f64)>>,
}

impl Bursts {
    /// `population` threads at `capacity` slots. What has been solved is kept, as many machines ask for the same.
    pub fn new(population: u32, capacity: u32) -> Arc<Self> {
        static SOLVED: Mutex<BTreeMap<[u32; 2], Arc<Bursts>>> = Mutex::new(BTreeMap::new());
        let mut solved = SOLVED.lock().expect("solving does not panic");
        let of = |threads| solve(threads as usize, capacity as usize);
        let new = || Arc::new(Self { balance: (0..=population).map(of).collect() });
        Arc::clone(solved.entry([population, capacity]).or_insert_with(new))
    }

    /// The cycles that a request of one of `population` threads waits, if a thread that does not wait asks in a cycle with the chance
    /// `chance`, and with the chance `in_burst` while it is in a burst.
    pub fn wait(&self, population: u32, chance: f64, in_burst: f64) -> f64 {
        let in_burst = in_burst.clamp(1e-3, 1.0);
        let place = in_burst * CHANCES as f64;
        let below = (place as usize).min(CHANCES - 1);
        let part = place - below as f64;
        let at = |threads: usize| {
            let (a, b) = (self.balance[threads][below], self.balance[threads][below + 1]);
            (a.0 + part * (b.0 - a.0), a.1 + part * (b.1 - a.1))
        };
        let share = (chance / in_burst).min(0.999);
        let rate = share / (1.0 - share) * in_burst;
        let population = population as usize;
        let (mut weight, mut waiting, mut served) = (1.0, 0.0, 0.0);
        for threads in 1..=population {
            let (waits, serves) = at(threads);
            weight *= (population - threads + 1) as f64 * rate / serves;
            waiting += weight * waits;
            served += weight * serves;
        }
        if served > 0.0 { waiting / served } else { 0.0 }
    }
}

/// How many of `threads` wait on the average, and how many are served in a cycle, by the chance with which one asks that does not wait.
fn solve(threads: usize, capacity: usize) -> Vec<(f64, f64)> {
    let mut balance = vec![0.0; threads + 1];
    balance[0] = 1.0;
    let of = |chance: usize| {
        let chance = chance as f64 / CHANCES as f64;
        if threads <= capacity {
            return (0.0, threads as f64 * chance);
        }
        let asks: Vec<Vec<f64>> = (0..=threads).map(|others| binomial(others, chance)).collect();
        let mut served = 0.0;
        for _ in 0..STEPS {
            let mut next = vec![0.0; threads + 1];
            served = 0.0;
            for (waiting, share) in balance.iter().enumerate().filter(|(_, share)| **share > 1e-12) {
                for (asking, chance) in asks[threads - waiting].iter().enumerate() {
                    let all = waiting + asking;
                    next[all.saturating_sub(capacity)] += share * chance;
                    served += share * chance * all.min(capacity) as f64;
                }
            }
            balance = next;
        }
        let waiting = balance.iter().enumerate().map(|(waiting, share)| waiting as f64 * share).sum();
        (waiting, served)
    };
    (0..=CHANCES).map(of).collect()
}

/// The chances that 0 to `n` of `n` ask, if each does with `chance`.
fn binomial(n: usize, chance: f64) -> Vec<f64> {
    let mut chances = vec![0.0; n + 1];
    chances[0] = 1.0;
    for count in 0..n {
        for asking in (0..=count).rev() {
            chances[asking + 1] += chances[asking] * chance;
            chances[asking] *= 1.0 - chance;
        }
    }
    chances
}

/// The least chance of a free track. Where all are full, a train would wait for ever; this formula is not made for such a machine.
const LEAST_FREE: f64 = 0.02;

/// The cycles that a train waits for a track. Threads ask for the banks of a memory one after another, a cycle each; then they are
/// never in each other's way again, once each has found a bank at which fewer than `capacity` of the others are. A thread is at
/// a given bank with `chance`, and a train that finds its bank full tries the one before in the next cycle.
pub fn train_wait(population: u32, capacity: u32, chance: f64) -> f64 {
    let chances = binomial(population.saturating_sub(1) as usize, chance.min(1.0));
    let free: f64 = chances.iter().take(capacity as usize).sum();
    (1.0 - free) / free.max(LEAST_FREE)
}
