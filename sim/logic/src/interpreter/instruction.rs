//! What the interpreter executes: operations on columns, the values of a node in all lanes.

use netlist::BinaryOp;

/// Size of a column's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Size {
    /// 32 bits.
    Small,
    /// 64 bits.
    Medium,
    /// 128 bits.
    Large,
}

impl Size {
    /// The least size for values of `width` bits.
    pub fn of(width: u32) -> Self {
        match width {
            ..=32 => Self::Small,
            33..=64 => Self::Medium,
            _ => Self::Large,
        }
    }
}

/// A column: its size and its position among those of that size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    pub size: Size,
    pub at: usize,
}

/// What an instruction does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Operation {
    /// `a & b` and the like, and arithmetic, masked.
    Word(BinaryOp),
    /// `a << shift | b`.
    Join,
    /// `a`, whose sign bit is at `shift`, extended and masked.
    SignExtend,
    /// A comparison; operands move up by `shift` if it is signed.
    Test(BinaryOp),
    /// The operand's parity.
    Parity,
    /// `a ? b : c`.
    Select,
    /// `(a >> shift) & mask`, in another size.
    Convert,
    /// The least of `a` and 2^32 - 1.
    Saturate,
    /// `a << b`, masked.
    ShiftLeft,
    /// `a >> b`.
    ShiftRight,
}

/// An operation on columns.
#[derive(Clone, Copy, Debug)]
pub struct Instruction {
    pub operation: Operation,
    /// Size of the operands where it is not the result's.
    pub from: Size,
    pub to: Place,
    /// Positions of the operands in their size.
    pub operands: [usize; 3],
    pub shift: u32,
    pub mask: u128,
}
