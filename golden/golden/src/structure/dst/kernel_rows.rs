//! What each node code means to one ray: the decoding of [`crate::dst::step`] as table rows.
//!
//! An interval is kept as its entry and its negated exit, so that both are folded by a maximum; negation is exact. A
//! plane of a node is met at one distance, which bounds the entry or the exit of the ray, not both: the reciprocals for
//! the other one are NaN, which makes the distance NaN, which the folds drop.
//!
//! A carve node's kind and its corner bits or axis are four adjacent header bits below the one that says that it carves.
//! These five bits select the origin and both reciprocals of each of its planes. Where they are not those of a carve, the
//! reciprocals are NaN.

use crate::dst::header::{AXIS, CARVE, SINGLE, SIZE};
use crate::ray::TraversalRay;
use crate::simd::{F32x4, lanes};

/// Values of the five bits, in the lower half of which nothing carves.
const CODES: usize = 1 << (CARVE.width + AXIS.width + SIZE.width);
const CARVES: usize = CODES / 2;

const _: () = assert!(AXIS.low == SIZE.low + SIZE.width, "kind and corners are adjacent");
const _: () =
    assert!(CARVE.low == AXIS.low + AXIS.width && CARVE.low == 31, "so is the bit above them, the last");
const _: () = assert!(SINGLE == 2, "the rows of single carves come third");

/// The parts of [`Rows::carves`] for entries and for exits, from the first code that carves nothing, and for origins; what
/// a code that carves nothing finds there does not matter.
const ENTRIES: usize = 0;
const EXITS: usize = ENTRIES + CODES;
const ORIGINS: usize = EXITS + CARVES;
const CARVE_ROWS: usize = ORIGINS + CODES;

/// The origin and the reciprocals of a split: those for the left and the right child's entry, then for their exit.
#[derive(Clone, Copy, Default)]
#[repr(C, align(16))]
struct SplitRow {
    origin: [f32; 4],
    inv: [f32; 4],
}

/// Four lanes at a time, two codes of two planes.
#[derive(Clone, Copy)]
#[repr(C, align(16))]
struct CarveRows([[f32; 4]; CARVE_ROWS / 2]);

/// All rows of a ray.
pub(super) struct Rows {
    carves: CarveRows,
    /// One row for each axis; the reserved axis 3 reads as z.
    splits: [SplitRow; 4],
    /// Bit `k` set: axis `k` runs downwards.
    octant: u32,
}

/// The intervals of a left and of a right child: both entries, then both exits negated.
#[derive(Clone, Copy)]
pub(super) struct Intervals(F32x4);

/// The interval of one child.
#[derive(Clone, Copy)]
pub(super) struct Interval {
    pub t_min: f32,
    pub negated_t_max: f32,
}

impl Intervals {
    /// The same interval for both.
    #[inline(always)]
    pub fn both(Interval { t_min, negated_t_max }: Interval) -> Self {
        Self(F32x4::xxyy(&[t_min, negated_t_max]))
    }

    #[inline(always)]
    pub fn left(self) -> Interval {
        Interval { t_min: self.0.x(), negated_t_max: self.0.z() }
    }

    #[inline(always)]
    pub fn right(self) -> Interval {
        Interval { t_min: self.0.y(), negated_t_max: self.0.w() }
    }

    /// The left one for both.
    #[inline(always)]
    pub fn both_left(self) -> Self {
        Self(self.0.shuffle::<{ lanes(0, 0, 2, 2) }>(self.0))
    }

    /// The right one for both.
    #[inline(always)]
    pub fn both_right(self) -> Self {
        Self(self.0.shuffle::<{ lanes(1, 1, 3, 3) }>(self.0))
    }

    /// Which of them hold anything, bounds included: bit 0 the left one, bit 1 the right one.
    #[inline(always)]
    pub fn not_empty(self) -> u32 {
        self.0.le(self.0.zwxy().negated()) & 0b11
    }

    #[inline(always)]
    fn fold(self, distances: F32x4) -> Self {
        // NaN, standing first, is dropped.
        Self(distances.max(self.0))
    }
}

