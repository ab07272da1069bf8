//! Traversal one node at a time, as the hardware does it, by any step function; and the choice between it and the kernel.

use super::header::{CARVE, LEAF, LEAF_WORDS, NODE_WORDS};
use super::{Child, Code, Dst, Step, address, kernel, step};
use crate::bvh::{BoxStep, box_step};
use crate::ray::{Hit, TraversalRay};
use crate::traverse::query::Query;
use crate::traverse::stack::Stack;
use crate::traverse::{Node, Observer, Outcome, Part, Target, Tests, Trace};

impl Trace for Dst {
    #[inline]
    fn closest_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
        let mut query = Query::<false>::new(ray, &self.triangles);
        if O::ACTIVE {
            by_steps(self, &mut query, observer, step);
        } else {
            kernel::traverse(self, &mut query);
        }
        query.hit()
    }

    #[inline]
    fn occluded_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
        let mut query = Query::<true>::new(ray, &self.triangles);
        if O::ACTIVE {
            by_steps(self, &mut query, observer, step)
        } else {
            kernel::traverse(self, &mut query)
        }
    }
}

/// The nearest hit in `dst` with every node step executed by `step`: the specification's, or hardware's.
///
/// `step` is given a node's three words, the ray and the interval, and has to do what [`crate::dst::step`] does.
pub fn closest_by_steps<O: Observer>(
    dst: &Dst,
    ray: &TraversalRay,
    observer: &mut O,
    step: impl FnMut([u32; 3], &TraversalRay, f32, f32) -> Step,
) -> Option<Hit> {
    let mut query = Query::<false>::new(ray, &dst.triangles);
    by_steps(dst, &mut query, observer, step);
    query.hit()
}

/// Whether anything in `dst` is hit, with every node step executed by `step` as in [`closest_by_steps`].
pub fn occluded_by_steps<O: Observer>(
    dst: &Dst,
    ray: &TraversalRay,
    observer: &mut O,
    step: impl FnMut([u32; 3], &TraversalRay, f32, f32) -> Step,
) -> bool {
    let mut query = Query::<true>::new(ray, &dst.triangles);
    by_steps(dst, &mut query, observer, step)
}

fn by_steps<const ANY: bool, O: Observer>(
    dst: &Dst,
    query: &mut Query<'_, ANY>,
    observer: &mut O,
    mut step: impl FnMut([u32; 3], &TraversalRay, f32, f32) -> Step,
) -> bool {
    let ray = query.ray;
    let root = box_step(&dst.root_box, ray, ray.t_min, ray.t_max);
    traverse(dst, root, query, observer, |words, low, high| step(words, ray, low, high), |t| t)
}

/// Visits nodes by `step` until nothing nearer can be found, or with `ANY` until something is; returns whether it was.
///
/// `root` is the outcome of the root box's test. `limit` turns the distance of a hit, at first the ray's end, into
/// what intervals are compared with.
pub(super) fn traverse<const ANY: bool, O: Observer>(
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
    let mut stack = Stack::<Child, 1>::new();
    let mut here = Child { offset: 0, t_min: root.t_entry, t_max: root.t_exit };
    loop {
        let words = dst.node(here.offset);
        let outcome = step(words, here.t_min, here.t_max);
        observer.node(&visit(words[0], &here, &outcome));
        match outcome.code {
            Code::Two => {
                stack.push(outcome.far);
                let Child { offset, t_min, .. } = outcome.far;
                observer.push(Target::Node(address(offset)), t_min, stack.len());
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
            observer.pop(Target::Node(address(next.offset)), discarded);
            if !discarded {
                here = Child { t_max: fp::minimum_number(next.t_max, nearest), ..next };
                break;
            }
        }
    }
}

/// The visit of the node with this `header` at `here`.
#[inline(always)]
fn visit(header: u32, here: &Child, step: &Step) -> Node {
    let bare_leaf = CARVE.get(header) == 0 && LEAF.get(header) == 1;
    let (words, tests) = if bare_leaf { (LEAF_WORDS, Tests::None) } else { (NODE_WORDS, Tests::Planes) };
    let node = |child: &Child| Part {
        target: Target::Node(address(child.offset)),
        t_min: child.t_min,
        t_max: child.t_max,
    };
    let outcome = match step.code {
        Code::Miss => Outcome::Nothing,
        Code::One => Outcome::One(node(&step.near)),
        Code::Two => Outcome::Two(node(&step.near), node(&step.far)),
        Code::Leaf => Outcome::One(Part { target: Target::Leaf(step.near.offset), ..node(&step.near) }),
    };
    let Child { offset, t_min, t_max } = *here;
    Node { address: address(offset), bytes: 4 * words, tests, t_min, t_max, outcome }
}
