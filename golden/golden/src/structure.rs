//! All structures behind one name, and what they share.

use crate::build::{BinaryTree, Content, collapse_wide};
use crate::bvh::{Bvh2, Bvh4, Bvh8};
use crate::dst::{Dst, DstError};
use crate::ray::{Hit, TraversalRay};
use crate::traverse::{Trace, Traversal};
use crate::triangle::Triangle;
use rayon::prelude::*;
use scenes::Mesh;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

/// Which structure rays are traced through.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StructureKind {
    /// Binary hierarchy of boxes.
    Bvh2,
    /// Hierarchy of up to four boxes to a node.
    Bvh4,
    /// Hierarchy of up to eight boxes to a node.
    Bvh8,
    /// Dual-split tree.
    Dst,
}

impl StructureKind {
    /// All of them, in the order in which tables list them.
    pub const ALL: [Self; 4] = [Self::Bvh2, Self::Bvh4, Self::Bvh8, Self::Dst];

    /// The structure's name on the command line and in result files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Bvh2 => "bvh2",
            Self::Bvh4 => "bvh4",
            Self::Bvh8 => "bvh8",
            Self::Dst => "dst",
        }
    }
}

impl fmt::Display for StructureKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The name of no structure.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no structure '{0}': take one of bvh2, bvh4, bvh8, dst")]
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

/// A structure of any kind.
#[derive(Clone, Debug)]
pub enum Structure {
    /// Binary hierarchy of boxes.
    Bvh2(Bvh2),
    /// Hierarchy of up to four boxes to a node.
    Bvh4(Bvh4),
    /// Hierarchy of up to eight boxes to a node.
    Bvh8(Bvh8),
    /// Dual-split tree.
    Dst(Dst),
}

impl Structure {
    /// Converts `tree` to a structure of `kind`; `triangles` are the tree's, from [`pack_triangles`].
    ///
    /// # Errors
    /// [`DstError::TooLarge`] if a dual-split tree's offsets do not suffice.
    pub fn convert(
        kind: StructureKind,
        tree: &BinaryTree,
        triangles: &Arc<[Triangle]>,
    ) -> Result<Self, DstError> {
        let triangles = Arc::clone(triangles);
        Ok(match kind {
            StructureKind::Bvh2 => Self::Bvh2(Bvh2::encode(tree, triangles)),
            StructureKind::Bvh4 => Self::Bvh4(Bvh4::encode(&collapse_wide(tree), triangles)),
            StructureKind::Bvh8 => Self::Bvh8(Bvh8::encode(&collapse_wide(tree), triangles)),
            StructureKind::Dst => Self::Dst(Dst::convert(tree, triangles)?),
        })
    }

    /// Which structure this is.
    #[must_use]
    pub fn kind(&self) -> StructureKind {
        match self {
            Self::Bvh2(_) => StructureKind::Bvh2,
            Self::Bvh4(_) => StructureKind::Bvh4,
            Self::Bvh8(_) => StructureKind::Bvh8,
            Self::Dst(_) => StructureKind::Dst,
        }
    }

    /// The leaves' triangles.
    #[must_use]
    pub fn triangles(&self) -> &Arc<[Triangle]> {
        match self {
            Self::Bvh2(bvh) => &bvh.triangles,
            Self::Bvh4(bvh) => &bvh.triangles,
            Self::Bvh8(bvh) => &bvh.triangles,
            Self::Dst(dst) => &dst.triangles,
        }
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

    /// Bytes of the nodes, without the triangles.
    #[must_use]
    pub fn node_bytes(&self) -> usize {
        match self {
            Self::Bvh2(bvh) => bvh.node_bytes(),
            Self::Bvh4(bvh) => bvh.node_bytes(),
            Self::Bvh8(bvh) => bvh.node_bytes(),
            Self::Dst(dst) => dst.node_bytes(),
        }
    }
}

impl Trace for Structure {
    #[inline]
    fn closest_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
        match self {
            Self::Bvh2(bvh) => bvh.closest_prepared(ray, observer),
            Self::Bvh4(bvh) => bvh.closest_prepared(ray, observer),
            Self::Bvh8(bvh) => bvh.closest_prepared(ray, observer),
            Self::Dst(dst) => dst.closest_prepared(ray, observer),
        }
    }

    #[inline]
    fn occluded_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
        match self {
            Self::Bvh2(bvh) => bvh.occluded_prepared(ray, observer),
            Self::Bvh4(bvh) => bvh.occluded_prepared(ray, observer),
            Self::Bvh8(bvh) => bvh.occluded_prepared(ray, observer),
            Self::Dst(dst) => dst.occluded_prepared(ray, observer),
        }
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
