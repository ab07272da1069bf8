//! The search for the best place of a node.

use glam::Vec3A;

use crate::build::MAX_DEPTH;
use crate::build::bounds::Bounds;
use crate::build::work::WorkTree;

/// Pairs that one search may look at. Together with [`MAX_DEPTH`], beyond which no search climbs and no move
/// reaches, this makes a round O(n log n) whatever the tree. On real scenes no search comes near it.
const SEARCH_PAIRS_MAX: usize = 1024;

/// Where `node` had best be the sibling of `target`.
#[derive(Clone, Copy)]
pub(super) struct Target {
    pub(super) gain: f32,
    pub(super) node: u32,
    pub(super) target: u32,
}

/// Searches in `f32`, on boxes scaled so that no area overflows.
pub(super) struct Finder<'a> {
    tree: &'a WorkTree,
    pub(super) scale: Vec3A,
}

impl<'a> Finder<'a> {
    pub(super) fn new(tree: &'a WorkTree) -> Self {
        let root = tree.bounds(WorkTree::ROOT);
        let extent = (root.max - root.min).max_element();
        Self { tree, scale: Vec3A::splat(if extent > 0.0 { extent.recip() } else { 1.0 }) }
    }

    #[inline(always)]
    fn area(&self, bounds: Bounds) -> f32 {
        bounds.scaled_half_area(self.scale)
    }

    pub(super) fn best_target(&self, node: u32, stack: &mut Vec<(u32, f32)>) -> Target {
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
        for _ in 0..MAX_DEPTH {
            if below == WorkTree::ROOT {
                break;
            }
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

    /// Considers `slot` as target when `saved` is the gain before the new node's area; returns `saved` for
    /// its children.
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
