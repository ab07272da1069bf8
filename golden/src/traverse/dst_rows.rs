//! What each node code means to one ray: the decoding of [`crate::dst::step`] as table rows.
//!
//! A carve node's kind and its corner bits or axis are four adjacent header bits below the one that says that it carves.
//! These five bits select the origin and the reciprocal of each of its planes, and a mask that says which plane is an
//! exit. The values that no carve has stand for every other node: their reciprocals make both distances NaN, which the
//! folds drop.

use crate::dst::header::{AXIS, CARVE, SINGLE, SIZE, dual_axes};
use crate::ray::TraversalRay;
use crate::simd::{F32x4, lanes};

/// Codes of two planes that follow each other in a [`Table`], written at once.
const CODES_PER_PAIR: usize = 2;
const CODES: usize = 1 << (CARVE.width + AXIS.width + SIZE.width);
const CARVES: usize = CODES / 2;

const _: () = assert!(AXIS.low == SIZE.low + SIZE.width, "kind and corners are adjacent");
const _: () =
    assert!(CARVE.low == AXIS.low + AXIS.width && CARVE.low == 31, "so is the bit above them, the last");

/// Two numbers for each code.
#[derive(Clone, Copy)]
#[repr(C, align(16))]
struct Table([[f32; 4]; CODES / CODES_PER_PAIR]);

impl Table {
    /// `value` for all codes but the carves', and for these `carves`.
    #[inline(always)]
    fn new(value: f32, carves: [F32x4; CARVES / CODES_PER_PAIR]) -> Self {
        let mut table = Self([[value; 4]; CODES / CODES_PER_PAIR]);
        for (pair, carve) in table.0[CARVES / CODES_PER_PAIR..].iter_mut().zip(carves) {
            carve.store(pair);
        }
        table
    }

    #[inline(always)]
    fn at(&self, header: u32) -> &[f32; 2] {
        let pairs: &[[f32; 2]; CODES] = bytemuck::cast_ref(&self.0);
        &pairs[(header >> SIZE.low) as usize]
    }
}

/// The two planes of a split, for one ray; the left child's in lanes 0 and 1, the right child's in lanes 2 and 3.
#[derive(Clone, Copy, Default)]
#[repr(C, align(16))]
struct SplitRow {
    origin: [f32; 4],
    inv: [f32; 4],
}

/// All rows of a ray.
pub(super) struct Rows {
    origins: Table,
    reciprocals: Table,
    /// One row for each axis; the reserved axis 3 reads as z.
    splits: [SplitRow; 4],
    /// Bit `k` set: axis `k` runs downwards.
    octant: usize,
}

impl Rows {
    #[inline(always)]
    pub fn new(ray: &TraversalRay) -> Self {
        let four = |[x, y, z]: [f32; 3]| F32x4::new([x, y, z, z]);
        let (origin, inv_entry, inv_exit) = (four(ray.origin), four(ray.inv_entry), four(ray.inv_exit));
        let octant = inv_entry.sign_bits() as usize & 0b111;
        // A max plane is an exit plane unless the ray runs downwards, a min plane if it does.
        let (max, min) = inv_exit.exchange(inv_entry, F32x4::load(&NEGATIVE[octant]));

        let (xy, zz) = (max.interleave_low(min), max.interleave_high(min));
        let xz = xy.shuffle::<{ lanes(0, 1, 0, 1) }>(zz);
        let yz = xy.shuffle::<{ lanes(2, 3, 0, 1) }>(zz);
        // All corners of two axes whose max and min are in lanes 0, 1 and 2, 3.
        let corners = |sides: F32x4| {
            [sides.shuffle::<{ lanes(0, 2, 0, 3) }>(sides), sides.shuffle::<{ lanes(1, 2, 1, 3) }>(sides)]
        };
        let ([xy0, xy1], [xz0, xz1], [yz0, yz1]) = (corners(xy), corners(xz), corners(yz));
        // In the order of the codes: dual x,y; dual x,z; single, the max plane first; dual y,z.
        let reciprocals = Table::new(f32::NAN, [xy0, xy1, xz0, xz1, xy, zz, yz0, yz1]);
        let oxy = origin.shuffle::<{ lanes(0, 1, 0, 1) }>(origin);
        let oxz = origin.shuffle::<{ lanes(0, 2, 0, 2) }>(origin);
        let oyz = origin.shuffle::<{ lanes(1, 2, 1, 2) }>(origin);
        let (oxxyy, ozz) = (origin.interleave_low(origin), origin.interleave_high(origin));
        let origins = Table::new(0.0, [oxy, oxy, oxz, oxz, oxxyy, ozz, oyz, oyz]);

        let mut splits = [SplitRow::default(); 4];
        let ([ox, oy, oz], [x, y, z]) = (
            [
                oxxyy.shuffle::<{ lanes(0, 0, 0, 0) }>(oxxyy),
                oxxyy.shuffle::<{ lanes(2, 2, 2, 2) }>(oxxyy),
                ozz,
            ],
            [
                xy.shuffle::<{ lanes(0, 0, 1, 1) }>(xy),
                xy.shuffle::<{ lanes(2, 2, 3, 3) }>(xy),
                zz.shuffle::<{ lanes(0, 0, 1, 1) }>(zz),
            ],
        );
        for (row, (origin, inv)) in splits.iter_mut().zip([(ox, x), (oy, y), (oz, z), (oz, z)]) {
            origin.store(&mut row.origin);
            inv.store(&mut row.inv);
        }
        Self { origins, reciprocals, splits, octant }
    }

