//! Optimisation of a finished tree by moving subtrees to better places.
//!
//! Meister and Bittner 2018, "Parallel Reinsertion for Bounding Volume Hierarchy Optimization": for each node
//! the place is searched where putting it lowers the sum of inner areas most. Moving node A away removes its
//! parent, whose place its sibling takes, and shrinks the ancestors; making it the sibling of node T adds a
//! node around both and grows T's ancestors:
//!
//! ```text
//!        R                  R
//!      /   \              /   \
//!     P     Q    ->      B     Q
//!    / \   / \                / \
//!   A   B T   U              N   U
//!                           / \
//!                          A   T
//! ```
//!
//! Beyond the paper, T may also be an ancestor of A. Instead of locking, nodes are taken in batches of a
//! fixed size: the tree is searched for all nodes of a batch in parallel, then the moves are carried out one
//! after the other, each after its gain is computed anew in `f64`. So no move raises the cost, and the result
//! does not depend on the number of threads.

mod moves;
mod search;

use rayon::prelude::*;

use super::work::WorkTree;
use moves::Mover;
use search::{Finder, Target};

/// Some rounds of [`optimise`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Stage {
    /// The share of the nodes, largest first, that is considered.
    pub(super) share: f64,
    /// The greatest number of rounds.
    pub(super) rounds: u32,
}

/// The stage ends when a round lowers the cost by less than this share.
const LEAST_GAIN: f64 = 2e-4;
/// Nodes whose targets are searched before the next moves. A small batch wastes fewer searches on a tree that
/// has changed meanwhile; this one still keeps dozens of threads busy.
const BATCH: usize = 512;

/// Lowers the sum of inner areas of `tree`, whose leaves stay as they are. Slots are permuted.
///
/// The first round of a stage tries to move all of its nodes, the others only those near which something
/// changed in the round before.
pub(super) fn optimise(tree: &mut WorkTree, stages: &[Stage]) {
    let mut cost = tree.inner_area();
    for stage in stages {
        let mut changed = vec![true; 2 * tree.links.len()];
        for _ in 0..stage.rounds {
            changed = run_round(tree, stage.share, &changed);
            let before = std::mem::replace(&mut cost, tree.inner_area());
            if cost > before * (1.0 - LEAST_GAIN) {
                break;
            }
        }
    }
}

/// Tries to move the nodes that are, or whose sibling or parent is, in `changed`; returns the slots that
/// changed.
fn run_round(tree: &mut WorkTree, share: f64, changed: &[bool]) -> Vec<bool> {
    let mut order = largest_first(tree, share);
    order.retain(|&slot| [slot, slot ^ 1, tree.parent(slot)].iter().any(|&near| changed[near as usize]));
    let mut mover = Mover::new(tree);
    for batch in order.chunks(BATCH) {
        let finder = Finder::new(mover.tree);
        let mut targets: Vec<Target> = batch
            .par_iter()
            .with_min_len(BATCH / 32)
            .map_init(Vec::new, |stack, &node| finder.best_target(node, stack))
            .filter(|target| target.gain > 0.0)
            .collect();
        targets.sort_unstable_by(|a, b| b.gain.total_cmp(&a.gain).then(a.node.cmp(&b.node)));
        for target in targets {
            mover.try_move(target.node, target.target);
        }
    }
    mover.changed
}

/// The `share` of the slots below the root with the largest boxes, largest first.
fn largest_first(tree: &WorkTree, share: f64) -> Vec<u32> {
    let slots = 2 * tree.links.len() as u32;
    let mut keys: Vec<(u64, u32)> = (2..slots)
        .into_par_iter()
        // Areas are not negative, so that their bits are ordered as they are.
        .map(|slot| (u64::MAX - tree.bounds(slot).half_area().to_bits(), slot))
        .collect();
    let count = (keys.len() as f64 * share).ceil() as usize;
    if count < keys.len() {
        keys.select_nth_unstable(count);
        keys.truncate(count);
    }
    keys.par_sort_unstable();
    keys.into_iter().map(|(_, slot)| slot).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::build::testing::{random_tree, triangles};

    fn all_slots(tree: &WorkTree) -> std::ops::Range<u32> {
        2..2 * tree.links.len() as u32
    }

    proptest! {
        /// Every move of every node to every place, in trees of random shape.
        #[test]
        fn gain_is_what_the_move_saves((mesh, splits) in triangles(2..10)) {
            let tree = random_tree(&mesh, &splits);
            let cost = tree.inner_area();
            for node in all_slots(&tree) {
                let mut best = 0.0_f64;
                for target in 0..2 * tree.links.len() as u32 {
                    let mut moved = tree.clone();
                    let mut mover = Mover::new(&mut moved);
                    let fixed = target == 1 || target == node ^ 1 || target == tree.parent(node);
                    if fixed || !mover.mark_path(node, target) {
                        continue;
                    }
                    let (gain, common) = mover.gain(node, target).expect("a shallow tree");
                    mover.carry_out(node, target, common);
                    moved.to_tree().validate(&mesh).expect("a hierarchy");
                    prop_assert!((cost - moved.inner_area() - gain).abs() <= 1e-12 * cost);
                    best = best.max(gain);

                    let mut tried = tree.clone();
                    Mover::new(&mut tried).try_move(node, target);
                    let expected = if gain > 0.0 { &moved } else { &tree };
                    prop_assert_eq!(tried.to_tree(), expected.to_tree());
                }
                let found = Finder::new(&tree).best_target(node, &mut Vec::new());
                let scale = f64::from(Finder::new(&tree).scale.x).powi(2);
                prop_assert!((f64::from(found.gain) - best * scale).abs() <= 1e-5, "{} {best}", found.gain);
            }
        }

        #[test]
        fn optimisation_never_raises_the_cost((mesh, splits) in triangles(1..60)) {
            let mut tree = random_tree(&mesh, &splits);
            let before = tree.inner_area();
            optimise(&mut tree, &[Stage { share: 1.0, rounds: 3 }]);
            tree.to_tree().validate(&mesh).expect("a hierarchy");
            prop_assert!(tree.inner_area() <= before);
        }
    }

    #[test]
    fn impossible_moves_are_refused() {
        let mesh = crate::build::testing::grid(8);
        let mut tree = random_tree(&mesh, &[0.5]);
        let before = tree.to_tree();
        let inner = tree.link(WorkTree::ROOT).children().expect("children");
        let below = tree.link(2 * inner).children().expect("grandchildren");
        let mut mover = Mover::new(&mut tree);
        for target in [2 * below, 2 * inner + 1, WorkTree::ROOT] {
            mover.try_move(2 * inner, target);
        }
        assert_eq!(tree.to_tree(), before);
    }
}
