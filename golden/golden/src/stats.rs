//! What there is to know about a structure without tracing a ray.

use crate::Aabb;
use crate::bvh::{Bvh, INDEX, LEAF};
use crate::dst::header::{LEAF_WORDS, NODE_WORDS};
use crate::dst::{Dst, End, MAX_CARVES};
use crate::structure::Structure;
use crate::triangle::Triangle;

/// Sizes, costs and histograms of a structure, read from its memory format.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeStatistics {
    /// Nodes in memory: boxes of a BVH (the root's is kept outside), splits, carves and bare leaves of a dual-split tree.
    pub nodes: u64,
    /// Leaves, whether they are nodes of their own or not.
    pub leaves: u64,
    /// Bytes of the nodes, without the triangles.
    pub bytes: u64,
    /// SAH cost of the hierarchy of boxes: (sum of inner areas + sum over leaves of area x triangles) / area of the root.
    /// A dual-split tree has that of the binary hierarchy with the same boxes; its carves are not inner boxes.
    pub sah_cost: f64,
    /// Expected number of nodes that a ray through the root's box reads without early termination: all children of every
    /// inner BVH node that it meets, or every dual-split node whose remaining box it meets.
    pub expected_node_visits: f64,
    /// Expected number of triangles that such a ray tests: the sum over leaves of area x triangles / area of the root.
    pub expected_triangle_tests: f64,
    /// Most steps from the root to a leaf; a carve is a step.
    pub max_depth: u32,
    /// Number of leaves at each depth.
    pub leaves_by_depth: Vec<u64>,
    /// Number of leaves with each number of triangles.
    pub leaves_by_size: Vec<u64>,
    /// The carves of a dual-split tree.
    pub carves: Option<CarveStatistics>,
}

/// The carve nodes of a dual-split tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarveStatistics {
    /// Number of children with no, one, two and three carve nodes between the split and themselves.
    pub children_by_carves: [u64; MAX_CARVES + 1],
    /// Carve nodes of one axis.
    pub single: u64,
    /// Carve nodes of two axes.
    pub dual: u64,
    /// Carve nodes per split node; zero if there is no split.
    pub per_split: f64,
}

impl TreeStatistics {
    /// What a ray through the root's box is expected to cost if a node and a triangle cost the same: the cost that the
    /// structure itself has, where [`Self::sah_cost`] compares partitions.
    #[must_use]
    pub fn own_cost(&self) -> f64 {
        self.expected_node_visits + self.expected_triangle_tests
    }

    /// The statistics of `structure`.
    ///
    /// # Panics
    /// If `structure` is not valid.
    #[must_use]
    pub fn of(structure: &Structure) -> Self {
        match structure {
            Structure::Bvh2(bvh) => of_bvh(bvh),
            Structure::Bvh4(bvh) => of_bvh(bvh),
            Structure::Bvh8(bvh) => of_bvh(bvh),
            Structure::Dst(dst) => of_dst(dst),
        }
    }
}

fn of_bvh<const N: usize>(bvh: &Bvh<N>) -> TreeStatistics {
    let mut sums = Sums::new(bvh.root_box, &bvh.triangles);
    let mut stack = vec![(bvh.root, bvh.root_box, 0)];
    while let Some((word, aabb, depth)) = stack.pop() {
        let share = sums.share(&aabb);
        if LEAF.get(word) == 1 {
            sums.leaf(INDEX.get(word), share, depth);
        } else {
            let children = bvh.children(word);
            sums.sah_cost += share;
            sums.node_visits += share * children.len() as f64;
            stack.extend(children.iter().map(|child| (child.word, child.aabb, depth + 1)));
        }
    }
    sums.finish(bvh.nodes.len(), bvh.node_bytes(), None)
}

fn of_dst(dst: &Dst) -> TreeStatistics {
    let counts = dst.node_counts();
    let mut carves = CarveStatistics {
        children_by_carves: [0; MAX_CARVES + 1],
        single: counts.single_carves as u64,
        dual: counts.dual_carves as u64,
        per_split: counts.carves() as f64 / counts.splits.max(1) as f64,
    };
    let mut sums = Sums::new(dst.root_box, &dst.triangles);
    let mut stack = vec![(0, dst.root_box, 0)];
    while let Some((offset, region, depth)) = stack.pop() {
        let record = dst.record(offset, region).expect("a valid tree");
        let nodes = record.words.div_ceil(NODE_WORDS as usize);
        debug_assert!(
            (record.words as u32).is_multiple_of(NODE_WORDS)
                || record.words as u32 % NODE_WORDS == LEAF_WORDS
        );
        let last_depth = depth + nodes - 1;
        sums.node_visits += sums.share_of(record.visited_half_area, nodes);
        if offset != 0 {
            carves.children_by_carves[record.carves] += 1;
        }
        let share = sums.share(&record.region);
        match record.end {
            End::Leaf { first_triangle } => sums.leaf(first_triangle, share, last_depth),
            End::Split { children } => {
                sums.sah_cost += share;
                stack.extend(children.map(|(offset, region)| (offset, region, last_depth + 1)));
            }
        }
    }
    sums.finish(counts.nodes(), dst.node_bytes(), Some(carves))
}

struct Sums<'a> {
    root_half_area: f64,
    triangles: &'a [Triangle],
    /// Of the inner nodes.
    sah_cost: f64,
    node_visits: f64,
    triangle_tests: f64,
    by_depth: Vec<u64>,
    by_size: Vec<u64>,
}

