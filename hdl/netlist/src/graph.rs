//! The typed, hash-consed word graph: what every kernel becomes.
//!
//! The constructors of [`Graph`] keep these invariants, and everything downstream relies on them:
//! - a node's operands have smaller ids than the node, so id order is an evaluation order;
//! - two nodes of a graph never have the same operation, operands and width;
//! - every width is between 1 and [`MAX_WIDTH`] bits, every value is below 2^width;
//! - the operand widths obey the table of [`Op`]; no operation widens or truncates implicitly.

use std::collections::HashMap;

/// Widest word of the graph, in bits; wider buses are split by the designer.
pub const MAX_WIDTH: u32 = 128;

/// The value with the `width` lowest bits set.
#[must_use]
pub const fn mask(width: u32) -> u128 {
    if width >= 128 { u128::MAX } else { (1 << width) - 1 }
}

/// Index of a node in its [`Graph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NodeId(pub u32);

impl NodeId {
    /// The position in [`Graph::nodes`].
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Operators of one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum UnaryOp {
    /// Every bit inverted; result as wide as the operand.
    Not,
    /// Two's complement negation; result as wide as the operand.
    Negate,
    /// One bit: all bits set.
    ReduceAnd,
    /// One bit: any bit set.
    ReduceOr,
    /// One bit: parity.
    ReduceXor,
}

/// Operators of two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BinaryOp {
    /// Bitwise and; operands and result of one width, as for the next four.
    And,
    /// Bitwise or.
    Or,
    /// Bitwise exclusive or.
    Xor,
    /// Sum modulo 2^width.
    Add,
    /// Difference modulo 2^width.
    Sub,
    /// Unsigned product modulo 2^width of operands of one width, at most as wide as the result.
    Mul,
    /// One bit: equal. The operands of comparisons have one width.
    Eq,
    /// One bit: different.
    Ne,
    /// One bit: less, unsigned.
    Lt,
    /// One bit: less or equal, unsigned.
    Le,
    /// One bit: less, two's complement.
    SignedLt,
    /// One bit: less or equal, two's complement.
    SignedLe,
    /// Logical shift left by an amount of any width; zero when the amount reaches the width.
    Shl,
    /// Logical shift right by an amount of any width; zero when the amount reaches the width.
    Shr,
}

/// What a node computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Op {
    /// A constant below 2^width.
    Constant(u128),
    /// An input port, by its position in the module's inputs.
    Input(u32),
    /// The present value of a register, by its position in the module's registers.
    Register(u32),
    /// An output port of an instance; never in a flattened netlist.
    Instance {
        /// Position in the module's instances.
        instance: u32,
        /// Position in the outputs of the instance's module.
        output: u32,
    },
    /// See [`UnaryOp`].
    Unary(UnaryOp, NodeId),
    /// See [`BinaryOp`].
    Binary(BinaryOp, NodeId, NodeId),
    /// `select ? when_true : when_false`; `select` is one bit, the others as wide as the result.
    Mux {
        /// The one-bit condition.
        select: NodeId,
        /// The value when `select` is 1.
        when_true: NodeId,
        /// The value when `select` is 0.
        when_false: NodeId,
    },
    /// Bits `low + width - 1 ..= low` of an operand that has them.
    Slice {
        /// The operand.
        of: NodeId,
        /// Position of the lowest bit taken.
        low: u32,
    },
    /// `{high, low}`; the result is as wide as both together.
    Concat {
        /// The upper bits.
        high: NodeId,
        /// The lower bits.
        low: NodeId,
    },
    /// Extension to a larger width.
    Extend {
        /// The operand, narrower than the result.
        of: NodeId,
        /// Whether the sign bit fills the new bits, zero otherwise.
        signed: bool,
    },
}

impl Op {
    /// The operands, in order.
    pub fn operands(self) -> impl Iterator<Item = NodeId> {
        let list = match self {
            Op::Constant(_) | Op::Input(_) | Op::Register(_) | Op::Instance { .. } => [None; 3],
            Op::Unary(_, a) | Op::Slice { of: a, .. } | Op::Extend { of: a, .. } => [Some(a), None, None],
            Op::Binary(_, a, b) | Op::Concat { high: a, low: b } => [Some(a), Some(b), None],
            Op::Mux { select, when_true, when_false } => [Some(select), Some(when_true), Some(when_false)],
        };
        list.into_iter().flatten()
    }

