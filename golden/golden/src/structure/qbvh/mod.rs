//! Bounding volume hierarchies with planes of 8 bits: up to 2, 4 or 8 boxes in a node of 40, 52 or 80 bytes.
//!
//! | word | content |
//! |---|---|
//! | 0..=2 | x, y, z of the grid's origin, in binary32 |
//! | 3 | bits 7:0, 15:8, 23:16: the biased binary32 exponent of the grid's step on x, y, z; bits 26:24: number of children - 1 |
//! | 4 | index of the first child that is a node |
//! | 5 | slot of the first triangle of the first child that is a leaf |
//! | from 6 | bytes, the least significant first: `N` numbers of triangles, 0 for a child that is a node; then `N` planes each for the minimum x, y, z and the maximum x, y, z |
//!
//! Children that are nodes lie one behind the other, and so do the triangles of children that are leaves: the place of
//! a child is the sum of what stands before it. Bytes of children that are not there are 0. Nodes lie depth-first, and a
//! node's own leaves lie before those below it, so that the order of triangles is not that of the binary tree. As in
//! [`crate::bvh`], the root's box and word are kept beside the array.
//!
//! After Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", HPG 2017, whose
//! node has the same size for eight children. There, children are ordered by octant when the tree is built; here a ray
//! visits them in the order in which it enters them, as in the hierarchy with exact boxes.
//!
//! # Grids
//! A plane `q` of an axis lies at `origin + q * step`. The step is the least power of two with which 256 planes reach around
//! the node's box and with which every one of them is a binary32 number: a multiple of the step below `2^24` steps. So
//! decoding a plane is exact. Minima are rounded down and maxima up, to the nearest plane of the grid.
//!
//! # Why robust mode loses nothing
//! Every stored box contains the exact one. A subtraction and a multiplication that round to nearest are monotone, and
//! so are the folds of the ray-box test. So the interval of a stored box contains that of the exact box, bit for bit, NaN
//! included: a plane that is moved off a parallel ray's origin gives an infinite distance on the side that constrains
//! nothing. A hit lies in the interval of every exact box around its triangle (see [`crate::triangle`]), hence in that
//! of every stored one, and the traversal finds it. The hit is that of the exact hierarchy, as the triangle test
//! is the same and knows no box. Fast mode loses hits at a box's edge, of which a larger box has fewer.

mod format;
mod node;
#[cfg(test)]
mod tests;
mod validate;

pub use node::Node;
pub use validate::QBvhDefect;

use crate::Aabb;
use crate::build::{Content, Tree};
use crate::bvh::{self, Hierarchy, LEAF};
use crate::dst::header::Field;
use crate::ray::{Hit, TraversalRay};
use crate::traverse::{Leaf, Leaves, Observer, Trace};
use crate::triangle::Triangle;
use node::{Child, Siblings};
use std::sync::Arc;

/// A hierarchy of boxes with planes of 8 bits, up to `N` of which share a node.
#[derive(Clone, Debug, PartialEq)]
pub struct QBvh<const N: usize> {
    /// The box of everything, exact.
    pub root_box: Aabb,
    /// [`LEAF`] if the root is a leaf, else 0.
    pub root: u32,
    /// The nodes.
    words: Vec<u32>,
    /// The leaves' triangles, in the order of the leaves.
    pub triangles: Arc<[Triangle]>,
}

impl<const N: usize> QBvh<N> {
    /// Writes `tree` in the memory format; `triangles` are its primitives in order (see [`pack_triangles`]).
    ///
    /// [`pack_triangles`]: crate::structure::pack_triangles
    #[must_use]
    pub fn encode(tree: &Tree<N>, triangles: &Arc<[Triangle]>) -> Self {
        let root_box = tree.nodes[0].aabb;
        if tree.children(&tree.nodes[0]).is_empty() {
            let triangles = Arc::clone(triangles);
            return Self { root_box, root: 1 << LEAF.low, words: vec![], triangles };
        }
        let inner = tree.nodes.iter().filter(|node| !tree.children(node).is_empty()).count();
        let mut words = vec![0; inner * Node::<N>::WORDS];
        let mut ordered = Vec::with_capacity(triangles.len());
        let mut next_node = 1;
        // Index in the tree, and among the nodes in memory.
        let mut stack = vec![(0, 0)];
        let mut below = vec![];
        while let Some((index, at)) = stack.pop() {
            let (first_node, first_triangle) = (next_node as u32, ordered.len() as u32);
            let of = |child: usize| {
                let node = &tree.nodes[child];
                let triangles = match node.content {
                    Content::Inner { .. } => {
                        below.push((child, next_node));
                        next_node += 1;
                        0
                    }
                    Content::Leaf { first_primitive, primitive_count } => {
                        let first = first_primitive as usize;
                        ordered.extend_from_slice(&triangles[first..first + primitive_count as usize]);
                        u8::try_from(primitive_count).expect("leaves have at most MAX_LEAF_SIZE triangles")
                    }
                };
                Child { triangles, aabb: node.aabb }
            };
            let children: Vec<Child> = tree.children(&tree.nodes[index]).map(of).collect();
            let first = at * Node::<N>::WORDS;
            words[first..first + Node::<N>::WORDS].copy_from_slice(&node::encode::<N>(
                &children,
                first_node,
                first_triangle,
            ));
            stack.extend(below.drain(..).rev());
        }
        Self { root_box, root: 0, words, triangles: ordered.into() }
    }

    /// The node at `index`.
    ///
    /// # Panics
    /// If there are fewer nodes.
    #[inline(always)]
    #[must_use]
    pub fn node(&self, index: u32) -> Node<'_, N> {
        let first = index as usize * Node::<N>::WORDS;
        Node::new(&self.words[first..first + Node::<N>::WORDS])
    }

    /// Bytes of the nodes, without the triangles.
    #[must_use]
    pub fn node_bytes(&self) -> usize {
        size_of_val(self.words.as_slice())
    }
}

impl<const N: usize> Hierarchy<N> for QBvh<N> {
    const INDEX: Field = Field { low: 0, width: LEAF.low };

    type Siblings<'a> = Siblings<N>;

    #[inline(always)]
    fn root(&self) -> (u32, &Aabb) {
        (self.root, &self.root_box)
    }

    #[inline(always)]
    fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    #[inline(always)]
    fn siblings(&self, word: u32) -> Siblings<N> {
        self.node(word).siblings()
    }

    #[inline(always)]
    fn address(word: u32) -> u64 {
        u64::from(word) * Node::<N>::BYTES as u64
    }

    /// The first child stands for all bytes but the seven of each other child.
    #[inline(always)]
    fn place(word: u32, child: usize, count: usize) -> (u64, u32) {
        let head = Node::<N>::BYTES - node::BYTES_PER_CHILD * (count - 1);
        let (before, bytes) = match child {
            0 => (0, head),
            _ => (head + node::BYTES_PER_CHILD * (child - 1), node::BYTES_PER_CHILD),
        };
        (Self::address(word) + before as u64, bytes as u32)
    }
}

impl<const N: usize> Trace for QBvh<N> {
    #[inline]
    fn closest_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
        bvh::traverse::closest(self, ray, observer)
    }

    #[inline]
    fn occluded_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
        bvh::traverse::occluded(self, ray, observer)
    }
}

impl<const N: usize> Leaves for QBvh<N> {
    fn leaves(&self, ray: &TraversalRay) -> Vec<Leaf> {
        bvh::leaves::of(self, ray)
    }
}
