//! Traversal in a narrow format.

use super::{Bvh, LEAF, box_step};
use crate::precision::NarrowBvh;
use crate::traverse::Observer;
use crate::traverse::query::Query;
use crate::traverse::stack::Stack;

/// All children of a node are tested and visited in the order of their entries, equal ones in that of memory.
pub(super) fn traverse<const N: usize, const ANY: bool, O: Observer>(
    narrow: &NarrowBvh<N>,
    query: &mut Query<'_, ANY>,
    observer: &mut O,
) -> bool {
    let bvh = &narrow.structure;
    let ray = narrow.ray(query.ray);
    if !box_step(&bvh.root_box, &ray, ray.t_min, ray.t_max).hit {
        return false;
    }
    let mut stack = Stack::<(u32, f32), N>::new();
    let mut word = bvh.root;
    loop {
        let mut next = None;
        if LEAF.get(word) == 1 {
            if query.leaf(Bvh::<N>::INDEX.get(word), observer) {
                return true;
            }
        } else {
            let nearest = ray.limit(query.t_max);
            let mut hits = [(0u32, 0.0f32); N];
            let mut count = 0;
            for (index, child) in (Bvh::<N>::INDEX.get(word)..).zip(bvh.children(word)) {
                let test = box_step(&child.aabb, &ray, ray.t_min, nearest);
                Bvh::<N>::observe(observer, index, child.word, test);
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
                    observer.push(Bvh::<N>::target(word), t_min, stack.len());
                }
                next = Some(nearest.0);
            }
        }
        let nearest = ray.limit(query.t_max);
        while next.is_none() {
            let Some((other, t_entry)) = stack.pop() else {
                return false;
            };
            observer.pop(Bvh::<N>::target(other), t_entry > nearest);
            next = (t_entry <= nearest).then_some(other);
        }
        word = next.expect("the loop ends with a node");
    }
}
