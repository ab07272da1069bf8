//! What a hierarchy of boxes is expected to cost.

use super::{Bvh, LEAF};
use crate::stats::{Sums, TreeStatistics};

/// The statistics of `bvh`.
pub(super) fn of<const N: usize>(bvh: &Bvh<N>) -> TreeStatistics {
    let mut sums = Sums::new(bvh.root_box, &bvh.triangles);
    let mut stack = vec![(bvh.root, bvh.root_box, 0)];
    while let Some((word, aabb, depth)) = stack.pop() {
        let share = sums.share(&aabb);
        if LEAF.get(word) == 1 {
            sums.leaf(Bvh::<N>::INDEX.get(word), share, depth);
        } else {
            let children = bvh.children(word);
            sums.sah_cost += share;
            sums.node_visits += share * children.len() as f64;
            stack.extend(children.iter().map(|child| (child.word, child.aabb, depth + 1)));
        }
    }
    sums.finish(bvh.nodes.len(), bvh.node_bytes(), None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{BinaryTree, BuildOptions, Quality, build, collapse_wide};
    use crate::structure::pack_triangles;
    use crate::triangle::Triangle;
    use scenes::Scene;
    use std::sync::Arc;

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() <= 1e-9 * b
    }

    fn tree(max_leaf_size: u32) -> (BinaryTree, Arc<[Triangle]>) {
        let scene = Scene::load("hairball", 0.001, 0).unwrap();
        let options = BuildOptions { max_leaf_size, ..BuildOptions::new(Quality::Fast) };
        let tree = build(&scene.mesh, &options).unwrap();
        let triangles = pack_triangles(&scene.mesh, &tree);
        (tree, triangles)
    }

    fn check<const N: usize>(tree: &BinaryTree, triangles: &Arc<[Triangle]>) {
        let wide = collapse_wide::<N>(tree);
        let stats = of(&Bvh::<N>::encode(&wide, Arc::clone(triangles)));
        assert!(close(stats.sah_cost, wide.sah_cost()), "{N}: {} {}", stats.sah_cost, wide.sah_cost());
        assert_eq!(stats.nodes as usize, wide.nodes.len() - 1);
        assert_eq!(stats.bytes, 28 * stats.nodes);
        assert_eq!(stats.max_depth, wide.max_depth());
    }

    #[test]
    fn costs_are_those_of_the_hierarchies() {
        let (tree, triangles) = tree(4);
        check::<2>(&tree, &triangles);
        check::<4>(&tree, &triangles);
        check::<8>(&tree, &triangles);
        check::<16>(&tree, &triangles);
    }

    /// A binary node is visited together with its sibling, so that every inner node stands for two visits.
    #[test]
    fn expected_visits_of_a_binary_tree() {
        let (tree, triangles) = tree(1);
        let leaves: f64 =
            tree.nodes.iter().filter(|n| tree.children(n).is_empty()).map(|n| n.aabb.half_area()).sum();
        let inner = tree.sah_cost() - leaves / tree.nodes[0].aabb.half_area();
        let stats = of(&Bvh::<2>::encode(&tree, triangles));
        assert!(close(stats.expected_node_visits, 2.0 * inner));
    }
}
