//! The dual-split node's first word: the one definition of the format.
//!
//! A split or carve node is three 32-bit words: this header and two planes. A leaf without a carving parent is
//! this word alone. Layout after Lin, Shkurko, Mallett, Yuksel, "Dual-Split Trees", I3D 2019.
//!
//! | bits | split | carve | bare leaf |
//! |---|---|---|---|
//! | 31 | 0 | 1 | 0 |
//! | 30:29 | axis 0, 1, 2 | 0 dual x,y; 1 dual x,z; 3 dual y,z; 2 single | 0 |
//! | 28:27 | size of the left child in words: 1 or 3 | dual: bit 28 plane 0, bit 27 plane 1 is a box's min side; single: axis | 0 |
//! | 26 | 0 | 1: a leaf is inside the carved box | 1 |
//! | 25:0 | word offset of the left child | word offset of the child, or index of the first triangle | index of the first triangle |
//!
//! | planes | word 1 | word 2 |
//! |---|---|---|
//! | split | left child's max | right child's min |
//! | single carve | box's max | box's min |
//! | dual carve | plane on the first axis | plane on the second axis |
//!
//! Offsets count 32-bit words from the start of the tree. The right child of a split follows the left one. A carve
//! plane that carves nothing repeats the parent's own plane, so that its test changes nothing.

use bitvec::{field::BitField, order::Lsb0, view::BitView};
use std::fmt;

/// A bit field of the header word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Field {
    /// Least significant bit.
    pub low: usize,
    /// Number of bits.
    pub width: usize,
}

impl Field {
    /// The field's value in `word`.
    #[inline(always)]
    #[must_use]
    pub const fn get(self, word: u32) -> u32 {
        (word >> self.low) & self.mask()
    }

    /// All ones, `width` bits wide.
    #[inline(always)]
    #[must_use]
    pub const fn mask(self) -> u32 {
        (1 << self.width) - 1
    }

    pub(crate) fn store(self, word: &mut u32, value: u32) {
        debug_assert!(value <= self.mask());
        word.view_bits_mut::<Lsb0>()[self.low..self.low + self.width].store_le(value);
    }
}

/// 1 in a carve node.
pub const CARVE: Field = Field { low: 31, width: 1 };
/// Split axis, or kind of carve.
pub const AXIS: Field = Field { low: 29, width: 2 };
/// Size of the left child in words, corner bits, or single-carve axis.
pub const SIZE: Field = Field { low: 27, width: 2 };
/// 1 where the offset is the index of a leaf's first triangle.
pub const LEAF: Field = Field { low: 26, width: 1 };
/// Offset of a child in words, or index of the first triangle.
pub const OFFSET: Field = Field { low: 0, width: 26 };
/// All bits above the offset.
pub const HEADER: Field = Field { low: 26, width: 6 };

/// The value of [`AXIS`] in a carve node that carves a single axis.
pub const SINGLE: u32 = 2;
/// Words of a split or carve node.
pub const NODE_WORDS: u32 = 3;
/// Words of a bare leaf.
pub const LEAF_WORDS: u32 = 1;
/// Offsets and triangle indices are below this.
pub const OFFSET_LIMIT: u32 = 1 << OFFSET.width;

/// A header word, decoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Header {
    /// Cuts the box in two on `axis`.
    Split {
        /// 0, 1, 2 for x, y, z.
        axis: u32,
        /// Size of the left child: [`LEAF_WORDS`] or [`NODE_WORDS`].
        left_words: u32,
        /// Word offset of the left child; the right one follows it.
        offset: u32,
    },
    /// Cuts both sides of one axis off the box.
    CarveSingle {
        /// 0, 1, 2 for x, y, z.
        axis: u32,
        /// Whether `offset` is the index of a leaf's first triangle.
        leaf: bool,
        /// Word offset of the child, or index of the first triangle.
        offset: u32,
    },
    /// Cuts one side off the box on each of two axes.
    CarveDual {
        /// Both axes, ascending: (0, 1), (0, 2) or (1, 2).
        axes: [u32; 2],
        /// For each plane, whether it is the carved box's min side.
        is_min: [bool; 2],
        /// Whether `offset` is the index of a leaf's first triangle.
        leaf: bool,
        /// Word offset of the child, or index of the first triangle.
        offset: u32,
    },
    /// A leaf whose box is its parent's half.
    Leaf {
        /// Index of the first triangle.
        first_triangle: u32,
    },
}

