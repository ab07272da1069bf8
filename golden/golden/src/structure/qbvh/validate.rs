//! The proof that nodes in memory are a hierarchy over their triangles, with boxes as tight as their grids allow.

use super::node::{self, Child};
use super::{Node, QBvh};
use crate::Aabb;
use crate::build::MAX_DEPTH;
use crate::bvh::LEAF;
use crate::triangle::{Triangle, leaf_at};

/// Why nodes in memory are not a hierarchy with planes of 8 bits.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum QBvhDefect {
    /// The root's word is none.
    #[error("the root's word is {0:#010x}, which is neither a leaf's nor a node's")]
    Root(u32),
    /// A node's index, or its first triangle, is not the one behind those before it.
    #[error("node {node}: its children or triangles do not follow those of the nodes before it")]
    Order {
        /// Index of the node.
        node: u32,
    },
    /// A leaf has another number of triangles than its node says.
    #[error("node {node}: child {child} is not {triangles} triangles")]
    Leaf {
        /// Index of the node.
        node: u32,
        /// Which child.
        child: usize,
        /// What the node says.
        triangles: u32,
    },
    /// A node has too few or too many children.
    #[error("node {node}: {count} children")]
    Children {
        /// Index of the node.
        node: u32,
        /// Their number.
        count: usize,
    },
    /// A path is longer than [`MAX_DEPTH`].
    #[error("node {node} is more than {MAX_DEPTH} levels deep")]
    Depth {
        /// Index of the node.
        node: u32,
    },
    /// The words of a node are not those that its children's exact boxes give.
    #[error("node {node}: grid and planes are not those of the boxes inside")]
    Planes {
        /// Index of the node.
        node: u32,
    },
    /// The root's box is not the union of the triangles.
    #[error("the root's box {found:?} should be {expected:?}")]
    RootBox {
        /// The stored box.
        found: Aabb,
        /// The union.
        expected: Aabb,
    },
    /// Nodes or triangles are left over.
    #[error("{reached} of {total} nodes and triangles are reached")]
    Coverage {
        /// How many are reached.
        reached: usize,
        /// How many there are.
        total: usize,
    },
}

impl<const N: usize> QBvh<N> {
    /// Proves that the tree is what [`QBvh::encode`] writes: every node and every triangle is reached exactly once from the
    /// root, every grid is the finest around the exact boxes inside, every plane the nearest outside, and no path is
    /// longer than [`MAX_DEPTH`].
    ///
    /// # Errors
    /// The first defect that is found.
    pub fn validate(&self) -> Result<(), QBvhDefect> {
        let mut walk = Walk { tree: self, next_node: 0, next_triangle: 0 };
        let expected = match self.root {
            0 => {
                walk.next_node = 1;
                walk.node(0, 0)?
            }
            root if root == 1 << LEAF.low => walk.leaf(0).ok_or(QBvhDefect::Root(root))?,
            root => return Err(QBvhDefect::Root(root)),
        };
        let total = self.node_count() + self.triangles.len();
        let reached = walk.next_node as usize + walk.next_triangle as usize;
        if reached != total {
            return Err(QBvhDefect::Coverage { reached, total });
        }
        if expected.to_bits() != self.root_box.to_bits() {
            return Err(QBvhDefect::RootBox { found: self.root_box, expected });
        }
        Ok(())
    }

    fn node_count(&self) -> usize {
        self.words.len() / Node::<N>::WORDS
    }
}

/// A walk in the order of [`QBvh::encode`]: what comes next is told by what came before, so that nothing is reached twice.
struct Walk<'a, const N: usize> {
    tree: &'a QBvh<N>,
    next_node: u32,
    next_triangle: u32,
}

impl<const N: usize> Walk<'_, N> {
    /// Checks the node at `index`, and returns the exact box around it. The recursion is as deep as the tree.
    fn node(&mut self, index: u32, depth: u32) -> Result<Aabb, QBvhDefect> {
        if depth == MAX_DEPTH {
            return Err(QBvhDefect::Depth { node: index });
        }
        if index as usize >= self.tree.node_count() {
            return Err(QBvhDefect::Order { node: index });
        }
        let node = self.tree.node(index);
        let count = node.children();
        if !(2..=N).contains(&count) {
            return Err(QBvhDefect::Children { node: index, count });
        }
        let (first_node, first_triangle) = (self.next_node, self.next_triangle);
        let mut children = Vec::with_capacity(count);
        for child in 0..count {
            let triangles = node.triangles(child);
            let aabb = if triangles == 0 {
                self.next_node += 1;
                Aabb::EMPTY
            } else {
                let first = self.next_triangle;
                let aabb = self.leaf(first);
                aabb.filter(|_| self.next_triangle - first == triangles).ok_or(QBvhDefect::Leaf {
                    node: index,
                    child,
                    triangles,
                })?
            };
            children.push(Child { triangles: triangles as u8, aabb });
        }
        let inner = children.iter_mut().filter(|child| child.triangles == 0);
        for (index, child) in (first_node..).zip(inner) {
            child.aabb = self.node(index, depth + 1)?;
        }
        if (node.first_node(), node.first_triangle()) != (first_node, first_triangle) {
            return Err(QBvhDefect::Order { node: index });
        }
        if node.words() != node::encode::<N>(&children, first_node, first_triangle) {
            return Err(QBvhDefect::Planes { node: index });
        }
        Ok(children.iter().fold(Aabb::EMPTY, |bounds, child| bounds.union(child.aabb)))
    }

    /// Walks over the leaf whose first triangle is in slot `first`, and returns its box, if there is such a leaf.
    fn leaf(&mut self, first: u32) -> Option<Aabb> {
        let leaf = leaf_at(&self.tree.triangles, first)?;
        self.next_triangle += leaf.len() as u32;
        Some(union(leaf))
    }
}

fn union(triangles: &[Triangle]) -> Aabb {
    triangles.iter().map(Triangle::aabb).fold(Aabb::EMPTY, Aabb::union)
}
