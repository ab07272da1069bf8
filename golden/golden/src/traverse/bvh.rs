//! Traversal of 2-, 4- and 8-wide hierarchies: all children of a node are tested, the nearest is visited first.

use super::box_test::BoxTest;
use super::query::Query;
use super::stack::Stack;
use super::{Tests, Trace, Traversal};
use crate::build::MAX_DEPTH;
use crate::bvh::{Bvh, BvhNode, INDEX, LEAF};
use crate::ray::{Hit, TraversalRay};

impl<const N: usize> Trace for Bvh<N> {
    #[inline]
    fn closest_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
        let mut query = Query::<false>::new(ray, &self.triangles);
        traverse(self, &mut query, observer);
        query.hit()
    }

    #[inline]
    fn occluded_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
        let mut query = Query::<true>::new(ray, &self.triangles);
        traverse(self, &mut query, observer)
    }
}

/// Visits nodes until nothing nearer can be found, or with `ANY` until something is; returns whether it was.
#[inline(always)]
fn traverse<const N: usize, const ANY: bool, O: Traversal>(
    bvh: &Bvh<N>,
    query: &mut Query<'_, ANY>,
    observer: &mut O,
) -> bool {
    let test = BoxTest::new(query.ray);
    if test.interval(&bvh.root_box, query.t_max).is_none() {
        return false;
    }
    // A node leaves at most N - 1 siblings of each ancestor behind.
    let mut stack = Stack::<(u32, f32), STACK_ENTRIES>::new();
    let mut word = bvh.root;
    loop {
        if LEAF.get(word) == 1 {
            if query.leaf(INDEX.get(word), observer) {
                return true;
            }
        } else {
            let children = bvh.children(word);
            if O::ACTIVE {
                for i in 0..children.len() as u32 {
                    observer.node((INDEX.get(word) + i) * BvhNode::WORDS, BvhNode::WORDS, Tests::Box);
                }
            }
            if let Some(next) = visit_children(children, &test, query.t_max, &mut stack, observer) {
                word = next;
                continue;
            }
        }
        loop {
            let Some((next, t_entry)) = stack.pop() else {
                return false;
            };
            let discarded = t_entry > query.t_max;
            observer.pop(discarded);
            if !discarded {
                word = next;
                break;
            }
        }
    }
}

const STACK_ENTRIES: usize = 7 * MAX_DEPTH as usize;

/// Tests `children`, stacks all but the nearest that are hit, the farthest first, and returns the nearest.
///
/// Children at equal distance are visited in the order of memory.
#[inline(always)]
fn visit_children<O: Traversal>(
    children: &[BvhNode],
    test: &BoxTest,
    t_max: f32,
    stack: &mut Stack<(u32, f32), STACK_ENTRIES>,
    observer: &mut O,
) -> Option<u32> {
    if let [a, b] = children {
        let (hits, [ta, tb]) = test.pair(&a.aabb, &b.aabb, t_max);
        return match hits {
            0 => None,
            1 => Some(a.word),
            2 => Some(b.word),
            _ => {
                let (near, far) = if ta <= tb { (a.word, (b.word, tb)) } else { (b.word, (a.word, ta)) };
                stack.push(far);
                observer.push(stack.len());
                Some(near)
            }
        };
    }
    let mut found = [(0u32, 0.0f32); 8];
    let mut count = 0;
    let mut insert = |entry: (u32, f32)| {
        let mut at = count;
        // Farthest first; an equal one that comes later in memory goes before, to be visited later.
        while at > 0 && found[at - 1].1 <= entry.1 {
            found[at] = found[at - 1];
            at -= 1;
        }
        found[at] = entry;
        count += 1;
    };
    for pair in children.chunks(2) {
        let (a, b) = (&pair[0], &pair[pair.len() - 1]);
        let (hits, [ta, tb]) = test.pair(&a.aabb, &b.aabb, t_max);
        if hits & 1 != 0 {
            insert((a.word, ta));
        }
        if hits & 2 != 0 && pair.len() == 2 {
            insert((b.word, tb));
        }
    }
    let (nearest, others) = found[..count].split_last()?;
    for entry in others {
        stack.push(*entry);
        observer.push(stack.len());
    }
    Some(nearest.0)
}
