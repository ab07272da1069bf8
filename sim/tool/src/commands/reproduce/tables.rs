//! The main job's results as CSV and as text.

use super::results::Document;
use crate::console::{fixed, table};
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
    build_ms: f64,
    convert_ms: f64,
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
                build_ms: s.build_ms,
                convert_ms: s.convert_ms,
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

/// Both as tables.
pub fn text(document: &Document) -> String {
    let d = document;
    let mut text = format!("Trees: {} quality, seed {}\n\n", d.quality, d.seed);
    let header =
        ["scene", "triangles", "structure", "nodes", "bytes/triangle", "of bvh2", "SAH", "expected visits"];
    let rows = d.scenes.iter().flat_map(|result| {
        let reference = result.structures[0].bytes.max(1) as f64;
        result.structures.iter().map(move |s| {
            [
                result.scene.clone(),
                result.triangles.to_string(),
                s.name.to_string(),
                s.nodes.to_string(),
                fixed(s.bytes_per_triangle, 2),
                fixed(s.bytes as f64 / reference, 3),
                fixed(s.sah_cost, 2),
                fixed(s.expected_node_visits, 2),
            ]
        })
    });
    text += &table(header, rows);
    text += &format!(
        "\nTraversal work per ray: {}x{}, {} sample(s) per pixel, {} mode; all structures gave the same pictures\n\n",
        d.width, d.height, d.spp, d.mode
    );
    let header = [
        "scene",
        "test",
        "structure",
        "rays",
        "node visits",
        "plane tests",
        "triangle tests",
        "bytes",
        "stack depth",
    ];
    let rows = d.scenes.iter().flat_map(|result| {
        result.renders.iter().map(|r| {
            [
                result.scene.clone(),
                r.test.to_string(),
                r.structure.to_string(),
                r.rays.to_string(),
                fixed(r.node_visits_per_ray, 2),
                fixed(r.plane_tests_per_ray, 2),
                fixed(r.triangle_tests_per_ray, 2),
                fixed(r.bytes_per_ray, 1),
                r.stack_depth.to_string(),
            ]
        })
    });
    text += &table(header, rows);
    text
}
