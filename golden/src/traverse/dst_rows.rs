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
pub(super) struct Row {
    /// The origin on each plane's axis.
    pub origin: [f32; 2],
    /// The reciprocal of each plane's axis and role.
    pub inv: [f32; 2],
}

/// All rows of a ray.
pub(super) struct Rows {
    pub rows: [Row; ROWS],
    /// For each row and plane, all ones if it is an exit plane.
    pub exit_masks: &'static [[f32; 2]; ROWS],
}

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
        let mut rows = [Row { origin: [f32::NAN; 2], inv: [f32::NAN; 2] }; ROWS];
        for kind in [0, 1, 3] {
            let [a, b] = dual_axes(kind).map(|axis| axis as usize);
            for corner in 0..4 {
                rows[(kind << SIZE.width | corner) as usize] = Row {
                    origin: [ray.origin[a], ray.origin[b]],
                    inv: [by_side[a][corner as usize >> 1], by_side[b][corner as usize & 1]],
                };
            }
        }
        for axis in 0..3 {
            // The max plane is stored first.
            rows[(SINGLE << SIZE.width) as usize + axis] =
                Row { origin: [ray.origin[axis]; 2], inv: by_side[axis] };
        }
        Self { rows, exit_masks: &EXIT_MASKS[octant] }
    }

    /// Distances to the two planes of `near` and of `far`, and a mask of ones where they are exit planes.
    #[inline(always)]
    pub fn distances(&self, near: [u32; 3], far: [u32; 3]) -> (F32x4, F32x4) {
        let (n, f) = (row_of(near[0]), row_of(far[0]));
        let planes = |node: [u32; 3]| [f32::from_bits(node[1]), f32::from_bits(node[2])];
        let t = F32x4::pairs(planes(near), planes(far))
            .sub(F32x4::pairs(self.rows[n].origin, self.rows[f].origin))
            .mul(F32x4::pairs(self.rows[n].inv, self.rows[f].inv));
        (t, F32x4::pairs(self.exit_masks[n], self.exit_masks[f]))
    }
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
                    masks[octant as usize][row][plane] = f32::from_bits(u32::MAX);
                }
                plane += 1;
            }
            row += 1;
        }
        octant += 1;
    }
    masks
};
