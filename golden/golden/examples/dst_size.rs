//! Size, expected work and conversion rate of dual-split trees over the real scenes, beside the BVH2 with the same leaves.
//!
//! `DUALSPLIT_DATA=... cargo run --release -p dualsplit-golden --example dst_size [-- SCENE...]`
//!
//! The bound is the fewest carve nodes per split that any choice of axes could reach: of the planes of two children that
//! are not their parent's, the split stores two and each carve node two. Times are processor time of all threads; the conversion
//! has one. A structure's own cost is what a ray through the root's box is expected to cost, nodes and triangles alike.

#[path = "../tests/support/mod.rs"]
mod support;

use cpu_time::{ProcessTime, ThreadTime};
use golden::build::{BinaryTree, BuildError, BuildOptions, Quality, build};
use golden::dst::{Dst, build_for_dst};
use golden::stats::TreeStatistics;
use golden::structure::{Structure, StructureKind, pack_triangles};
use scenes::Mesh;

fn main() {
    let chosen: Vec<String> = std::env::args().skip(1).collect();
    println!(
        "| scene | partition | bytes, DST / BVH2 | carves per split | bound | SAH | BVH2's own cost | DST's own cost \
         | build, s | conversion, M triangles/s |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for name in support::SHARED_SCENES {
        if chosen.is_empty() || chosen.iter().any(|c| c == name) {
            let Some(mesh) = support::shared_scene(name) else {
                return eprintln!("set DUALSPLIT_DATA to the folder that holds scenes/");
            };
            let options = BuildOptions::new(Quality::High);
            row(name, "high", &mesh, || build(&mesh, &options));
            row(name, "for the DST", &mesh, || build_for_dst(&mesh, &options));
        }
    }
}

fn row(name: &str, partition: &str, mesh: &Mesh, build: impl Fn() -> Result<BinaryTree, BuildError>) {
    let start = ProcessTime::now();
    let tree = build().expect("a valid mesh");
    let seconds = start.elapsed().as_secs_f64();
    let triangles = pack_triangles(mesh, &tree);
    let [bvh2, dst] = [StructureKind::Bvh2, StructureKind::Dst]
        .map(|kind| TreeStatistics::of(&Structure::convert(kind, &tree, &triangles).expect("a small scene")));
    let rate = (0..7)
        .map(|_| {
            let start = ThreadTime::now();
            std::hint::black_box(Dst::convert(&tree, triangles.clone()).expect("a small scene"));
            mesh.triangles.len() as f64 / start.elapsed().as_secs_f64() / 1e6
        })
        .fold(0.0, f64::max);
    println!(
        "| {name} | {partition} | {:.3} | {:.3} | {:.3} | {:.2} | {:.2} | {:.2} | {seconds:.2} | {rate:.2} |",
        dst.bytes as f64 / bvh2.bytes as f64,
        dst.carves.expect("a dual-split tree has carves").per_split,
        fewest_carves(&tree),
        dst.sah_cost,
        bvh2.own_cost(),
        dst.own_cost(),
    );
}

fn fewest_carves(tree: &BinaryTree) -> f64 {
    let (mut splits, mut carves) = (0, 0);
    for parent in &tree.nodes {
        let children = tree.children(parent);
        if children.is_empty() {
            continue;
        }
        let outer = parent.aabb.to_bits();
        let new: usize = tree.nodes[children]
            .iter()
            .map(|child| child.aabb.to_bits().iter().zip(&outer).filter(|(a, b)| a != b).count())
            .sum();
        splits += 1;
        carves += new.saturating_sub(2).div_ceil(2);
    }
    carves as f64 / splits.max(1) as f64
}
