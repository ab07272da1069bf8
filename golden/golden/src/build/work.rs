//! The binary tree under construction.
//!
//! Siblings share a *pair*: slots `2 p` and `2 p + 1`, one cache line of boxes. The root is slot 0 and slot 1
//! is unused, so a tree of `n` leaves has `n` pairs. A slot's sibling is `slot ^ 1`, its parent `parents[slot
//! / 2]`.

use super::bounds::Bounds;
use super::tree::{BinaryTree, Content, Node};
use crate::aabb::Aabb;

/// What is in a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slot {
    /// An inner node with this pair of children.
    Inner(u32),
    /// The leaf of this number.
    Leaf(u32),
}

/// A [`Slot`] in one word; leaves are in order of their numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Link(u32);

impl Link {
    const LEAF: u32 = 1 << 31;

    pub(super) fn pair(pair: u32) -> Self {
        Self(pair)
    }

    pub(super) fn leaf(leaf: u32) -> Self {
        Self(leaf | Self::LEAF)
    }

    #[inline(always)]
    pub(super) fn decode(self) -> Slot {
        if self.0 & Self::LEAF == 0 { Slot::Inner(self.0) } else { Slot::Leaf(self.0 & !Self::LEAF) }
    }

    /// The pair of children, unless this is a leaf.
    #[inline(always)]
    pub(super) fn children(self) -> Option<u32> {
        match self.decode() {
            Slot::Inner(pair) => Some(pair),
            Slot::Leaf(_) => None,
        }
    }
}

/// The boxes of two siblings.
#[repr(align(64))]
#[derive(Clone, Copy, Debug)]
pub(super) struct BoundsPair(pub(super) [Bounds; 2]);

/// See the [module](self).
#[derive(Clone, Debug)]
pub(super) struct WorkTree {
    pub(super) bounds: Vec<BoundsPair>,
    pub(super) links: Vec<[Link; 2]>,
    /// The parent's slot of each pair; meaningless for the root's pair.
    pub(super) parents: Vec<u32>,
    /// Leaf `i` holds `primitives[leaf_starts[i]..leaf_starts[i + 1]]`, in ascending order.
    pub(super) leaf_starts: Vec<u32>,
    pub(super) primitives: Vec<u32>,
}

impl WorkTree {
    pub(super) const ROOT: u32 = 0;

    /// A tree without nodes, to be filled through [`Place`], of one leaf for each of `count` primitives.
    pub(super) fn with_single_leaves(primitives: Vec<u32>) -> Self {
        let count = primitives.len();
        Self {
            bounds: vec![BoundsPair([Bounds::EMPTY; 2]); count],
            links: vec![[Link::leaf(0); 2]; count],
            parents: vec![0; count],
            leaf_starts: (0..=count as u32).collect(),
            primitives,
        }
    }

    #[inline(always)]
    pub(super) fn bounds(&self, slot: u32) -> Bounds {
        self.bounds[(slot >> 1) as usize].0[(slot & 1) as usize]
    }

    #[inline(always)]
    pub(super) fn set_bounds(&mut self, slot: u32, bounds: Bounds) {
        self.bounds[(slot >> 1) as usize].0[(slot & 1) as usize] = bounds;
    }

    #[inline(always)]
    pub(super) fn link(&self, slot: u32) -> Link {
        self.links[(slot >> 1) as usize][(slot & 1) as usize]
    }

    #[inline(always)]
    pub(super) fn slot(&self, slot: u32) -> Slot {
        self.link(slot).decode()
    }

    /// Puts `link` into `slot` and tells its children where they hang.
    #[inline(always)]
    pub(super) fn set_link(&mut self, slot: u32, link: Link) {
        self.links[(slot >> 1) as usize][(slot & 1) as usize] = link;
        if let Some(pair) = link.children() {
            self.parents[pair as usize] = slot;
        }
    }

    #[inline(always)]
    pub(super) fn parent(&self, slot: u32) -> u32 {
        self.parents[(slot >> 1) as usize]
    }

