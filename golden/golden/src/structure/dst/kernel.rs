//! The fast kernel for dual-split trees: a split and the first carve of both its children in one go.
//!
//! Children lie side by side, so the six planes of a split and of the carve nodes that most children begin with are
//! near each other in memory. Testing them together costs one unpredictable branch where node-by-node
//! traversal costs three. The planes, their arithmetic and the order in which leaves are reached are those of
//! the specification's steps; only the moment at which an empty child is noticed differs.

use super::Dst;
use super::header::{AXIS, CARVE, LEAF, OFFSET, SIZE};
use super::kernel_rows::{Interval, Intervals, Rows};
use crate::traverse::NoObserver;
use crate::traverse::box_test::BoxTest;
use crate::traverse::query::Query;
use crate::traverse::stack::Stack;

/// A child with the part of the ray that lies in it.
#[derive(Clone, Copy)]
struct Place {
    /// [`LEAF`] and [`OFFSET`] as in a header.
    target: u32,
    interval: Interval,
}

/// Visits nodes until nothing nearer can be found, or with `ANY` until something is; returns whether it was.
#[inline(always)]
pub(super) fn traverse<const ANY: bool>(dst: &Dst, query: &mut Query<'_, ANY>) -> bool {
    let ray = query.ray;
    let Some([t_min, t_max]) = BoxTest::new(ray).interval(&dst.root_box, ray.t_max) else {
        return false;
    };
    let rows = Rows::new(ray);
    let mut stack = Stack::<Place, 1>::new();
    let mut here = target(dst.node(0)[0], 0);
    // Of the node that is visited, for both of its children.
    let mut intervals = Intervals::both(Interval { t_min, negated_t_max: -t_max });
    loop {
        loop {
            if LEAF.get(here) == 1 {
                if query.leaf(OFFSET.get(here), &mut NoObserver) {
                    return true;
                }
                break;
            }
            // SAFETY: a `Dst` is only made by conversion or by a validated load; its offsets are in range.
            let node = unsafe { dst.node_unchecked(here) };
            let header = node.0;
            if CARVE.get(header) == 1 {
                // The second or third of a chain; the first was tested with its split.
                intervals = rows.carve(node, node, intervals);
                if intervals.not_empty() == 0 {
                    break;
                }
                here = target(header, 0);
                continue;
            }
            let left_at = OFFSET.get(header);
            let right_at = left_at + SIZE.get(header);
            // SAFETY: as above.
            let (left, right) = unsafe { (dst.node_unchecked(left_at), dst.node_unchecked(right_at)) };
            let children = rows.carve(left, right, rows.split(node, intervals));
            match children.not_empty() {
                0b11 => {
                    let (left, right) = (target(left.0, left_at), target(right.0, right_at));
                    let far = if rows.is_negative(AXIS.get(header)) {
                        (here, intervals) = (right, children.both_right());
                        Place { target: left, interval: children.left() }
                    } else {
                        (here, intervals) = (left, children.both_left());
                        Place { target: right, interval: children.right() }
                    };
                    stack.push(far);
                }
                0b01 => (here, intervals) = (target(left.0, left_at), children.both_left()),
                0b10 => (here, intervals) = (target(right.0, right_at), children.both_right()),
                _ => break,
            }
        }
        loop {
            let Some(Place { target, interval: Interval { t_min, negated_t_max } }) = stack.pop() else {
                return false;
            };
            if t_min <= query.t_max {
                let negated_t_max = if negated_t_max > -query.t_max { negated_t_max } else { -query.t_max };
                (here, intervals) = (target, Intervals::both(Interval { t_min, negated_t_max }));
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
