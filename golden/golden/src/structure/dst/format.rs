//! The dual-split tree as one of the structures.

use super::Dst;
use super::header::Header;
use crate::Aabb;
use crate::build::BinaryTree;
use crate::precision::{Narrow, Planes};
use crate::stats::TreeStatistics;
use crate::structure::{Memory, NodeWords, StructureFormat, TooLarge};
use crate::traverse::Observer;
use crate::traverse::query::Query;
use crate::tree_file::Damage;
use crate::triangle::Triangle;
use std::sync::Arc;

impl StructureFormat for Dst {
    const ADDRESS_BYTES: u32 = size_of::<u32>() as u32;

    fn convert(tree: &BinaryTree, triangles: Arc<[Triangle]>) -> Result<Self, TooLarge> {
        Self::convert(tree, triangles)
    }

    fn memory(&self) -> Memory<'_> {
        Memory { root_box: &self.root_box, root: 0, words: self.words(), triangles: &self.triangles }
    }

    fn from_memory(
        root_box: Aabb,
        _root: u32,
        words: Vec<u32>,
        triangles: Arc<[Triangle]>,
    ) -> Result<Self, Damage> {
        let dst = Self::new(root_box, words, triangles);
        dst.validate_alone().map_err(Damage::nodes)?;
        Ok(dst)
    }

    fn statistics(&self) -> TreeStatistics {
        super::statistics::of(self)
    }

    fn node_words(&self, address: u64) -> NodeWords {
        let [header, planes @ ..] = self.node((address / u64::from(Self::ADDRESS_BYTES)) as u32);
        let header = Header::decode(header).expect("a valid tree");
        let planes = if matches!(header, Header::Leaf { .. }) { &[][..] } else { &planes };
        NodeWords::Planes {
            header: header.to_string(),
            planes: planes.iter().map(|word| f32::from_bits(*word)).collect(),
        }
    }

    fn rounded(&self, planes: &Planes) -> Self {
        super::narrow::rounded(self, planes)
    }

    fn traverse_narrow<const ANY: bool, O: Observer>(
        narrow: &Narrow<Self>,
        query: &mut Query<'_, ANY>,
        observer: &mut O,
    ) -> bool {
        narrow.by_steps(query, observer, super::step)
    }
}