    /// The same operation on other operands.
    #[must_use]
    pub fn map_operands(self, mut map: impl FnMut(NodeId) -> NodeId) -> Self {
        match self {
            Op::Constant(_) | Op::Input(_) | Op::Register(_) | Op::Instance { .. } => self,
            Op::Unary(op, a) => Op::Unary(op, map(a)),
            Op::Binary(op, a, b) => Op::Binary(op, map(a), map(b)),
            Op::Mux { select, when_true, when_false } => {
                Op::Mux { select: map(select), when_true: map(when_true), when_false: map(when_false) }
            }
            Op::Slice { of, low } => Op::Slice { of: map(of), low },
            Op::Concat { high, low } => Op::Concat { high: map(high), low: map(low) },
            Op::Extend { of, signed } => Op::Extend { of: map(of), signed },
        }
    }

    /// Whether the node has no operands: a constant or a value that arrives from elsewhere.
    #[must_use]
    pub fn is_source(self) -> bool {
        self.operands().next().is_none()
    }
}

/// An operation and the width of its result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Node {
    /// What is computed.
    pub op: Op,
    /// Width of the result in bits.
    pub width: u32,
}

/// A hash-consed graph of nodes; see the module for its invariants.
///
/// Nodes are made by the constructors of the `simplify` module, which fold and normalise, or by
/// [`Graph::intern`], which takes a node as it is.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    ids: HashMap<Node, NodeId>,
}

impl PartialEq for Graph {
    fn eq(&self, other: &Self) -> bool {
        self.nodes == other.nodes
    }
}

impl Graph {
    /// All nodes, operands before users.
    #[must_use]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// All node ids with their nodes, operands before users.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (NodeId, Node)> + ExactSizeIterator {
        self.nodes.iter().enumerate().map(|(i, &node)| (NodeId(i as u32), node))
    }

    /// The node with this id.
    #[must_use]
    pub fn node(&self, id: NodeId) -> Node {
        self.nodes[id.index()]
    }

    /// The operation of a node.
    #[must_use]
    pub fn op(&self, id: NodeId) -> Op {
        self.nodes[id.index()].op
    }

    /// Width of a node in bits.
    #[must_use]
    pub fn width(&self, id: NodeId) -> u32 {
        self.nodes[id.index()].width
    }

    /// The value of a constant node.
    #[must_use]
    pub fn constant_value(&self, id: NodeId) -> Option<u128> {
        match self.op(id) {
            Op::Constant(value) => Some(value),
            _ => None,
        }
    }

    /// Adds the node as given, without simplification, or returns an equal node that exists.
    ///
    /// # Panics
    /// When the node breaks the width rules of [`Op`]: a mistake of the caller, never of a design.
    pub fn intern(&mut self, node: Node) -> NodeId {
        if let Some(&id) = self.ids.get(&node) {
            return id;
        }
        self.check(node);
        let id = NodeId(u32::try_from(self.nodes.len()).expect("fewer than 2^32 nodes"));
        self.nodes.push(node);
        self.ids.insert(node, id);
        id
    }

    fn check(&self, Node { op, width }: Node) {
        let w = |id| self.width(id);
        let well_typed = match op {
            Op::Constant(value) => value <= mask(width),
            Op::Input(_) | Op::Register(_) | Op::Instance { .. } => true,
            Op::Unary(UnaryOp::Not | UnaryOp::Negate, a) => w(a) == width,
            Op::Unary(_, _) => width == 1,
            Op::Binary(op, a, b) => match op {
                BinaryOp::Shl | BinaryOp::Shr => w(a) == width,
                BinaryOp::Mul => w(a) == w(b) && w(a) <= width,
                _ if op.is_comparison() => w(a) == w(b) && width == 1,
                _ => w(a) == width && w(b) == width,
            },
            Op::Mux { select, when_true, when_false } => {
                w(select) == 1 && w(when_true) == width && w(when_false) == width
            }
            Op::Slice { of, low } => low + width <= w(of),
            Op::Concat { high, low } => w(high) + w(low) == width,
            Op::Extend { of, .. } => w(of) < width,
        };
        assert!(well_typed && (1..=MAX_WIDTH).contains(&width), "ill-typed node {op:?} of width {width}");
    }
}

