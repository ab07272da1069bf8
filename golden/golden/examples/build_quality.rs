//! Compares the builder with `obvhs` on the real scenes: SAH cost and time, at equal maximum leaf size.
//!
//! `DUALSPLIT_DATA=... cargo run --release -p dualsplit-golden --example build_quality [-- SCENE...]`
//!
//! `ratio` is the cost over the better of the two `very_slow` trees. The time is processor time of all
//! threads; `obvhs` has one.

#[path = "../tests/support/peer.rs"]
mod peer;
#[path = "../tests/support/mod.rs"]
mod support;

use cpu_time::ProcessTime;
use golden::build::{BuildOptions, Quality, build};
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2;
use scenes::Mesh;

fn main() {
    let chosen: Vec<String> = std::env::args().skip(1).collect();
    println!("| scene | leaf | builder | SAH | ratio | depth | nodes/triangle | ms |");
    println!("|---|---|---|---|---|---|---|---|");
    for name in support::SHARED_SCENES {
        if chosen.is_empty() || chosen.iter().any(|c| c == name) {
            let Some(mesh) = support::shared_scene(name) else {
                return eprintln!("set DUALSPLIT_DATA to the folder that holds scenes/");
            };
            for max_leaf_size in [1, 4, 8] {
                compare(name, &mesh, max_leaf_size);
            }
        }
    }
}

fn compare(name: &str, mesh: &Mesh, max_leaf_size: u32) {
    let row = |builder: &str, cost: f64, ratio: f64, depth: u32, nodes: usize, milliseconds: f64| {
        let nodes = nodes as f64 / mesh.triangles.len() as f64;
        println!(
            "| {name} | {max_leaf_size} | {builder} | {cost:.3} | {ratio:.4} | {depth} | {nodes:.3} | {milliseconds:.0} |"
        );
    };
    let reference = peer::very_slow_sah_cost(mesh, max_leaf_size);
    let triangles = peer::triangles(mesh);
    let [very_slow, equal_costs] = peer::very_slow_params(max_leaf_size);
    for (builder, params) in [
        ("obvhs medium", peer::params(BvhBuildParams::medium_build(), max_leaf_size)),
        ("obvhs very_slow", very_slow),
        ("obvhs very_slow, equal costs", equal_costs),
    ] {
        let (bvh, milliseconds) = timed(|| build_bvh2(&triangles, params, &mut Default::default()));
        let cost = peer::sah_cost(&bvh);
        row(builder, cost, cost / reference, bvh.depth(0) as u32, bvh.nodes.len(), milliseconds);
    }
    for quality in [Quality::Fast, Quality::Medium, Quality::High] {
        let options = BuildOptions { max_leaf_size, ..BuildOptions::new(quality) };
        let (tree, milliseconds) = timed(|| build(mesh, &options).expect("a valid scene"));
        let cost = tree.sah_cost();
        let builder = format!("{quality:?}");
        row(&builder, cost, cost / reference, tree.max_depth(), tree.nodes.len(), milliseconds);
    }
}

/// The result of `work` and the least processor time of three runs in milliseconds.
fn timed<T>(work: impl Fn() -> T) -> (T, f64) {
    let run = || {
        let start = ProcessTime::now();
        (work(), start.elapsed().as_secs_f64() * 1e3)
    };
    let (result, first) = run();
    (result, [first, run().1, run().1].into_iter().fold(f64::INFINITY, f64::min))
}
