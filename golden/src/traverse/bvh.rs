//! Traversal of 2-, 4- and 8-wide hierarchies: all children of a node are tested, the nearest is visited first.

use super::query::Query;
use super::stack::Stack;
use super::{Tests, Trace, Traversal};
use crate::build::MAX_DEPTH;
use crate::bvh::{Bvh, BvhNode, INDEX, LEAF, box_step};
use crate::ray::{Hit, TraversalRay};
use crate::simd::F32x4;

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
    if !box_step(&bvh.root_box, query.ray, query.ray.t_min, query.ray.t_max).hit {
        return false;
    }
    let test = BoxTest::new(query.ray);
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
        let (hits, [ta, tb]) = test.pair(a, b, t_max);
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
        let (hits, [ta, tb]) = test.pair(a, b, t_max);
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

/// A ray, prepared to test two boxes at a time.
struct BoxTest {
    origin: F32x4,
    inv_entry: F32x4,
    inv_exit: F32x4,
    /// All ones in the lanes whose axis is entered at its max plane.
    negative: F32x4,
    t_min: F32x4,
}

impl BoxTest {
    #[inline(always)]
    fn new(ray: &TraversalRay) -> Self {
        let four = |[x, y, z]: [f32; 3]| F32x4::new([x, y, z, z]);
        let mask = |axis: usize| f32::from_bits(if ray.is_negative(axis) { u32::MAX } else { 0 });
        Self {
            origin: four(ray.origin),
            inv_entry: four(ray.inv_entry),
            inv_exit: four(ray.inv_exit),
            negative: four([mask(0), mask(1), mask(2)]),
            t_min: F32x4::splat(ray.t_min),
        }
    }

    /// Distances to the planes of entry and of exit, one axis to a lane.
    #[inline(always)]
    fn planes(&self, node: &BvhNode) -> (F32x4, F32x4) {
        let words: &[f32; 7] = bytemuck::cast_ref(node);
        let min = F32x4::load(words[1..5].try_into().expect("four words"));
        // Words 3 to 6, rotated so that the maxima come first.
        let max = F32x4::load(words[3..7].try_into().expect("four words")).yzwx();
        let (entry, exit) = min.exchange(max, self.negative);
        (entry.sub(self.origin).mul(self.inv_entry), exit.sub(self.origin).mul(self.inv_exit))
    }

    /// Which of two boxes are hit (bit 0, bit 1), and where they are entered.
    #[inline(always)]
    fn pair(&self, a: &BvhNode, b: &BvhNode, t_max: f32) -> (u32, [f32; 2]) {
        let (entry_a, exit_a) = self.planes(a);
        let (entry_b, exit_b) = self.planes(b);
        // Lanes: x of a, x of b, y of a, y of b; then z of a, z of b. NaN is dropped by standing first.
        let t_max = F32x4::splat(t_max);
        let (low, high) = (entry_a.interleave_low(entry_b), entry_a.interleave_high(entry_b));
        let t_entry = high.max(low.max(self.t_min)).max(low.max(self.t_min).zwxy());
        let (low, high) = (exit_a.interleave_low(exit_b), exit_a.interleave_high(exit_b));
        let t_exit = high.min(low.min(t_max)).min(low.min(t_max).zwxy());
        let [ta, tb, ..] = t_entry.to_array();
        (t_entry.le(t_exit) & 3, [ta, tb])
    }
}
