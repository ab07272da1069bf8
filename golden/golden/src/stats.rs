//! What there is to know about a structure without tracing a ray.

pub use crate::dst::CarveStatistics;

use crate::Aabb;
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
        structure.statistics()
    }
}

/// Sums over the nodes of a structure.
pub(crate) struct Sums<'a> {
    root_half_area: f64,
    triangles: &'a [Triangle],
    /// Of the inner nodes.
    pub sah_cost: f64,
    pub node_visits: f64,
    triangle_tests: f64,
    by_depth: Vec<u64>,
    by_size: Vec<u64>,
}

impl<'a> Sums<'a> {
    pub fn new(root: Aabb, triangles: &'a [Triangle]) -> Self {
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
    pub fn share(&self, aabb: &Aabb) -> f64 {
        self.share_of(aabb.half_area(), 1)
    }

    /// The sum of these probabilities over `count` boxes.
    pub fn share_of(&self, half_areas: f64, count: usize) -> f64 {
        if self.root_half_area > 0.0 { half_areas / self.root_half_area } else { count as f64 }
    }

    /// A leaf whose box is met with probability `share`.
    pub fn leaf(&mut self, first_triangle: u32, share: f64, depth: usize) {
        let rest = &self.triangles[first_triangle as usize..];
        let size = rest.iter().position(Triangle::is_last).expect("leaves have a last triangle") + 1;
        self.triangle_tests += share * size as f64;
        for (histogram, at) in [(&mut self.by_depth, depth), (&mut self.by_size, size)] {
            histogram.resize(histogram.len().max(at + 1), 0);
            histogram[at] += 1;
        }
    }

    pub fn finish(self, nodes: usize, bytes: usize, carves: Option<CarveStatistics>) -> TreeStatistics {
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
    use crate::build::{BinaryTree, BuildOptions, Quality, build};
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

    #[test]
    fn a_single_triangle() {
        let mesh = scenes::Mesh {
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            triangles: vec![[0, 1, 2]],
        };
        let tree = build(&mesh, &BuildOptions::default()).unwrap();
        for kind in StructureKind::ALL {
            let triangles = pack_triangles(&mesh, &tree);
            let structure = Structure::convert(kind, &tree, &triangles).unwrap();
            let stats = TreeStatistics::of(&structure);
            assert_eq!((stats.leaves, stats.max_depth, stats.sah_cost), (1, 0, 1.0));
            assert_eq!(stats.bytes as usize, structure.node_bytes());
        }
    }
}
