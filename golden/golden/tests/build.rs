//! Properties of every tree that the builder makes.

#[path = "support/peer.rs"]
mod peer;
mod support;

use golden::build::{BinaryTree, BuildError, BuildOptions, MAX_DEPTH, Quality, build};
use golden::structure::{Structure, StructureKind, pack_triangles};
use proptest::prelude::*;
use scenes::Mesh;
use stress::shapes::soup;
use support::random_soup;

const QUALITIES: [Quality; 3] = [Quality::Fast, Quality::Medium, Quality::High];

fn options(quality: Quality, max_leaf_size: u32) -> BuildOptions {
    BuildOptions { max_leaf_size, ..BuildOptions::new(quality) }
}

/// Builds with every preset, checks what holds for all trees, and returns the trees.
fn checked(name: &str, mesh: &Mesh) -> Vec<BinaryTree> {
    let mut trees = Vec::new();
    for quality in QUALITIES {
        for max_leaf_size in [1, 4] {
            let tree = build(mesh, &options(quality, max_leaf_size)).expect(name);
            tree.validate(mesh).expect(name);
            let largest = tree.nodes.iter().map(|node| tree.triangles(node).len()).max();
            assert!(largest <= Some(max_leaf_size as usize), "{name}: {largest:?} triangles in a leaf");
            assert!(tree.max_depth() <= MAX_DEPTH, "{name}: depth {}", tree.max_depth());
            let cost = tree.sah_cost();
            assert!(cost.is_finite() && cost >= 1.0, "{name}: cost {cost}");
            trees.push(tree);
        }
    }
    trees
}

const CORNERS: [[f32; 3]; 3] = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// [`CORNERS`] times `scale` plus `offset`.
fn triangle(scale: f32, offset: [f32; 3]) -> [[f32; 3]; 3] {
    CORNERS.map(|p| [0, 1, 2].map(|i| p[i] * scale + offset[i]))
}

/// A triangle whose box is centred on the origin.
fn centred(half: f32) -> [[f32; 3]; 3] {
    [[-half; 3], [half; 3], [-half, half, 0.0]]
}

#[test]
fn few_triangles() {
    for count in 1..4 {
        checked("apart", &soup((0..count).map(|i| triangle(1.0, [i as f32; 3]))));
        checked("identical", &soup((0..count).map(|_| CORNERS)));
    }
}

#[test]
fn no_or_little_area() {
    checked("one point", &soup([[[1.0; 3]; 3]; 100]));
    checked("points in a line", &soup((0..1000).map(|i| [[i as f32, 0.0, 0.0]; 3])));
    checked(
        "segments in a line",
        &soup((0..1000).map(|i| [0.0, 5.0, 2.0].map(|x| [i as f32 + x, 1.0, 2.0]))),
    );
    checked("coplanar", &soup((0..1000).map(|i| CORNERS.map(|[x, y, _]| [x + i as f32, y, 2.0]))));
    let tiny = f32::from_bits;
    let subnormal = |i| [[tiny(i), 0.0, 0.0], [0.0, tiny(2 * i), -0.0], [-0.0, 0.0, -tiny(i * i)]];
    checked("subnormal", &soup((0..100).map(subnormal)));
}

#[test]
fn all_scales() {
    let power = |i: i32| 2_f32.powi(i);
    checked("growing", &soup((0..84).map(|i| triangle(power(i), [0.0; 3]))));
    checked("growing slowly", &soup((0..2000).map(|i| triangle(1.029_f32.powi(i), [0.0; 3]))));
    checked(
        "growing to both sides",
        &soup((-120..120).map(|i| triangle(power(i) * (-1_f32).powi(i), [0.0; 3]))),
    );
    checked("points growing apart", &soup((-125..125).map(|i| [[power(i), 0.0, 0.0]; 3])));
    checked("concentric", &soup((-125..125).map(|i| centred(power(i)))));
    let huge = |i| [[f32::MAX, 0.0, i as f32], [-f32::MAX, f32::MAX, 0.0], [0.0, -f32::MAX, 1e36 * i as f32]];
    checked("huge", &soup((0..100).map(huge)));
    checked("one vast", &soup((0..1000).map(|i| triangle(if i == 500 { 1e9 } else { 1.0 }, [i as f32; 3]))));
    checked("far away", &soup((0..1000).map(|i| triangle(1.0, [1e7 + i as f32, 1e7, -1e7]))));
}

