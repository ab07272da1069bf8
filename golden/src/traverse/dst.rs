//! The fast kernel for dual-split trees: a split and the first carve of both its children in one go.
//!
//! Children lie side by side, so the six planes of a split and of the carve nodes that most children begin with are
//! near each other in memory. Testing them together costs one unpredictable branch where node-by-node
//! traversal costs three. The planes, their arithmetic and the order in which leaves are reached are those of
//! the specification's steps; only the moment at which an empty child is noticed differs.

use super::NoObserver;
use super::dst_rows::Rows;
use super::query::Query;
use super::stack::Stack;
use crate::build::MAX_DEPTH;
use crate::bvh::box_step;
use crate::dst::Dst;
use crate::dst::header::{AXIS, CARVE, LEAF, OFFSET, SIZE};
use crate::simd::F32x4;

/// A child with the part of the ray that lies in it.
#[derive(Clone, Copy)]
struct Place {
    /// [`LEAF`] and [`OFFSET`] as in a header.
    target: u32,
    t_min: f32,
    t_max: f32,
}

/// Visits nodes until nothing nearer can be found, or with `ANY` until something is; returns whether it was.
#[inline(always)]
pub(super) fn traverse<const ANY: bool>(dst: &Dst, query: &mut Query<'_, ANY>) -> bool {
    let ray = query.ray;
    let root = box_step(&dst.root_box, ray, ray.t_min, ray.t_max);
    if !root.hit {
        return false;
    }
    let rows = Rows::new(ray);
    let mut stack = Stack::<Place, { MAX_DEPTH as usize }>::new();
    let mut here = Place { target: target(dst.node(0)[0], 0), t_min: root.t_entry, t_max: root.t_exit };
    loop {
        loop {
            if LEAF.get(here.target) == 1 {
                if query.leaf(OFFSET.get(here.target), &mut NoObserver) {
                    return true;
                }
                break;
            }
            let node = dst.node(here.target);
            let header = node[0];
            if CARVE.get(header) == 1 {
                // The second or third of a chain; the first was tested with its split.
                let (t, exit_mask) = rows.distances(node, node);
                let (entry, exit) = fold(t, exit_mask, here, here);
                if !(entry.x() <= exit.x()) {
                    break;
                }
                here = Place { target: target(header, 0), t_min: entry.x(), t_max: exit.x() };
                continue;
            }
            let axis = (AXIS.get(header) as usize).min(2);
            let negative = ray.is_negative(axis);
            let (left, size) = (OFFSET.get(header), SIZE.get(header));
            let (near_at, far_at, near_plane, far_plane) = if negative {
                (left + size, left, node[2], node[1])
            } else {
                (left, left + size, node[1], node[2])
            };
            let t_near = ray.exit(f32::from_bits(near_plane), axis);
            let t_far = ray.entry(f32::from_bits(far_plane), axis);
            let near_part = Place { t_max: if t_near < here.t_max { t_near } else { here.t_max }, ..here };
            let far_part = Place { t_min: if t_far > here.t_min { t_far } else { here.t_min }, ..here };

            let (near, far) = (dst.node(near_at), dst.node(far_at));
            let (t, exit_mask) = rows.distances(near, far);
            let (entry, exit) = fold(t, exit_mask, near_part, far_part);
            let near = Place { target: target(near[0], near_at), t_min: entry.x(), t_max: exit.x() };
            let far = Place { target: target(far[0], far_at), t_min: entry.z(), t_max: exit.z() };
            match entry.le(exit) & 0b101 {
                0b101 => {
                    stack.push(far);
                    here = near;
                }
                0b001 => here = near,
                0b100 => here = far,
                _ => break,
            }
        }
        loop {
            let Some(next) = stack.pop() else {
                return false;
            };
            if next.t_min <= query.t_max {
                let t_max = if next.t_max < query.t_max { next.t_max } else { query.t_max };
                here = Place { t_max, ..next };
                break;
            }
        }
    }
}

/// Where a record that has been carved by its first node leads, or `at` itself if that is a split.
#[inline(always)]
fn target(header: u32, at: u32) -> u32 {
    let is_split = header & (CARVE.mask() << CARVE.low | LEAF.mask() << LEAF.low) == 0;
    if is_split { at } else { header & (LEAF.mask() << LEAF.low | OFFSET.mask()) }
}

/// Entry and exit of the near child in lanes 0 and 1, of the far child in lanes 2 and 3.
#[inline(always)]
fn fold(t: F32x4, exit_mask: F32x4, near: Place, far: Place) -> (F32x4, F32x4) {
    // Ones make a NaN of a distance that is not to be folded.
    let entry = t.or(exit_mask).max(F32x4::xxyy(near.t_min, far.t_min));
    let exit = t.or_not(exit_mask).min(F32x4::xxyy(near.t_max, far.t_max));
    (entry.max(entry.yxwz()), exit.min(exit.yxwz()))
}
