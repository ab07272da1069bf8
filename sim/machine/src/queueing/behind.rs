//! What lies behind the first-level caches: the caches of the partitions, and the DRAM.

use super::caches::Tags;
use super::calendar::Calendar;
use super::dram::Dram;
use crate::description::{BankBy, Cache as Description, MachineDescription};
use memory::CacheCounts;

/// A cache: its lines, and when its banks are taken.
#[derive(Clone, Debug)]
pub struct Cache {
    tags: Tags,
    /// The ports of each bank; none of a cache that is disabled and first.
    banks: Vec<Vec<Calendar>>,
    /// Bits of a word's address below those that choose its bank.
    bank_shift: u32,
}

impl Cache {
    /// An empty cache.
    pub fn new(cache: &Description) -> Self {
        let line_shift = cache.line_words().trailing_zeros();
        Self {
            tags: Tags::new(cache),
            banks: vec![vec![Calendar::default(); cache.ports as usize]; cache.banks as usize],
            bank_shift: if cache.bank_by == BankBy::Line { line_shift } else { 0 },
        }
    }

    /// The same cache without banks, so that nobody waits for one.
    pub fn without_banks(self) -> Self {
        Self { banks: vec![], ..self }
    }

    /// No request comes before cycle `start` any more.
    pub fn advance(&mut self, start: u32) {
        self.banks.iter_mut().flatten().for_each(|port| port.advance(start.into()));
    }

    /// The cycle in which the bank of `word` serves a request of cycle `now`.
    #[inline(always)]
    fn serve(&mut self, now: u32, word: u32) -> u32 {
        if self.banks.is_empty() {
            return now;
        }
        let bank = (word >> self.bank_shift) as usize % self.banks.len();
        match &mut self.banks[bank][..] {
            [port] => port.take(now.into()) as u32,
            ports => {
                let port = ports.iter_mut().min_by_key(|port| port.free(now.into()));
                port.expect("a bank has a port").take(now.into()) as u32
            }
        }
    }
}

/// All second-level caches and the DRAM, with what is counted of these and of the first-level caches.
#[derive(Clone, Debug)]
pub struct Behind {
    l2s: Vec<Cache>,
    pub dram: Dram,
    line_shift: u32,
    /// Cycles from a hit in a first-level cache until the word can be used.
    l1_cycles: u32,
    /// The same of a second-level cache.
    l2_cycles: u32,
    /// Cycles from a first-level cache to the second level and back.
    network_cycles: u32,
    pub l1: CacheCounts,
    pub l2: CacheCounts,
}

impl Behind {
    /// Those of `machine`, idle and empty.
    pub fn new(machine: &MachineDescription) -> Self {
        let line_shift = machine.l2.line_words().trailing_zeros();
        let l1_cycles = if machine.l1.enabled { machine.l1.latency_cycles } else { 0 };
        Self {
            l2s: vec![Cache::new(&machine.l2); machine.chip.l2_partitions as usize],
            dram: Dram::new(&machine.dram),
            line_shift,
            l1_cycles,
            l2_cycles: machine.l2.latency_cycles + l1_cycles,
            network_cycles: 2 * machine.network.latency_cycles,
            l1: CacheCounts::default(),
            l2: CacheCounts::default(),
        }
    }

    /// No request comes before cycle `start` any more.
    pub fn advance(&mut self, start: u32) {
        self.l2s.iter_mut().for_each(|l2| l2.advance(start));
        self.dram.advance(start);
    }

    /// A load of `words` words from `word` on in cycle `now`, by a thread of cache `l1` in partition `l2`: the cycles for which the
    /// load itself is held up, and the cycle from which on its words are there if they were not.
    #[inline(always)]
    pub fn load(&mut self, l1: &mut Cache, l2: usize, now: u32, word: u32, words: u8) -> (u32, Option<u32>) {
        let (delay, first) = self.load_line(l1, l2, now, word);
        let last = word.wrapping_add(u32::from(words) - 1);
        if last >> self.line_shift == word >> self.line_shift {
            return (delay, first);
        }
        let (more, second) = self.load_line(l1, l2, now + delay + 1, last);
        (delay + 1 + more, first.max(second))
    }

    #[inline(always)]
    fn load_line(&mut self, l1: &mut Cache, l2: usize, now: u32, word: u32) -> (u32, Option<u32>) {
        let line = word >> self.line_shift;
        let served = l1.serve(now, word);
        self.l1.bank_conflicts += u64::from(served - now);
        self.l1.loads += 1;
        match l1.tags.find(line, served) {
            Some(from) if from <= served => {
                self.l1.hits += 1;
                (served - now, None)
            }
            Some(from) => {
                self.l1.joined += 1;
                (served - now, Some(from + self.l1_cycles))
            }
            None => {
                let (delay, arrives) = self.fetch(l1, l2, served, word);
                (served - now + delay, Some(arrives))
            }
        }
    }

    /// The line of `word` comes from behind `l1`: cycles for which the load is held up, and the cycle in which the line arrives.
    fn fetch(&mut self, l1: &mut Cache, l2: usize, now: u32, word: u32) -> (u32, u32) {
        let line = word >> self.line_shift;
        let free = l1.tags.free(now);
        self.l1.register_conflicts += u64::from(free - now);
        let l2 = &mut self.l2s[l2];
        let mut served = l2.serve(free, word);
        self.l2.bank_conflicts += u64::from(served - free);
        self.l2.loads += 1;
        let arrives = match l2.tags.find(line, served) {
            Some(from) if from <= served => {
                self.l2.hits += 1;
                served + self.l2_cycles
            }
            Some(from) => {
                self.dram.counts.merged_reads += 1;
                from
            }
            None => {
                let free = l2.tags.free(served);
                self.l2.register_conflicts += u64::from(free - served);
                served = free;
                let arrives = self.dram.read(served, line);
                l2.tags.fill(line, arrives);
                arrives
            }
        };
        let arrives = arrives + self.network_cycles;
        l1.tags.fill(line, arrives);
        (served - now, arrives)
    }

    /// A store to `word` in cycle `now`, past cache `l1`: cycles for which it is held up.
    pub fn store(&mut self, l1: &mut Cache, l2: usize, now: u32, word: u32) -> u32 {
        let passed = l1.serve(now, word);
        let served = self.l2s[l2].serve(passed, word);
        self.l1.bank_conflicts += u64::from(passed - now);
        self.l2.bank_conflicts += u64::from(served - passed);
        self.l1.stores += 1;
        self.l2.stores += 1;
        self.dram.write(served, word >> self.line_shift);
        served - now
    }
}