    /// Recomputes the box of an inner node from its children.
    pub(super) fn refit(&mut self, slot: u32) {
        let pair = self.link(slot).children().expect("an inner node");
        let [left, right] = self.bounds[pair as usize].0;
        self.set_bounds(slot, left.union(right));
    }

    /// The sum of the half areas of all inner nodes.
    pub(super) fn inner_area(&self) -> f64 {
        let area = |(bounds, links): (&BoundsPair, &[Link; 2])| -> f64 {
            bounds
                .0
                .iter()
                .zip(links)
                .filter(|(_, link)| link.children().is_some())
                .map(|(bounds, _)| bounds.half_area())
                .sum()
        };
        self.bounds.iter().zip(&self.links).map(area).sum()
    }

    /// The primitives of a leaf.
    pub(super) fn leaf_primitives(&self, leaf: u32) -> &[u32] {
        let leaf = leaf as usize;
        &self.primitives[self.leaf_starts[leaf] as usize..self.leaf_starts[leaf + 1] as usize]
    }

    /// Appends the primitives of all leaves of the subtree at `slot`.
    pub(super) fn append_primitives(&self, slot: u32, primitives: &mut Vec<u32>) {
        let mut stack = vec![slot];
        while let Some(slot) = stack.pop() {
            match self.slot(slot) {
                Slot::Inner(pair) => stack.extend([2 * pair, 2 * pair + 1]),
                Slot::Leaf(leaf) => primitives.extend_from_slice(self.leaf_primitives(leaf)),
            }
        }
    }

    /// Appends a pair with boxes, to be linked; returns its number.
    pub(super) fn push_pair(&mut self, bounds: BoundsPair) -> u32 {
        self.bounds.push(bounds);
        self.links.push([Link::leaf(0); 2]);
        self.parents.push(Self::ROOT);
        self.links.len() as u32 - 1
    }

    /// Number of leaves.
    pub(super) fn leaf_count(&self) -> usize {
        self.leaf_starts.len() - 1
    }

    /// The pairs below the root, every parent before its children, first child's descendants first.
    pub(super) fn pairs_depth_first(&self) -> Vec<u32> {
        let mut order = Vec::with_capacity(self.links.len() - 1);
        let mut stack: Vec<u32> = self.link(Self::ROOT).children().into_iter().collect();
        while let Some(pair) = stack.pop() {
            order.push(pair);
            stack.extend(self.links[pair as usize].iter().rev().filter_map(|link| link.children()));
        }
        order
    }

    /// Writes the tree in the layout of [`super::Tree`].
    pub(super) fn to_tree(&self) -> BinaryTree {
        let mut tree = BinaryTree {
            nodes: Vec::with_capacity(2 * self.leaf_count() - 1),
            primitives: Vec::with_capacity(self.primitives.len()),
        };
        self.push_node(&mut tree, Self::ROOT);
        // Slots of inner nodes whose children are not written yet, with the index of the node that waits for
        // them.
        let mut stack = vec![(Self::ROOT, 0_usize)];
        while let Some((slot, index)) = stack.pop() {
            tree.nodes[index].content = match self.slot(slot) {
                Slot::Inner(pair) => {
                    let first_child = tree.nodes.len();
                    self.push_node(&mut tree, 2 * pair);
                    self.push_node(&mut tree, 2 * pair + 1);
                    stack.extend([(2 * pair + 1, first_child + 1), (2 * pair, first_child)]);
                    Content::Inner { first_child: first_child as u32, child_count: 2 }
                }
                Slot::Leaf(leaf) => {
                    let first_primitive = tree.primitives.len() as u32;
                    let triangles = self.leaf_primitives(leaf);
                    tree.primitives.extend_from_slice(triangles);
                    Content::Leaf { first_primitive, primitive_count: triangles.len() as u32 }
                }
            };
        }
        tree
    }

    fn push_node(&self, tree: &mut BinaryTree, slot: u32) {
        // The content is known once the order of the nodes before it is.
        let content = Content::Leaf { first_primitive: 0, primitive_count: 0 };
        tree.nodes.push(Node { aabb: Aabb::from(self.bounds(slot)), content });
    }
}

