//! Candidates for smaller and flatter trees, by what they cost a path tracer: bytes, visits, planes and triangles tested.
//!
//! `cargo run --release -p dualsplit-render --example candidates -- [--detail D] SCENE...`
//!
//! A scene is one of the built-in ones or a file. Every candidate has the partition of the same binary hierarchy, and boxes that
//! are rounded outward to its grid. So the traversals are those of golden's kernels, and every hit is compared with that of the
//! hierarchy that is not rounded. `docs/candidates.md` describes the formats, and holds the tables. Bytes of nodes are counted from the
//! formats; the kernels read the nodes of golden.

use golden::build::{BinaryTree, BuildOptions, Content, Quality, WideTree, build, collapse_wide};
use golden::bvh::{Bvh, Bvh2};
use golden::dst::Dst;
use golden::dst::header::{Header, LEAF_WORDS, NODE_WORDS};
use golden::qbvh::QBvh;
use golden::structure::pack_triangles;
use golden::traverse::{Node, Observer, Tests, Trace};
use golden::triangle::Triangle;
use golden::{Aabb, Hit, Mode, Ray, TraversalRay};
use render::{RayClass, RenderOptions, Test, render};
use scenes::Scene;
use std::collections::HashSet;
use std::sync::Arc;

/// Pixels on each side of the picture whose rays are traced.
const SIDE: u32 = 64;

fn main() {
    let mut arguments = std::env::args().skip(1).peekable();
    let mut detail = 0.02;
    if arguments.next_if_eq("--detail").is_some() {
        detail = arguments.next().and_then(|d| d.parse().ok()).expect("--detail takes a number");
    }
    for name in arguments {
        let scene = Scene::load(&name, detail, 0).expect("a scene");
        table(&scene);
    }
}

/// The rays of one picture with the hits that every candidate has to find.
struct Workload {
    rays: Vec<(Ray, bool)>,
    hits: Vec<Option<Hit>>,
}

impl Workload {
    fn new(scene: &Scene, bvh: &Bvh2) -> Self {
        let options = RenderOptions { keep_rays: true, ..RenderOptions::new(Test::Path, SIDE, SIDE) };
        let stream = render(bvh, scene, &options, |_| ()).expect("a view").rays.expect("they are kept");
        let is_shadow = |class| matches!(class, RayClass::Shadow { .. });
        let rays: Vec<_> = stream
            .by_wave()
            .flat_map(|(class, rays)| rays.iter().map(move |ray| (*ray, is_shadow(class))))
            .collect();
        let hits = rays.iter().map(|(ray, _)| bvh.closest(ray, Mode::Robust)).collect();
        Self { rays, hits }
    }

    /// Traces all rays, and returns the number of those whose result is another.
    fn trace<S: Trace, O: Observer>(&self, structure: &S, observer: &mut O) -> usize {
        let mut lost = 0;
        for ((ray, is_shadow), expected) in self.rays.iter().zip(&self.hits) {
            let ray = TraversalRay::new(ray, Mode::Robust).expect("a ray of the renderer");
            let same = if *is_shadow {
                structure.occluded_prepared(&ray, observer) == expected.is_some()
            } else {
                structure.closest_prepared(&ray, observer) == *expected
            };
            lost += usize::from(!same);
        }
        lost
    }
}

/// What is counted while rays are traced.
#[derive(Default)]
struct Work {
    /// Addresses of nodes that are read together with the one above them.
    within: HashSet<u64>,
    /// Planes that a visit tests if that is not what the node has.
    planes_of_head: u64,
    visits: u64,
    planes: u64,
    triangles: u64,
}

impl Observer for Work {
    fn node(&mut self, node: &Node) {
        if self.within.contains(&node.address) {
            return;
        }
        self.visits += 1;
        self.planes += match node.tests {
            Tests::Box => 6,
            Tests::Planes => self.planes_of_head.max(2),
            Tests::None => 0,
        };
    }

    fn triangle(&mut self, _slot: u32, _t: Option<f32>) {
        self.triangles += 1;
    }
}

/// A grid of `2^bits` planes on each axis, whose step is the least power of two with which it reaches around a box.
struct Grid {
    steps: [f64; 3],
}

impl Grid {
    fn around(frame: &Aabb, bits: u32) -> Self {
        let steps = std::array::from_fn(|axis| {
            let [low, high] = [frame.min[axis], frame.max[axis]].map(f64::from);
            let mut step = 2f64.powi(-120);
            // Beside the bits of the grid, every plane has to be a binary32 number.
            let fits = |step: f64| {
                let [low, high] = [(low / step).floor(), (high / step).ceil()];
                high - low < f64::from(1u32 << bits) && low.abs().max(high.abs()) <= f64::from(1u32 << 24)
            };
            while !fits(step) {
                step *= 2.0;
            }
            step
        });
        Self { steps }
    }

