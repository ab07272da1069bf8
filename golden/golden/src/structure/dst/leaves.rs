//! The leaves that a ray reaches, by the specification's step.

use super::{Code, Dst, step};
use crate::bvh::box_step;
use crate::ray::TraversalRay;
use crate::traverse::{Leaf, Leaves};

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
        leaves.sort_by_key(|leaf| leaf.first_triangle);
        leaves
    }
}
