//! What a run counted, by kind: with the machine and its prices, all that its results follow from.

use crate::core::{CacheCounts, Counts, DramCounts, ThreadCycles};
use crate::costs::REGISTER_ACCESSES;
use crate::program::{Place, Program};
use costs::Unit;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Instructions executed, by where they executed.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Instructions {
    /// All of them, nops included.
    pub total: u64,
    /// By shared unit.
    pub units: BTreeMap<Unit, u64>,
    /// Operations of the pipeline.
    pub pipeline: u64,
    /// Accesses of local stores.
    pub local_store: u64,
    /// Loads from global memory.
    pub loads: u64,
    /// Stores to global memory.
    pub stores: u64,
    /// Nops in unfilled delay slots.
    pub nops: u64,
}

impl Instructions {
    /// Counts what `program` executed.
    #[must_use]
    pub fn new(program: &Program, counts: &Counts) -> Self {
        let mut sum = Self::default();
        for (id, &times) in counts.runs.iter().enumerate() {
            for &place in program.places_of(id as u32) {
                sum.total += times;
                match place {
                    Place::Unit(unit) => *sum.units.entry(unit).or_default() += times,
                    Place::Pipeline => sum.pipeline += times,
                    Place::LocalStore => sum.local_store += times,
                    Place::Load => sum.loads += times,
                    Place::Store => sum.stores += times,
                    Place::Nop => sum.nops += times,
                    Place::Registers | Place::Counter => {}
                }
            }
        }
        sum
    }
}

/// What a run counted, by kind. It holds no price, so that a run that is kept can be priced anew.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tally {
    /// Cycles until the last thread finished.
    pub cycles: u32,
    /// Thread-cycles in each class.
    pub thread_cycles: ThreadCycles,
    /// Instructions by where they executed. Each is an access of an instruction cache.
    pub instructions: Instructions,
    /// Accesses of register files.
    pub register_accesses: u64,
    /// Accesses of all first-level caches.
    pub l1: CacheCounts,
    /// Accesses of all second-level caches.
    pub l2: CacheCounts,
    /// Commands of the memory.
    pub dram: DramCounts,
}

impl Tally {
    /// What a run of `program` counted.
    #[must_use]
    pub fn new(program: &Program, counts: &Counts) -> Self {
        let instructions = Instructions::new(program, counts);
        Self {
            cycles: counts.cycles,
            thread_cycles: counts.thread_cycles,
            register_accesses: instructions.total * REGISTER_ACCESSES,
            instructions,
            l1: counts.l1,
            l2: counts.l2,
            dram: counts.dram,
        }
    }
}
