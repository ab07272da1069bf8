//! The table of the work of rays by class.

use crate::console::{fixed, table};
use studies::work::ClassRow;

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
