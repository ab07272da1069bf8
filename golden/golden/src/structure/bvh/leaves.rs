//! The leaves that a ray reaches, by the specification's step.

use super::{Bvh, LEAF, box_step};
use crate::ray::TraversalRay;
use crate::traverse::{Leaf, Leaves};

impl<const N: usize> Leaves for Bvh<N> {
    fn leaves(&self, ray: &TraversalRay) -> Vec<Leaf> {
        let mut leaves = vec![];
        let mut stack = vec![(self.root, self.root_box)];
        while let Some((word, aabb)) = stack.pop() {
            let test = box_step(&aabb, ray, ray.t_min, ray.t_max);
            if !test.hit {
                continue;
            }
            if LEAF.get(word) == 1 {
                let (t_entry, t_exit) = (test.t_entry, test.t_exit);
                leaves.push(Leaf { first_triangle: Self::INDEX.get(word), t_entry, t_exit });
            } else {
                stack.extend(self.children(word).iter().map(|child| (child.word, child.aabb)));
            }
        }
        leaves.sort_by_key(|leaf| leaf.first_triangle);
        leaves
    }
}
