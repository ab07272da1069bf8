//! A node in memory: the one definition of its fields, of its grid and of how it is decoded.

use crate::Aabb;
use crate::bvh::{BvhNode, LEAF};
use crate::dst::header::Field;
use std::array::from_fn;
use std::ops::Deref;

/// Number of children - 1, in word 3.
const CHILDREN: Field = Field { low: 24, width: 3 };
/// Words before the children's bytes.
const HEAD_WORDS: usize = 6;
/// Number of triangles and six planes.
pub(super) const BYTES_PER_CHILD: usize = 7;

/// The biased exponent of the step on `axis`, in word 3.
const fn exponent(axis: usize) -> Field {
    Field { low: 8 * axis, width: 8 }
}

/// A child as it is stored.
#[derive(Clone, Copy, Debug)]
pub(super) struct Child {
    /// Number of triangles of a leaf, 0 for a node.
    pub triangles: u8,
    /// Its exact box.
    pub aabb: Aabb,
}

/// Planes on one axis, each a binary32 number.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Grid {
    origin: f32,
    exponent: u32,
}

impl Grid {
    /// The finest grid around `low..=high`, which are finite.
    fn around(low: f32, high: f32) -> Self {
        // In binary64 every quotient below is exact: the steps are powers of two, far from its range's ends.
        let [low, high] = [low, high].map(f64::from);
        let fits = |step: f64| {
            let [first, last] = [(low / step).floor(), (high / step).ceil()];
            last - first <= 255.0
                && first.abs().max(last.abs()).max((first + 255.0).abs()) <= f64::from(1 << 24)
        };
        // No finer step reaches around, or has binary32 numbers as planes.
        let least = ((high - low) / 256.0).max(low.abs().max(high.abs()) / f64::from(1 << 24));
        let first = ((least as f32).to_bits() >> 23).max(1);
        let exponent = (first..0xff)
            .find(|exponent| fits(f64::from(step(*exponent))))
            .expect("coordinates are at most scenes::MAX_COORDINATE");
        let step = f64::from(step(exponent));
        Self { origin: ((low / step).floor() * step) as f32 + 0.0, exponent }
    }

    fn plane(&self, at: f32, round: fn(f64) -> f64) -> u8 {
        let step = f64::from(step(self.exponent));
        // Whole steps are subtracted, as a difference of coordinates may be rounded.
        (round(f64::from(at) / step) - f64::from(self.origin) / step) as u8
    }
}

/// The power of two with this biased exponent.
#[inline(always)]
const fn step(exponent: u32) -> f32 {
    f32::from_bits(exponent << 23)
}

/// The words of the node with `children`, which are 2 to `N`.
pub(super) fn encode<const N: usize>(children: &[Child], first_node: u32, first_triangle: u32) -> Vec<u32> {
    let bounds = children.iter().fold(Aabb::EMPTY, |bounds, child| bounds.union(child.aabb));
    let grids: [Grid; 3] = from_fn(|axis| Grid::around(bounds.min[axis], bounds.max[axis]));
    let mut words = vec![0; Node::<N>::WORDS];
    CHILDREN.store(&mut words[3], children.len() as u32 - 1);
    for (axis, grid) in grids.iter().enumerate() {
        words[axis] = grid.origin.to_bits();
        exponent(axis).store(&mut words[3], grid.exponent);
    }
    (words[4], words[5]) = (first_node, first_triangle);
    let mut put = |row: usize, child: usize, byte: u8| {
        let at = row * N + child;
        words[HEAD_WORDS + at / 4] |= u32::from(byte) << (8 * (at % 4));
    };
    for (index, child) in children.iter().enumerate() {
        put(0, index, child.triangles);
        for (axis, grid) in grids.iter().enumerate() {
            put(1 + axis, index, grid.plane(child.aabb.min[axis], f64::floor));
            put(4 + axis, index, grid.plane(child.aabb.max[axis], f64::ceil));
        }
    }
    words
}

/// A node of up to `N` children in memory.
#[derive(Clone, Copy, Debug)]
pub struct Node<'a, const N: usize> {
    words: &'a [u32],
}

impl<'a, const N: usize> Node<'a, N> {
    /// The 32-bit words that a node takes.
    pub const WORDS: usize = {
        assert!(N >= 2 && N <= CHILDREN.mask() as usize + 1, "the number of children fits its field");
        HEAD_WORDS + (BYTES_PER_CHILD * N).div_ceil(4)
    };
    /// The bytes that a node takes.
    pub const BYTES: usize = 4 * Self::WORDS;

    #[inline(always)]
    pub(super) fn new(words: &'a [u32]) -> Self {
        Self { words }
    }

    /// All of its words.
    pub(super) fn words(&self) -> &[u32] {
        self.words
    }

    /// Number of children.
    #[inline(always)]
    #[must_use]
    pub fn children(&self) -> usize {
        CHILDREN.get(self.words[3]) as usize + 1
    }

    /// Index of the first child that is a node.
    #[inline(always)]
    #[must_use]
    pub fn first_node(&self) -> u32 {
        self.words[4]
    }

    /// Slot of the first triangle of the first child that is a leaf.
    #[inline(always)]
    #[must_use]
    pub fn first_triangle(&self) -> u32 {
        self.words[5]
    }

    /// Number of triangles of `child`, 0 if it is a node.
    #[inline(always)]
    #[must_use]
    pub fn triangles(&self, child: usize) -> u32 {
        self.byte(0, child)
    }

    /// The box of `child`, which contains its exact one.
    #[inline(always)]
    #[must_use]
    pub fn aabb(&self, child: usize) -> Aabb {
        // Neither operation rounds, by the choice of the grid.
        let plane = |row: usize, axis: usize| {
            f32::from_bits(self.words[axis])
                + self.byte(row + axis, child) as f32 * step(exponent(axis).get(self.words[3]))
        };
        Aabb { min: from_fn(|axis| plane(1, axis)), max: from_fn(|axis| plane(4, axis)) }
    }

    /// The children with their words, as traversals take them.
    #[inline(always)]
    pub(super) fn siblings(&self) -> Siblings<N> {
        let count = self.children();
        let (mut node, mut triangle) = (self.first_node(), self.first_triangle());
        let mut boxes = [BvhNode { word: 0, aabb: Aabb::EMPTY }; N];
        for (child, found) in boxes[..count].iter_mut().enumerate() {
            let triangles = self.triangles(child);
            let word = if triangles == 0 { node } else { 1 << LEAF.low | triangle };
            *found = BvhNode { word, aabb: self.aabb(child) };
            node += u32::from(triangles == 0);
            triangle += triangles;
        }
        Siblings { boxes, count }
    }

    #[inline(always)]
    fn byte(&self, row: usize, child: usize) -> u32 {
        let at = row * N + child;
        self.words[HEAD_WORDS + at / 4] >> (8 * (at % 4)) & 0xff
    }
}

/// The decoded children of a node.
pub(crate) struct Siblings<const N: usize> {
    boxes: [BvhNode; N],
    count: usize,
}

impl<const N: usize> Deref for Siblings<N> {
    type Target = [BvhNode];

    #[inline(always)]
    fn deref(&self) -> &[BvhNode] {
        &self.boxes[..self.count]
    }
}