    fn outward(&self, aabb: &Aabb) -> Aabb {
        let rounded = |round: fn(f64) -> f64, planes: [f32; 3]| {
            std::array::from_fn(|axis| {
                (round(f64::from(planes[axis]) / self.steps[axis]) * self.steps[axis]) as f32 + 0.0
            })
        };
        Aabb { min: rounded(f64::floor, aabb.min), max: rounded(f64::ceil, aabb.max) }
    }
}

/// One line of the table.
struct Line<'a> {
    workload: &'a Workload,
    triangles: usize,
}

impl Line<'_> {
    fn print<S: Trace>(&self, name: &str, bytes: usize, structure: &S, mut work: Work) {
        let lost = self.workload.trace(structure, &mut work);
        let per_ray = |count: u64| count as f64 / self.workload.rays.len() as f64;
        println!(
            "| {name} | {:.2} | {:.1} | {:.1} | {:.2} | {lost} |",
            bytes as f64 / self.triangles as f64,
            per_ray(work.visits),
            per_ray(work.planes),
            per_ray(work.triangles),
        );
    }
}

fn table(scene: &Scene) {
    let tree = build(&scene.mesh, &BuildOptions::new(Quality::Medium)).expect("triangles");
    let triangles = pack_triangles(&scene.mesh, &tree);
    let bvh2 = Bvh2::encode(&tree, Arc::clone(&triangles));
    let workload = Workload::new(scene, &bvh2);
    let line = Line { workload: &workload, triangles: triangles.len() };
    println!("\n{}, {} triangles, {} rays:\n", scene.name, triangles.len(), workload.rays.len());
    println!(
        "| candidate | bytes a triangle | visits a ray | planes a ray | triangles a ray | other results |"
    );
    println!("|---|--:|--:|--:|--:|--:|");
    boxes::<2>(&tree, &triangles, &line);
    boxes::<4>(&collapse_wide(&tree), &triangles, &line);
    boxes::<8>(&collapse_wide(&tree), &triangles, &line);
    let dst = |tree: &BinaryTree| Dst::convert(tree, Arc::clone(&triangles)).expect("a small scene");
    let exact = dst(&tree);
    planes("dst", WORDS, &exact, &line);
    let whole = Grid::around(&tree.nodes[0].aabb, 16);
    let q16 = dst(&mapped(&tree, |_, aabb| whole.outward(aabb)));
    planes("dst-q16", HALVES, &q16, &line);
    for most in [32, 64, 128] {
        let (narrow, treelets) = in_treelets(&tree, most);
        // A frame of 20 bytes, and a word that leads to it.
        let format = Format { node: 4, leaf: 4, extra: 24 * treelets };
        let narrow = dst(&narrow);
        planes(&format!("dst-treelet {most}"), format, &narrow, &line);
        if most == 64 {
            // A split with one carve takes 64 bits with its offset, with two carves 80.
            fused("dst-treelet 64, fused", [8, 8, 12], format, &narrow, &line);
        }
    }
    fused("dst-fused", [12, 20, 28], WORDS, &exact, &line);
    fused("dst-q16, fused", [8, 12, 16], HALVES, &q16, &line);
    wide("dst-wide", &exact, &line);
}

/// A hierarchy of boxes, and the same with planes of 8 bits on a grid of each node.
fn boxes<const N: usize>(tree: &WideTree<N>, triangles: &Arc<[Triangle]>, line: &Line<'_>) {
    let bvh = Bvh::<N>::encode(tree, Arc::clone(triangles));
    line.print(&format!("bvh{N}"), bvh.node_bytes(), &bvh, Work::default());
    let narrow = QBvh::<N>::encode(tree, triangles);
    line.print(&format!("qbvh{N}"), narrow.node_bytes(), &narrow, Work::default());
}

/// Bytes of a split or carve node, of a bare leaf, and of everything else.
#[derive(Clone, Copy)]
struct Format {
    node: usize,
    leaf: usize,
    extra: usize,
}

/// Planes of 32 bits, and of 16.
const WORDS: Format = Format { node: 12, leaf: 4, extra: 0 };
const HALVES: Format = Format { node: 8, ..WORDS };

fn planes(name: &str, format: Format, dst: &Dst, line: &Line<'_>) {
    let counts = dst.node_counts();
    let nodes = counts.splits + counts.carves();
    let bytes = format.node * nodes + format.leaf * counts.bare_leaves + format.extra;
    line.print(name, bytes, dst, Work::default());
}

/// `tree` with its boxes mapped; `map` gets a node's index.
fn mapped(tree: &BinaryTree, map: impl Fn(usize, &Aabb) -> Aabb) -> BinaryTree {
    let mut tree = tree.clone();
    tree.nodes.iter_mut().enumerate().for_each(|(index, node)| node.aabb = map(index, &node.aabb));
    tree
}

