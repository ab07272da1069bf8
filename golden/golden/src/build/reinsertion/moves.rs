//! Moving a node, and what that saves.

use crate::build::MAX_DEPTH;
use crate::build::work::{Link, WorkTree};

/// Carries out moves one after the other.
pub(super) struct Mover<'a> {
    pub(super) tree: &'a mut WorkTree,
    /// The last move for which a slot was on the path from the target to the root.
    path_of: Vec<u32>,
    moves_tried: u32,
    /// The slots whose content or box is new, and the nodes of moves that came too late.
    pub(super) changed: Vec<bool>,
}

impl<'a> Mover<'a> {
    pub(super) fn new(tree: &'a mut WorkTree) -> Self {
        let slots = 2 * tree.links.len();
        Self { tree, path_of: vec![0; slots], moves_tried: 0, changed: vec![false; slots] }
    }

    /// Makes `node` the sibling of `target` if that is possible and lowers the cost.
    pub(super) fn try_move(&mut self, node: u32, target: u32) {
        self.changed[node as usize] = true;
        let parent = self.tree.parent(node);
        if target == parent || target == node ^ 1 || !self.mark_path(node, target) {
            return;
        }
        if let Some((gain, common)) = self.gain(node, target)
            && gain > 0.0
        {
            self.carry_out(node, target, common);
        }
    }

    /// Marks `target` and its ancestors; false if `node` is one of them or they are too many.
    pub(super) fn mark_path(&mut self, node: u32, target: u32) -> bool {
        self.moves_tried += 1;
        let mut slot = target;
        for _ in 0..MAX_DEPTH {
            if slot == node {
                return false;
            }
            self.path_of[slot as usize] = self.moves_tried;
            if slot == WorkTree::ROOT {
                return true;
            }
            slot = self.tree.parent(slot);
        }
        false
    }

    fn on_path(&self, slot: u32) -> bool {
        self.path_of[slot as usize] == self.moves_tried
    }

    /// By how much the sum of inner areas falls, and the lowest slot that holds both `target` and what is
    /// left of `node`'s parent; `None` if that is too far up.
    pub(super) fn gain(&self, node: u32, target: u32) -> Option<(f64, u32)> {
        let tree = &*self.tree;
        let bounds = tree.bounds(node);
        let mut slot = tree.parent(node);
        let mut pivot = tree.bounds(node ^ 1);
        let mut gain = tree.bounds(slot).half_area();
        let mut common = slot;
        let mut levels = 0;
        while !self.on_path(common) {
            levels += 1;
            if levels == MAX_DEPTH {
                return None;
            }
            pivot = pivot.union(tree.bounds(slot ^ 1));
            common = tree.parent(slot);
            if !self.on_path(common) {
                gain += tree.bounds(common).half_area() - pivot.half_area();
            }
            slot = common;
        }
        if common == target {
            // The target shrinks to the pivot, and the new node takes the target's former box.
            return Some((gain - pivot.half_area(), common));
        }
        gain -= tree.bounds(target).union(bounds).half_area();
        slot = tree.parent(target);
        while slot != common {
            let before = tree.bounds(slot);
            gain -= before.union(bounds).half_area() - before.half_area();
            slot = tree.parent(slot);
        }
        Some((gain, common))
    }

    pub(super) fn carry_out(&mut self, node: u32, target: u32, common: u32) {
        let tree = &mut *self.tree;
        let bounds = tree.bounds(node);
        let sibling = node ^ 1;
        let parent = tree.parent(node);
        for slot in [sibling, parent, target] {
            self.changed[slot as usize] = true;
        }

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
                self.changed[slot as usize] = true;
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
                self.changed[slot as usize] = true;
            }
        }
    }
}
