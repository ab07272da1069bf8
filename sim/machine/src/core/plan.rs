//! Which items of the work are timed.

use super::Counts;
use super::stats::ThreadCycles;
use crate::program::{Kind, Program};
use memory::{CacheCounts, DramCounts};
use std::ops::Range;

/// Items that are not timed, and items before which counts are noted. By default everything is timed.
///
/// Items that are not timed are recorded all the same, so the runs of all items are counted. The last of them warm the caches:
/// the lines that they read are put into the caches in no time, item by item into the next multiprocessor's (functional warming,
/// as in Wunderlich, Wenisch, Falsafi, Hoe, "SMARTS", ISCA 2003).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plan {
    /// Ranges of items that are not timed, in order, without overlap.
    pub skipped: Vec<Range<u32>>,
    /// How many items at the end of each skipped range warm the caches.
    pub warming: u32,
    /// Items in order. Counts are noted when the counter reaches or passes each of these.
    pub marks: Vec<u32>,
}

/// What has been counted by the time that the counter has come to a mark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Noted {
    /// Cycles from the start.
    pub cycles: u32,
    /// What threads did.
    pub thread_cycles: ThreadCycles,
    /// All first-level caches.
    pub l1: CacheCounts,
    /// All second-level caches.
    pub l2: CacheCounts,
    /// The memory.
    pub dram: DramCounts,
}

impl Noted {
    /// What has been counted by the end.
    #[must_use]
    pub fn of(counts: &Counts) -> Self {
        let Counts { cycles, thread_cycles, l1, l2, dram, .. } = *counts;
        Self { cycles, thread_cycles, l1, l2, dram }
    }
}

/// Calls `touch` with each word that the runs and addresses in `words` load.
pub fn loads(program: &Program, words: &[u32], mut touch: impl FnMut(u32)) {
    accesses(program, words, |kind, word| {
        if kind == Kind::Load {
            touch(word);
        }
    });
}

/// Calls `touch` with each load and store of the runs and addresses in `words`, and its word.
pub fn accesses(program: &Program, words: &[u32], mut touch: impl FnMut(Kind, u32)) {
    let mut at = 0;
    while at < words.len() {
        for op in program.ops_of(words[at]) {
            if matches!(op.kind, Kind::Load | Kind::Store) {
                let first = words[at + 1 + usize::from(op.base)].wrapping_add(u32::from(op.offset));
                let count = program.operands_of(op).writes.len().max(1) as u32;
                touch(op.kind, first);
                if count > 1 {
                    touch(op.kind, first + count - 1);
                }
            }
        }
        at += 1 + usize::from(program.code.runs[words[at] as usize].addresses);
    }
}