/// Consecutive pairs of a [`WorkTree`], to be filled by one task.
pub(super) struct PairsMut<'a> {
    bounds: &'a mut [BoundsPair],
    links: &'a mut [[Link; 2]],
    parents: &'a mut [u32],
    first: u32,
}

impl<'a> PairsMut<'a> {
    fn split_at(self, count: usize) -> [Self; 2] {
        let (bounds, bounds_rest) = self.bounds.split_at_mut(count);
        let (links, links_rest) = self.links.split_at_mut(count);
        let (parents, parents_rest) = self.parents.split_at_mut(count);
        [
            Self { bounds, links, parents, first: self.first },
            Self {
                bounds: bounds_rest,
                links: links_rest,
                parents: parents_rest,
                first: self.first + count as u32,
            },
        ]
    }
}

/// The place for a subtree over some primitives, one leaf each.
pub(super) struct Place<'a> {
    /// The numbers of the primitives, to be brought into the order of the leaves.
    pub(super) primitives: &'a mut [u32],
    /// Number of the first primitive's leaf.
    pub(super) first_leaf: u32,
    /// The slot of the subtree's root.
    pub(super) slot: u32,
    /// How many levels are allowed below the subtree's root.
    pub(super) levels: u32,
    /// One pair for each primitive but one.
    pub(super) pairs: PairsMut<'a>,
}

impl<'a> Place<'a> {
    /// The whole of `tree`.
    pub(super) fn root(tree: &'a mut WorkTree, levels: u32) -> Self {
        Self {
            primitives: &mut tree.primitives,
            first_leaf: 0,
            slot: WorkTree::ROOT,
            levels,
            pairs: PairsMut {
                bounds: &mut tree.bounds[1..],
                links: &mut tree.links[1..],
                parents: &mut tree.parents[1..],
                first: 1,
            },
        }
    }

    /// Number of primitives.
    pub(super) fn count(&self) -> usize {
        self.primitives.len()
    }

    /// Whether both children keep to the number of levels if one has `left_count` primitives.
    pub(super) fn allows(&self, left_count: usize) -> bool {
        levels_needed(left_count.max(self.count() - left_count)) < self.levels
    }

    /// The link to the pair that [`Self::split`] fills.
    pub(super) fn link(&self) -> Link {
        Link::pair(self.pairs.first)
    }

    /// The children's pair, and the places of the children, the first with `left_count` primitives.
    pub(super) fn split(self, left_count: usize) -> (PairMut<'a>, [Self; 2]) {
        let first_pair = self.pairs.first;
        let [pair, rest] = self.pairs.split_at(1);
        let [pairs_left, pairs_right] = rest.split_at(left_count - 1);
        let (primitives_left, primitives_right) = self.primitives.split_at_mut(left_count);
        pair.parents[0] = self.slot;
        let levels = self.levels - 1;
        (
            PairMut { bounds: &mut pair.bounds[0], links: &mut pair.links[0] },
            [
                Self {
                    primitives: primitives_left,
                    first_leaf: self.first_leaf,
                    slot: 2 * first_pair,
                    levels,
                    pairs: pairs_left,
                },
                Self {
                    primitives: primitives_right,
                    first_leaf: self.first_leaf + left_count as u32,
                    slot: 2 * first_pair + 1,
                    levels,
                    pairs: pairs_right,
                },
            ],
        )
    }
}

/// The least number of levels that a binary tree of `leaves` leaves needs below its root.
pub(super) fn levels_needed(leaves: usize) -> u32 {
    leaves.next_power_of_two().ilog2()
}

/// One pair of a [`WorkTree`] to be filled.
pub(super) struct PairMut<'a> {
    bounds: &'a mut BoundsPair,
    links: &'a mut [Link; 2],
}

impl PairMut<'_> {
    /// Stores the two children; returns the box around both.
    pub(super) fn fill(self, left: (Link, Bounds), right: (Link, Bounds)) -> Bounds {
        *self.links = [left.0, right.0];
        *self.bounds = BoundsPair([left.1, right.1]);
        left.1.union(right.1)
    }
}
