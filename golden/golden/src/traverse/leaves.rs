//! All leaves that a ray reaches, by the specification's steps and without early termination.

use crate::bvh::{Bvh, INDEX, LEAF, box_step};
use crate::dst::{Code, Dst, step};
use crate::ray::TraversalRay;

/// A leaf, with the interval in which the ray is in its box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leaf {
    /// Slot of its first triangle.
    pub first_triangle: u32,
    /// Where the ray enters its box.
    pub t_entry: f32,
    /// Where the ray leaves its box.
    pub t_exit: f32,
}

/// A structure whose leaves can be enumerated.
pub trait Leaves {
    /// Every leaf whose box, and all of whose ancestors' boxes, `ray` meets; in ascending order of first triangle.
    fn leaves(&self, ray: &TraversalRay) -> Vec<Leaf>;
}

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
                leaves.push(Leaf { first_triangle: INDEX.get(word), t_entry, t_exit });
            } else {
                stack.extend(self.children(word).iter().map(|child| (child.word, child.aabb)));
            }
        }
        sorted(leaves)
    }
}

impl Leaves for Dst {
    fn leaves(&self, ray: &TraversalRay) -> Vec<Leaf> {
        let root = box_step(&self.root_box, ray, ray.t_min, ray.t_max);
        let mut leaves = vec![];
        let mut stack = vec![];
        if root.hit {
            stack.push((0, root.t_entry, root.t_exit));
        }
        while let Some((offset, t_min, t_max)) = stack.pop() {
            let step = step(self.node(offset), ray, t_min, t_max);
            let near = (step.near.offset, step.near.t_min, step.near.t_max);
            match step.code {
                Code::Miss => {}
                Code::One => stack.push(near),
                Code::Two => stack.extend([(step.far.offset, step.far.t_min, step.far.t_max), near]),
                Code::Leaf => {
                    leaves.push(Leaf { first_triangle: near.0, t_entry: near.1, t_exit: near.2 });
                }
            }
        }
        sorted(leaves)
    }
}

fn sorted(mut leaves: Vec<Leaf>) -> Vec<Leaf> {
    leaves.sort_by_key(|leaf| leaf.first_triangle);
    leaves
}
