//! Traversal in a narrow format.

use super::{Hierarchy, LEAF, box_step};
use crate::Aabb;
use crate::precision::NarrowRay;
use crate::traverse::Observer;
use crate::traverse::query::Query;
use crate::traverse::stack::Stack;

/// All children of a node are tested and visited in the order of their entries, equal ones in that of memory.
///
/// `root_box`, `ray` and what `planes` makes of a stored box are in the format.
pub(in crate::structure) fn traverse<const N: usize, const ANY: bool, H: Hierarchy<N>, O: Observer>(
    tree: &H,
    root_box: &Aabb,
    planes: impl Fn(&Aabb) -> Aabb,
    ray: &NarrowRay,
    query: &mut Query<'_, ANY>,
    observer: &mut O,
) -> bool {
    if !box_step(root_box, ray, ray.t_min, ray.t_max).hit {
        return false;
    }
    let (mut word, _) = tree.root();
    let mut stack = Stack::<(u32, f32), N>::new();
    loop {
        let mut next = None;
        if LEAF.get(word) == 1 {
            if query.leaf(H::INDEX.get(word), observer) {
                return true;
            }
        } else {
            let nearest = ray.limit(query.t_max);
            let mut hits = [(0u32, 0.0f32); N];
            let mut count = 0;
            let siblings = tree.siblings(word);
            for (index, child) in siblings.iter().enumerate() {
                let test = box_step(&planes(&child.aabb), ray, ray.t_min, nearest);
                H::observe(observer, H::place(word, index, siblings.len()), child.word, test);
                if test.hit {
                    hits[count] = (child.word, test.t_entry);
                    count += 1;
                }
            }
            // Farthest first, later in memory before earlier; entries are never NaN.
            hits[..count].reverse();
            hits[..count].sort_by(|a, b| b.1.total_cmp(&a.1));
            if let Some((nearest, others)) = hits[..count].split_last() {
                for &(word, t_min) in others {
                    stack.push((word, t_min));
                    observer.push(H::target(word), t_min, stack.len());
                }
                next = Some(nearest.0);
            }
        }
        let nearest = ray.limit(query.t_max);
        while next.is_none() {
            let Some((other, t_entry)) = stack.pop() else {
                return false;
            };
            observer.pop(H::target(other), t_entry > nearest);
            next = (t_entry <= nearest).then_some(other);
        }
        word = next.expect("the loop ends with a node");
    }
}