impl BinaryOp {
    /// Whether the result is one bit whatever the operands' width.
    #[must_use]
    pub fn is_comparison(self) -> bool {
        use BinaryOp::{Eq, Le, Lt, Ne, SignedLe, SignedLt};
        matches!(self, Eq | Ne | Lt | Le | SignedLt | SignedLe)
    }

    /// Whether the operands may be exchanged.
    #[must_use]
    pub fn is_commutative(self) -> bool {
        use BinaryOp::{Add, And, Eq, Mul, Ne, Or, Xor};
        matches!(self, And | Or | Xor | Add | Mul | Eq | Ne)
    }
}

/// Reads a value of `width` bits as two's complement.
#[must_use]
pub fn as_signed(value: u128, width: u32) -> i128 {
    let shift = 128 - width;
    ((value << shift) as i128) >> shift
}

/// The value that an operation computes from its operands' values; the one definition of the
/// semantics, shared by constant folding and the interpreter.
///
/// `operand_width` is the width of the first operand (of the lower part for [`Op::Concat`]).
/// Sources have no operands; a constant is its value, any other source gives 0.
#[must_use]
pub fn apply(op: Op, width: u32, operand_width: u32, values: [u128; 3]) -> u128 {
    let [a, b, c] = values;
    match op {
        Op::Constant(value) => value,
        Op::Input(_) | Op::Register(_) | Op::Instance { .. } => 0,
        Op::Unary(op, _) => match op {
            UnaryOp::Not => !a & mask(width),
            UnaryOp::Negate => a.wrapping_neg() & mask(width),
            UnaryOp::ReduceAnd => u128::from(a == mask(operand_width)),
            UnaryOp::ReduceOr => u128::from(a != 0),
            UnaryOp::ReduceXor => u128::from(a.count_ones() % 2),
        },
        Op::Binary(op, _, _) => match op {
            BinaryOp::And => a & b,
            BinaryOp::Or => a | b,
            BinaryOp::Xor => a ^ b,
            BinaryOp::Add => a.wrapping_add(b) & mask(width),
            BinaryOp::Sub => a.wrapping_sub(b) & mask(width),
            BinaryOp::Mul => a.wrapping_mul(b) & mask(width),
            BinaryOp::Eq => u128::from(a == b),
            BinaryOp::Ne => u128::from(a != b),
            BinaryOp::Lt => u128::from(a < b),
            BinaryOp::Le => u128::from(a <= b),
            BinaryOp::SignedLt => u128::from(as_signed(a, operand_width) < as_signed(b, operand_width)),
            BinaryOp::SignedLe => u128::from(as_signed(a, operand_width) <= as_signed(b, operand_width)),
            BinaryOp::Shl if b < u128::from(width) => (a << b) & mask(width),
            BinaryOp::Shr if b < u128::from(width) => a >> b,
            BinaryOp::Shl | BinaryOp::Shr => 0,
        },
        Op::Mux { .. } => {
            if a != 0 {
                b
            } else {
                c
            }
        }
        Op::Slice { low, .. } => (a >> low) & mask(width),
        Op::Concat { .. } => (a << operand_width) | b,
        Op::Extend { signed: false, .. } => a,
        Op::Extend { signed: true, .. } => as_signed(a, operand_width) as u128 & mask(width),
    }
}

/// The width that [`apply`] wants as `operand_width` for a node.
#[must_use]
pub fn operand_width(op: Op, width_of: impl Fn(NodeId) -> u32) -> u32 {
    match op {
        Op::Concat { low, .. } => width_of(low),
        _ => op.operands().next().map_or(1, width_of),
    }
}
