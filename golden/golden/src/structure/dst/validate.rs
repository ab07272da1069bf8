//! The proof that a dual-split tree is a given binary hierarchy.

use super::header::{Header, LEAF_WORDS, NODE_WORDS, OFFSET_LIMIT};
use super::{Dst, MAX_CARVES};
use crate::Aabb;
use crate::build::{BinaryTree, Content, MAX_DEPTH};
use crate::triangle::{Triangle, leaf_at};

/// Why a dual-split tree does not stand for its hierarchy.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DstDefect {
    /// The word at `offset` is a reserved code.
    #[error("offset {offset}: {word:#010x} is not a header")]
    Header {
        /// Word offset.
        offset: u32,
        /// The word.
        word: u32,
    },
    /// A node or a child leaves the tree, or 26 bits.
    #[error("offset {offset}: the node or its child is out of range")]
    OutOfRange {
        /// Word offset of the node.
        offset: u32,
    },
    /// More than three carve nodes in a row, or a carve that does not lie inside its parent.
    #[error("offset {offset}: a chain of {length} carves, or one that grows its box")]
    Carve {
        /// Word offset of the last carve.
        offset: u32,
        /// How many there are in a row.
        length: usize,
    },
    /// The reconstructed box differs from the hierarchy's.
    #[error("offset {offset}: the box {found:?} should be {expected:?}")]
    Box {
        /// Word offset.
        offset: u32,
        /// What the planes on the way down give.
        found: Aabb,
        /// The hierarchy's box.
        expected: Aabb,
    },
    /// A leaf or an inner node stands where the hierarchy has the other, or a leaf names other triangles.
    #[error("offset {offset}: not the node that the hierarchy has there")]
    Node {
        /// Word offset.
        offset: u32,
    },
    /// A path has more than [`MAX_DEPTH`] splits.
    #[error("offset {offset}: more than {MAX_DEPTH} splits deep")]
    Depth {
        /// Word offset.
        offset: u32,
    },
    /// Words of the tree are reached twice or never.
    #[error("{reached} of {words} words are reached")]
    Coverage {
        /// Words that the nodes take, each counted as often as it is reached.
        reached: usize,
        /// Words of the tree.
        words: usize,
    },
}

impl Dst {
    /// Proves that the tree has the boxes of `tree` bit for bit and the same triangles in each leaf, that every
    /// word belongs to one node, and that every offset is in range.
    ///
    /// With [`BinaryTree::validate`], every triangle is then in exactly one leaf.
    ///
    /// # Errors
    /// The first defect that is found from the root downwards.
    pub fn validate(&self, tree: &BinaryTree) -> Result<(), DstDefect> {
        let mut reached = 0;
        let mut stack = vec![(self.record(0, self.root_box)?, 0usize)];
        while let Some((record, node)) = stack.pop() {
            reached += record.words;
            let expected = &tree.nodes[node];
            if record.region.to_bits() != expected.aabb.to_bits() {
                let (offset, found) = (record.offset, record.region);
                return Err(DstDefect::Box { offset, found, expected: expected.aabb });
            }
            match (record.end, expected.content) {
                (End::Leaf { first_triangle }, Content::Leaf { .. }) => {
                    let found = leaf_at(&self.triangles, first_triangle).unwrap_or_default();
                    if !found.iter().map(Triangle::index).eq(tree.triangles(expected).iter().copied()) {
                        return Err(DstDefect::Node { offset: record.offset });
                    }
                }
                (End::Split { children }, Content::Inner { first_child, .. }) => {
                    let [left, right] = [
                        self.record(children[0].0, children[0].1)?,
                        self.record(children[1].0, children[1].1)?,
                    ];
                    let first = first_child as usize;
                    // The lower child is the left one, so their boxes tell which is which; equal boxes keep their order.
                    let in_order = left.region.to_bits() == tree.nodes[first].aabb.to_bits();
                    let [l, r] = if in_order { [first, first + 1] } else { [first + 1, first] };
                    stack.push((right, r));
                    stack.push((left, l));
                }
                _ => return Err(DstDefect::Node { offset: record.offset }),
            }
        }
        if reached == self.words().len() {
            Ok(())
        } else {
            Err(DstDefect::Coverage { reached, words: self.words().len() })
        }
    }

    /// Proves, without the hierarchy that it comes from, that this is a dual-split tree over its triangles: every word and
    /// every triangle belongs to one node, every node's box is exactly the union of the boxes inside,
    /// offsets are in range and no path has more than [`MAX_DEPTH`] splits.
    ///
    /// # Errors
    /// The first defect that is found.
    pub fn validate_alone(&self) -> Result<(), DstDefect> {
        let (mut words, mut triangles) = (0, 0);
        self.check(0, self.root_box, 0, &mut words, &mut triangles)?;
        if words == self.words().len() && triangles == self.triangles.len() {
            Ok(())
        } else {
            Err(DstDefect::Coverage { reached: words + triangles, words: self.words().len() })
        }
    }

