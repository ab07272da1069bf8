//! Traversal of dual-split trees: a ray carries its interval down, and each node cuts it with two planes.

use super::query::Query;
use super::stack::Stack;
use super::{Tests, Trace, Traversal};
use crate::build::MAX_DEPTH;
use crate::bvh::box_step;
use crate::dst::Dst;
use crate::dst::header::{AXIS, CARVE, LEAF, LEAF_WORDS, NODE_WORDS, OFFSET, SINGLE, SIZE, dual_axes};
use crate::ray::{Hit, TraversalRay};

impl Trace for Dst {
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

/// A child that waits on the stack.
#[derive(Clone, Copy)]
struct Entry {
    offset: u32,
    t_min: f32,
    t_max: f32,
}

/// Visits nodes until nothing nearer can be found, or with `ANY` until something is; returns whether it was.
#[inline(always)]
fn traverse<const ANY: bool, O: Traversal>(dst: &Dst, query: &mut Query<'_, ANY>, observer: &mut O) -> bool {
    let ray = query.ray;
    let root = box_step(&dst.root_box, ray, ray.t_min, ray.t_max);
    if !root.hit {
        return false;
    }
    let mut stack = Stack::<Entry, { MAX_DEPTH as usize }>::new();
    let mut here = Entry { offset: 0, t_min: root.t_entry, t_max: root.t_exit };
    loop {
        let [header, plane_0, plane_1] = dst.node(here.offset);
        let planes = [f32::from_bits(plane_0), f32::from_bits(plane_1)];
        let is_carve = CARVE.get(header) == 1;
        let is_leaf = LEAF.get(header) == 1;
        let child = OFFSET.get(header);
        if is_carve {
            observer.node(here.offset, NODE_WORDS, Tests::Planes);
            carve(header, planes, ray, &mut here);
            if here.t_min <= here.t_max {
                if !is_leaf {
                    here.offset = child;
                    continue;
                }
                if query.leaf(child, observer) {
                    return true;
                }
            }
        } else if is_leaf {
            observer.node(here.offset, LEAF_WORDS, Tests::None);
            if query.leaf(child, observer) {
                return true;
            }
        } else {
            observer.node(here.offset, NODE_WORDS, Tests::Planes);
            let axis = AXIS.get(header) as usize;
            let (t_exit, t_entry, negative) = both(planes, ray, axis);
            let size = SIZE.get(header);
            let (near, far) = if negative { (child + size, child) } else { (child, child + size) };
            let t_exit = min(t_exit, here.t_max);
            let t_entry = max(t_entry, here.t_min);
            match (here.t_min <= t_exit, t_entry <= here.t_max) {
                (true, true) => {
                    stack.push(Entry { offset: far, t_min: t_entry, t_max: here.t_max });
                    observer.push(stack.len());
                    here = Entry { offset: near, t_max: t_exit, ..here };
                    continue;
                }
                (true, false) => {
                    here = Entry { offset: near, t_max: t_exit, ..here };
                    continue;
                }
                (false, true) => {
                    here = Entry { offset: far, t_min: t_entry, ..here };
                    continue;
                }
                (false, false) => {}
            }
        }
        loop {
            let Some(next) = stack.pop() else {
                return false;
            };
            let discarded = next.t_min > query.t_max;
            observer.pop(discarded);
            if !discarded {
                here = Entry { t_max: min(next.t_max, query.t_max), ..next };
                break;
            }
        }
    }
}

/// Distances to a pair of planes on one axis, the first of which bounds the lower side from above: where the ray leaves the
/// side that it meets first, where it enters the other, and whether it runs downwards.
#[inline(always)]
fn both(planes: [f32; 2], ray: &TraversalRay, axis: usize) -> (f32, f32, bool) {
    let negative = ray.is_negative(axis);
    let (first, second) = if negative { (planes[1], planes[0]) } else { (planes[0], planes[1]) };
    (ray.exit(first, axis), ray.entry(second, axis), negative)
}

#[inline(always)]
fn carve(header: u32, planes: [f32; 2], ray: &TraversalRay, here: &mut Entry) {
    let size = SIZE.get(header);
    let kind = AXIS.get(header);
    if kind == SINGLE {
        let (t_exit, t_entry, _) = both(planes, ray, size as usize);
        here.t_max = min(t_exit, here.t_max);
        here.t_min = max(t_entry, here.t_min);
        return;
    }
    let is_min = [size & 2 != 0, size & 1 != 0];
    for (i, axis) in dual_axes(kind).into_iter().enumerate() {
        let axis = axis as usize;
        if ray.is_negative(axis) == is_min[i] {
            here.t_max = min(ray.exit(planes[i], axis), here.t_max);
        } else {
            here.t_min = max(ray.entry(planes[i], axis), here.t_min);
        }
    }
}

/// The lesser of a distance and a bound; a NaN distance is dropped.
#[inline(always)]
fn min(distance: f32, bound: f32) -> f32 {
    if distance < bound { distance } else { bound }
}

/// The greater of a distance and a bound; a NaN distance is dropped.
#[inline(always)]
fn max(distance: f32, bound: f32) -> f32 {
    if distance > bound { distance } else { bound }
}
