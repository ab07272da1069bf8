//! The leaves that a ray reaches, by the specification's step.

use super::{Bvh, Hierarchy, LEAF, box_step};
use crate::ray::TraversalRay;
use crate::traverse::{Leaf, Leaves};

impl<const N: usize> Leaves for Bvh<N> {
    fn leaves(&self, ray: &TraversalRay) -> Vec<Leaf> {
        of(self, ray)
    }
}

/// The leaves of `tree` that `ray` reaches.
pub(in crate::structure) fn of<const N: usize, H: Hierarchy<N>>(tree: &H, ray: &TraversalRay) -> Vec<Leaf> {
    let mut leaves = vec![];
    let (root, root_box) = tree.root();
    let mut stack = vec![(root, *root_box)];
    while let Some((word, aabb)) = stack.pop() {
        let test = box_step(&aabb, ray, ray.t_min, ray.t_max);
        if !test.hit {
            continue;
        }
        if LEAF.get(word) == 1 {
            let (t_entry, t_exit) = (test.t_entry, test.t_exit);
            leaves.push(Leaf { first_triangle: H::INDEX.get(word), t_entry, t_exit });
        } else {
            stack.extend(tree.siblings(word).iter().map(|child| (child.word, child.aabb)));
        }
    }
    leaves.sort_by_key(|leaf| leaf.first_triangle);
    leaves
}
