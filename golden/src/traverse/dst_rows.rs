//! What each carve code means to one ray: the decoding of [`crate::dst::step`] as table rows.
//!
//! A carve node's kind and its corner bits or axis are four adjacent header bits. They select a [`Row`] with the origin
//! and the reciprocal of each of its planes, and a mask that says which plane is an exit. The one value of these
//! bits that no carve has stands for every other node: its row makes both distances NaN, which the folds drop.

use crate::dst::header::{AXIS, CARVE, SINGLE, SIZE, dual_axes};
use crate::ray::TraversalRay;
use crate::simd::F32x4;

const ROWS: usize = 1 << (AXIS.width + SIZE.width);
/// A single carve of the reserved axis 3.
const NEUTRAL: u32 = SINGLE << SIZE.width | SIZE.mask();

const _: () = assert!(AXIS.low == SIZE.low + SIZE.width, "kind and corners are adjacent");
const _: () = assert!(CARVE.low == 31, "the sign bit says whether a node carves");

/// The row of the node with this header.
#[inline(always)]
pub(super) fn row_of(header: u32) -> usize {
    // All ones unless the node carves; only the neutral row's bits are taken.
    let not_carve = !((header as i32 >> 31) as u32);
    let bits = header >> SIZE.low & (ROWS as u32 - 1);
    (if not_carve == 0 { bits } else { NEUTRAL }) as usize
}

/// The two planes of a carve, for one ray.
#[derive(Clone, Copy)]
#[repr(C, align(16))]
struct CarveRow {
    /// The origin on each plane's axis.
    origin: [f32; 2],
    /// The reciprocal of each plane's axis and role.
    inv: [f32; 2],
}

/// The two planes of a split, for one ray; the left child's in lanes 0 and 1, the right child's in lanes 2 and 3.
#[derive(Clone, Copy)]
#[repr(C, align(16))]
struct SplitRow {
    origin: [f32; 4],
    inv: [f32; 4],
    /// All ones where the plane is an exit plane.
    exit_mask: [f32; 4],
}

/// All rows of a ray.
pub(super) struct Rows {
    carves: [CarveRow; ROWS],
    /// For each row and plane of a carve, all ones if it is an exit plane.
    carve_exit_masks: &'static [[f32; 2]; ROWS],
    /// One row for each axis; the reserved axis 3 reads as z.
    splits: [SplitRow; 4],
}

const ONES: f32 = f32::from_bits(u32::MAX);

impl Rows {
    #[inline(always)]
    pub fn new(ray: &TraversalRay) -> Self {
        let octant: usize = (0..3).map(|k| usize::from(ray.is_negative(k)) << k).sum();
        // A max plane is an exit plane unless the ray runs downwards, a min plane if it does.
        let reciprocal = |axis: usize, is_min: bool| {
            if ray.is_negative(axis) == is_min { ray.inv_exit[axis] } else { ray.inv_entry[axis] }
        };
        let by_side: [[f32; 2]; 3] =
            std::array::from_fn(|axis| [reciprocal(axis, false), reciprocal(axis, true)]);
        let mut carves = [CarveRow { origin: [f32::NAN; 2], inv: [f32::NAN; 2] }; ROWS];
        for kind in [0, 1, 3] {
            let [a, b] = dual_axes(kind).map(|axis| axis as usize);
            for corner in 0..4 {
                carves[(kind << SIZE.width | corner) as usize] = CarveRow {
                    origin: [ray.origin[a], ray.origin[b]],
                    inv: [by_side[a][corner as usize >> 1], by_side[b][corner as usize & 1]],
                };
            }
        }
        for axis in 0..3 {
            // The max plane is stored first.
            carves[(SINGLE << SIZE.width) as usize + axis] =
                CarveRow { origin: [ray.origin[axis]; 2], inv: by_side[axis] };
        }
        let splits = std::array::from_fn(|axis| {
            let axis = axis.min(2);
            let [max, min] = by_side[axis];
            let exit_mask =
                if ray.is_negative(axis) { [0.0, 0.0, ONES, ONES] } else { [ONES, ONES, 0.0, 0.0] };
            SplitRow { origin: [ray.origin[axis]; 4], inv: [max, max, min, min], exit_mask }
        });
        Self { carves, carve_exit_masks: &EXIT_MASKS[octant], splits }
    }

    /// Whether the ray runs downwards on the axis with this code.
    #[inline(always)]
    pub fn is_negative(&self, axis: u32) -> bool {
        self.splits[(axis & AXIS.mask()) as usize].exit_mask[0].to_bits() == 0
    }

    /// Folds the planes of a split into the intervals of its left child (lanes 0 and 1) and right child (2 and 3).
    #[inline(always)]
    pub fn split(&self, node: [u32; 3], entry: F32x4, exit: F32x4) -> (F32x4, F32x4) {
        let row = &self.splits[AXIS.get(node[0]) as usize];
        let plane = F32x4::xxyy(f32::from_bits(node[1]), f32::from_bits(node[2]));
        let t = plane.sub(F32x4::load(&row.origin)).mul(F32x4::load(&row.inv));
        fold(t, F32x4::load(&row.exit_mask), entry, exit)
    }

    /// Folds the planes of a left (lanes 0 and 1) and of a right carve (2 and 3) into their intervals; a node that does
    /// not carve leaves its interval alone.
    #[inline(always)]
    pub fn carve(&self, left: [u32; 3], right: [u32; 3], entry: F32x4, exit: F32x4) -> (F32x4, F32x4) {
        let (l, r) = (row_of(left[0]), row_of(right[0]));
        let planes = |node: [u32; 3]| [f32::from_bits(node[1]), f32::from_bits(node[2])];
        let t = F32x4::pairs(planes(left), planes(right))
            .sub(F32x4::pairs(self.carves[l].origin, self.carves[r].origin))
            .mul(F32x4::pairs(self.carves[l].inv, self.carves[r].inv));
        let exit_mask = F32x4::pairs(self.carve_exit_masks[l], self.carve_exit_masks[r]);
        let (entry, exit) = fold(t, exit_mask, entry, exit);
        (entry.max(entry.yxwz()), exit.min(exit.yxwz()))
    }
}

/// Folds distances to planes into intervals, lane by lane.
#[inline(always)]
fn fold(t: F32x4, exit_mask: F32x4, entry: F32x4, exit: F32x4) -> (F32x4, F32x4) {
    // Ones make a NaN of a distance that is not to be folded; NaN, standing first, is dropped.
    (t.or(exit_mask).max(entry), t.or_not(exit_mask).min(exit))
}

/// For each octant (bit `k` set: axis `k` runs downwards).
static EXIT_MASKS: [[[f32; 2]; ROWS]; 8] = {
    let mut masks = [[[0.0; 2]; ROWS]; 8];
    let mut octant = 0;
    while octant < 8 {
        let mut row = 0;
        while row < ROWS {
            let (kind, size) = (row as u32 >> SIZE.width, row as u32 & SIZE.mask());
            let (axes, is_min) = match kind {
                SINGLE => ([size; 2], [0, 1]),
                _ => (dual_axes(kind), [size >> 1, size & 1]),
            };
            let mut plane = 0;
            while plane < 2 {
                if octant >> axes[plane] & 1 == is_min[plane] {
                    masks[octant as usize][row][plane] = ONES;
                }
                plane += 1;
            }
            row += 1;
        }
        octant += 1;
    }
    masks
};
