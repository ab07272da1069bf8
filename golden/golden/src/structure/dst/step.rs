//! One step of dual-split traversal: what the hardware pipeline computes, operation for operation.
//!
//! For the node's two planes, `t = (plane - origin[axis]) * inv[axis]` with the reciprocal of the plane's role.
//! With `s` the sign bit of `inv_entry[axis]`:
//!
//! | node | plane 0 is | plane 1 is |
//! |---|---|---|
//! | split | s = 0: exit of the near (left) child; s = 1: entry of the far (left) child | the other of the two |
//! | single carve | exit if s = 0, else entry | entry if s = 0, else exit |
//! | dual carve | exit if s equals its min-side bit, else entry | likewise |
//!
//! A split accepts its near child if `t_min <= minimum_number(t_max, exit)` and its far child if
//! `maximum_number(t_min, entry) <= t_max`; a carve folds both planes into the interval and survives if
//! `t_min <= t_max`. Acceptance always compares a folded interval, never a raw distance, which may be NaN.

use super::header::{AXIS, CARVE, LEAF, OFFSET, SINGLE, SIZE, dual_axes};
use crate::ray::PlaneDistances;
use fp::{maximum_number, minimum_number};

/// What the caller does next; the pipeline's two-bit return value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Code {
    /// Nothing is inside the interval: pop.
    Miss = 0,
    /// Go to the near slot.
    One = 1,
    /// Push the far slot, go to the near one.
    Two = 2,
    /// The near slot is a leaf: test its triangles.
    Leaf = 3,
}

/// A child with the part of the ray that lies in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Child {
    /// Word offset, or index of the first triangle for [`Code::Leaf`].
    pub offset: u32,
    /// Where the ray enters.
    pub t_min: f32,
    /// Where the ray leaves.
    pub t_max: f32,
}

/// The outcome of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// What to do next.
    pub code: Code,
    /// The surviving child, carve child or leaf; meaningless for [`Code::Miss`].
    pub near: Child,
    /// The farther child; meaningful for [`Code::Two`] only.
    pub far: Child,
}

/// Visits the node `words` with the part `t_min..=t_max` of `ray`.
///
/// Words 1 and 2 of a bare leaf are ignored. Reserved header codes give some result, never a panic.
#[must_use]
pub fn step<R: PlaneDistances>(words: [u32; 3], ray: &R, t_min: f32, t_max: f32) -> Step {
    let header = words[0];
    let planes = [f32::from_bits(words[1]), f32::from_bits(words[2])];
    let offset = OFFSET.get(header);
    let here = Child { offset, t_min, t_max };
    if CARVE.get(header) == 1 {
        let child = carve(header, planes, ray, here);
        let code = match (child.t_min <= child.t_max, LEAF.get(header) == 1) {
            (false, _) => Code::Miss,
            (true, false) => Code::One,
            (true, true) => Code::Leaf,
        };
        Step { code, near: child, far: child }
    } else if LEAF.get(header) == 1 {
        Step { code: Code::Leaf, near: here, far: here }
    } else {
        split(header, planes, ray, here)
    }
}

fn split(header: u32, planes: [f32; 2], ray: &impl PlaneDistances, parent: Child) -> Step {
    let axis = axis_index(AXIS.get(header));
    let negative = ray.is_negative(axis);
    let (left, right) = (parent.offset, parent.offset + SIZE.get(header));
    let (near_offset, far_offset) = if negative { (right, left) } else { (left, right) };
    let (near_plane, far_plane) = if negative { (planes[1], planes[0]) } else { (planes[0], planes[1]) };
    let near = Child {
        offset: near_offset,
        t_max: minimum_number(parent.t_max, ray.exit(near_plane, axis)),
        ..parent
    };
    let far = Child {
        offset: far_offset,
        t_min: maximum_number(parent.t_min, ray.entry(far_plane, axis)),
        ..parent
    };
    match (near.t_min <= near.t_max, far.t_min <= far.t_max) {
        (true, true) => Step { code: Code::Two, near, far },
        (true, false) => Step { code: Code::One, near, far },
        (false, true) => Step { code: Code::One, near: far, far },
        (false, false) => Step { code: Code::Miss, near, far },
    }
}

fn carve(header: u32, planes: [f32; 2], ray: &impl PlaneDistances, parent: Child) -> Child {
    let size = SIZE.get(header);
    let (axes, is_min) = match AXIS.get(header) {
        SINGLE => ([size; 2], [false, true]),
        kind => (dual_axes(kind), [size & 2 != 0, size & 1 != 0]),
    };
    let mut child = parent;
    for i in 0..2 {
        let axis = axis_index(axes[i]);
        if ray.is_negative(axis) == is_min[i] {
            child.t_max = minimum_number(child.t_max, ray.exit(planes[i], axis));
        } else {
            child.t_min = maximum_number(child.t_min, ray.entry(planes[i], axis));
        }
    }
    child
}

/// The axis that the hardware's multiplexers select: the reserved code 3 gives z.
#[inline(always)]
fn axis_index(code: u32) -> usize {
    code.min(2) as usize
}

#[cfg(test)]
#[path = "step_tests.rs"]
mod tests;
