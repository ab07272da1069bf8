//! Merging leaves where that lowers the SAH cost.

use super::bounds::Bounds;
use super::work::{BoundsPair, Link, Slot, WorkTree};

/// Makes leaves of up to `max_leaf_size` triangles out of subtrees, so that the sum of `cost` over the inner nodes and of
/// half area x triangles over the leaves is the least that any such choice reaches; a leaf that is larger
/// already stays. Ties go to the leaf. The result is laid out depth-first.
///
/// `cost` is a function of a node's box and its children's; with the node's half area, the sum is the SAH cost.
pub(super) fn collapse_leaves(
    tree: &WorkTree,
    max_leaf_size: u32,
    cost: impl Fn(Bounds, [Bounds; 2]) -> f64,
) -> WorkTree {
    let subtrees = Subtrees::new(tree, max_leaf_size, cost);
    let pairs = tree.links.len();
    let mut result = WorkTree {
        bounds: Vec::with_capacity(pairs),
        links: Vec::with_capacity(pairs),
        parents: Vec::with_capacity(pairs),
        leaf_starts: Vec::with_capacity(pairs + 1),
        primitives: Vec::with_capacity(tree.primitives.len()),
    };
    result.push_pair(BoundsPair([tree.bounds(WorkTree::ROOT), Bounds::EMPTY]));
    result.leaf_starts.push(0);
    // (slot in the tree, slot in the result)
    let mut stack = vec![(WorkTree::ROOT, WorkTree::ROOT)];
    while let Some((from, to)) = stack.pop() {
        match tree.slot(from) {
            Slot::Inner(pair) if !subtrees.becomes_leaf[from as usize] => {
                let new_pair = result.push_pair(tree.bounds[pair as usize]);
                result.set_link(to, Link::pair(new_pair));
                stack.extend([(2 * pair + 1, 2 * new_pair + 1), (2 * pair, 2 * new_pair)]);
            }
            _ => {
                let first = result.primitives.len();
                tree.append_primitives(from, &mut result.primitives);
                result.primitives[first..].sort_unstable();
                result.set_link(to, Link::leaf(result.leaf_count() as u32));
                result.leaf_starts.push(result.primitives.len() as u32);
            }
        }
    }
    result
}

/// What an inner node costs under the surface area heuristic.
pub(super) fn surface_area(node: Bounds, _children: [Bounds; 2]) -> f64 {
    node.half_area()
}

/// Facts about the subtree of each slot.
struct Subtrees {
    /// The least cost, in area.
    cost: Vec<f64>,
    triangles: Vec<u32>,
    becomes_leaf: Vec<bool>,
}

impl Subtrees {
    fn new(tree: &WorkTree, max_leaf_size: u32, cost: impl Fn(Bounds, [Bounds; 2]) -> f64) -> Self {
        let slots = 2 * tree.links.len();
        let mut subtrees =
            Self { cost: vec![0.0; slots], triangles: vec![0; slots], becomes_leaf: vec![false; slots] };
        for pair in tree.pairs_depth_first().into_iter().rev() {
            subtrees.visit(tree, 2 * pair, max_leaf_size, &cost);
            subtrees.visit(tree, 2 * pair + 1, max_leaf_size, &cost);
        }
        subtrees.visit(tree, WorkTree::ROOT, max_leaf_size, &cost);
        subtrees
    }

    fn visit(
        &mut self,
        tree: &WorkTree,
        slot: u32,
        max_leaf_size: u32,
        cost: &impl Fn(Bounds, [Bounds; 2]) -> f64,
    ) {
        let bounds = tree.bounds(slot);
        let area = bounds.half_area();
        let (triangles, cost, becomes_leaf) = match tree.slot(slot) {
            Slot::Inner(pair) => {
                let [left, right] = [2 * pair as usize, 2 * pair as usize + 1];
                let triangles = self.triangles[left] + self.triangles[right];
                let own_cost = cost(bounds, tree.bounds[pair as usize].0);
                let inner_cost = own_cost + self.cost[left] + self.cost[right];
                let leaf_cost = area * f64::from(triangles);
                let becomes_leaf = triangles <= max_leaf_size && leaf_cost <= inner_cost;
                (triangles, if becomes_leaf { leaf_cost } else { inner_cost }, becomes_leaf)
            }
            Slot::Leaf(leaf) => {
                let triangles = tree.leaf_primitives(leaf).len() as u32;
                (triangles, area * f64::from(triangles), true)
            }
        };
        let slot = slot as usize;
        (self.triangles[slot], self.cost[slot], self.becomes_leaf[slot]) = (triangles, cost, becomes_leaf);
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::build::testing::{random_tree, triangles};

    /// The cost in area, and the triangles, of every way to merge leaves below `slot`.
    fn all_costs(tree: &WorkTree, slot: u32, max_leaf_size: usize) -> (Vec<f64>, usize) {
        let area = tree.bounds(slot).half_area();
        let Slot::Inner(pair) = tree.slot(slot) else { return (vec![area], 1) };
        let (left, left_count) = all_costs(tree, 2 * pair, max_leaf_size);
        let (right, right_count) = all_costs(tree, 2 * pair + 1, max_leaf_size);
        let count = left_count + right_count;
        let mut costs: Vec<f64> = left.iter().flat_map(|l| right.iter().map(move |r| area + l + r)).collect();
        if count <= max_leaf_size {
            costs.push(area * count as f64);
        }
        (costs, count)
    }

    proptest! {
        #[test]
        fn cost_is_the_least_of_all_collapses((mesh, splits) in triangles(1..9), max_leaf_size in 1_u32..6) {
            let tree = random_tree(&mesh, &splits);
            let collapsed = collapse_leaves(&tree, max_leaf_size, surface_area).to_tree();
            collapsed.validate(&mesh).expect("a hierarchy");
            let (costs, _) = all_costs(&tree, WorkTree::ROOT, max_leaf_size as usize);
            let least = costs.into_iter().fold(f64::INFINITY, f64::min);
            let root_area = tree.bounds(WorkTree::ROOT).half_area();
            prop_assume!(root_area > 0.0);
            prop_assert!((collapsed.sah_cost() * root_area - least).abs() <= 1e-12 * least);
            let largest = collapsed.nodes.iter().map(|node| collapsed.triangles(node).len()).max();
            prop_assert!(largest <= Some(max_leaf_size as usize));
        }
    }
}
