//! Expressions by the kernel's own rules: what Rust computes when rust-hdl simulates.
//!
//! Every operation has the width of its operands, `bit_cast` truncates or extends with zeros, a literal takes
//! the width of the other operand. Bits read past the end of a signal are zero; a bit replaced there changes
//! nothing. (rust-hdl's simulation panics on the latter and on `get_bit`, so no kernel that runs can tell;
//! the exported Verilog has X there, which the guard reports.)

use rust_hdl_core::ast::{VerilogExpression as Expr, VerilogOp, VerilogOpUnary};

use super::design::SignalType;
use super::error::ErrorKind;
use super::graph::{BinaryOp, NodeId, UnaryOp, mask};
use super::kernel::Kernel;

/// A value and whether its type is `Signed`.
#[derive(Clone, Copy, Debug)]
pub struct Typed {
    /// The value.
    pub node: NodeId,
    /// Whether comparisons and extensions treat it as two's complement.
    pub signed: bool,
}

impl Kernel<'_> {
    /// The value of an expression that must have this width.
    pub(super) fn rust_value_of_width(&mut self, expr: &Expr, width: u32) -> Result<NodeId, ErrorKind> {
        let value = self.rust_value(expr, Some(width))?.node;
        let found = self.graph.width(value);
        if found == width { Ok(value) } else { Err(ErrorKind::WidthMismatch { left: width, right: found }) }
    }

    /// The value of an expression; literals take the expected width.
    pub(super) fn rust_value(&mut self, expr: &Expr, expected: Option<u32>) -> Result<Typed, ErrorKind> {
        if let Some(value) = self.constant_integer(expr) {
            let width = expected.ok_or_else(|| {
                ErrorKind::NotUnderstood(format!(
                    "the literal {value} where no width is known; use bits::<N>()"
                ))
            })?;
            if value > mask(width) {
                return Err(ErrorKind::WidthMismatch { left: width, right: 128 - value.leading_zeros() });
            }
            return Ok(unsigned(self.graph.constant(value, width)));
        }
        match expr {
            Expr::Signal(name) => {
                if let Some(&(value, width)) = self.signals.labels.get(name.as_str()) {
                    return Ok(unsigned(self.graph.constant(value, width)));
                }
                let signal = self.lookup(name)?;
                let node = self.read(name, signal)?;
                Ok(Typed { node, signed: signal.signal_type == SignalType::Signed })
            }
            Expr::Paren(inner) => self.rust_value(inner, expected),
            Expr::Cast(inner, width) => {
                let width = checked(*width)?;
                let expected = self.constant_integer(inner).map(|_| width);
                let value = self.rust_value(inner, expected)?;
                Ok(unsigned(self.graph.resize(value.node, width, false)))
            }
            Expr::Signed(inner) => {
                let value = self.rust_value(inner, expected)?;
                // A `Signed` of a `Signed` comes from `signed_bit_cast`, whose width the tree does not show.
                let node = match expected {
                    Some(width) if value.signed => self.graph.resize(value.node, width, true),
                    None if value.signed => {
                        return Err(ErrorKind::NotUnderstood(
                            "the width of signed_bit_cast here; assign it to a local signal".into(),
                        ));
                    }
                    _ => value.node,
                };
                Ok(Typed { node, signed: true })
            }
            Expr::Unsigned(inner) => Ok(unsigned(self.rust_value(inner, expected)?.node)),
            Expr::Unary(op, inner) => self.rust_unary(op, inner, expected),
            Expr::Binary(left, op, right) => self.rust_binary(left, op, right, expected),
            Expr::Index(base, index) => Ok(unsigned(self.rust_slice(base, 1, index)?)),
            Expr::Slice(base, width, offset) => {
                let width = checked(*width)?;
                Ok(unsigned(self.rust_slice(base, width, offset)?))
            }
            Expr::IndexReplace(base, index, value) => self.rust_replace_bit(base, index, value),
            Expr::Literal(literal) => Err(ErrorKind::NotUnderstood(format!("the literal {literal}"))),
        }
    }

    fn rust_unary(
        &mut self,
        op: &VerilogOpUnary,
        inner: &Expr,
        expected: Option<u32>,
    ) -> Result<Typed, ErrorKind> {
        let same_width = matches!(op, VerilogOpUnary::Not | VerilogOpUnary::Neg);
        let value = self.rust_value(inner, if same_width { expected } else { None })?;
        let op = match op {
            VerilogOpUnary::Not => UnaryOp::Not,
            VerilogOpUnary::Neg => UnaryOp::Negate,
            VerilogOpUnary::All => UnaryOp::ReduceAnd,
            VerilogOpUnary::Any => UnaryOp::ReduceOr,
            VerilogOpUnary::Xor => UnaryOp::ReduceXor,
        };
        Ok(Typed { node: self.graph.unary(op, value.node), signed: value.signed && same_width })
    }

    fn rust_binary(
        &mut self,
        left: &Expr,
        op: &VerilogOp,
        right: &Expr,
        expected: Option<u32>,
    ) -> Result<Typed, ErrorKind> {
        match op {
            VerilogOp::Shl | VerilogOp::Shr => {
                let value = self.rust_value(left, expected)?;
                let op = if matches!(op, VerilogOp::Shl) { BinaryOp::Shl } else { BinaryOp::Shr };
                let amount = match self.constant_integer(right) {
                    Some(amount) => self.graph.constant(amount, 64),
                    None => self.rust_value(right, None)?.node,
                };
                Ok(Typed { node: self.graph.binary(op, value.node, amount), signed: value.signed })
            }
            VerilogOp::Mul => {
                let (a, b) = (self.rust_value(left, Some(16))?, self.rust_value(right, Some(16))?);
                self.expect_equal_widths(a.node, b.node)?;
                let width = 2 * self.graph.width(a.node);
                if !(a.signed && b.signed) {
                    return Ok(unsigned(self.graph.multiply(a.node, b.node, width)));
                }
                let (a, b) = (self.graph.extend(a.node, width, true), self.graph.extend(b.node, width, true));
                Ok(Typed { node: self.graph.multiply(a, b, width), signed: true })
            }
            VerilogOp::LogicalAnd | VerilogOp::LogicalOr => {
                let (a, b) = (self.rust_value_of_width(left, 1)?, self.rust_value_of_width(right, 1)?);
                let op = if matches!(op, VerilogOp::LogicalAnd) { BinaryOp::And } else { BinaryOp::Or };
                Ok(unsigned(self.graph.binary(op, a, b)))
            }
            VerilogOp::Add | VerilogOp::Sub | VerilogOp::BitAnd | VerilogOp::BitOr | VerilogOp::BitXor => {
                let width = self.rust_width(left).or_else(|| self.rust_width(right)).or(expected);
                let (a, b) = (self.rust_value(left, width)?, self.rust_value(right, width)?);
                self.expect_equal_widths(a.node, b.node)?;
                let op = match op {
                    VerilogOp::Add => BinaryOp::Add,
                    VerilogOp::Sub => BinaryOp::Sub,
                    VerilogOp::BitAnd => BinaryOp::And,
                    VerilogOp::BitOr => BinaryOp::Or,
                    _ => BinaryOp::Xor,
                };
                Ok(Typed { node: self.graph.binary(op, a.node, b.node), signed: a.signed || b.signed })
            }
            VerilogOp::Eq | VerilogOp::Ne | VerilogOp::Lt | VerilogOp::Le | VerilogOp::Gt | VerilogOp::Ge => {
                let width = self.rust_width(left).or_else(|| self.rust_width(right));
                let (a, b) = (self.rust_value(left, width)?, self.rust_value(right, width)?);
                self.expect_equal_widths(a.node, b.node)?;
                Ok(unsigned(self.compare(op, a.node, b.node, a.signed || b.signed)))
            }
        }
    }

    /// A comparison of operands of one width; `op` is one of the six.
    pub(super) fn compare(&mut self, op: &VerilogOp, a: NodeId, b: NodeId, signed: bool) -> NodeId {
        let (less, less_or_equal) = match signed {
            true => (BinaryOp::SignedLt, BinaryOp::SignedLe),
            false => (BinaryOp::Lt, BinaryOp::Le),
        };
        match op {
            VerilogOp::Lt => self.graph.binary(less, a, b),
            VerilogOp::Le => self.graph.binary(less_or_equal, a, b),
            VerilogOp::Gt => self.graph.binary(less, b, a),
            VerilogOp::Ge => self.graph.binary(less_or_equal, b, a),
            VerilogOp::Ne => self.graph.binary(BinaryOp::Ne, a, b),
            _ => self.graph.binary(BinaryOp::Eq, a, b),
        }
    }

    fn rust_slice(&mut self, base: &Expr, width: u32, offset: &Expr) -> Result<NodeId, ErrorKind> {
        let base = self.sliced_signal(base)?;
        let offset = self.rust_index(offset)?;
        let shifted = self.graph.binary(BinaryOp::Shr, base, offset);
        Ok(self.graph.resize(shifted, width, false))
    }

    fn rust_replace_bit(&mut self, base: &Expr, index: &Expr, value: &Expr) -> Result<Typed, ErrorKind> {
        let base = self.sliced_signal(base)?;
        let width = self.graph.width(base);
        let index = self.rust_index(index)?;
        let value = self.rust_value_of_width(value, 1)?;
        let one = self.graph.constant(1, width);
        let position = self.graph.binary(BinaryOp::Shl, one, index);
        let others = self.graph.unary(UnaryOp::Not, position);
        let kept = self.graph.binary(BinaryOp::And, base, others);
        let extended = self.graph.extend(value, width, false);
        let placed = self.graph.binary(BinaryOp::Shl, extended, index);
        Ok(unsigned(self.graph.binary(BinaryOp::Or, kept, placed)))
    }

    /// The signal under a slice. Verilog slices nothing else, so neither does a kernel.
    pub(super) fn sliced_signal(&mut self, base: &Expr) -> Result<NodeId, ErrorKind> {
        let Expr::Signal(name) = base else {
            return Err(ErrorKind::NotUnderstood(
                "bits of an expression; assign it to a local signal and take the bits of that".into(),
            ));
        };
        let signal = self.lookup(name)?;
        self.read(name, signal)
    }

    fn rust_index(&mut self, index: &Expr) -> Result<NodeId, ErrorKind> {
        if let Some(value) = self.constant_integer(index) {
            return Ok(self.graph.constant(value, 64));
        }
        let mut inner = index;
        while let Expr::Paren(next) = inner {
            inner = next;
        }
        if matches!(inner, Expr::Binary(..)) {
            // `index()` leaves no trace in the tree, so the width of the arithmetic is unknown here.
            return Err(ErrorKind::NotUnderstood(
                "arithmetic in an index; assign it to a local signal".into(),
            ));
        }
        Ok(self.rust_value(inner, None)?.node)
    }

    fn expect_equal_widths(&self, a: NodeId, b: NodeId) -> Result<(), ErrorKind> {
        let (left, right) = (self.graph.width(a), self.graph.width(b));
        if left == right { Ok(()) } else { Err(ErrorKind::WidthMismatch { left, right }) }
    }

    /// The width of an expression as far as it does not depend on its surroundings.
    fn rust_width(&self, expr: &Expr) -> Option<u32> {
        match expr {
            Expr::Signal(name) => match self.signals.labels.get(name.as_str()) {
                Some(&(_, width)) => Some(width),
                None => self.lookup(name).ok().map(|signal| signal.width),
            },
            Expr::Literal(_) => None,
            Expr::Cast(_, width) | Expr::Slice(_, width, _) => u32::try_from(*width).ok(),
            Expr::Signed(inner) if self.is_signed(inner) => None,
            Expr::Signed(inner) | Expr::Unsigned(inner) | Expr::Paren(inner) => self.rust_width(inner),
            Expr::IndexReplace(inner, _, _) => self.rust_width(inner),
            Expr::Index(..) => Some(1),
            Expr::Unary(VerilogOpUnary::Not | VerilogOpUnary::Neg, inner) => self.rust_width(inner),
            Expr::Unary(..) => Some(1),
            Expr::Binary(left, op, right) => match op {
                VerilogOp::Shl | VerilogOp::Shr => self.rust_width(left),
                VerilogOp::Mul => self.rust_width(left).map(|width| 2 * width),
                VerilogOp::Add
                | VerilogOp::Sub
                | VerilogOp::BitAnd
                | VerilogOp::BitOr
                | VerilogOp::BitXor => self.rust_width(left).or_else(|| self.rust_width(right)),
                _ => Some(1),
            },
        }
    }

    fn is_signed(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Signal(name) => {
                self.lookup(name).is_ok_and(|signal| signal.signal_type == SignalType::Signed)
            }
            Expr::Signed(_) => true,
            Expr::Paren(inner) | Expr::Unary(VerilogOpUnary::Neg, inner) => self.is_signed(inner),
            Expr::Binary(left, VerilogOp::Add | VerilogOp::Sub | VerilogOp::Mul, right) => {
                self.is_signed(left) || self.is_signed(right)
            }
            _ => false,
        }
    }
}

fn unsigned(node: NodeId) -> Typed {
    Typed { node, signed: false }
}

/// A width as the graph takes it.
pub(super) fn checked(width: usize) -> Result<u32, ErrorKind> {
    match u32::try_from(width) {
        Ok(narrow) if (1..=super::graph::MAX_WIDTH).contains(&narrow) => Ok(narrow),
        _ => Err(ErrorKind::UnsupportedWidth(width)),
    }
}
