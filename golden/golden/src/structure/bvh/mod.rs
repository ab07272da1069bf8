//! Bounding volume hierarchies in their memory format: up to 2, 4, 8 or 16 boxes to a node, 28 bytes a box.
//!
//! | word | content |
//! |---|---|
//! | 0 | bit 31: leaf; below it the number of siblings - 1; then the index of the first child, or of the first triangle |
//! | 1..=3 | the box's minimum x, y, z |
//! | 4..=6 | the box's maximum x, y, z |
//!
//! The number of siblings takes bits 30:28, and bits 30:27 where there are up to 16. Nodes lie depth-first with siblings
//! consecutive. The root is not stored: its box and its word 0 are kept beside the array, as for the dual-split tree.

mod format;
mod hierarchy;
pub(super) mod leaves;
pub(super) mod narrow;
pub(super) mod statistics;
mod step;
pub(super) mod traverse;
mod validate;

pub(super) use hierarchy::Hierarchy;
pub use step::{BoxStep, box_step};
pub use validate::BvhDefect;

use crate::Aabb;
use crate::build::{Content, Tree};
use crate::dst::header::Field;
use crate::triangle::Triangle;
use bytemuck::{Pod, Zeroable};
use scenes::MAX_TRIANGLES;
use std::sync::Arc;

/// 1 in a leaf.
pub const LEAF: Field = Field { low: 31, width: 1 };

/// A node in memory: seven 32-bit words.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct BvhNode {
    /// Word 0.
    pub word: u32,
    /// Words 1 to 6.
    pub aabb: Aabb,
}

const _: () = assert!(size_of::<BvhNode>() == 28);

impl BvhNode {
    /// The 32-bit words that a node takes.
    pub const WORDS: u32 = 7;
}

/// A hierarchy of boxes, up to `N` of which share a parent.
#[derive(Clone, Debug, PartialEq)]
pub struct Bvh<const N: usize> {
    /// The box of everything.
    pub root_box: Aabb,
    /// Word 0 of the root.
    pub root: u32,
    /// All nodes but the root.
    pub nodes: Vec<BvhNode>,
    /// The leaves' triangles, in the order of the leaves.
    pub triangles: Arc<[Triangle]>,
}

/// The binary hierarchy.
pub type Bvh2 = Bvh<2>;
/// The 4-wide hierarchy.
pub type Bvh4 = Bvh<4>;
/// The 8-wide hierarchy.
pub type Bvh8 = Bvh<8>;
/// The 16-wide hierarchy.
pub type Bvh16 = Bvh<16>;

impl<const N: usize> Bvh<N> {
    /// Number of siblings, this node included, less one.
    pub const SIBLINGS: Field = {
        let width = if N <= 8 { 3 } else { (N - 1).ilog2() as usize + 1 };
        Field { low: LEAF.low - width, width }
    };
    /// Index of the first child, or of a leaf's first triangle.
    pub const INDEX: Field = Field { low: 0, width: Self::SIBLINGS.low };

    /// Writes `tree` in the memory format; `triangles` are its primitives in order (see [`pack_triangles`]).
    ///
    /// [`pack_triangles`]: crate::structure::pack_triangles
    #[must_use]
    pub fn encode<const WIDTH: usize>(tree: &Tree<WIDTH>, triangles: Arc<[Triangle]>) -> Self {
        const { assert!(WIDTH <= N, "all children of a node are siblings in memory") };
        // A hierarchy has fewer than two nodes to a triangle.
        const { assert!(2 * MAX_TRIANGLES <= 1 << Self::INDEX.width, "every index fits") };
        // Without the root, every node moves up by one.
        let siblings_less_one = |siblings: u32| (siblings - 1) << Self::SIBLINGS.low;
        let word = |content: Content, siblings: u32| match content {
            Content::Inner { first_child, .. } => siblings_less_one(siblings) | (first_child - 1),
            Content::Leaf { first_primitive, .. } => {
                1 << LEAF.low | siblings_less_one(siblings) | first_primitive
            }
        };
        let mut siblings = vec![1; tree.nodes.len()];
        for node in &tree.nodes {
            let children = tree.children(node);
            let count = children.len() as u32;
            siblings[children].fill(count);
        }
        let nodes = tree.nodes.iter().zip(&siblings).skip(1);
        Self {
            root_box: tree.nodes[0].aabb,
            root: word(tree.nodes[0].content, 1),
            nodes: nodes.map(|(n, s)| BvhNode { word: word(n.content, *s), aabb: n.aabb }).collect(),
            triangles,
        }
    }

    /// The children of the inner node with word 0 `word`.
    #[inline(always)]
    #[must_use]
    pub fn children(&self, word: u32) -> &[BvhNode] {
        let first = Self::INDEX.get(word) as usize;
        // Every inner node of a binary hierarchy has two.
        let count = if N == 2 { 2 } else { Self::SIBLINGS.get(self.nodes[first].word) as usize + 1 };
        &self.nodes[first..first + count]
    }

    /// Bytes of the nodes, without the root and the triangles.
    #[must_use]
    pub fn node_bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice())
    }
}

impl<const N: usize> Hierarchy<N> for Bvh<N> {
    const INDEX: Field = Self::INDEX;

    type Siblings<'a> = &'a [BvhNode];

    #[inline(always)]
    fn root(&self) -> (u32, &Aabb) {
        (self.root, &self.root_box)
    }

    #[inline(always)]
    fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    #[inline(always)]
    fn siblings(&self, word: u32) -> &[BvhNode] {
        self.children(word)
    }

    #[inline(always)]
    fn address(word: u32) -> u64 {
        u64::from(Self::INDEX.get(word)) * size_of::<BvhNode>() as u64
    }

    #[inline(always)]
    fn place(word: u32, child: usize, _count: usize) -> (u64, u32) {
        let bytes = size_of::<BvhNode>() as u32;
        (Self::address(word) + child as u64 * u64::from(bytes), bytes)
    }
}
