//! Traversal: all children of a node are tested, the nearest is visited first.

use super::{Bvh, BvhNode, Hierarchy, LEAF, box_step};
use crate::ray::{Hit, TraversalRay};
use crate::traverse::box_test::BoxTest;
use crate::traverse::query::Query;
use crate::traverse::stack::Stack;
use crate::traverse::{Observer, Trace};

impl<const N: usize> Trace for Bvh<N> {
    #[inline]
    fn closest_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
        closest(self, ray, observer)
    }

    #[inline]
    fn occluded_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
        occluded(self, ray, observer)
    }
}

/// The nearest hit of `ray` in `tree`.
#[inline(always)]
pub(in crate::structure) fn closest<const N: usize, H: Hierarchy<N>, O: Observer>(
    tree: &H,
    ray: &TraversalRay,
    observer: &mut O,
) -> Option<Hit> {
    let mut query = Query::<false>::new(ray, tree.triangles());
    traverse(tree, &mut query, observer);
    query.hit()
}

/// Whether `ray` hits anything in `tree`.
#[inline(always)]
pub(in crate::structure) fn occluded<const N: usize, H: Hierarchy<N>, O: Observer>(
    tree: &H,
    ray: &TraversalRay,
    observer: &mut O,
) -> bool {
    let mut query = Query::<true>::new(ray, tree.triangles());
    traverse(tree, &mut query, observer)
}

/// Visits nodes until nothing nearer can be found, or with `ANY` until something is; returns whether it was.
#[inline(always)]
fn traverse<const N: usize, const ANY: bool, H: Hierarchy<N>, O: Observer>(
    tree: &H,
    query: &mut Query<'_, ANY>,
    observer: &mut O,
) -> bool {
    let test = BoxTest::new(query.ray);
    let (mut word, root_box) = tree.root();
    if test.interval(root_box, query.t_max).is_none() {
        return false;
    }
    let mut stack = Stack::<(u32, f32), N>::new();
    loop {
        if LEAF.get(word) == 1 {
            if query.leaf(H::INDEX.get(word), observer) {
                return true;
            }
        } else {
            let siblings = tree.siblings(word);
            if O::ACTIVE {
                for (index, child) in siblings.iter().enumerate() {
                    let test = box_step(&child.aabb, query.ray, query.ray.t_min, query.t_max);
                    H::observe(observer, H::place(word, index, siblings.len()), child.word, test);
                }
            }
            if let Some(next) = visit_children::<N, H, O>(&siblings, &test, query.t_max, &mut stack, observer)
            {
                word = next;
                continue;
            }
        }
        loop {
            let Some((next, t_entry)) = stack.pop() else {
                return false;
            };
            let discarded = t_entry > query.t_max;
            observer.pop(H::target(next), discarded);
            if !discarded {
                word = next;
                break;
            }
        }
    }
}

/// Tests `children`, stacks all but the nearest that are hit, the farthest first, and returns the nearest.
///
/// Children at equal distance are visited in the order of memory.
#[inline(always)]
fn visit_children<const N: usize, H: Hierarchy<N>, O: Observer>(
    children: &[BvhNode],
    test: &BoxTest,
    t_max: f32,
    stack: &mut Stack<(u32, f32), N>,
    observer: &mut O,
) -> Option<u32> {
    let mut push = |(word, t_entry): (u32, f32)| {
        stack.push((word, t_entry));
        // Folding gives a zero of either sign; adding +0 makes it that of the specification.
        observer.push(H::target(word), t_entry + 0.0, stack.len());
    };
    if let [a, b] = children {
        let (hits, [ta, tb]) = test.pair(&a.aabb, &b.aabb, t_max);
        return match hits {
            0 => None,
            1 => Some(a.word),
            2 => Some(b.word),
            _ => {
                let (near, far) = if ta <= tb { (a.word, (b.word, tb)) } else { (b.word, (a.word, ta)) };
                push(far);
                Some(near)
            }
        };
    }
    let mut found = [(0u32, 0.0f32); N];
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
        push(*entry);
    }
    Some(nearest.0)
}
