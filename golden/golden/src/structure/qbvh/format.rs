//! A hierarchy with planes of 8 bits as one of the structures.

use super::{Node, QBvh};
use crate::Aabb;
use crate::build::{BinaryTree, collapse_wide};
use crate::bvh::{self, Hierarchy, LEAF};
use crate::precision::{Narrow, Planes};
use crate::stats::TreeStatistics;
use crate::structure::{Memory, NodeWords, StructureFormat, TooLarge};
use crate::traverse::Observer;
use crate::traverse::query::Query;
use crate::tree_file::Damage;
use crate::triangle::Triangle;
use std::sync::Arc;

impl<const N: usize> StructureFormat for QBvh<N> {
    /// A box has no size of its own.
    const ADDRESS_BYTES: u32 = 1;

    fn convert(tree: &BinaryTree, triangles: Arc<[Triangle]>) -> Result<Self, TooLarge> {
        Ok(Self::encode(&collapse_wide::<N>(tree), &triangles))
    }

    fn memory(&self) -> Memory<'_> {
        Memory { root_box: &self.root_box, root: self.root, words: &self.words, triangles: &self.triangles }
    }

    fn from_memory(
        root_box: Aabb,
        root: u32,
        words: Vec<u32>,
        triangles: Arc<[Triangle]>,
    ) -> Result<Self, Damage> {
        let words_per_node = Node::<N>::WORDS;
        if !words.len().is_multiple_of(words_per_node) {
            let expected = words.len().next_multiple_of(words_per_node) as u128 * 4;
            return Err(Damage::Length { found: words.len() * 4, expected });
        }
        let tree = Self { root_box, root, words, triangles };
        tree.validate().map_err(Damage::nodes)?;
        Ok(tree)
    }

    fn statistics(&self) -> TreeStatistics {
        bvh::statistics::of(self, self.node_bytes())
    }

    fn node_words(&self, address: u64) -> NodeWords {
        let bytes = Node::<N>::BYTES as u64;
        let index = (address / bytes) as u32;
        let siblings = self.siblings(index);
        let is_at = |child: &usize| Self::place(index, *child, siblings.len()).0 == address;
        let child = (0..siblings.len()).find(is_at).expect("a box of the node begins there");
        NodeWords::Box { leaf: LEAF.get(siblings[child].word) == 1 }
    }

    /// The nodes stay as they are, and a traversal rounds the planes that it decodes.
    fn rounded(&self, planes: &Planes) -> Self {
        Self { root_box: planes.aabb(&self.root_box), ..self.clone() }
    }

    fn traverse_narrow<const ANY: bool, O: Observer>(
        narrow: &Narrow<Self>,
        query: &mut Query<'_, ANY>,
        observer: &mut O,
    ) -> bool {
        let (tree, ray) = (&narrow.structure, narrow.ray(query.ray));
        bvh::narrow::traverse(tree, &tree.root_box, |aabb| narrow.aabb(aabb), &ray, query, observer)
    }
}