/// `tree` cut into subtrees of at most `most` inner nodes, with planes of 8 bits on a grid of each subtree's root; and how many
/// subtrees there are.
fn in_treelets(tree: &BinaryTree, most: usize) -> (BinaryTree, usize) {
    // From the leaves up, the larger child is cut off where a subtree would become too large.
    let mut size = vec![0; tree.nodes.len()];
    let mut is_root = vec![false; tree.nodes.len()];
    is_root[0] = true;
    for (index, node) in tree.nodes.iter().enumerate().rev() {
        let Content::Inner { first_child, .. } = node.content else { continue };
        let [a, b] = [first_child as usize, first_child as usize + 1];
        size[index] = 1 + size[a] + size[b];
        while size[index] > most {
            let larger = if is_root[b] || !is_root[a] && size[a] >= size[b] { a } else { b };
            is_root[larger] = true;
            size[index] -= size[larger];
        }
    }
    let mut narrow = tree.clone();
    let mut stack = vec![(0, Grid::around(&tree.nodes[0].aabb, 8))];
    narrow.nodes[0].aabb = stack[0].1.outward(&tree.nodes[0].aabb);
    while let Some((index, grid)) = stack.pop() {
        for child in tree.children(&tree.nodes[index]) {
            let aabb = grid.outward(&tree.nodes[child].aabb);
            narrow.nodes[child].aabb = aabb;
            let own = if is_root[child] { Grid::around(&aabb, 8) } else { Grid { steps: grid.steps } };
            stack.push((child, own));
        }
    }
    (narrow, is_root.iter().filter(|root| **root).count())
}

/// The nodes of a tree in the order of memory, with their word offsets.
fn nodes(dst: &Dst) -> impl Iterator<Item = (u32, Header)> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let header = Header::decode(*dst.words().get(at as usize)?).expect("a valid tree");
        let offset = at;
        at += if matches!(header, Header::Leaf { .. }) { LEAF_WORDS } else { NODE_WORDS };
        Some((offset, header))
    })
}

/// The children's offsets of a split.
fn children(header: Header) -> Option<[u32; 2]> {
    match header {
        Header::Split { left_words, offset, .. } => Some([offset, offset + left_words]),
        _ => None,
    }
}

fn header(dst: &Dst, offset: u32) -> Header {
    Header::decode(dst.words()[offset as usize]).expect("a valid tree")
}

const fn address(offset: u32) -> u64 {
    offset as u64 * 4
}

/// A split holds the first carve of each child, and takes `record` bytes with none, one or two of them. A leaf that such a carve
/// holds takes a word of its own. Later carves of a chain take `carve` bytes.
fn fused(
    name: &str,
    record: [usize; 3],
    Format { node: carve, extra, .. }: Format,
    dst: &Dst,
    line: &Line<'_>,
) {
    let mut work = Work { planes_of_head: 6, ..Work::default() };
    let mut bytes = extra;
    for (offset, own) in nodes(dst) {
        let Some(children) = children(own) else {
            // What is left are later carves of a chain and leaves.
            let is_within = work.within.contains(&address(offset));
            bytes +=
                match own {
                    Header::CarveSingle { leaf, .. } | Header::CarveDual { leaf, .. } if is_within => {
                        if leaf { 4 } else { 0 }
                    }
                    Header::Leaf { .. } => 4,
                    _ => carve,
                };
            continue;
        };
        let is_carve =
            |child: &u32| !matches!(header(dst, *child), Header::Split { .. } | Header::Leaf { .. });
        let carves: Vec<u64> = children.into_iter().filter(is_carve).map(address).collect();
        bytes += record[carves.len()];
        work.within.extend(carves);
    }
    line.print(name, bytes, dst, work);
}

/// A split holds those of its children that are splits themselves, with no carve between: 8 bytes more for each pair of planes,
/// and 4 for an offset that has to be longer.
fn wide(name: &str, dst: &Dst, line: &Line<'_>) {
    let mut work = Work { planes_of_head: 6, ..Work::default() };
    let mut bytes = 0;
    for (offset, own) in nodes(dst) {
        bytes += match own {
            Header::Leaf { .. } => 4,
            Header::Split { .. } if work.within.contains(&address(offset)) => 8,
            Header::Split { .. } => 16,
            Header::CarveSingle { .. } | Header::CarveDual { .. } => 12,
        };
        if work.within.contains(&address(offset)) {
            continue;
        }
        for child in children(own).into_iter().flatten() {
            if matches!(header(dst, child), Header::Split { .. }) {
                work.within.insert(address(child));
            }
        }
    }
    line.print(name, bytes, dst, work);
}
