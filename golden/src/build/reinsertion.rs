//! Optimisation of a finished tree by moving subtrees to better places.
//!
//! Meister and Bittner 2018, "Parallel Reinsertion for Bounding Volume Hierarchy Optimization": for each node the
//! place is searched where putting it lowers the sum of inner areas most. Moving node A away removes its parent,
//! whose place its sibling takes, and shrinks the ancestors; making it the sibling of node T adds a node around
//! both and grows T's ancestors:
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
//! Beyond the paper, T may also be an ancestor of A. Instead of locking, nodes are taken in batches of a fixed size:
//! the tree is searched for all nodes of a batch in parallel, then the moves are carried out one after the other,
//! each after its gain is computed anew in `f64`. So no move raises the cost, and the result does not depend on the
//! number of threads.

use glam::Vec3A;
use rayon::prelude::*;

use super::bounds::Bounds;
use super::work::{Link, WorkTree};

/// Some rounds of [`optimise`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Stage {
    /// The share of the nodes, largest first, that a round tries to move.
    pub(super) share: f64,
    /// The greatest number of rounds.
    pub(super) rounds: u32,
}

/// The stage ends when a round lowers the cost by less than this share.
const LEAST_GAIN: f64 = 1e-3;
/// Nodes whose targets are searched before the next moves. A small batch wastes fewer searches on a tree that has
/// changed meanwhile; this one still keeps dozens of threads busy.
const BATCH: usize = 512;
/// Pairs that one search may look at. The bound makes a round O(n log n) whatever the tree; typical searches end
/// far below it.
const SEARCH_PAIRS_MAX: usize = 4096;

/// Lowers the sum of inner areas of `tree`, whose leaves stay as they are. Slots are permuted.
pub(super) fn optimise(tree: &mut WorkTree, stages: &[Stage]) {
    let mut cost = tree.inner_area();
    for stage in stages {
        for _ in 0..stage.rounds {
            run_round(tree, stage.share);
            let before = std::mem::replace(&mut cost, tree.inner_area());
            if cost > before * (1.0 - LEAST_GAIN) {
                break;
            }
        }
    }
}

fn run_round(tree: &mut WorkTree, share: f64) {
    let order = largest_first(tree, share);
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

/// Where `node` had best be the sibling of `target`.
#[derive(Clone, Copy)]
struct Target {
    gain: f32,
    node: u32,
    target: u32,
}

/// Searches in `f32`, on boxes scaled so that no area overflows.
struct Finder<'a> {
    tree: &'a WorkTree,
    scale: Vec3A,
}

impl<'a> Finder<'a> {
    fn new(tree: &'a WorkTree) -> Self {
        let root = tree.bounds(WorkTree::ROOT);
        let extent = (root.max - root.min).max_element();
        Self { tree, scale: Vec3A::splat(if extent > 0.0 { extent.recip() } else { 1.0 }) }
    }

    #[inline(always)]
    fn area(&self, bounds: Bounds) -> f32 {
        bounds.scaled_half_area(self.scale)
    }

    fn best_target(&self, node: u32, stack: &mut Vec<(u32, f32)>) -> Target {
        let tree = self.tree;
        let bounds = tree.bounds(node);
        let mut search = Search {
            finder: self,
            bounds,
            area: self.area(bounds),
            best: Target { gain: 0.0, node, target: node },
            pairs_left: SEARCH_PAIRS_MAX,
            stack,
        };
        search.stack.clear();

        // The box of what remains where the node was, and the area saved by removing it.
        let mut pivot = tree.bounds(node ^ 1);
        let mut below = tree.parent(node);
        let mut saved = self.area(tree.bounds(below));
        search.push(node ^ 1, self.area(pivot));
        search.descend();
        while below != WorkTree::ROOT {
            search.visit(below ^ 1, saved);
            search.descend();
            let parent = tree.parent(below);
            let parent_bounds = tree.bounds(parent);
            pivot = pivot.union(tree.bounds(below ^ 1));
            let pivot_area = self.area(pivot);
            if pivot == parent_bounds {
                // No ancestor from here on shrinks.
                if saved - search.area <= search.best.gain {
                    break;
                }
            } else {
                let parent_area = self.area(parent_bounds);
                saved += parent_area - pivot_area;
                search.offer(parent, saved - parent_area);
            }
            below = parent;
        }
        search.best
    }
}

/// The search for one node's target.
struct Search<'a> {
    finder: &'a Finder<'a>,
    bounds: Bounds,
    area: f32,
    best: Target,
    pairs_left: usize,
    /// Pairs to look at, each with the gain of a target in it less the area of the node made for it.
    stack: &'a mut Vec<(u32, f32)>,
}

