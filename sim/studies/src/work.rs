//! The work of rays by class, as result files show it.

use golden::traverse::Counters;
use render::{ClassTotals, RayClass};
use serde::{Deserialize, Serialize};

/// [`Counters`] with the keys of result files.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[allow(missing_docs, reason = "they are those of the counters")]
pub struct CounterRow {
    pub node_visits: u64,
    pub plane_tests: u64,
    pub box_tests: u64,
    pub triangle_tests: u64,
    pub bytes: u64,
    pub stack_depth: u32,
}

impl From<Counters> for CounterRow {
    fn from(c: Counters) -> Self {
        Self {
            node_visits: c.node_visits,
            plane_tests: c.plane_tests,
            box_tests: c.box_tests,
            triangle_tests: c.triangle_tests,
            bytes: c.bytes,
            stack_depth: c.stack_depth,
        }
    }
}

/// The rays of one class.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ClassRow {
    /// The name of the class.
    pub class: String,
    /// Number of rays.
    pub rays: u64,
    /// Number of rays that hit something.
    pub hits: u64,
    /// The work of the rays; absent if it was not counted.
    #[serde(flatten)]
    pub counters: Option<CounterRow>,
}

impl ClassRow {
    /// The row of `class`, with its work if `counted`.
    pub fn new(class: RayClass, totals: &ClassTotals, counted: bool) -> Self {
        Self {
            class: class.to_string(),
            rays: totals.rays,
            hits: totals.hits,
            counters: counted.then(|| totals.counters.into()),
        }
    }
}
