//! What rays have cost, class by class, as result files and tables show it.

use crate::console::{fixed, table};
use golden::traverse::Counters;
use render::{ClassTotals, RayClass};
use serde::{Deserialize, Serialize};

/// [`Counters`] with the keys of result files.
#[derive(Clone, Copy, Serialize, Deserialize)]
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
#[derive(Clone, Serialize, Deserialize)]
pub struct ClassRow {
    pub class: String,
    pub rays: u64,
    pub hits: u64,
    /// Absent if the work was not counted.
    #[serde(flatten)]
    pub counters: Option<CounterRow>,
}

impl ClassRow {
    pub fn new(class: RayClass, totals: &ClassTotals, counted: bool) -> Self {
        Self {
            class: class.to_string(),
            rays: totals.rays,
            hits: totals.hits,
            counters: counted.then(|| totals.counters.into()),
        }
    }
}

/// A table of all classes, with the work per ray if it was counted.
pub fn class_table(classes: &[ClassRow]) -> String {
    let counted: Option<Vec<_>> = classes.iter().map(|c| c.counters.map(|counters| (c, counters))).collect();
    let Some(counted) = counted else {
        let rows = classes.iter().map(|c| [c.class.clone(), c.rays.to_string(), c.hits.to_string()]);
        return table(["class", "rays", "hits"], rows);
    };
    let header = [
        "class",
        "rays",
        "hits",
        "node visits/ray",
        "planes/ray",
        "boxes/ray",
        "triangles/ray",
        "stack depth",
    ];
    let rows = counted.into_iter().map(|(c, counters)| {
        let per_ray = |x: u64| fixed(x as f64 / c.rays.max(1) as f64, 2);
        [
            c.class.clone(),
            c.rays.to_string(),
            c.hits.to_string(),
            per_ray(counters.node_visits),
            per_ray(counters.plane_tests),
            per_ray(counters.box_tests),
            per_ray(counters.triangle_tests),
            counters.stack_depth.to_string(),
        ]
    });
    table(header, rows)
}
