//! The structures, one folder each, behind one name; and what they share.
//!
//! A structure is a type that is a [`StructureFormat`], and a line in the list below, from which the enumerations over
//! all structures are made. Everything else goes through the trait.

#[macro_use]
mod list;
pub mod bvh;
pub mod dst;
mod format;
pub mod qbvh;

pub use format::{Memory, NodeWords, StructureFormat, TooLarge};

use crate::Aabb;
use crate::build::{BinaryTree, Content};
use crate::precision::{Narrow, NarrowRay, Precision, Scale};
use crate::ray::{Hit, TraversalRay};
use crate::stats::TreeStatistics;
use crate::traverse::{Observer, Trace};
use crate::tree_file::Damage;
use crate::triangle::Triangle;
use rayon::prelude::*;
use scenes::Mesh;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

// Name of the variant: name for people, number in files, type.
structures! { $
    /// Binary hierarchy of boxes.
    Bvh2: "bvh2", 2, bvh::Bvh<2>;
    /// Hierarchy of up to four boxes to a node.
    Bvh4: "bvh4", 4, bvh::Bvh<4>;
    /// Hierarchy of up to eight boxes to a node.
    Bvh8: "bvh8", 8, bvh::Bvh<8>;
    /// Hierarchy of up to sixteen boxes to a node.
    Bvh16: "bvh16", 16, bvh::Bvh<16>;
    /// Binary hierarchy of boxes with planes of 8 bits.
    QBvh2: "qbvh2", 34, qbvh::QBvh<2>;
    /// Hierarchy of up to four boxes to a node, with planes of 8 bits.
    QBvh4: "qbvh4", 36, qbvh::QBvh<4>;
    /// Hierarchy of up to eight boxes to a node, with planes of 8 bits.
    QBvh8: "qbvh8", 40, qbvh::QBvh<8>;
    /// Dual-split tree.
    Dst: "dst", 0, dst::Dst;
}

impl StructureKind {
    /// The names of all, for messages.
    #[must_use]
    pub fn names() -> String {
        Self::ALL.map(Self::name).join(", ")
    }

    /// The structure with this number in files.
    #[must_use]
    pub fn from_code(code: u32) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.code() == code)
    }
}

impl fmt::Display for StructureKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The name of no structure.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no structure '{0}': take one of {names}", names = StructureKind::names())]
pub struct UnknownStructure(String);

impl FromStr for StructureKind {
    type Err = UnknownStructure;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        Self::ALL.into_iter().find(|s| s.name() == name).ok_or_else(|| UnknownStructure(name.to_owned()))
    }
}

/// A structure is not over the mesh that it is to be used with.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OtherMesh {
    /// Another number of triangles.
    #[error("the tree is over {tree} triangles, the scene has {mesh}")]
    Count {
        /// Triangles of the structure.
        tree: usize,
        /// Triangles of the mesh.
        mesh: usize,
    },
    /// A triangle that is elsewhere, or there twice, or not at all.
    #[error("triangle {0} of the tree is not that of the scene")]
    Triangle(usize),
}

impl Structure {
    /// Converts `tree` to a structure of `kind`; `triangles` are the tree's, from [`pack_triangles`].
    ///
    /// # Errors
    /// If the structure's offsets do not suffice.
    pub fn convert(
        kind: StructureKind,
        tree: &BinaryTree,
        triangles: &Arc<[Triangle]>,
    ) -> Result<Self, TooLarge> {
        let triangles = Arc::clone(triangles);
        with_format!(kind, Format => <Format as StructureFormat>::convert(tree, triangles).map(Self::from))
    }

    /// The structure of `kind` that lies in memory, if it is proved to be one.
    pub(crate) fn from_memory(
        kind: StructureKind,
        root_box: Aabb,
        root: u32,
        words: Vec<u32>,
        triangles: Arc<[Triangle]>,
    ) -> Result<Self, Damage> {
        with_format!(kind, Format => Format::from_memory(root_box, root, words, triangles).map(Self::from))
    }