    /// Whether the ray runs downwards on the axis with this code; not on the reserved one.
    #[inline(always)]
    pub fn is_negative(&self, axis: u32) -> bool {
        self.octant >> axis & 1 != 0
    }

    /// Folds the planes of a split into the intervals of its left child (lanes 0 and 1) and right child (2 and 3).
    #[inline(always)]
    pub fn split(&self, (header, planes): (u32, &[f32; 2]), entry: F32x4, exit: F32x4) -> (F32x4, F32x4) {
        let axis = AXIS.get(header) as usize;
        let row = &self.splits[axis];
        let t = F32x4::xxyy(planes[0], planes[1]).sub(F32x4::load(&row.origin)).mul(F32x4::load(&row.inv));
        let masks = &SPLIT_MASKS[self.octant][axis];
        (t.or(F32x4::load(&masks[0])).max(entry), t.or(F32x4::load(&masks[1])).min(exit))
    }

    /// Folds the planes of a left (lanes 0 and 1) and of a right carve (2 and 3) into their intervals; a node that does
    /// not carve leaves its interval alone.
    #[inline(always)]
    pub fn carve(
        &self,
        left: (u32, &[f32; 2]),
        right: (u32, &[f32; 2]),
        entry: F32x4,
        exit: F32x4,
    ) -> (F32x4, F32x4) {
        let both = |table: &Table| F32x4::pairs(table.at(left.0), table.at(right.0));
        let t = F32x4::pairs(left.1, right.1).sub(both(&self.origins)).mul(both(&self.reciprocals));
        // Ones make a NaN of a distance that is not to be folded; NaN, standing first, is dropped.
        let exits = both(&CARVE_EXITS[self.octant]);
        let (entry, exit) = (t.or(exits).max(entry), t.or_not(exits).min(exit));
        (entry.max(entry.yxwz()), exit.min(exit.yxwz()))
    }
}

const ONES: f32 = f32::from_bits(u32::MAX);

/// For each octant, all ones in the lanes of the axes that run downwards; lane 3 is lane 2's.
static NEGATIVE: [[f32; 4]; 8] = {
    let mut masks = [[0.0; 4]; 8];
    let mut octant = 0;
    while octant < 8 {
        let mut lane = 0;
        while lane < 4 {
            let axis = if lane == 3 { 2 } else { lane };
            if octant >> axis & 1 == 1 {
                masks[octant][lane] = ONES;
            }
            lane += 1;
        }
        octant += 1;
    }
    masks
};

/// For each octant and axis of a split, all ones in the lanes whose plane is an exit, then in those where it is an entry.
static SPLIT_MASKS: [[[[f32; 4]; 2]; 4]; 8] = {
    let [left, right] = [[ONES, ONES, 0.0, 0.0], [0.0, 0.0, ONES, ONES]];
    let mut masks = [[[left, right]; 4]; 8];
    let mut octant = 0;
    while octant < 8 {
        let mut axis = 0;
        while axis < 3 {
            if octant >> axis & 1 == 1 {
                masks[octant][axis] = [right, left];
            }
            axis += 1;
        }
        masks[octant][3] = masks[octant][2];
        octant += 1;
    }
    masks
};

/// For each octant, and each code and plane of a carve, all ones if it is an exit plane.
static CARVE_EXITS: [Table; 8] = {
    let mut tables = [Table([[0.0; 4]; CODES / CODES_PER_PAIR]); 8];
    let mut octant = 0;
    while octant < 8 {
        let mut carve = 0;
        while carve < CARVES {
            let (kind, size) = (carve as u32 >> SIZE.width, carve as u32 & SIZE.mask());
            let (axes, is_min) = match kind {
                SINGLE => ([size; 2], [0, 1]),
                _ => (dual_axes(kind), [size >> 1, size & 1]),
            };
            let mut plane = 0;
            while plane < 2 {
                if octant >> axes[plane] & 1 == is_min[plane] as usize {
                    let code = CARVES + carve;
                    tables[octant].0[code / CODES_PER_PAIR][code % CODES_PER_PAIR * 2 + plane] = ONES;
                }
                plane += 1;
            }
            carve += 1;
        }
        octant += 1;
    }
    tables
};
