//! Construction of the binary hierarchy that every structure is converted from.
//!
//! ```
//! use golden::build::{BuildOptions, Quality, build};
//!
//! let mesh = scenes::Mesh {
//!     positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//!     triangles: vec![[0, 1, 2]],
//! };
//! let tree = build(&mesh, &BuildOptions::new(Quality::High))?;
//! assert_eq!(tree.nodes.len(), 1);
//! # Ok::<(), golden::build::BuildError>(())
//! ```

mod binned;
mod bounds;
mod collapse;
mod depth;
mod exchange;
mod reinsertion;
mod sweep;
#[cfg(test)]
mod testing;
mod tree;
mod wide;
mod work;

use crate::Aabb;
use crate::dst::fewest_carves;
use rayon::prelude::*;
use scenes::{MAX_TRIANGLES, Mesh};

pub use tree::{BinaryNode, BinaryTree, Content, Node, Tree, TreeDefect};
pub use wide::{WideTree, collapse_wide};

use bounds::Bounds;
use collapse::{collapse_leaves, surface_area};
use reinsertion::Stage;
use work::{Place, WorkTree};

/// No tree is deeper: at most this many edges from the root to a leaf, whatever the mesh. A traversal that
/// keeps one entry for each level above the current node needs a stack of this size.
pub const MAX_DEPTH: u32 = 64;

/// The greatest value of [`BuildOptions::max_leaf_size`].
pub const MAX_LEAF_SIZE: u32 = 255;

/// What a carve node of the dual-split tree is worth to [`Quality::High`], in visits of an average inner node: among trees
/// of about the same SAH cost, the one is taken whose dual-split tree is smaller. The cost rises by less than 1 %.
const CARVE_WEIGHT: f64 = 0.08;
/// The most rounds of exchanges; the last ones hardly change anything.
const EXCHANGE_ROUNDS: u32 = 8;

/// How much time is spent on a good tree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quality {
    /// Binned SAH, reinsertion of the largest nodes.
    Fast,
    /// Binned SAH with full sweeps of small ranges, reinsertion of more nodes.
    Medium,
    /// Full sweeps, reinsertion of all nodes until it hardly gains, exchanges that save carve nodes.
    #[default]
    High,
}

impl Quality {
    fn reinsertion_stages(self) -> &'static [Stage] {
        match self {
            Self::Fast => &[Stage { share: 0.01, rounds: 2 }],
            Self::Medium => &[Stage { share: 0.05, rounds: 4 }],
            Self::High => &[
                Stage { share: 0.1, rounds: 12 },
                Stage { share: 1.0, rounds: 12 },
                Stage { share: 1.0, rounds: 12 },
            ],
        }
    }
}

/// What [`build`] is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BuildOptions {
    /// Construction time against tree quality.
    pub quality: Quality,
    /// The greatest number of triangles in a leaf, 1 to [`MAX_LEAF_SIZE`]. Leaves grow only where that lowers
    /// the SAH cost.
    pub max_leaf_size: u32,
}

impl BuildOptions {
    /// `quality` with the default leaf size.
    #[must_use]
    pub fn new(quality: Quality) -> Self {
        Self { quality, max_leaf_size: 4 }
    }
}

impl Default for BuildOptions {
    fn default() -> Self {
        Self::new(Quality::default())
    }
}

/// Why there is no tree.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BuildError {
    /// The mesh has no triangles.
    #[error("the mesh has no triangles: nothing to build a tree over")]
    NoTriangles,
    /// The mesh is too large for the node formats.
    #[error(
        "the mesh has {triangles} triangles, more than the {MAX_TRIANGLES} that a tree can address: split it"
    )]
    TooManyTriangles {
        /// Number of triangles in the mesh.
        triangles: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle}: vertex index {index} is out of range, the mesh has {vertices} vertices")]
    IndexOutOfRange {
        /// Index of the triangle.
        triangle: usize,
        /// The index that it names.
        index: u32,
        /// Number of vertices in the mesh.
        vertices: usize,
    },
    /// A triangle has a corner that is infinite or not a number.
    #[error("triangle {triangle}: vertex {vertex} is at {position:?}; coordinates must be finite")]
    NonFiniteVertex {
        /// Index of the triangle.
        triangle: usize,
        /// Index of the vertex.
        vertex: u32,
        /// Its position.
        position: [f32; 3],
    },
    /// The leaf size is out of range.
    #[error("max_leaf_size is {0}, must be 1 to {MAX_LEAF_SIZE}")]
    LeafSize(u32),
}