    /// Checks the record at `offset` and returns the union of what is inside. The recursion is as deep as the tree.
    fn check(
        &self,
        offset: u32,
        region: Aabb,
        depth: u32,
        words: &mut usize,
        triangles: &mut usize,
    ) -> Result<Aabb, DstDefect> {
        let record = self.record(offset, region)?;
        *words += record.words;
        if *words > self.words().len() {
            return Err(DstDefect::Coverage { reached: *words, words: self.words().len() });
        }
        let inside = match record.end {
            End::Leaf { first_triangle } => {
                let leaf =
                    leaf_at(&self.triangles, first_triangle).ok_or(DstDefect::OutOfRange { offset })?;
                *triangles += leaf.len();
                leaf.iter().map(Triangle::aabb).fold(Aabb::EMPTY, Aabb::union)
            }
            End::Split { .. } if depth == MAX_DEPTH => return Err(DstDefect::Depth { offset }),
            End::Split { children: [left, right] } => self
                .check(left.0, left.1, depth + 1, words, triangles)?
                .union(self.check(right.0, right.1, depth + 1, words, triangles)?),
        };
        if inside.to_bits() == record.region.to_bits() {
            Ok(inside)
        } else {
            Err(DstDefect::Box { offset, found: record.region, expected: inside })
        }
    }

    /// Follows the carves from `offset` to the split or leaf inside, starting with the box `region`.
    ///
    /// # Errors
    /// A reserved header, a node or child out of range, a chain that is too long or grows its box.
    pub fn record(&self, start: u32, region: Aabb) -> Result<Record, DstDefect> {
        let mut record = Record {
            offset: start,
            region,
            carves: 0,
            words: 0,
            visited_half_area: 0.0,
            end: End::Leaf { first_triangle: 0 },
        };
        let mut offset = start;
        loop {
            let out_of_range = DstDefect::OutOfRange { offset };
            let word = *self.words().get(offset as usize).ok_or(out_of_range.clone())?;
            let header = Header::decode(word).ok_or(DstDefect::Header { offset, word })?;
            record.visited_half_area += record.region.half_area();
            if let Header::Leaf { first_triangle } = header {
                record.words += LEAF_WORDS as usize;
                record.end = End::Leaf { first_triangle };
                return Ok(record);
            }
            if offset as usize + NODE_WORDS as usize > self.words().len() {
                return Err(out_of_range);
            }
            record.words += NODE_WORDS as usize;
            let planes = [1, 2].map(|i| f32::from_bits(self.words()[offset as usize + i]));
            let before = record.region;
            let (leaf, child) = match header {
                Header::Split { axis, left_words, offset: left } => {
                    let right = left + left_words;
                    if right >= OFFSET_LIMIT {
                        return Err(out_of_range);
                    }
                    let mut halves = [before; 2];
                    halves[0].max[axis as usize] = planes[0];
                    halves[1].min[axis as usize] = planes[1];
                    record.end = End::Split { children: [(left, halves[0]), (right, halves[1])] };
                    return Ok(record);
                }
                Header::CarveSingle { axis, leaf, offset } => {
                    record.region.max[axis as usize] = planes[0];
                    record.region.min[axis as usize] = planes[1];
                    (leaf, offset)
                }
                Header::CarveDual { axes, is_min, leaf, offset } => {
                    for i in 0..2 {
                        let sides = if is_min[i] { &mut record.region.min } else { &mut record.region.max };
                        sides[axes[i] as usize] = planes[i];
                    }
                    (leaf, offset)
                }
                Header::Leaf { .. } => unreachable!("handled above"),
            };
            record.carves += 1;
            if record.carves > MAX_CARVES || !before.contains(&record.region) {
                return Err(DstDefect::Carve { offset, length: record.carves });
            }
            if leaf {
                record.end = End::Leaf { first_triangle: child };
                return Ok(record);
            }
            offset = child;
        }
    }
}

/// What lies at a child's place: a chain of carves and its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Record {
    /// Word offset of the first node.
    pub offset: u32,
    /// The box after all carves.
    pub region: Aabb,
    /// Number of carve nodes.
    pub carves: usize,
    /// Words that the chain and its end take.
    pub words: usize,
    /// Sum over these nodes of half the area of the box that is left when the node is visited.
    pub visited_half_area: f64,
    /// The split or leaf inside.
    pub end: End,
}

/// The end of a chain of carves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    /// A split: offset and box of the left and the right child.
    Split {
        /// Left, then right.
        children: [(u32, Aabb); 2],
    },
    /// A leaf.
    Leaf {
        /// Index of its first triangle.
        first_triangle: u32,
    },
}