    /// What is in memory.
    #[must_use]
    pub fn memory(&self) -> Memory<'_> {
        with_structure!(self, structure => structure.memory())
    }

    /// The leaves' triangles.
    #[must_use]
    pub fn triangles(&self) -> &Arc<[Triangle]> {
        self.memory().triangles
    }

    /// Bytes of the nodes, without the triangles.
    #[must_use]
    pub fn node_bytes(&self) -> usize {
        size_of_val(self.memory().words)
    }

    /// See [`StructureFormat::statistics`].
    pub(crate) fn statistics(&self) -> TreeStatistics {
        with_structure!(self, structure => structure.statistics())
    }

    /// Bytes that an offset in the format counts.
    #[must_use]
    pub fn address_bytes(&self) -> u32 {
        with_format!(self.kind(), Format => Format::ADDRESS_BYTES)
    }

    /// What the node says that begins `address` bytes from the start.
    ///
    /// # Panics
    /// If no node begins there.
    #[must_use]
    pub fn node_words(&self, address: u64) -> NodeWords {
        with_structure!(self, structure => structure.node_words(address))
    }

    /// Proves that the structure holds each triangle of `mesh` once and no other, bit for bit; for one that is loaded.
    ///
    /// # Errors
    /// [`OtherMesh`], the first difference.
    pub fn check_over(&self, mesh: &Mesh) -> Result<(), OtherMesh> {
        let triangles = self.triangles();
        if triangles.len() != mesh.triangles.len() {
            return Err(OtherMesh::Count { tree: triangles.len(), mesh: mesh.triangles.len() });
        }
        let mut found = vec![false; triangles.len()];
        for triangle in triangles.iter() {
            let index = triangle.index() as usize;
            let differs = |corners: [[f32; 3]; 3]| {
                triangle
                    .corners()
                    .as_flattened()
                    .iter()
                    .zip(corners.as_flattened())
                    .any(|(a, b)| a.to_bits() != b.to_bits())
            };
            match found.get_mut(index) {
                Some(found) if !*found && !differs(mesh.corners(index)) => *found = true,
                _ => return Err(OtherMesh::Triangle(index)),
            }
        }
        Ok(())
    }
}

impl Trace for Structure {
    #[inline]
    fn closest_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
        with_structure!(self, structure => structure.closest_prepared(ray, observer))
    }

    #[inline]
    fn occluded_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
        with_structure!(self, structure => structure.occluded_prepared(ray, observer))
    }
}

impl NarrowStructure {
    /// Converts `structure`; the same nodes in the same places.
    #[must_use]
    pub fn new(structure: &Structure, precision: Precision) -> Self {
        with_structure!(structure, structure => Narrow::new(structure, precision).into())
    }

    /// A box of the scene and a ray as this structure would hold them.
    #[must_use]
    pub fn narrow(&self, bounds: &Aabb, ray: &TraversalRay) -> (Aabb, NarrowRay) {
        with_narrow!(self, structure => (structure.aabb(bounds), structure.ray(ray)))
    }

    /// What planes have been multiplied by.
    #[must_use]
    pub fn scale(&self) -> Scale {
        with_narrow!(self, structure => structure.scale)
    }
}

impl Trace for NarrowStructure {
    fn closest_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
        with_narrow!(self, structure => structure.closest_prepared(ray, observer))
    }

    fn occluded_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
        with_narrow!(self, structure => structure.occluded_prepared(ray, observer))
    }
}

/// The triangles of `tree` in the order of its primitives, each leaf's last one marked.
///
/// # Panics
/// If `tree` is not a hierarchy over `mesh`.
#[must_use]
pub fn pack_triangles(mesh: &Mesh, tree: &BinaryTree) -> Arc<[Triangle]> {
    let mut last = vec![false; tree.primitives.len()];
    for node in &tree.nodes {
        if let Content::Leaf { first_primitive, primitive_count } = node.content {
            last[(first_primitive + primitive_count - 1) as usize] = true;
        }
    }
    tree.primitives.par_iter().zip(&last).map(|(&index, &last)| Triangle::new(mesh, index, last)).collect()
}
