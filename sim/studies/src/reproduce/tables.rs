//! The main job's results as CSV.

use super::results::Document;
use serde::Serialize;

#[derive(Serialize)]
struct TreeLine<'a> {
    scene: &'a str,
    triangles: usize,
    structure: &'a str,
    nodes: u64,
    leaves: u64,
    bytes: u64,
    bytes_per_triangle: f64,
    sah_cost: f64,
    expected_node_visits: f64,
    max_depth: u32,
    carve_nodes_per_split: Option<f64>,
}

/// Sizes and costs of all trees.
pub fn trees_csv(document: &Document) -> anyhow::Result<Vec<u8>> {
    let mut csv = csv::Writer::from_writer(vec![]);
    for result in &document.scenes {
        for s in &result.structures {
            csv.serialize(TreeLine {
                scene: &result.scene,
                triangles: result.triangles,
                structure: &s.name,
                nodes: s.nodes,
                leaves: s.leaves,
                bytes: s.bytes,
                bytes_per_triangle: s.bytes_per_triangle,
                sah_cost: s.sah_cost,
                expected_node_visits: s.expected_node_visits,
                max_depth: s.max_depth,
                carve_nodes_per_split: s.carve_nodes_per_split,
            })?;
        }
    }
    Ok(csv.into_inner()?)
}

#[derive(Serialize)]
struct WorkLine<'a> {
    scene: &'a str,
    test: &'a str,
    structure: &'a str,
    mode: &'a str,
    class: &'a str,
    rays: u64,
    hits: u64,
    node_visits: u64,
    plane_tests: u64,
    box_tests: u64,
    triangle_tests: u64,
    bytes: u64,
    stack_depth: u32,
}

/// Traversal work by class of rays.
pub fn work_csv(document: &Document) -> anyhow::Result<Vec<u8>> {
    let mut csv = csv::Writer::from_writer(vec![]);
    for result in &document.scenes {
        for render in &result.renders {
            for (c, counters) in render.classes.iter().filter_map(|c| Some((c, c.counters?))) {
                csv.serialize(WorkLine {
                    scene: &result.scene,
                    test: &render.test,
                    structure: &render.structure,
                    mode: document.mode,
                    class: &c.class,
                    rays: c.rays,
                    hits: c.hits,
                    node_visits: counters.node_visits,
                    plane_tests: counters.plane_tests,
                    box_tests: counters.box_tests,
                    triangle_tests: counters.triangle_tests,
                    bytes: counters.bytes,
                    stack_depth: counters.stack_depth,
                })?;
            }
        }
    }
    Ok(csv.into_inner()?)
}
