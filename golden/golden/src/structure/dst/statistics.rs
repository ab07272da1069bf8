//! What a dual-split tree is expected to cost, and its carves.

use super::header::{LEAF_WORDS, NODE_WORDS};
use super::{Dst, End, MAX_CARVES};
use crate::stats::{Sums, TreeStatistics};

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

/// The statistics of `dst`.
///
/// # Panics
/// If `dst` is not valid.
pub(super) fn of(dst: &Dst) -> TreeStatistics {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{BuildOptions, Quality, build};
    use crate::structure::pack_triangles;
    use scenes::Scene;

    #[test]
    fn the_cost_is_that_of_the_binary_hierarchy() {
        let scene = Scene::load("hairball", 0.001, 0).unwrap();
        let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
        let stats = of(&Dst::convert(&tree, pack_triangles(&scene.mesh, &tree)).unwrap());
        let expected = tree.sah_cost();
        assert!((stats.sah_cost - expected).abs() <= 1e-9 * expected, "{} {expected}", stats.sah_cost);
    }
}
