//! Traversal of dual-split trees one node at a time, as the hardware does it, by any step function.

use super::query::Query;
use super::stack::Stack;
use super::{Tests, Traversal};
use crate::build::MAX_DEPTH;
use crate::bvh::BoxStep;
use crate::dst::header::{CARVE, LEAF, LEAF_WORDS, NODE_WORDS};
use crate::dst::{Child, Code, Dst, Step};

/// Visits nodes by `step` until nothing nearer can be found, or with `ANY` until something is; returns whether it was.
///
/// `root` is the outcome of the root box's test. `limit` turns the distance of a hit, at first the ray's end, into
/// what intervals are compared with.
pub(crate) fn traverse<const ANY: bool, O: Traversal>(
    dst: &Dst,
    root: BoxStep,
    query: &mut Query<'_, ANY>,
    observer: &mut O,
    mut step: impl FnMut([u32; 3], f32, f32) -> Step,
    limit: impl Fn(f32) -> f32,
) -> bool {
    if !root.hit {
        return false;
    }
    let mut stack = Stack::<Child, { MAX_DEPTH as usize }>::new();
    let mut here = Child { offset: 0, t_min: root.t_entry, t_max: root.t_exit };
    loop {
        let words = dst.node(here.offset);
        if CARVE.get(words[0]) == 0 && LEAF.get(words[0]) == 1 {
            observer.node(here.offset, LEAF_WORDS, Tests::None);
        } else {
            observer.node(here.offset, NODE_WORDS, Tests::Planes);
        }
        let outcome = step(words, here.t_min, here.t_max);
        match outcome.code {
            Code::Two => {
                stack.push(outcome.far);
                observer.push(stack.len());
                here = outcome.near;
                continue;
            }
            Code::One => {
                here = outcome.near;
                continue;
            }
            Code::Leaf => {
                if query.leaf(outcome.near.offset, observer) {
                    return true;
                }
            }
            Code::Miss => {}
        }
        let nearest = limit(query.t_max);
        loop {
            let Some(next) = stack.pop() else {
                return false;
            };
            let discarded = next.t_min > nearest;
            observer.pop(discarded);
            if !discarded {
                here = Child { t_max: fp::minimum_number(next.t_max, nearest), ..next };
                break;
            }
        }
    }
}