impl Header {
    /// The header as a word.
    ///
    /// # Panics
    /// In debug builds, if a field exceeds its width.
    #[must_use]
    pub fn encode(self) -> u32 {
        let mut word = 0;
        match self {
            Header::Split { axis, left_words, offset } => {
                AXIS.store(&mut word, axis);
                SIZE.store(&mut word, left_words);
                OFFSET.store(&mut word, offset);
            }
            Header::CarveSingle { axis, leaf, offset } => {
                CARVE.store(&mut word, 1);
                AXIS.store(&mut word, SINGLE);
                SIZE.store(&mut word, axis);
                LEAF.store(&mut word, u32::from(leaf));
                OFFSET.store(&mut word, offset);
            }
            Header::CarveDual { axes, is_min, leaf, offset } => {
                CARVE.store(&mut word, 1);
                AXIS.store(&mut word, dual_kind(axes));
                SIZE.store(&mut word, u32::from(is_min[0]) << 1 | u32::from(is_min[1]));
                LEAF.store(&mut word, u32::from(leaf));
                OFFSET.store(&mut word, offset);
            }
            Header::Leaf { first_triangle } => {
                LEAF.store(&mut word, 1);
                OFFSET.store(&mut word, first_triangle);
            }
        }
        word
    }

    /// Decodes `word`, or returns `None` where it is one of the reserved codes.
    #[must_use]
    pub fn decode(word: u32) -> Option<Self> {
        let bits = word.view_bits::<Lsb0>();
        let field = |f: Field| bits[f.low..f.low + f.width].load_le::<u32>();
        let (axis, size, leaf, offset) = (field(AXIS), field(SIZE), field(LEAF) == 1, field(OFFSET));
        match (field(CARVE) == 1, leaf) {
            (false, false) => (axis < 3 && (size == LEAF_WORDS || size == NODE_WORDS))
                .then_some(Header::Split { axis, left_words: size, offset }),
            (false, true) => (axis == 0 && size == 0).then_some(Header::Leaf { first_triangle: offset }),
            (true, _) if axis == SINGLE => {
                (size < 3).then_some(Header::CarveSingle { axis: size, leaf, offset })
            }
            (true, _) => Some(Header::CarveDual {
                axes: dual_axes(axis),
                is_min: [size & 2 != 0, size & 1 != 0],
                leaf,
                offset,
            }),
        }
    }
}

/// The axes of a dual carve of kind 0, 1 or 3.
#[inline(always)]
#[must_use]
pub const fn dual_axes(kind: u32) -> [u32; 2] {
    [kind >> 1, (kind & 1) + 1]
}

/// The kind of the dual carve on `axes`, ascending.
#[must_use]
pub const fn dual_kind(axes: [u32; 2]) -> u32 {
    axes[0] << 1 | (axes[1] - 1)
}

/// `split x, left @12, right @15`, `carve y max, y min, leaf at 7`, `carve x min, z max, child @30`, `leaf at 4`.
impl fmt::Display for Header {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let axis = |axis: u32| ["x", "y", "z"][axis as usize];
        let end = |leaf: bool, offset: u32| {
            if leaf { format!("leaf at {offset}") } else { format!("child @{offset}") }
        };
        match *self {
            Header::Split { axis: a, left_words, offset } => {
                write!(f, "split {}, left @{offset}, right @{}", axis(a), offset + left_words)
            }
            Header::CarveSingle { axis: a, leaf, offset } => {
                write!(f, "carve {0} max, {0} min, {1}", axis(a), end(leaf, offset))
            }
            Header::CarveDual { axes, is_min, leaf, offset } => {
                let side = |i: usize| if is_min[i] { "min" } else { "max" };
                let (first, second) = (axis(axes[0]), axis(axes[1]));
                write!(f, "carve {first} {}, {second} {}, {}", side(0), side(1), end(leaf, offset))
            }
            Header::Leaf { first_triangle } => f.write_str(&end(true, first_triangle)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_header_that_decodes_encodes_to_itself() {
        let mut valid = 0;
        for code in 0..1u32 << HEADER.width {
            let word = code << HEADER.low | 0x2aa_aaa1;
            if let Some(header) = Header::decode(word) {
                assert_eq!(header.encode(), word, "{header:?}");
                valid += 1;
            }
        }
        // 6 splits, 6 single carves, 24 dual carves, 1 leaf.
        assert_eq!(valid, 6 + 6 + 24 + 1);
    }

    #[test]
    fn dual_kinds_name_all_pairs_of_axes() {
        for axes in [[0, 1], [0, 2], [1, 2]] {
            let kind = dual_kind(axes);
            assert_ne!(kind, SINGLE);
            assert_eq!(dual_axes(kind), axes);
        }
    }
}