/// Builds a hierarchy over the triangles of `mesh` on the threads of the current `rayon` pool.
///
/// The result depends on the mesh and the options only, not on the number of threads nor on the machine.
/// Degenerate and duplicate triangles are kept. The tree is at most [`MAX_DEPTH`] deep for every input, and
/// each pass takes O(n log n) as long as the trees in between are about as balanced as scenes make them, O(n
/// [`MAX_DEPTH`]) at worst.
///
/// # Errors
/// See [`BuildError`]; of several faulty triangles the first is named.
pub fn build(mesh: &Mesh, options: &BuildOptions) -> Result<BinaryTree, BuildError> {
    let mut tree = partition(mesh, options)?;
    if options.quality == Quality::High {
        let inner_nodes = tree.leaf_count().saturating_sub(1).max(1);
        let carve = CARVE_WEIGHT * tree.inner_area() / inner_nodes as f64;
        exchange::exchange(&mut tree, EXCHANGE_ROUNDS, |node, children| {
            node.half_area() + carve * f64::from(fewest_carves(&node.into(), &children.map(Aabb::from)))
        });
    }
    depth::limit_depth(&mut tree, MAX_DEPTH);
    Ok(tree.to_tree())
}

/// As [`build`], but for structures whose inner nodes cost `cost` of their box and their children's boxes, in half area and
/// no less than that of their box, where a triangle costs the half area of its leaf.
pub(crate) fn build_for_cost(
    mesh: &Mesh,
    options: &BuildOptions,
    cost: impl Fn(&Aabb, &[Aabb; 2]) -> f64 + Sync,
) -> Result<BinaryTree, BuildError> {
    let cost = |node: Bounds, children: [Bounds; 2]| cost(&node.into(), &children.map(Aabb::from));
    let mut tree = partition(mesh, options)?;
    exchange::exchange(&mut tree, EXCHANGE_ROUNDS, cost);
    tree = collapse_leaves(&tree, options.max_leaf_size, cost);
    depth::limit_depth(&mut tree, MAX_DEPTH);
    Ok(tree.to_tree())
}

/// The hierarchy of the least SAH cost that the preset finds, of any depth.
fn partition(mesh: &Mesh, options: &BuildOptions) -> Result<WorkTree, BuildError> {
    if !(1..=MAX_LEAF_SIZE).contains(&options.max_leaf_size) {
        return Err(BuildError::LeafSize(options.max_leaf_size));
    }
    let mut boxes = triangle_boxes(mesh)?;
    let mut tree = WorkTree::with_single_leaves((0..boxes.len() as u32).collect());
    let centres = binned::centre_bounds(&boxes);
    let place = Place::root(&mut tree, MAX_DEPTH);
    let (link, bounds) = match options.quality {
        Quality::Fast => binned::build::<16>(&mut boxes, centres, place, 32),
        Quality::Medium => binned::build::<32>(&mut boxes, centres, place, 1024),
        Quality::High => sweep::build(&boxes, place),
    };
    tree.set_link(WorkTree::ROOT, link);
    tree.set_bounds(WorkTree::ROOT, bounds);

    // Merging before the optimisation halves its work and makes it count what the result will cost.
    tree = collapse_leaves(&tree, options.max_leaf_size, surface_area);
    let stages = options.quality.reinsertion_stages();
    reinsertion::optimise(&mut tree, stages);
    if options.quality == Quality::High {
        tree = collapse_leaves(&tree, options.max_leaf_size, surface_area);
    }
    Ok(tree)
}

fn triangle_boxes(mesh: &Mesh) -> Result<Vec<Bounds>, BuildError> {
    check_mesh(mesh)?;
    let corner = |index: u32| mesh.positions[index as usize];
    Ok(mesh.triangles.par_iter().map(|triangle| Bounds::of_triangle(triangle.map(corner))).collect())
}

/// Whether a tree can be built over `mesh`.
pub(crate) fn check_mesh(mesh: &Mesh) -> Result<(), BuildError> {
    match mesh.triangles.len() {
        0 => return Err(BuildError::NoTriangles),
        triangles if triangles > MAX_TRIANGLES => return Err(BuildError::TooManyTriangles { triangles }),
        _ => {}
    }
    let triangles = mesh.triangles.par_iter().enumerate();
    triangles.find_map_first(|(i, t)| check_triangle(mesh, i, t).err()).map_or(Ok(()), Err)
}

fn check_triangle(mesh: &Mesh, triangle: usize, indices: &[u32; 3]) -> Result<(), BuildError> {
    for &index in indices {
        match mesh.positions.get(index as usize) {
            None => {
                return Err(BuildError::IndexOutOfRange { triangle, index, vertices: mesh.positions.len() });
            }
            Some(position) if position.iter().any(|x| !x.is_finite()) => {
                return Err(BuildError::NonFiniteVertex { triangle, vertex: index, position: *position });
            }
            Some(_) => {}
        }
    }
    Ok(())
}
