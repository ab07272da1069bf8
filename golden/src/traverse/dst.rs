//! The fast kernel for dual-split trees: a split and the first carve of both its children in one go.
//!
//! Children lie side by side, so the six planes of a split and of the carve nodes that most children begin with are
//! near each other in memory. Testing them together costs one unpredictable branch where node-by-node
//! traversal costs three. The planes, their arithmetic and the order in which leaves are reached are those of
//! the specification's steps; only the moment at which an empty child is noticed differs.

use super::NoObserver;
use super::box_test::BoxTest;
use super::dst_rows::Rows;
use super::query::Query;
use super::stack::Stack;
use crate::build::MAX_DEPTH;
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
    let Some([t_min, t_max]) = BoxTest::new(ray).interval(&dst.root_box, ray.t_max) else {
        return false;
    };
    let rows = Rows::new(ray);
    let mut stack = Stack::<Place, { MAX_DEPTH as usize }>::new();
    let mut here = Place { target: target(dst.node(0)[0], 0), t_min, t_max };
    loop {
        loop {
            if LEAF.get(here.target) == 1 {
                if query.leaf(OFFSET.get(here.target), &mut NoObserver) {
                    return true;
                }
                break;
            }
            // SAFETY: a `Dst` is only made by conversion or by a validated load; its offsets are in range.
            let node = unsafe { dst.node_unchecked(here.target) };
            let header = node.0;
            let (entry, exit) = (F32x4::splat(here.t_min), F32x4::splat(here.t_max));
            if CARVE.get(header) == 1 {
                // The second or third of a chain; the first was tested with its split.
                let (entry, exit) = rows.carve(node, node, entry, exit);
                if entry.le(exit) & 1 == 0 {
                    break;
                }
                here = Place { target: target(header, 0), t_min: entry.x(), t_max: exit.x() };
                continue;
            }
            let left_at = OFFSET.get(header);
            let right_at = left_at + SIZE.get(header);
            // SAFETY: as above.
            let (left, right) = unsafe { (dst.node_unchecked(left_at), dst.node_unchecked(right_at)) };
            let (entry, exit) = rows.split(node, entry, exit);
            let (entry, exit) = rows.carve(left, right, entry, exit);
            let left = || Place { target: target(left.0, left_at), t_min: entry.x(), t_max: exit.x() };
            let right = || Place { target: target(right.0, right_at), t_min: entry.z(), t_max: exit.z() };
            match entry.le(exit) & 0b101 {
                0b101 => {
                    let (left, right) = (left(), right());
                    let (near, far) =
                        if rows.is_negative(AXIS.get(header)) { (right, left) } else { (left, right) };
                    stack.push(far);
                    here = near;
                }
                0b001 => here = left(),
                0b100 => here = right(),
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