impl Search<'_> {
    #[inline(always)]
    fn offer(&mut self, target: u32, gain: f32) {
        if gain > self.best.gain {
            self.best.gain = gain;
            self.best.target = target;
        }
    }

    /// Considers `slot` as target when `saved` is the gain before the new node's area; returns `saved` for its
    /// children.
    #[inline(always)]
    fn evaluate(&mut self, slot: u32, saved: f32) -> f32 {
        let bounds = self.finder.tree.bounds(slot);
        let gain = saved - self.finder.area(bounds.union(self.bounds));
        self.offer(slot, gain);
        gain + self.finder.area(bounds)
    }

    /// Puts the children of `slot` on the stack unless none of them can be better than the best.
    #[inline(always)]
    fn push(&mut self, slot: u32, saved: f32) {
        // The new node is at least as large as the moved one.
        if saved - self.area > self.best.gain
            && let Some(pair) = self.finder.tree.link(slot).children()
        {
            self.stack.push((pair, saved));
        }
    }

    fn visit(&mut self, slot: u32, saved: f32) {
        let saved = self.evaluate(slot, saved);
        self.push(slot, saved);
    }

    fn descend(&mut self) {
        while let Some((pair, saved)) = self.stack.pop() {
            if saved - self.area <= self.best.gain {
                continue;
            }
            if self.pairs_left == 0 {
                self.stack.clear();
                return;
            }
            self.pairs_left -= 1;
            let (left, right) = (2 * pair, 2 * pair + 1);
            let (saved_left, saved_right) = (self.evaluate(left, saved), self.evaluate(right, saved));
            // The better one is popped first.
            if saved_left > saved_right {
                self.push(right, saved_right);
                self.push(left, saved_left);
            } else {
                self.push(left, saved_left);
                self.push(right, saved_right);
            }
        }
    }
}

/// Carries out moves one after the other.
struct Mover<'a> {
    tree: &'a mut WorkTree,
    /// The last move for which a slot was on the path from the target to the root.
    path_of: Vec<u32>,
    moves_tried: u32,
}

impl<'a> Mover<'a> {
    fn new(tree: &'a mut WorkTree) -> Self {
        let slots = 2 * tree.links.len();
        Self { tree, path_of: vec![0; slots], moves_tried: 0 }
    }

    /// Makes `node` the sibling of `target` if that is possible and lowers the cost; returns whether it did.
    fn try_move(&mut self, node: u32, target: u32) -> bool {
        let parent = self.tree.parent(node);
        if target == parent || target == node ^ 1 || !self.mark_path(node, target) {
            return false;
        }
        let (gain, common) = self.gain(node, target);
        if gain > 0.0 {
            self.carry_out(node, target, common);
        }
        gain > 0.0
    }

    /// Marks `target` and its ancestors; false if `node` is one of them.
    fn mark_path(&mut self, node: u32, target: u32) -> bool {
        self.moves_tried += 1;
        let mut slot = target;
        loop {
            if slot == node {
                return false;
            }
            self.path_of[slot as usize] = self.moves_tried;
            if slot == WorkTree::ROOT {
                return true;
            }
            slot = self.tree.parent(slot);
        }
    }

    fn on_path(&self, slot: u32) -> bool {
        self.path_of[slot as usize] == self.moves_tried
    }

    /// By how much the sum of inner areas falls, and the lowest slot that holds both `target` and what is left of
    /// `node`'s parent.
    fn gain(&self, node: u32, target: u32) -> (f64, u32) {
        let tree = &*self.tree;
        let bounds = tree.bounds(node);
        let mut slot = tree.parent(node);
        let mut pivot = tree.bounds(node ^ 1);
        let mut gain = tree.bounds(slot).half_area();
        let mut common = slot;
        while !self.on_path(common) {
            pivot = pivot.union(tree.bounds(slot ^ 1));
            common = tree.parent(slot);
            if !self.on_path(common) {
                gain += tree.bounds(common).half_area() - pivot.half_area();
            }
            slot = common;
        }
        if common == target {
            // The target shrinks to the pivot, and the new node takes the target's former box.
            return (gain - pivot.half_area(), common);
        }
        gain -= tree.bounds(target).union(bounds).half_area();
        slot = tree.parent(target);
        while slot != common {
            let before = tree.bounds(slot);
            gain -= before.union(bounds).half_area() - before.half_area();
            slot = tree.parent(slot);
        }
        (gain, common)
    }

    fn carry_out(&mut self, node: u32, target: u32, common: u32) {
        let tree = &mut *self.tree;
        let bounds = tree.bounds(node);
        let sibling = node ^ 1;
        let parent = tree.parent(node);

        tree.set_link(parent, tree.link(sibling));
        if parent != common {
            // Otherwise the node stays below, and the sibling grows to the parent's box.
            tree.set_bounds(parent, tree.bounds(sibling));
        }
        let mut slot = parent;
        while slot != common {
            slot = tree.parent(slot);
            if slot != common || slot == target {
                tree.refit(slot);
            }
        }

        tree.set_link(sibling, tree.link(target));
        tree.set_bounds(sibling, tree.bounds(target));
        tree.set_link(target, Link::pair(node >> 1));
        tree.set_bounds(target, tree.bounds(target).union(bounds));
        slot = target;
        while slot != common {
            slot = tree.parent(slot);
            if slot != common {
                tree.set_bounds(slot, tree.bounds(slot).union(bounds));
            }
        }
    }
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
                    let (gain, common) = mover.gain(node, target);
                    mover.carry_out(node, target, common);
                    moved.to_tree().validate(&mesh).expect("a hierarchy");
                    prop_assert!((cost - moved.inner_area() - gain).abs() <= 1e-12 * cost);
                    best = best.max(gain);
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
            assert!(!mover.try_move(2 * inner, target), "{target}");
        }
        assert_eq!(tree.to_tree(), before);
    }
}
