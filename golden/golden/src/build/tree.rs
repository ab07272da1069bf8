//! The hierarchy that every memory format is written from.

use std::ops::Range;

use scenes::Mesh;

use crate::aabb::Aabb;

/// What a [`Node`] holds. Indices refer to the vectors of its [`Tree`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// `child_count` (2 to the tree's width) consecutive nodes from `first_child`, which is greater than the
    /// node's own index.
    Inner {
        /// Index of the first child in [`Tree::nodes`].
        first_child: u32,
        /// Number of children.
        child_count: u32,
    },
    /// `primitive_count` (at least 1) consecutive entries from `first_primitive`, in ascending order of
    /// triangle.
    Leaf {
        /// Index of the first entry in [`Tree::primitives`].
        first_primitive: u32,
        /// Number of triangles.
        primitive_count: u32,
    },
}

/// A node: its exact box and what is inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The union of the boxes of the triangles below, bit for bit.
    pub aabb: Aabb,
    /// Children or triangles.
    pub content: Content,
}

/// A bounding volume hierarchy whose inner nodes have 2 to `WIDTH` children.
///
/// Nodes are in depth-first order with siblings consecutive: the block of a node's children precedes
/// everything below the first child, which precedes everything below the second. Leaves' ranges ascend in
/// that order.
#[derive(Clone, Debug, PartialEq)]
pub struct Tree<const WIDTH: usize> {
    /// The nodes; the root is the first.
    pub nodes: Vec<Node>,
    /// Triangle numbers of the mesh, each once, grouped by leaf.
    pub primitives: Vec<u32>,
}

/// The binary hierarchy that [`super::build`] makes.
pub type BinaryTree = Tree<2>;
/// A node of a [`BinaryTree`].
pub type BinaryNode = Node;

/// Why a tree is not a hierarchy over its mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TreeDefect {
    /// A child index or a primitive range leaves its vector, or points backwards.
    #[error("node {node}: its children or triangles are out of range")]
    OutOfRange {
        /// Index of the node.
        node: usize,
    },
    /// An inner node has fewer than 2 or more than `WIDTH` children, or a leaf no triangle.
    #[error("node {node}: {count} children or triangles")]
    Count {
        /// Index of the node.
        node: usize,
        /// The count that was found.
        count: u32,
    },
    /// A node is the child of two nodes or of none.
    #[error("node {node} has {parents} parents")]
    Parents {
        /// Index of the node.
        node: usize,
        /// How many nodes name it as a child.
        parents: u32,
    },
    /// A box is not exactly the union of what it encloses.
    #[error("node {node}: its box is not the union of what is inside")]
    Box {
        /// Index of the node.
        node: usize,
    },
    /// A triangle is in no leaf or in several.
    #[error("triangle {triangle} is in {leaves} leaves")]
    Triangle {
        /// Index of the triangle in the mesh.
        triangle: usize,
        /// How many leaves hold it.
        leaves: u32,
    },
    /// The triangles of a leaf are not in ascending order.
    #[error("node {node}: its triangles are not in ascending order")]
    Order {
        /// Index of the leaf.
        node: usize,
    },
}

impl<const WIDTH: usize> Tree<WIDTH> {
    /// The indices of `node`'s children; empty for a leaf.
    #[must_use]
    pub fn children(&self, node: &Node) -> Range<usize> {
        match node.content {
            Content::Inner { first_child, child_count } => {
                first_child as usize..(first_child + child_count) as usize
            }
            Content::Leaf { .. } => 0..0,
        }
    }

    /// The triangles of `node` in ascending order; empty for an inner node.
    #[must_use]
    pub fn triangles(&self, node: &Node) -> &[u32] {
        match node.content {
            Content::Inner { .. } => &[],
            Content::Leaf { first_primitive, primitive_count } => {
                &self.primitives[first_primitive as usize..(first_primitive + primitive_count) as usize]
            }
        }
    }

    /// Number of leaves.
    #[must_use]
    pub fn leaf_count(&self) -> usize {
        self.nodes.iter().filter(|node| matches!(node.content, Content::Leaf { .. })).count()
    }

