//! The counts of a part of a simulation, as numbers that can be scaled and added.

use machine::core::{CacheCounts, Counts, DramCounts, Noted, ThreadCycles};

/// All counts of a part of a simulation, or estimates of them, as real numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Window(pub(super) [f64; Self::FIELDS]);

impl Window {
    const CACHE_FIELDS: usize = 6;
    pub(super) const FIELDS: usize = 1 + 7 + 2 * Self::CACHE_FIELDS + 9;

    pub(super) fn new(noted: &Noted) -> Self {
        let ThreadCycles { issue, data, units, memory, fetch, nop, halted } = noted.thread_cycles;
        let d = &noted.dram;
        let cache = |c: &CacheCounts| -> [u64; Self::CACHE_FIELDS] {
            [c.loads, c.hits, c.joined, c.stores, c.bank_conflicts, c.register_conflicts]
        };
        let all = [u64::from(noted.cycles), issue, data, units, memory, fetch, nop, halted]
            .into_iter()
            .chain(cache(&noted.l1))
            .chain(cache(&noted.l2))
            .chain([d.reads, d.writes, d.merged_reads, d.merged_writes, d.activates])
            .chain([d.refreshes, d.read_latency_clocks, d.active_clocks, d.refused]);
        let mut fields = [0.0; Self::FIELDS];
        fields.iter_mut().zip(all).for_each(|(field, value)| *field = value as f64);
        Self(fields)
    }

    pub(super) fn between(start: &Noted, end: &Noted) -> Self {
        Self::new(end).minus(&Self::new(start))
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] - other.0[i]))
    }

    pub(super) fn cycles(&self) -> f64 {
        self.0[0]
    }

    /// Instructions issued, nops included.
    pub(super) fn instructions(&self) -> f64 {
        self.0[1] + self.0[6]
    }

    /// The rounded counts, without runs.
    pub(super) fn counts(&self) -> Counts {
        let n: [u64; Self::FIELDS] = self.0.map(|field| field.round().max(0.0) as u64);
        let [cycles, issue, data, units, memory, fetch, nop, halted, rest @ ..] = n;
        let cache = |at: usize| CacheCounts {
            loads: rest[at],
            hits: rest[at + 1],
            joined: rest[at + 2],
            stores: rest[at + 3],
            bank_conflicts: rest[at + 4],
            register_conflicts: rest[at + 5],
        };
        let d = &rest[2 * Self::CACHE_FIELDS..];
        Counts {
            cycles: u32::try_from(cycles).unwrap_or(u32::MAX),
            thread_cycles: ThreadCycles { issue, data, units, memory, fetch, nop, halted },
            runs: vec![],
            l1: cache(0),
            l2: cache(Self::CACHE_FIELDS),
            dram: DramCounts {
                reads: d[0],
                writes: d[1],
                merged_reads: d[2],
                merged_writes: d[3],
                activates: d[4],
                refreshes: d[5],
                read_latency_clocks: d[6],
                active_clocks: d[7],
                refused: d[8],
            },
        }
    }
}
