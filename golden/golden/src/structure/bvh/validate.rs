//! The proof that nodes in memory are a hierarchy over their triangles.

use super::{Bvh, LEAF};
use crate::Aabb;
use crate::build::MAX_DEPTH;
use crate::triangle::{Triangle, leaf_at};

/// Why nodes in memory are not a hierarchy.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BvhDefect {
    /// A child or triangle index leaves its array.
    #[error("word {word:#010x}: the child or triangle is out of range")]
    OutOfRange {
        /// Word 0 of the node.
        word: u32,
    },
    /// Siblings disagree about their number, or are fewer than two or more than the width.
    #[error("node {node}: {count} siblings, or not all of them say so")]
    Siblings {
        /// Index of the first sibling.
        node: u32,
        /// What the first one says.
        count: u32,
    },
    /// A path is longer than [`MAX_DEPTH`].
    #[error("node {node} is more than {MAX_DEPTH} levels deep")]
    Depth {
        /// Index of the node.
        node: u32,
    },
    /// A box is not the union of what is inside.
    #[error("the box {found:?} should be {expected:?}")]
    Box {
        /// The stored box.
        found: Aabb,
        /// The union.
        expected: Aabb,
    },
    /// Nodes or triangles are reached twice.
    #[error("node or triangle {0} is reached twice")]
    Twice(u32),
    /// Nodes or triangles are never reached.
    #[error("{reached} of {total} nodes and triangles are reached")]
    Coverage {
        /// How many are reached.
        reached: usize,
        /// How many there are.
        total: usize,
    },
}

impl<const N: usize> Bvh<N> {
    /// Proves that every node and every triangle is reached exactly once from the root, that every box is exactly the
    /// union of what is inside, that offsets are in range and that no path is longer than [`MAX_DEPTH`].
    ///
    /// # Errors
    /// The first defect that is found.
    pub fn validate(&self) -> Result<(), BvhDefect> {
        let mut reached =
            Reached { nodes: vec![false; self.nodes.len()], triangles: vec![false; self.triangles.len()] };
        self.check(self.root, 0, &self.root_box, &mut reached)?;
        let all = || reached.nodes.iter().chain(&reached.triangles);
        let (reached, total) = (all().filter(|reached| **reached).count(), all().count());
        if reached == total { Ok(()) } else { Err(BvhDefect::Coverage { reached, total }) }
    }

    /// Checks the node with word 0 `word`, whose box is `stored`. The recursion is as deep as the tree.
    fn check(&self, word: u32, depth: u32, stored: &Aabb, reached: &mut Reached) -> Result<(), BvhDefect> {
        let index = Self::INDEX.get(word);
        let inside = if LEAF.get(word) == 1 {
            let leaf = leaf_at(&self.triangles, index).ok_or(BvhDefect::OutOfRange { word })?;
            mark(&mut reached.triangles, index, leaf.len())?;
            leaf.iter().map(Triangle::aabb).fold(Aabb::EMPTY, Aabb::union)
        } else {
            if depth == MAX_DEPTH {
                return Err(BvhDefect::Depth { node: index });
            }
            let first = self.nodes.get(index as usize).ok_or(BvhDefect::OutOfRange { word })?;
            let count = Self::SIBLINGS.get(first.word) + 1;
            let children = self
                .nodes
                .get(index as usize..(index + count) as usize)
                .ok_or(BvhDefect::OutOfRange { word })?;
            let agree = children.iter().all(|child| Self::SIBLINGS.get(child.word) + 1 == count);
            if !agree || !(2..=N as u32).contains(&count) {
                return Err(BvhDefect::Siblings { node: index, count });
            }
            mark(&mut reached.nodes, index, children.len())?;
            for child in children {
                self.check(child.word, depth + 1, &child.aabb, reached)?;
            }
            children.iter().fold(Aabb::EMPTY, |aabb, child| aabb.union(child.aabb))
        };
        if inside.to_bits() == stored.to_bits() {
            Ok(())
        } else {
            Err(BvhDefect::Box { found: *stored, expected: inside })
        }
    }
}

/// Which nodes and triangles have been reached.
struct Reached {
    nodes: Vec<bool>,
    triangles: Vec<bool>,
}

/// Marks `count` of them from `first` on.
fn mark(reached: &mut [bool], first: u32, count: usize) -> Result<(), BvhDefect> {
    for (index, reached) in (first..).zip(&mut reached[first as usize..][..count]) {
        if std::mem::replace(reached, true) {
            return Err(BvhDefect::Twice(index));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{BuildOptions, Quality, build};
    use crate::bvh::Bvh2;
    use crate::structure::pack_triangles;
    use scenes::Mesh;

    /// Two pairs of equal triangles: the numbers and boxes fit if one pair is reached twice and the other never.
    #[test]
    fn what_is_reached_twice_is_found() {
        let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 1.0]];
        let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]; 4] };
        let options = BuildOptions { max_leaf_size: 1, ..BuildOptions::new(Quality::Fast) };
        let tree = build(&mesh, &options).unwrap();
        let mut bvh = Bvh2::encode(&tree, pack_triangles(&mesh, &tree));
        bvh.validate().unwrap();
        let inner: Vec<usize> = (0..bvh.nodes.len()).filter(|n| LEAF.get(bvh.nodes[*n].word) == 0).collect();
        let [first, second] = inner[..] else { panic!("a balanced tree of four leaves") };
        bvh.nodes[second].word = bvh.nodes[first].word;
        assert!(matches!(bvh.validate(), Err(BvhDefect::Twice(_))), "{:?}", bvh.validate());
    }
}
