//! What a hierarchy of boxes is expected to cost.

use super::{Hierarchy, LEAF};
use crate::stats::{Sums, TreeStatistics};

/// The statistics of `tree`, whose nodes take `bytes`.
pub(in crate::structure) fn of<const N: usize, H: Hierarchy<N>>(tree: &H, bytes: usize) -> TreeStatistics {
    let (root, root_box) = tree.root();
    let mut sums = Sums::new(*root_box, tree.triangles());
    let mut nodes = 0;
    let mut stack = vec![(root, *root_box, 0)];
    while let Some((word, aabb, depth)) = stack.pop() {
        let share = sums.share(&aabb);
        if LEAF.get(word) == 1 {
            sums.leaf(H::INDEX.get(word), share, depth);
        } else {
            let siblings = tree.siblings(word);
            nodes += siblings.len();
            sums.sah_cost += share;
            sums.node_visits += share * siblings.len() as f64;
            stack.extend(siblings.iter().map(|child| (child.word, child.aabb, depth + 1)));
        }
    }
    sums.finish(nodes, bytes, None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{BinaryTree, BuildOptions, Quality, build, collapse_wide};
    use crate::bvh::Bvh;
    use crate::structure::pack_triangles;
    use crate::triangle::Triangle;
    use scenes::Scene;
    use std::sync::Arc;

    fn statistics<const N: usize>(bvh: &Bvh<N>) -> TreeStatistics {
        of(bvh, bvh.node_bytes())
    }

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
        let stats = statistics(&Bvh::<N>::encode(&wide, Arc::clone(triangles)));
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
        let stats = statistics(&Bvh::<2>::encode(&tree, triangles));
        assert!(close(stats.expected_node_visits, 2.0 * inner));
    }
}
