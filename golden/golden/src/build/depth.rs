//! Keeping a tree within a number of levels.

use super::bounds::Bounds;
use super::work::{Link, WorkTree, levels_needed};

/// Rebuilds subtrees by median splits so that no leaf is more than `levels` below the root. As little as
/// possible and as far down as possible is touched; a tree that is within the bound stays as it is.
///
/// # Panics
/// If `2^levels` leaves are too few.
pub(super) fn limit_depth(tree: &mut WorkTree, levels: u32) {
    assert!(levels_needed(tree.leaf_count()) <= levels, "{levels} levels for {} leaves", tree.leaf_count());
    let slots = 2 * tree.links.len();
    let (mut height, mut leaves) = (vec![0_u32; slots], vec![1_usize; slots]);
    for pair in tree.pairs_depth_first().into_iter().rev() {
        let [left, right] = [2 * pair as usize, 2 * pair as usize + 1];
        let parent = tree.parents[pair as usize] as usize;
        height[parent] = 1 + height[left].max(height[right]);
        leaves[parent] = leaves[left] + leaves[right];
    }
    let mut stack = vec![(WorkTree::ROOT, levels)];
    while let Some((slot, levels)) = stack.pop() {
        if height[slot as usize] <= levels {
            continue;
        }
        let pair = tree.link(slot).children().expect("a subtree with height has children");
        let children = [2 * pair, 2 * pair + 1];
        if children.iter().all(|&child| levels_needed(leaves[child as usize]) < levels) {
            stack.extend(children.map(|child| (child, levels - 1)));
        } else {
            rebuild_balanced(tree, slot);
        }
    }
}

/// Replaces the subtree at `slot` by one of the least height over the same leaves.
fn rebuild_balanced(tree: &mut WorkTree, slot: u32) {
    let (mut leaves, mut pairs, mut stack) = (Vec::new(), Vec::new(), vec![slot]);
    while let Some(slot) = stack.pop() {
        match tree.link(slot).children() {
            Some(pair) => {
                pairs.push(pair);
                stack.extend([2 * pair + 1, 2 * pair]);
            }
            None => leaves.push((tree.bounds(slot), tree.link(slot))),
        }
    }
    place_balanced(tree, &mut leaves, &mut pairs, slot);
}

/// Builds at `slot` by median splits on the axis on which the centres lie farthest apart; takes pairs off
/// `pairs`.
fn place_balanced(
    tree: &mut WorkTree,
    leaves: &mut [(Bounds, Link)],
    pairs: &mut Vec<u32>,
    slot: u32,
) -> Bounds {
    if let [(bounds, link)] = *leaves {
        tree.set_link(slot, link);
        tree.set_bounds(slot, bounds);
        return bounds;
    }
    let centres = leaves.iter().fold(Bounds::EMPTY, |centres, leaf| centres.grow(leaf.0.centre()));
    let axis = (centres.max * 0.5 - centres.min * 0.5).max_position();
    let middle = leaves.len() / 2;
    leaves.select_nth_unstable_by(middle, |a, b| {
        a.0.centre()[axis].total_cmp(&b.0.centre()[axis]).then(a.1.cmp(&b.1))
    });
    let pair = pairs.pop().expect("one pair fewer than leaves");
    tree.set_link(slot, Link::pair(pair));
    let (left, right) = leaves.split_at_mut(middle);
    let left = place_balanced(tree, left, pairs, 2 * pair);
    let right = place_balanced(tree, right, pairs, 2 * pair + 1);
    let bounds = left.union(right);
    tree.set_bounds(slot, bounds);
    bounds
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::testing::{grid, random_tree};

    #[test]
    fn long_chain_is_cut_and_its_top_stays() {
        let mesh = grid(100);
        // One triangle on each level.
        let mut tree = random_tree(&mesh, &[0.0]);
        let chain = tree.to_tree();
        assert_eq!(chain.max_depth(), 99);
        limit_depth(&mut tree, 20);
        let limited = tree.to_tree();
        limited.validate(&mesh).expect("a hierarchy");
        assert!((18..=20).contains(&limited.max_depth()), "depth {}", limited.max_depth());
        assert_eq!(limited.nodes[..25], chain.nodes[..25]);
        limit_depth(&mut tree, 7);
        assert_eq!(tree.to_tree().max_depth(), 7);
        tree.to_tree().validate(&mesh).expect("a hierarchy");
    }

    #[test]
    fn tree_within_the_bound_stays() {
        let mut tree = random_tree(&grid(100), &[0.3, 0.5]);
        let before = tree.to_tree();
        limit_depth(&mut tree, before.max_depth());
        assert_eq!(tree.to_tree(), before);
    }
}