    /// Number of edges on the longest path from the root, 0 if the root is a leaf.
    #[must_use]
    pub fn max_depth(&self) -> u32 {
        let mut depth = vec![0; self.nodes.len()];
        for (i, node) in self.nodes.iter().enumerate() {
            let below = depth[i] + 1;
            depth[self.children(node)].fill(below);
        }
        depth.into_iter().max().unwrap_or(0)
    }

    /// The cost of the surface area heuristic, with both the cost of an inner node and that of a triangle
    /// test 1: (sum of inner areas + sum over leaves of area x triangles) / area of the root.
    ///
    /// If the root has no area (all vertices on one axis-parallel line), every area ratio is taken as 1: the
    /// cost of a ray that visits everything.
    #[must_use]
    pub fn sah_cost(&self) -> f64 {
        let weight = |node: &Node| match node.content {
            Content::Inner { .. } => 1.0,
            Content::Leaf { primitive_count, .. } => f64::from(primitive_count),
        };
        let sum: f64 = self.nodes.iter().map(|node| weight(node) * self.area_weight(node)).sum();
        sum / self.area_weight(&self.nodes[0])
    }

    /// The measure of `node` in the cost: its half area, or 1 if the root has none.
    pub(super) fn area_weight(&self, node: &Node) -> f64 {
        if self.nodes[0].aabb.half_area() > 0.0 { node.aabb.half_area() } else { 1.0 }
    }

    /// Proves that this is a hierarchy over `mesh`: every triangle in exactly one leaf, every box exact,
    /// every node reached once, children after their parents.
    ///
    /// # Errors
    /// The first [`TreeDefect`] in order of nodes, then of triangles.
    pub fn validate(&self, mesh: &Mesh) -> Result<(), TreeDefect> {
        let mut parents = vec![0_u32; self.nodes.len()];
        let mut leaves = vec![0_u32; mesh.triangles.len()];
        for (index, node) in self.nodes.iter().enumerate() {
            let inside = match node.content {
                Content::Inner { first_child, child_count } => {
                    if !(2..=WIDTH as u32).contains(&child_count) {
                        return Err(TreeDefect::Count { node: index, count: child_count });
                    }
                    let end = u64::from(first_child) + u64::from(child_count);
                    if first_child as usize <= index || end > self.nodes.len() as u64 {
                        return Err(TreeDefect::OutOfRange { node: index });
                    }
                    let children = self.children(node);
                    parents[children.clone()].iter_mut().for_each(|count| *count += 1);
                    self.nodes[children].iter().fold(Aabb::EMPTY, |aabb, child| aabb.union(child.aabb))
                }
                Content::Leaf { first_primitive, primitive_count } => {
                    if primitive_count == 0 {
                        return Err(TreeDefect::Count { node: index, count: 0 });
                    }
                    let end = u64::from(first_primitive) + u64::from(primitive_count);
                    if end > self.primitives.len() as u64 {
                        return Err(TreeDefect::OutOfRange { node: index });
                    }
                    let triangles = self.triangles(node);
                    if triangles.iter().any(|&triangle| triangle as usize >= leaves.len()) {
                        return Err(TreeDefect::OutOfRange { node: index });
                    }
                    if !triangles.is_sorted_by(|a, b| a < b) {
                        return Err(TreeDefect::Order { node: index });
                    }
                    triangles.iter().for_each(|&triangle| leaves[triangle as usize] += 1);
                    triangles.iter().fold(Aabb::EMPTY, |aabb, &triangle| {
                        aabb.union(Aabb::of_points(&mesh.corners(triangle as usize)))
                    })
                }
            };
            if inside.to_bits() != node.aabb.to_bits() {
                return Err(TreeDefect::Box { node: index });
            }
        }
        if let Some(node) = (0..parents.len()).find(|&node| parents[node] != u32::from(node != 0)) {
            return Err(TreeDefect::Parents { node, parents: parents[node] });
        }
        match leaves.iter().position(|&count| count != 1) {
            Some(triangle) => Err(TreeDefect::Triangle { triangle, leaves: leaves[triangle] }),
            None => Ok(()),
        }
    }
}
