//! Top-down construction that tries every split between two primitives on all three axes: sorted once on each
//! axis, then partitioned stably, O(n log n) for trees of logarithmic depth and O(n x levels) at worst.

use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use super::bounds::Bounds;
use super::work::{Link, Place};

/// Both children of a range of at least this many primitives are built at the same time.
const PARALLEL_CHILDREN_MIN: usize = 1 << 11;
/// The axes of a range of at least this many primitives are sorted and swept at the same time.
const PARALLEL_AXES_MIN: usize = 1 << 14;

/// What all ranges share. Primitives are meant by their position in `boxes`.
struct Input<'a> {
    boxes: &'a [Bounds],
    /// The mesh's number of each primitive.
    numbers: &'a [u32],
    /// Whether a primitive goes left in the split of the range that holds it; written and read by that
    /// range's task.
    goes_left: &'a [AtomicBool],
}

/// A range of primitives in the order of its centres on each axis, and scratch of the same length.
struct Range<'a> {
    orders: [&'a mut [u32]; 3],
    right_areas: [&'a mut [f64]; 3],
}

/// The first `left_count` primitives of `axis` go left.
#[derive(Clone, Copy)]
struct Split {
    cost: f64,
    axis: usize,
    left_count: usize,
}

impl Split {
    /// Less cost first; ties go to the more balanced.
    fn better_than(&self, other: &Self, count: usize) -> bool {
        let imbalance = |split: &Self| split.left_count.abs_diff(count - split.left_count);
        self.cost < other.cost || (self.cost == other.cost && imbalance(self) < imbalance(other))
    }
}

/// Builds the subtree at `place` over primitives with `boxes` down to single primitives; a split that would
/// exceed the place's levels is replaced by the median. Returns the root's link and box.
pub(super) fn build(boxes: &[Bounds], place: Place) -> (Link, Bounds) {
    let count = boxes.len();
    if count == 1 {
        return (Link::leaf(place.first_leaf), boxes[0]);
    }
    let axes: [usize; 3] = [0, 1, 2];
    let mut orders: [Vec<u32>; 3] = if count >= PARALLEL_AXES_MIN {
        let sorted: Vec<_> = axes.into_par_iter().map(|axis| sorted_on_axis(boxes, axis)).collect();
        sorted.try_into().expect("three axes")
    } else {
        axes.map(|axis| sorted_on_axis(boxes, axis))
    };
    let numbers = place.primitives.to_vec();
    let goes_left: Vec<AtomicBool> = (0..count).map(|_| AtomicBool::new(false)).collect();
    let input = Input { boxes, numbers: &numbers, goes_left: &goes_left };
    let mut right_areas = axes.map(|_| vec![0.0; count]);
    let range = Range {
        orders: orders.each_mut().map(Vec::as_mut_slice),
        right_areas: right_areas.each_mut().map(Vec::as_mut_slice),
    };
    build_range(&input, range, place)
}

/// Primitives by centre on `axis`; equal centres by area, so that concentric boxes nest, then by position.
fn sorted_on_axis(boxes: &[Bounds], axis: usize) -> Vec<u32> {
    let mut keys: Vec<(u64, u32)> = boxes
        .iter()
        .zip(0_u32..)
        .map(|(bounds, position)| {
            let centre = total_order_bits(bounds.centre()[axis]);
            // Rounding the area to f32 only makes more ties.
            let area = total_order_bits(bounds.half_area() as f32);
            (u64::from(centre) << 32 | u64::from(area), position)
        })
        .collect();
    if boxes.len() >= PARALLEL_AXES_MIN {
        keys.par_sort_unstable()
    } else {
        keys.sort_unstable()
    }
    keys.into_iter().map(|(_, position)| position).collect()
}

/// Maps floats to integers of the same order.
fn total_order_bits(x: f32) -> u32 {
    let bits = x.to_bits();
    if bits >> 31 == 0 { bits | 1 << 31 } else { !bits }
}

fn build_range(input: &Input, mut range: Range, place: Place) -> (Link, Bounds) {
    let count = place.count();
    if let [position] = *range.orders[0] {
        place.primitives[0] = input.numbers[position as usize];
        return (Link::leaf(place.first_leaf), input.boxes[position as usize]);
    }
    let mut split = best_split(input, &mut range);
    if !place.allows(split.left_count) {
        split.left_count = count / 2;
    }
    range.partition(input, split);
    let [range_left, range_right] = range.split_at(split.left_count);
    let link = place.link();
    let (pair, [place_left, place_right]) = place.split(split.left_count);
    let left = || build_range(input, range_left, place_left);
    let right = || build_range(input, range_right, place_right);
    let (left, right) =
        if count >= PARALLEL_CHILDREN_MIN { rayon::join(left, right) } else { (left(), right()) };
    (link, pair.fill(left, right))
}

/// The split with the least SAH cost; ties go to the more balanced, then to the first axis and position.
fn best_split(input: &Input, range: &mut Range) -> Split {
    let count = range.orders[0].len();
    if count == 2 {
        return Split { cost: 0.0, axis: 0, left_count: 1 };
    }
    let [x, y, z] = range.orders.each_ref();
    let [areas_x, areas_y, areas_z] = range.right_areas.each_mut();
    let mut x = || best_split_on_axis(input.boxes, x, 0, areas_x);
    let mut y = || best_split_on_axis(input.boxes, y, 1, areas_y);
    let mut z = || best_split_on_axis(input.boxes, z, 2, areas_z);
    let (x, (y, z)) =
        if count >= PARALLEL_AXES_MIN { rayon::join(x, || rayon::join(y, z)) } else { (x(), (y(), z())) };
    [y, z].into_iter().fold(x, |best, split| if split.better_than(&best, count) { split } else { best })
}

fn best_split_on_axis(boxes: &[Bounds], order: &[u32], axis: usize, right_areas: &mut [f64]) -> Split {
    let count = order.len();
    let mut bounds = Bounds::EMPTY;
    for i in (1..count).rev() {
        bounds = bounds.union(boxes[order[i] as usize]);
        right_areas[i] = bounds.half_area();
    }
    let mut best = Split { cost: f64::INFINITY, axis, left_count: 0 };
    let mut bounds = Bounds::EMPTY;
    for left_count in 1..count {
        bounds = bounds.union(boxes[order[left_count - 1] as usize]);
        let cost =
            bounds.half_area() * left_count as f64 + right_areas[left_count] * (count - left_count) as f64;
        let split = Split { cost, axis, left_count };
        if split.better_than(&best, count) {
            best = split;
        }
    }
    best
}

impl<'a> Range<'a> {
    /// Brings the left child's primitives to the front on every axis, keeping their order.
    fn partition(&mut self, input: &Input, split: Split) {
        for (i, &position) in self.orders[split.axis].iter().enumerate() {
            input.goes_left[position as usize].store(i < split.left_count, Ordering::Relaxed);
        }
        for (axis, order) in self.orders.iter_mut().enumerate().filter(|&(axis, _)| axis != split.axis) {
            // The areas are used up; their bytes hold the right child's primitives meanwhile.
            let right: &mut [u32] = bytemuck::cast_slice_mut(self.right_areas[axis]);
            let (mut left_count, mut right_count) = (0, 0);
            for i in 0..order.len() {
                let position = order[i];
                let left = input.goes_left[position as usize].load(Ordering::Relaxed);
                // Both are written and one counter advances, so that no branch has to be predicted.
                order[left_count] = position;
                right[right_count] = position;
                left_count += usize::from(left);
                right_count += usize::from(!left);
            }
            order[left_count..].copy_from_slice(&right[..right_count]);
        }
    }

    fn split_at(self, left_count: usize) -> [Self; 2] {
        let [(x0, x1), (y0, y1), (z0, z1)] = self.orders.map(|order| order.split_at_mut(left_count));
        let [(a0, a1), (b0, b1), (c0, c1)] = self.right_areas.map(|areas| areas.split_at_mut(left_count));
        [
            Self { orders: [x0, y0, z0], right_areas: [a0, b0, c0] },
            Self { orders: [x1, y1, z1], right_areas: [a1, b1, c1] },
        ]
    }
}
