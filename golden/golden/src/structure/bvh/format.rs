//! A hierarchy of boxes as one of the structures.

use super::{Bvh, BvhNode, LEAF};
use crate::Aabb;
use crate::build::{BinaryTree, collapse_wide};
use crate::precision::{Narrow, Planes};
use crate::stats::TreeStatistics;
use crate::structure::{Memory, NodeWords, StructureFormat, TooLarge};
use crate::traverse::Observer;
use crate::traverse::query::Query;
use crate::tree_file::Damage;
use crate::triangle::Triangle;
use std::sync::Arc;

impl<const N: usize> StructureFormat for Bvh<N> {
    const ADDRESS_BYTES: u32 = size_of::<BvhNode>() as u32;

    fn convert(tree: &BinaryTree, triangles: Arc<[Triangle]>) -> Result<Self, TooLarge> {
        Ok(if N == 2 {
            Self::encode(tree, triangles)
        } else {
            Self::encode(&collapse_wide::<N>(tree), triangles)
        })
    }

    fn memory(&self) -> Memory<'_> {
        Memory {
            root_box: &self.root_box,
            root: self.root,
            words: bytemuck::cast_slice(&self.nodes),
            triangles: &self.triangles,
        }
    }

    fn from_memory(
        root_box: Aabb,
        root: u32,
        words: Vec<u32>,
        triangles: Arc<[Triangle]>,
    ) -> Result<Self, Damage> {
        let words_per_node = BvhNode::WORDS as usize;
        if !words.len().is_multiple_of(words_per_node) {
            let expected = words.len().next_multiple_of(words_per_node) as u128 * 4;
            return Err(Damage::Length { found: words.len() * 4, expected });
        }
        let nodes = bytemuck::cast_slice(&words).to_vec();
        let bvh = Self { root_box, root, nodes, triangles };
        bvh.validate().map_err(Damage::nodes)?;
        Ok(bvh)
    }

    fn statistics(&self) -> TreeStatistics {
        super::statistics::of(self, self.node_bytes())
    }

    fn node_words(&self, address: u64) -> NodeWords {
        let node = &self.nodes[(address / u64::from(Self::ADDRESS_BYTES)) as usize];
        NodeWords::Box { leaf: LEAF.get(node.word) == 1 }
    }

    fn rounded(&self, planes: &Planes) -> Self {
        let node = |n: &BvhNode| BvhNode { word: n.word, aabb: planes.aabb(&n.aabb) };
        Self {
            root_box: planes.aabb(&self.root_box),
            root: self.root,
            nodes: self.nodes.iter().map(node).collect(),
            triangles: Arc::clone(&self.triangles),
        }
    }

    fn traverse_narrow<const ANY: bool, O: Observer>(
        narrow: &Narrow<Self>,
        query: &mut Query<'_, ANY>,
        observer: &mut O,
    ) -> bool {
        let bvh = &narrow.structure;
        super::narrow::traverse(bvh, &bvh.root_box, |aabb| *aabb, &narrow.ray(query.ray), query, observer)
    }
}