#[test]
fn regular() {
    checked("in a line", &soup((0..10_000).map(|i| triangle(1.0, [i as f32, 0.0, 0.0]))));
    let cell = |i: i32| [i % 16, i / 16 % 16, i / 256].map(|x| x as f32);
    checked("grid", &soup((0..4096).map(|i| triangle(1.0, cell(i)))));
}

/// Quadratic time would take minutes.
#[test]
fn many_equal_centres_take_linearithmic_time() {
    let n = 100_000;
    for tree in checked("identical", &soup((0..n).map(|_| CORNERS))) {
        assert!(tree.max_depth() <= 17, "depth {}", tree.max_depth());
    }
    checked("concentric", &soup((1..=n).map(|i| centred(i as f32))));
}

#[test]
fn tree_does_not_depend_on_the_number_of_threads() {
    // Enough triangles for every part that runs in parallel.
    let sizes = [(Quality::Fast, 70_000), (Quality::Medium, 70_000), (Quality::High, 20_000)];
    for (quality, triangles) in sizes {
        let mesh = random_soup(triangles, 7);
        let trees = [1, 2, 4].map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| build(&mesh, &BuildOptions::new(quality)).expect("a tree"))
        });
        assert!(trees[0] == trees[1] && trees[0] == trees[2], "{quality:?}");
    }
}

#[test]
fn better_presets_give_better_trees() {
    let mesh = random_soup(20_000, 3);
    let costs = QUALITIES.map(|quality| build(&mesh, &options(quality, 4)).expect("a tree").sah_cost());
    assert!(costs.is_sorted_by(|a, b| a > b), "{costs:?}");
}

/// The example `build_quality` compares all scenes and presets.
#[test]
fn high_is_no_worse_than_the_best_peer() {
    for name in ["bunny", "sibenik"] {
        let Some(mesh) = support::shared_scene(name) else { return };
        for max_leaf_size in [1, 4] {
            let tree = build(&mesh, &options(Quality::High, max_leaf_size)).expect("a tree");
            tree.validate(&mesh).expect("a hierarchy");
            let ratio = tree.sah_cost() / peer::very_slow_sah_cost(&mesh, max_leaf_size);
            assert!(ratio <= 1.0, "{name}, {max_leaf_size} triangles in a leaf: {ratio}");
        }
    }
}

/// The example `dst_size` shows all scenes.
#[test]
fn dual_split_trees_take_at_most_seven_tenths_of_the_bytes() {
    for name in ["bunny", "sanmiguel_leaves"] {
        let Some(mesh) = support::shared_scene(name) else { return };
        let tree = build(&mesh, &BuildOptions::new(Quality::High)).expect("a tree");
        let triangles = pack_triangles(&mesh, &tree);
        let [bvh2, dst] = [StructureKind::Bvh2, StructureKind::Dst]
            .map(|kind| Structure::convert(kind, &tree, &triangles).expect("a small scene").node_bytes());
        assert!(10 * dst <= 7 * bvh2, "{name}: {dst} of {bvh2} bytes");
    }
}

#[test]
fn bad_meshes_are_named() {
    let mut mesh = random_soup(100, 1);
    assert_eq!(build(&mesh, &options(Quality::Fast, 0)), Err(BuildError::LeafSize(0)));
    assert_eq!(build(&Mesh::default(), &BuildOptions::default()), Err(BuildError::NoTriangles));
    mesh.triangles[70][2] = 300;
    let out_of_range = BuildError::IndexOutOfRange { triangle: 70, index: 300, vertices: 300 };
    assert_eq!(build(&mesh, &BuildOptions::default()), Err(out_of_range));
    mesh.positions[125] = [0.0, f32::NEG_INFINITY, 0.0];
    let infinite = BuildError::NonFiniteVertex { triangle: 41, vertex: 125, position: mesh.positions[125] };
    assert_eq!(build(&mesh, &BuildOptions::default()), Err(infinite));
}

#[test]
fn unused_vertices_are_ignored() {
    let mut mesh = random_soup(10, 1);
    let tree = build(&mesh, &BuildOptions::default());
    mesh.positions.push([f32::NAN; 3]);
    assert_eq!(build(&mesh, &BuildOptions::default()), tree);
}

proptest! {
    #[test]
    fn small_meshes_give_valid_trees(
        corners in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(-4_i8..4)), 1..60),
        exponent in -120_i32..100,
    ) {
        let scale = 2_f32.powi(exponent);
        let mesh = soup(corners.into_iter().map(|t| t.map(|p| p.map(|x| f32::from(x) * scale))));
        for tree in checked("small", &mesh) {
            // No node is larger than the root.
            prop_assert!(tree.sah_cost() < 2.0 * mesh.triangles.len() as f64);
        }
    }
}
