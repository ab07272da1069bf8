//! Dual-split trees: node format, traversal step, conversion from a binary hierarchy, proof of validity.

mod build;
mod convert;
mod format;
pub mod header;
mod kernel;
mod kernel_rows;
mod leaves;
mod narrow;
mod statistics;
mod step;
mod steps;
mod validate;

pub use build::build_for_dst;
pub use convert::MAX_CARVES;
pub(crate) use convert::fewest_carves;
pub use statistics::CarveStatistics;
pub use step::{Child, Code, Step, step};
pub use steps::{closest_by_steps, occluded_by_steps};
pub use validate::{DstDefect, End, Record};

use crate::Aabb;
use crate::triangle::Triangle;
use header::{Header, LEAF_WORDS, NODE_WORDS};
use std::sync::Arc;

/// Words behind the tree, so that a bare leaf at its end can be read like a node.
const PADDING: usize = (NODE_WORDS - LEAF_WORDS) as usize;

/// A dual-split tree in its memory format.
#[derive(Clone, Debug, PartialEq)]
pub struct Dst {
    /// The box of everything; not stored in the tree.
    pub root_box: Aabb,
    /// Headers and planes (see [`header`]), the root at offset 0; then [`PADDING`] words of zero.
    memory: Vec<u32>,
    /// The leaves' triangles.
    pub triangles: Arc<[Triangle]>,
}

/// How many nodes of each kind a tree has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NodeCounts {
    /// Split nodes.
    pub splits: usize,
    /// Carve nodes of one axis.
    pub single_carves: usize,
    /// Carve nodes of two axes.
    pub dual_carves: usize,
    /// Leaves of one word.
    pub bare_leaves: usize,
    /// Leaves that a carve node holds.
    pub carved_leaves: usize,
}

impl NodeCounts {
    /// Carve nodes of either kind.
    #[must_use]
    pub fn carves(&self) -> usize {
        self.single_carves + self.dual_carves
    }

    /// Nodes of all kinds, bare leaves included.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.splits + self.carves() + self.bare_leaves
    }
}

impl Dst {
    /// A tree of these `words`, not yet validated.
    pub(crate) fn new(root_box: Aabb, words: Vec<u32>, triangles: Arc<[Triangle]>) -> Self {
        let mut memory = words;
        memory.extend([0; PADDING]);
        Self { root_box, memory, triangles }
    }

    /// Headers and planes (see [`header`]); the root is at offset 0.
    #[inline(always)]
    #[must_use]
    pub fn words(&self) -> &[u32] {
        &self.memory[..self.memory.len() - PADDING]
    }

    /// Three words from `offset`; those after a bare leaf are not part of it.
    ///
    /// # Panics
    /// If `offset` is not below the number of words.
    #[inline(always)]
    #[must_use]
    pub fn node(&self, offset: u32) -> [u32; NODE_WORDS as usize] {
        let offset = offset as usize;
        self.memory[offset..offset + NODE_WORDS as usize].try_into().expect("three words")
    }

    /// The header and the planes at `offset` without a check, for the innermost loop.
    ///
    /// # Safety
    /// `offset` has to be below the number of words, as is every offset that a header of a valid tree holds.
    #[inline(always)]
    pub(crate) unsafe fn node_unchecked(&self, offset: u32) -> (u32, &[f32; 2]) {
        debug_assert!((offset as usize) < self.words().len());
        // SAFETY: the caller's promise; PADDING words follow the tree, and f32 is aligned and as free of invalid bits as u32.
        unsafe {
            let node = self.memory.as_ptr().add(offset as usize);
            (*node, &*node.add(1).cast())
        }
    }

    /// Bytes of the nodes, without the triangles.
    #[must_use]
    pub fn node_bytes(&self) -> usize {
        size_of_val(self.words())
    }

    /// Counts the nodes of each kind; every record is read once in the order of memory.
    #[must_use]
    pub fn node_counts(&self) -> NodeCounts {
        let mut counts = NodeCounts::default();
        let mut at = 0;
        while at < self.words().len() {
            let leaf = match Header::decode(self.words()[at]) {
                Some(Header::Split { .. }) | None => {
                    counts.splits += 1;
                    false
                }
                Some(Header::CarveSingle { leaf, .. }) => {
                    counts.single_carves += 1;
                    leaf
                }
                Some(Header::CarveDual { leaf, .. }) => {
                    counts.dual_carves += 1;
                    leaf
                }
                Some(Header::Leaf { .. }) => {
                    counts.bare_leaves += 1;
                    at += 1;
                    continue;
                }
            };
            counts.carved_leaves += usize::from(leaf);
            at += NODE_WORDS as usize;
        }
        counts
    }
}

/// Bytes before the node at `offset`.
fn address(offset: u32) -> u64 {
    u64::from(offset) * size_of::<u32>() as u64
}