impl Rows {
    #[inline(always)]
    pub fn new(ray: &TraversalRay) -> Self {
        let four = |[x, y, z]: [f32; 3]| F32x4::new([x, y, z, z]);
        let (origin, entry, exit) = (four(ray.origin), four(ray.inv_entry), four(ray.inv_exit).negated());
        let octant = entry.sign_bits() & 0b111;
        // A max plane is an exit plane unless the ray runs downwards, a min plane if it does. Ones are a NaN.
        let negative = F32x4::load(&NEGATIVE[octant as usize]);
        let entries = Sides::new(entry.or_not(negative), entry.or(negative));
        let exits = Sides::new(exit.or(negative), exit.or_not(negative));

        let mut carves = CarveRows([[f32::NAN; 4]; CARVE_ROWS / 2]);
        let mut put = |first: usize, rows: [F32x4; CARVES / 2]| {
            for (lanes, row) in carves.0[first / 2..].iter_mut().zip(rows) {
                row.store(lanes);
            }
        };
        put(ENTRIES + CARVES, entries.carves());
        put(EXITS + CARVES, exits.carves());
        let pair = [
            origin.shuffle::<{ lanes(0, 1, 0, 1) }>(origin),
            origin.shuffle::<{ lanes(0, 2, 0, 2) }>(origin),
            origin.shuffle::<{ lanes(1, 2, 1, 2) }>(origin),
        ];
        let (xxyy, zzzz) = (origin.interleave_low(origin), origin.interleave_high(origin));
        put(ORIGINS + CARVES, [pair[0], pair[0], pair[1], pair[1], xxyy, zzzz, pair[2], pair[2]]);

        let (xxxx, yyyy) =
            (xxyy.shuffle::<{ lanes(0, 1, 0, 1) }>(xxyy), xxyy.shuffle::<{ lanes(2, 3, 2, 3) }>(xxyy));
        // The left child's max plane and the right child's min plane, once for the entries and once for the exits.
        let x = entries.xy.shuffle::<{ lanes(0, 1, 0, 1) }>(exits.xy);
        let y = entries.xy.shuffle::<{ lanes(2, 3, 2, 3) }>(exits.xy);
        let z = entries.zz.shuffle::<{ lanes(0, 1, 0, 1) }>(exits.zz);
        let mut splits = [SplitRow::default(); 4];
        for (row, (origin, inv)) in splits.iter_mut().zip([(xxxx, x), (yyyy, y), (zzzz, z), (zzzz, z)]) {
            origin.store(&mut row.origin);
            inv.store(&mut row.inv);
        }
        Self { carves, splits, octant }
    }

    /// Whether the ray runs downwards on the axis with this code; not on the reserved one.
    #[inline(always)]
    pub fn is_negative(&self, axis: u32) -> bool {
        self.octant >> axis & 1 != 0
    }

    /// Folds the planes of a split into the intervals of its children.
    #[inline(always)]
    pub fn split(&self, (header, planes): (u32, &[f32; 2]), intervals: Intervals) -> Intervals {
        let row = &self.splits[AXIS.get(header) as usize];
        let planes = F32x4::pairs(planes, planes);
        intervals.fold(planes.sub(F32x4::load(&row.origin)).mul(F32x4::load(&row.inv)))
    }

    /// Folds the planes of a left and of a right carve into their intervals; a node that does not carve leaves its interval
    /// alone.
    #[inline(always)]
    pub fn carve(&self, left: (u32, &[f32; 2]), right: (u32, &[f32; 2]), intervals: Intervals) -> Intervals {
        let carves: &[[f32; 2]] = self.carves.0.as_flattened().as_chunks().0;
        let [l, r] = [left.0, right.0].map(|header| (header >> SIZE.low) as usize);
        let rows = |first: usize| F32x4::pairs(&carves[first + l], &carves[first + r]);
        let ahead = F32x4::pairs(left.1, right.1).sub(rows(ORIGINS));
        // Lanes: both planes of the left, then of the right carve.
        let (entries, exits) = (ahead.mul(rows(ENTRIES)), ahead.mul(rows(EXITS)));
        intervals
            .fold(entries.shuffle::<{ lanes(0, 2, 0, 2) }>(exits))
            .fold(entries.shuffle::<{ lanes(1, 3, 1, 3) }>(exits))
    }
}

/// A number for each side of a box: max and min of x, of y; max and min of z, twice.
struct Sides {
    xy: F32x4,
    zz: F32x4,
}

impl Sides {
    #[inline(always)]
    fn new(max: F32x4, min: F32x4) -> Self {
        Self { xy: max.interleave_low(min), zz: max.interleave_high(min) }
    }

    /// In the order of the codes: the four corners of x and y, of x and z; single carves, the max plane first; y and z.
    #[inline(always)]
    fn carves(&self) -> [F32x4; CARVES / 2] {
        let Self { xy, zz } = *self;
        // Two axes, whose max and min are in lanes 0, 1 and 2, 3.
        let corners = |sides: F32x4| {
            [sides.shuffle::<{ lanes(0, 2, 0, 3) }>(sides), sides.shuffle::<{ lanes(1, 2, 1, 3) }>(sides)]
        };
        let [xy0, xy1] = corners(xy);
        let [xz0, xz1] = corners(xy.shuffle::<{ lanes(0, 1, 0, 1) }>(zz));
        let [yz0, yz1] = corners(xy.shuffle::<{ lanes(2, 3, 0, 1) }>(zz));
        [xy0, xy1, xz0, xz1, xy, zz, yz0, yz1]
    }
}

/// For each octant, all ones in the lanes of the axes that run downwards; lane 3 is lane 2's.
static NEGATIVE: [[f32; 4]; 8] = {
    let mut masks = [[0.0; 4]; 8];
    let mut octant = 0;
    while octant < 8 {
        let mut lane = 0;
        while lane < 4 {
            let axis = if lane == 3 { 2 } else { lane };
            if octant >> axis & 1 == 1 {
                masks[octant][lane] = f32::from_bits(u32::MAX);
            }
            lane += 1;
        }
        octant += 1;
    }
    masks
};
