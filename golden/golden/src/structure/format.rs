//! What a structure has to bring.

use crate::Aabb;
use crate::build::BinaryTree;
use crate::precision::{Narrow, Planes};
use crate::stats::TreeStatistics;
use crate::traverse::query::Query;
use crate::traverse::{Leaves, Observer, Trace};
use crate::tree_file::Damage;
use crate::triangle::Triangle;
use std::fmt;
use std::sync::Arc;

/// The memory format of a structure, with everything that is done to it. [`Trace`] is its traversal in binary32.
pub trait StructureFormat: Trace + Leaves + Clone + fmt::Debug + Sized {
    /// Bytes that an offset in the format counts: those of a node, or of a word.
    const ADDRESS_BYTES: u32;

    /// Converts `tree`, whose primitives are `triangles` in order.
    ///
    /// # Errors
    /// If the format cannot address all nodes.
    fn convert(tree: &BinaryTree, triangles: Arc<[Triangle]>) -> Result<Self, TooLarge>;

    /// What is in memory.
    fn memory(&self) -> Memory<'_>;

    /// The structure that lies in memory, if it is proved to be one: neither damage nor forgery gets as far as a traversal.
    ///
    /// # Errors
    /// What is wrong with it.
    fn from_memory(
        root_box: Aabb,
        root: u32,
        words: Vec<u32>,
        triangles: Arc<[Triangle]>,
    ) -> Result<Self, Damage>;

    /// Sizes, costs and histograms.
    ///
    /// # Panics
    /// If the structure is not valid.
    fn statistics(&self) -> TreeStatistics;

    /// What the node says that begins `address` bytes from the start.
    ///
    /// # Panics
    /// If no node begins there.
    fn node_words(&self, address: u64) -> NodeWords;

    /// The same nodes in the same places with planes of a narrow format.
    fn rounded(&self, planes: &Planes) -> Self;

    /// Visits nodes of a structure in a narrow format until nothing nearer can be found, or with `ANY` until something is;
    /// returns whether it was.
    fn traverse_narrow<const ANY: bool, O: Observer>(
        narrow: &Narrow<Self>,
        query: &mut Query<'_, ANY>,
        observer: &mut O,
    ) -> bool;
}

/// A structure in memory.
#[derive(Clone, Copy, Debug)]
pub struct Memory<'a> {
    /// The box of everything; not one of the words.
    pub root_box: &'a Aabb,
    /// What a format keeps beside the words to find the root, or 0.
    pub root: u32,
    /// The nodes.
    pub words: &'a [u32],
    /// The leaves' triangles.
    pub triangles: &'a Arc<[Triangle]>,
}

/// What a node says, for people.
#[derive(Clone, Debug, PartialEq)]
pub enum NodeWords {
    /// A box of its own.
    Box {
        /// Whether it is that of a leaf.
        leaf: bool,
    },
    /// Planes that cut the box of the node above.
    Planes {
        /// What they cut and where they lead.
        header: String,
        /// The planes that are tested; none in a bare leaf.
        planes: Vec<f32>,
    },
}

/// A structure's format cannot address all of a tree.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the {structure} would need offsets up to {words}, more than the 2^{bits} that a node's {bits} bits \
     reach: raise the leaf size or lower the scene's detail"
)]
pub struct TooLarge {
    /// The structure, for people.
    pub structure: &'static str,
    /// The offset that does not fit.
    pub words: u64,
    /// Bits of an offset.
    pub bits: u32,
}
