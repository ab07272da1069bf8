//! Top-down construction with binned SAH on all three axes (Wald 2007, "On fast Construction of SAH-based
//! Bounding Volume Hierarchies"), down to ranges that are swept instead.

use glam::Vec3A;
use rayon::prelude::*;

use super::bounds::Bounds;
use super::sweep;
use super::work::{Link, Place};

/// Ranges of at least this many primitives are binned and split by several tasks.
const PARALLEL_BINNING_MIN: usize = 1 << 16;
/// Both children of a range of at least this many primitives are built at the same time.
const PARALLEL_CHILDREN_MIN: usize = 1 << 11;

#[derive(Clone, Copy)]
struct Bin {
    bounds: Bounds,
    count: usize,
}

impl Bin {
    const EMPTY: Self = Self { bounds: Bounds::EMPTY, count: 0 };

    #[inline(always)]
    fn union(self, other: Self) -> Self {
        Self { bounds: self.bounds.union(other.bounds), count: self.count + other.count }
    }

    /// Area times primitives.
    fn cost(&self) -> f64 {
        self.bounds.half_area() * self.count as f64
    }
}

type Bins<const BINS: usize> = [[Bin; BINS]; 3];

/// Maps centres to bins of equal width on each axis.
struct Grid<const BINS: usize> {
    origin: Vec3A,
    bins_per_unit: Vec3A,
}

impl<const BINS: usize> Grid<BINS> {
    fn new(centres: Bounds) -> Self {
        Self { origin: centres.min, bins_per_unit: BINS as f32 / (centres.max - centres.min) }
    }

    /// The bins of `centre`. An axis without extent gives 0 x infinity = NaN, which the cast makes bin 0.
    #[inline(always)]
    fn bins(&self, centre: Vec3A) -> [usize; 3] {
        let position = (centre - self.origin) * self.bins_per_unit;
        position.to_array().map(|x| (x as u32 as usize).min(BINS - 1))
    }

    fn fill(&self, boxes: &[Bounds]) -> Bins<BINS> {
        let mut bins = [[Bin::EMPTY; BINS]; 3];
        for &bounds in boxes {
            let index = self.bins(bounds.centre());
            for axis in 0..3 {
                let bin = &mut bins[axis][index[axis]];
                bin.bounds = bin.bounds.union(bounds);
                bin.count += 1;
            }
        }
        bins
    }

    fn fill_parallel(&self, boxes: &[Bounds]) -> Bins<BINS> {
        // Minimum, maximum and integer sum do not depend on the order of the reduction.
        boxes.par_chunks(PARALLEL_BINNING_MIN / 8).map(|chunk| self.fill(chunk)).reduce(
            || [[Bin::EMPTY; BINS]; 3],
            |mut a, b| {
                for (a, b) in a.as_flattened_mut().iter_mut().zip(b.as_flattened()) {
                    *a = a.union(*b);
                }
                a
            },
        )
    }
}

/// The first `bin` bins of `axis` go left.
struct Split {
    axis: usize,
    bin: usize,
    left_count: usize,
}

/// The split with the least SAH cost; ties go to the more balanced, then to the first axis and bin. `None` if
/// all centres share one bin.
fn best_split<const BINS: usize>(bins: &Bins<BINS>) -> Option<Split> {
    let mut best: Option<(f64, usize, Split)> = None;
    for (axis, bins) in bins.iter().enumerate() {
        let mut right = [Bin::EMPTY; BINS];
        let mut sum = Bin::EMPTY;
        for i in (1..BINS).rev() {
            sum = sum.union(bins[i]);
            right[i] = sum;
        }
        let mut left = Bin::EMPTY;
        for i in 1..BINS {
            left = left.union(bins[i - 1]);
            if bins[i - 1].count == 0 || right[i].count == 0 {
                continue;
            }
            let cost = left.cost() + right[i].cost();
            let imbalance = left.count.abs_diff(right[i].count);
            if best.as_ref().is_none_or(|&(c, d, _)| cost < c || (cost == c && imbalance < d)) {
                best = Some((cost, imbalance, Split { axis, bin: i, left_count: left.count }));
            }
        }
    }
    best.map(|(_, _, split)| split)
}

/// Moves the primitives of the left child to the front; returns the bounds of the two children's centres.
fn partition<const BINS: usize>(
    boxes: &mut [Bounds],
    primitives: &mut [u32],
    grid: &Grid<BINS>,
    split: &Split,
) -> [Bounds; 2] {
    let mut centres = [Bounds::EMPTY; 2];
    let (mut i, mut end) = (0, boxes.len());
    while i < end {
        let centre = boxes[i].centre();
        if grid.bins(centre)[split.axis] < split.bin {
            centres[0] = centres[0].grow(centre);
            i += 1;
        } else {
            centres[1] = centres[1].grow(centre);
            end -= 1;
            boxes.swap(i, end);
            primitives.swap(i, end);
        }
    }
    debug_assert_eq!(i, split.left_count);
    centres
}

/// The bounds of all centres.
pub(super) fn centre_bounds(boxes: &[Bounds]) -> Bounds {
    boxes.iter().fold(Bounds::EMPTY, |centres, bounds| centres.grow(bounds.centre()))
}

/// Builds the subtree at `place` over primitives with `boxes`, whose centres have the bounds `centres`, down
/// to single primitives; ranges of at most `sweep_max` primitives, and those that bins cannot separate or
/// would make too deep, by [`sweep`]. Returns the root's link and box.
pub(super) fn build<const BINS: usize>(
    boxes: &mut [Bounds],
    centres: Bounds,
    place: Place,
    sweep_max: usize,
) -> (Link, Bounds) {
    let count = boxes.len();
    if count <= sweep_max.max(1) {
        return sweep::build(boxes, place);
    }
    let grid = Grid::<BINS>::new(centres);
    let bins = if count >= PARALLEL_BINNING_MIN { grid.fill_parallel(boxes) } else { grid.fill(boxes) };
    let split = match best_split(&bins) {
        Some(split) if place.allows(split.left_count) => split,
        _ => return sweep::build(boxes, place),
    };

    let centres = partition(boxes, place.primitives, &grid, &split);
    let (boxes_left, boxes_right) = boxes.split_at_mut(split.left_count);
    let link = place.link();
    let (pair, [place_left, place_right]) = place.split(split.left_count);
    let left = || build::<BINS>(boxes_left, centres[0], place_left, sweep_max);
    let right = || build::<BINS>(boxes_right, centres[1], place_right, sweep_max);
    let (left, right) =
        if count >= PARALLEL_CHILDREN_MIN { rayon::join(left, right) } else { (left(), right()) };
    (link, pair.fill(left, right))
}
