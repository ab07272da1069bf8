//! Merging leaves where that lowers the SAH cost.

use super::bounds::Bounds;
use super::work::{BoundsPair, Link, WorkTree};

/// Makes leaves of up to `max_leaf_size` triangles out of subtrees, so that the SAH cost is the least that any such
/// choice reaches. The result is laid out depth-first.
pub(super) fn collapse_leaves(tree: &WorkTree, max_leaf_size: u32) -> WorkTree {
    let order = tree.pairs_depth_first();
    let slots = 2 * tree.links.len();
    // Least cost of each slot's subtree, in area; its triangles; whether it becomes a leaf.
    let mut cost = vec![0.0_f64; slots];
    let mut triangles = vec![0_u32; slots];
    let mut visit = |slot: u32| {
        let area = tree.bounds(slot).half_area();
        let (inner_cost, count) = match (tree.link(slot).children(), tree.link(slot).as_leaf()) {
            (Some(pair), _) => {
                let [a, b] = [2 * pair as usize, 2 * pair as usize + 1];
                (area + cost[a] + cost[b], triangles[a] + triangles[b])
            }
            (None, leaf) => (f64::INFINITY, tree.leaf_primitives(leaf.unwrap_or(0)).len() as u32),
        };
        let leaf_cost = area * f64::from(count);
        let mergeable = count <= max_leaf_size || inner_cost == f64::INFINITY;
        cost[slot as usize] = if mergeable { leaf_cost.min(inner_cost) } else { inner_cost };
        triangles[slot as usize] = count;
    };
    for &pair in order.iter().rev() {
        visit(2 * pair);
        visit(2 * pair + 1);
    }
    visit(WorkTree::ROOT);

    let mut result = WorkTree {
        bounds: vec![BoundsPair([tree.bounds(WorkTree::ROOT), Bounds::EMPTY])],
        links: vec![[Link::leaf(0); 2]],
        parents: vec![0],
        leaf_starts: vec![0],
        primitives: Vec::with_capacity(tree.primitives.len()),
    };
    // (slot in the tree, slot in the result)
    let mut stack = vec![(WorkTree::ROOT, WorkTree::ROOT)];
    let mut below = Vec::new();
    while let Some((from, to)) = stack.pop() {
        let leaf_cost = tree.bounds(from).half_area() * f64::from(triangles[from as usize]);
        match tree.link(from).children() {
            Some(pair) if triangles[from as usize] > max_leaf_size || cost[from as usize] < leaf_cost => {
                let new_pair = result.links.len() as u32;
                result.bounds.push(tree.bounds[pair as usize]);
                result.links.push([Link::leaf(0); 2]);
                result.parents.push(to);
                result.set_link(to, Link::pair(new_pair));
                stack.push((2 * pair + 1, 2 * new_pair + 1));
                stack.push((2 * pair, 2 * new_pair));
            }
            _ => {
                let leaf = result.leaf_starts.len() as u32 - 1;
                let first = result.primitives.len();
                below.push(from);
                while let Some(slot) = below.pop() {
                    match (tree.link(slot).children(), tree.link(slot).as_leaf()) {
                        (Some(pair), _) => below.extend([2 * pair, 2 * pair + 1]),
                        (None, leaf) => {
                            result.primitives.extend_from_slice(tree.leaf_primitives(leaf.unwrap_or(0)));
                        }
                    }
                }
                result.primitives[first..].sort_unstable();
                result.leaf_starts.push(result.primitives.len() as u32);
                result.set_link(to, Link::leaf(leaf));
            }
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::build::testing::{random_tree, triangles};

    /// The cost in area, and the triangles, of every way to merge leaves below `slot`.
    fn all_costs(tree: &WorkTree, slot: u32, max_leaf_size: usize) -> (Vec<f64>, usize) {
        let area = tree.bounds(slot).half_area();
        let Some(pair) = tree.link(slot).children() else { return (vec![area], 1) };
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
            let collapsed = collapse_leaves(&tree, max_leaf_size).to_tree();
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
