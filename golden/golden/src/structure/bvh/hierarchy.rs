//! What a traversal reads of a hierarchy of boxes, however its nodes lie in memory.

use super::{BoxStep, BvhNode, LEAF};
use crate::Aabb;
use crate::dst::header::Field;
use crate::traverse::{Node, Observer, Outcome, Part, Target, Tests};
use crate::triangle::Triangle;
use std::ops::Deref;

/// A hierarchy of boxes, up to `N` of which share a parent.
///
/// A word leads to a leaf, where [`LEAF`] is set, or to siblings.
pub(crate) trait Hierarchy<const N: usize> {
    /// Of a leaf's word the slot of its first triangle, else where its children are.
    const INDEX: Field;

    /// The children of a node: box and word of each.
    type Siblings<'a>: Deref<Target = [BvhNode]>
    where
        Self: 'a;

    /// The root's word and box.
    fn root(&self) -> (u32, &Aabb);

    /// The leaves' triangles.
    fn triangles(&self) -> &[Triangle];

    /// The children of the inner node with `word`.
    fn siblings(&self, word: u32) -> Self::Siblings<'_>;

    /// Where the first child of the inner node with `word` is, in bytes from the start.
    fn address(word: u32) -> u64;

    /// Address and bytes of what is read for child `child` of the `count` children of the inner node with `word`.
    fn place(word: u32, child: usize, count: usize) -> (u64, u32);

    /// What `word` leads to.
    #[inline(always)]
    fn target(word: u32) -> Target {
        if LEAF.get(word) == 1 {
            Target::Leaf(Self::INDEX.get(word))
        } else {
            Target::Node(Self::address(word))
        }
    }

    /// Tells `observer` that the box at `place` with `word` was tested.
    #[inline(always)]
    fn observe<O: Observer>(observer: &mut O, (address, bytes): (u64, u32), word: u32, test: BoxStep) {
        let (t_min, t_max) = (test.t_entry, test.t_exit);
        let outcome = if test.hit {
            Outcome::One(Part { target: Self::target(word), t_min, t_max })
        } else {
            Outcome::Nothing
        };
        observer.node(&Node { address, bytes, tests: Tests::Box, t_min, t_max, outcome });
    }
}