impl<'a> Sums<'a> {
    fn new(root: Aabb, triangles: &'a [Triangle]) -> Self {
        let root_half_area = root.half_area();
        Self {
            root_half_area,
            triangles,
            sah_cost: 0.0,
            node_visits: 0.0,
            triangle_tests: 0.0,
            by_depth: vec![],
            by_size: vec![],
        }
    }

    /// The probability that a ray through the root meets `aabb`; 1 if the root has no area.
    fn share(&self, aabb: &Aabb) -> f64 {
        self.share_of(aabb.half_area(), 1)
    }

    /// The sum of these probabilities over `count` boxes.
    fn share_of(&self, half_areas: f64, count: usize) -> f64 {
        if self.root_half_area > 0.0 { half_areas / self.root_half_area } else { count as f64 }
    }

    fn leaf(&mut self, first_triangle: u32, share: f64, depth: usize) {
        let rest = &self.triangles[first_triangle as usize..];
        let size = rest.iter().position(Triangle::is_last).expect("leaves have a last triangle") + 1;
        self.triangle_tests += share * size as f64;
        for (histogram, at) in [(&mut self.by_depth, depth), (&mut self.by_size, size)] {
            histogram.resize(histogram.len().max(at + 1), 0);
            histogram[at] += 1;
        }
    }

    fn finish(self, nodes: usize, bytes: usize, carves: Option<CarveStatistics>) -> TreeStatistics {
        TreeStatistics {
            nodes: nodes as u64,
            leaves: self.by_size.iter().sum(),
            bytes: bytes as u64,
            sah_cost: self.sah_cost + self.triangle_tests,
            expected_node_visits: self.node_visits,
            expected_triangle_tests: self.triangle_tests,
            max_depth: self.by_depth.len() as u32 - 1,
            leaves_by_depth: self.by_depth,
            leaves_by_size: self.by_size,
            carves,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{BinaryTree, BuildOptions, Quality, WideTree, build, collapse_wide};
    use crate::structure::{StructureKind, pack_triangles};
    use scenes::Scene;

    fn tree(max_leaf_size: u32) -> (BinaryTree, Vec<(StructureKind, TreeStatistics)>) {
        let scene = Scene::load("hairball", 0.001, 0).unwrap();
        let options = BuildOptions { max_leaf_size, ..BuildOptions::new(Quality::Fast) };
        let tree = build(&scene.mesh, &options).unwrap();
        let triangles = pack_triangles(&scene.mesh, &tree);
        let of = |kind| TreeStatistics::of(&Structure::convert(kind, &tree, &triangles).unwrap());
        let all = StructureKind::ALL.map(|kind| (kind, of(kind))).to_vec();
        (tree, all)
    }

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() <= 1e-9 * b
    }

    #[test]
    fn costs_are_those_of_the_hierarchies() {
        let (tree, all) = tree(4);
        let wide: WideTree<8> = collapse_wide(&tree);
        for (kind, stats) in &all {
            let (expected, nodes) = match kind {
                StructureKind::Bvh2 | StructureKind::Dst => (tree.sah_cost(), tree.nodes.len()),
                StructureKind::Bvh8 => (wide.sah_cost(), wide.nodes.len()),
                StructureKind::Bvh4 => continue,
            };
            assert!(close(stats.sah_cost, expected), "{kind} {} {expected}", stats.sah_cost);
            if *kind != StructureKind::Dst {
                assert_eq!(stats.nodes as usize, nodes - 1);
                assert_eq!(stats.bytes, 28 * stats.nodes);
            }
        }
        assert_eq!(all[0].1.max_depth, tree.max_depth());
    }

    #[test]
    fn histograms_count_every_leaf_and_every_triangle() {
        for max_leaf_size in [1, 4] {
            let (tree, all) = tree(max_leaf_size);
            for (kind, stats) in all {
                assert_eq!(stats.leaves as usize, tree.leaf_count(), "{kind}");
                assert_eq!(stats.leaves_by_depth.iter().sum::<u64>(), stats.leaves);
                let triangles: usize =
                    stats.leaves_by_size.iter().enumerate().map(|(n, &count)| n * count as usize).sum();
                assert_eq!(triangles, tree.primitives.len());
                assert!(stats.leaves_by_size.len() <= max_leaf_size as usize + 1);
                if let Some(carves) = stats.carves {
                    let by_carves: u64 =
                        (0..).zip(carves.children_by_carves).map(|(n, count)| n * count).sum();
                    assert_eq!(by_carves, carves.single + carves.dual);
                    assert_eq!(carves.children_by_carves.iter().sum::<u64>(), tree.nodes.len() as u64 - 1);
                }
            }
        }
    }

    /// A binary node is visited together with its sibling, so that every inner node stands for two visits.
    #[test]
    fn expected_visits_of_a_binary_tree() {
        let (tree, all) = tree(1);
        let leaves: f64 =
            tree.nodes.iter().filter(|n| tree.children(n).is_empty()).map(|n| n.aabb.half_area()).sum();
        let inner = tree.sah_cost() - leaves / tree.nodes[0].aabb.half_area();
        assert!(close(all[0].1.expected_node_visits, 2.0 * inner));
    }

    #[test]
    fn a_single_triangle() {
        let mesh = scenes::Mesh {
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            triangles: vec![[0, 1, 2]],
        };
        let tree = build(&mesh, &BuildOptions::default()).unwrap();
        for kind in StructureKind::ALL {
            let triangles = pack_triangles(&mesh, &tree);
            let stats = TreeStatistics::of(&Structure::convert(kind, &tree, &triangles).unwrap());
            assert_eq!((stats.leaves, stats.max_depth, stats.sah_cost), (1, 0, 1.0));
            assert_eq!(stats.bytes, if kind == StructureKind::Dst { 4 } else { 0 });
        }
    }
}
