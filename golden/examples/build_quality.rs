//! Compares the builder with `obvhs` on the real scenes: SAH cost and time, at equal maximum leaf size.
//!
//! `DUALSPLIT_DATA=... cargo run --release --example build_quality [-- SCENE...]`; both libraries run on one thread
//! unless `RAYON_NUM_THREADS` says otherwise.

#[path = "../tests/support/mod.rs"]
mod support;

use std::time::Instant;

use golden::build::{BuildOptions, Quality, build};
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::triangle::Triangle;
use scenes::Mesh;

fn main() {
    let chosen: Vec<String> = std::env::args().skip(1).collect();
    println!("| scene | leaf | builder | SAH | ratio | depth | nodes/tri | ms |");
    println!("|---|---|---|---|---|---|---|---|");
    for name in support::SHARED_SCENES {
        if !chosen.is_empty() && !chosen.iter().any(|c| c == name) {
            continue;
        }
        let Some(mesh) = support::shared_scene(name) else {
            return eprintln!("set DUALSPLIT_DATA to the folder that holds scenes/");
        };
        for leaf in [1, 4, 8] {
            compare(name, &mesh, leaf);
        }
    }
}

fn compare(name: &str, mesh: &Mesh, leaf: u32) {
    let triangles: Vec<Triangle> = (0..mesh.triangles.len())
        .map(|i| {
            let [v0, v1, v2] = mesh.corners(i).map(Into::into);
            Triangle { v0, v1, v2 }
        })
        .collect();
    let peer =
        |params: BvhBuildParams| BvhBuildParams { pre_split: false, max_prims_per_leaf: leaf, ..params };
    let very_slow = peer(BvhBuildParams::very_slow_build());
    // The preset's collapse assumes a traversal step three times as dear as a triangle test; the SAH here weighs both
    // alike, so the peer is also given that weight, and the better of the two is what counts.
    let peers = [
        ("obvhs medium", peer(BvhBuildParams::medium_build())),
        ("obvhs very_slow", very_slow),
        ("obvhs very_slow, equal costs", BvhBuildParams { collapse_traversal_cost: 1.0, ..very_slow }),
    ];
    let triangle_count = mesh.triangles.len() as f64;
    let mut reference = f64::INFINITY;
    for (label, params) in peers {
        let start = Instant::now();
        let bvh = build_bvh2(&triangles, params, &mut Default::default());
        let ms = start.elapsed().as_secs_f64() * 1e3;
        let cost = peer_sah_cost(&bvh);
        if label.contains("very_slow") {
            reference = reference.min(cost);
        }
        let nodes = bvh.nodes.len() as f64 / triangle_count;
        println!("| {name} | {leaf} | {label} | {cost:.3} | | {} | {nodes:.3} | {ms:.0} |", bvh.depth(0));
    }
    for quality in [Quality::Fast, Quality::Medium, Quality::High] {
        let start = Instant::now();
        let tree = build(mesh, &BuildOptions { max_leaf_size: leaf, ..BuildOptions::new(quality) })
            .expect("the scene is valid");
        let ms = start.elapsed().as_secs_f64() * 1e3;
        tree.validate(mesh).expect("a hierarchy");
        let cost = tree.sah_cost();
        println!(
            "| {name} | {leaf} | {quality:?} | {cost:.3} | {:.4} | {} | {:.3} | {ms:.0} |",
            cost / reference,
            tree.max_depth(),
            tree.nodes.len() as f64 / triangle_count,
        );
    }
}

/// The formula of `Tree::sah_cost` on the peer's tree.
fn peer_sah_cost(bvh: &Bvh2) -> f64 {
    let half_area = |node: usize| {
        let aabb = bvh.nodes[node].aabb();
        let e = aabb.max.as_dvec3() - aabb.min.as_dvec3();
        e.x * e.y + e.y * e.z + e.z * e.x
    };
    let weight = |node: usize| match &bvh.nodes[node] {
        node if node.is_leaf() => f64::from(node.prim_count),
        _ => 1.0,
    };
    (0..bvh.nodes.len()).map(|node| weight(node) * half_area(node)).sum::<f64>() / half_area(0)
}
