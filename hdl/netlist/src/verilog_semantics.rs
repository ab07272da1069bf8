//! Expressions as a Verilog tool reads what rust-hdl prints for them (IEEE 1364-2005, sections 5.1.2 and 5.4).
//!
//! rust-hdl prints operators without parentheses of its own, so the printed text is parsed again with
//! Verilog's precedence; literals print as `32'h..`; and operands are evaluated in the width of their context,
//! which an assignment's target, a comparison's other side or a literal may widen. What Verilog leaves unknown
//! (bits beyond a signal) is a free input of the graph, so that anything depending on it shows.

use rust_hdl_core::ast::{VerilogExpression as Expr, VerilogOp, VerilogOpUnary};

use super::design::SignalType;
use super::error::ErrorKind;
use super::graph::{BinaryOp, MAX_WIDTH, Node, NodeId, Op, UnaryOp, mask};
use super::kernel::Kernel;
use super::rust_semantics::checked;
use super::signals::{Role, parse_literal};

/// Inputs from this position on stand for bits that Verilog leaves unknown.
pub const FIRST_UNKNOWN: u32 = 1 << 24;

/// Width of an unsized literal, an enum label and a loop index in Verilog.
const INTEGER_WIDTH: u32 = 32;

/// The printed text, parsed again.
enum Parsed<'e> {
    Leaf(&'e Expr),
    Unary(&'e VerilogOpUnary, Box<Parsed<'e>>),
    Binary(Box<Parsed<'e>>, &'e VerilogOp, Box<Parsed<'e>>),
}

enum Token<'e> {
    Operand(&'e Expr),
    Prefix(&'e VerilogOpUnary),
    Infix(&'e VerilogOp),
}

fn tokens<'e>(expr: &'e Expr, out: &mut Vec<Token<'e>>) {
    match expr {
        Expr::Binary(left, op, right) => {
            tokens(left, out);
            out.push(Token::Infix(op));
            tokens(right, out);
        }
        Expr::Unary(op, inner) => {
            out.push(Token::Prefix(op));
            tokens(inner, out);
        }
        _ => out.push(Token::Operand(expr)),
    }
}

/// Binding strength of IEEE 1364-2005 table 5-4; all associate to the left.
fn precedence(op: &VerilogOp) -> u32 {
    match op {
        VerilogOp::Mul => 10,
        VerilogOp::Add | VerilogOp::Sub => 9,
        VerilogOp::Shl | VerilogOp::Shr => 8,
        VerilogOp::Lt | VerilogOp::Le | VerilogOp::Gt | VerilogOp::Ge => 7,
        VerilogOp::Eq | VerilogOp::Ne => 6,
        VerilogOp::BitAnd => 5,
        VerilogOp::BitXor => 4,
        VerilogOp::BitOr => 3,
        VerilogOp::LogicalAnd => 2,
        VerilogOp::LogicalOr => 1,
    }
}

fn parse(expr: &Expr) -> Result<Parsed<'_>, ErrorKind> {
    let mut list = Vec::new();
    tokens(expr, &mut list);
    let mut rest = list.iter().peekable();
    climb(&mut rest, 0)
}

type Tokens<'t, 'e> = std::iter::Peekable<std::slice::Iter<'t, Token<'e>>>;

fn climb<'e>(rest: &mut Tokens<'_, 'e>, weakest: u32) -> Result<Parsed<'e>, ErrorKind> {
    let mut left = primary(rest)?;
    while let Some(&&Token::Infix(op)) = rest.peek() {
        let strength = precedence(op);
        if strength <= weakest {
            break;
        }
        rest.next();
        let right = climb(rest, strength)?;
        left = Parsed::Binary(Box::new(left), op, Box::new(right));
    }
    Ok(left)
}

fn primary<'e>(rest: &mut Tokens<'_, 'e>) -> Result<Parsed<'e>, ErrorKind> {
    match rest.next() {
        Some(Token::Prefix(op)) => Ok(Parsed::Unary(op, Box::new(primary(rest)?))),
        Some(Token::Operand(expr)) => Ok(Parsed::Leaf(expr)),
        _ => Err(ErrorKind::NotUnderstood("an operator without operand".into())),
    }
}

impl Kernel<'_> {
    /// The value that `target = expr;` gives a target of this width.
    pub(super) fn verilog_assigned(&mut self, expr: &Expr, target_width: u32) -> Result<NodeId, ErrorKind> {
        let parsed = parse(expr)?;
        let (width, signed) = self.size(&parsed)?;
        let value = self.evaluate(&parsed, width.max(target_width), signed)?;
        Ok(self.graph.resize(value, target_width, false))
    }

    /// The one-bit value of `if (expr)`.
    pub(super) fn verilog_condition(&mut self, expr: &Expr) -> Result<NodeId, ErrorKind> {
        let value = self.self_determined(expr)?.0;
        Ok(self.graph.unary(UnaryOp::ReduceOr, value))
    }

    /// The value that `case (expr)` compares, in the width of the integer labels; truncated to the width
    /// that the labels of the kernel have.
    pub(super) fn verilog_scrutinee(&mut self, expr: &Expr) -> Result<NodeId, ErrorKind> {
        let own = self.rust_value(expr, None)?.node;
        let own_width = self.graph.width(own);
        let parsed = parse(expr)?;
        let (width, signed) = self.size(&parsed)?;
        let value = self.evaluate(&parsed, width.max(INTEGER_WIDTH), signed)?;
        let low = self.graph.resize(value, own_width, false);
        if self.graph.width(value) == own_width {
            return Ok(low);
        }
        // A value beyond the labels matches none of them: it is as good as unknown.
        let back = self.graph.resize(low, self.graph.width(value), false);
        let fits = self.graph.binary(BinaryOp::Eq, back, value);
        let unknown = self.unknown(own_width);
        Ok(self.graph.mux(fits, low, unknown))
    }

    fn self_determined(&mut self, expr: &Expr) -> Result<(NodeId, bool), ErrorKind> {
        let parsed = parse(expr)?;
        let (width, signed) = self.size(&parsed)?;
        Ok((self.evaluate(&parsed, width, signed)?, signed))
    }

    /// Self-determined width, and whether the expression is signed.
    fn size(&self, parsed: &Parsed) -> Result<(u32, bool), ErrorKind> {
        Ok(match parsed {
            Parsed::Leaf(expr) => self.leaf_size(expr)?,
            Parsed::Unary(VerilogOpUnary::Not | VerilogOpUnary::Neg, inner) => self.size(inner)?,
            Parsed::Unary(..) => (1, false),
            Parsed::Binary(left, op, right) => match op {
                VerilogOp::Shl | VerilogOp::Shr => self.size(left)?,
                VerilogOp::Add
                | VerilogOp::Sub
                | VerilogOp::Mul
                | VerilogOp::BitAnd
                | VerilogOp::BitOr
                | VerilogOp::BitXor => {
                    let ((a, s), (b, t)) = (self.size(left)?, self.size(right)?);
                    (a.max(b), s && t)
                }
                _ => (1, false),
            },
        })
    }

    fn leaf_size(&self, expr: &Expr) -> Result<(u32, bool), ErrorKind> {
        Ok(match expr {
            Expr::Signal(name) => {
                if self.loops.contains_key(name) || self.signals.labels.contains_key(name) {
                    (INTEGER_WIDTH, true)
                } else {
                    let signal = self.lookup(name)?;
                    (signal.width, signal.signal_type == SignalType::Signed)
                }
            }
            Expr::Literal(literal) => (parse_literal(&literal.to_string())?.1, false),
            Expr::Cast(inner, width) => (self.size(&parse(inner)?)?.0.max(checked(*width)?), false),
            Expr::Signed(inner) => (self.size(&parse(inner)?)?.0, true),
            Expr::Unsigned(inner) => (self.size(&parse(inner)?)?.0, false),
            Expr::Paren(inner) => self.size(&parse(inner)?)?,
            Expr::Index(..) => (1, false),
            Expr::Slice(_, width, _) => (checked(*width)?, false),
            Expr::IndexReplace(base, _, value) => {
                let value = self.size(&parse(value)?)?.0;
                (self.size(&parse(base)?)?.0.max(value).max(INTEGER_WIDTH), false)
            }
            Expr::Binary(..) | Expr::Unary(..) => {
                return Err(ErrorKind::NotUnderstood("an operator as an operand".into()));
            }
        })
    }

    /// The value in a context of this width and signedness.
    fn evaluate(&mut self, parsed: &Parsed, width: u32, signed: bool) -> Result<NodeId, ErrorKind> {
        if width > MAX_WIDTH {
            return Err(ErrorKind::UnsupportedWidth(width as usize));
        }
        match parsed {
            Parsed::Leaf(expr) => self.evaluate_leaf(expr, width, signed),
            Parsed::Unary(op @ (VerilogOpUnary::Not | VerilogOpUnary::Neg), inner) => {
                let value = self.evaluate(inner, width, signed)?;
                let op = if matches!(op, VerilogOpUnary::Not) { UnaryOp::Not } else { UnaryOp::Negate };
                Ok(self.graph.unary(op, value))
            }
            Parsed::Unary(op, inner) => {
                let (own, own_signed) = self.size(inner)?;
                let value = self.evaluate(inner, own, own_signed)?;
                let op = match op {
                    VerilogOpUnary::All => UnaryOp::ReduceAnd,
                    VerilogOpUnary::Any => UnaryOp::ReduceOr,
                    _ => UnaryOp::ReduceXor,
                };
                let bit = self.graph.unary(op, value);
                Ok(self.graph.extend(bit, width, false))
            }
            Parsed::Binary(left, op, right) => self.evaluate_binary(left, op, right, width, signed),
        }
    }

    fn evaluate_binary(
        &mut self,
        left: &Parsed,
        op: &VerilogOp,
        right: &Parsed,
        width: u32,
        signed: bool,
    ) -> Result<NodeId, ErrorKind> {
        let arithmetic = match op {
            VerilogOp::Shl | VerilogOp::Shr => {
                let value = self.evaluate(left, width, signed)?;
                let (own, own_signed) = self.size(right)?;
                let amount = self.evaluate(right, own, own_signed)?;
                let op = if matches!(op, VerilogOp::Shl) { BinaryOp::Shl } else { BinaryOp::Shr };
                return Ok(self.graph.binary(op, value, amount));
            }
            VerilogOp::LogicalAnd | VerilogOp::LogicalOr => {
                let truth = |kernel: &mut Self, side: &Parsed| {
                    let (own, own_signed) = kernel.size(side)?;
                    let value = kernel.evaluate(side, own, own_signed)?;
                    Ok::<_, ErrorKind>(kernel.graph.unary(UnaryOp::ReduceOr, value))
                };
                let (a, b) = (truth(self, left)?, truth(self, right)?);
                let op = if matches!(op, VerilogOp::LogicalAnd) { BinaryOp::And } else { BinaryOp::Or };
                let bit = self.graph.binary(op, a, b);
                return Ok(self.graph.extend(bit, width, false));
            }
            VerilogOp::Eq | VerilogOp::Ne | VerilogOp::Lt | VerilogOp::Le | VerilogOp::Gt | VerilogOp::Ge => {
                let ((a, s), (b, t)) = (self.size(left)?, self.size(right)?);
                let (common, both_signed) = (a.max(b), s && t);
                let a = self.evaluate(left, common, both_signed)?;
                let b = self.evaluate(right, common, both_signed)?;
                let bit = self.compare(op, a, b, both_signed);
                return Ok(self.graph.extend(bit, width, false));
            }
            VerilogOp::Add => BinaryOp::Add,
            VerilogOp::Sub => BinaryOp::Sub,
            VerilogOp::Mul => BinaryOp::Mul,
            VerilogOp::BitAnd => BinaryOp::And,
            VerilogOp::BitOr => BinaryOp::Or,
            VerilogOp::BitXor => BinaryOp::Xor,
        };
        let (a, b) = (self.evaluate(left, width, signed)?, self.evaluate(right, width, signed)?);
        Ok(self.graph.binary(arithmetic, a, b))
    }

    fn evaluate_leaf(&mut self, expr: &Expr, width: u32, signed: bool) -> Result<NodeId, ErrorKind> {
        let value = match expr {
            Expr::Signal(name) => {
                if let Some(&value) = self.loops.get(name) {
                    self.graph.constant(u128::from(value), INTEGER_WIDTH)
                } else if let Some(&(value, _)) = self.signals.labels.get(name) {
                    self.graph.constant(value, INTEGER_WIDTH)
                } else {
                    let signal = self.lookup(name)?;
                    self.read(name, signal)?
                }
            }
            Expr::Literal(literal) => {
                let (value, own) = parse_literal(&literal.to_string())?;
                self.graph.constant(value, own)
            }
            Expr::Cast(inner, cast) => {
                let value = self.evaluate(&parse(inner)?, width, false)?;
                let ones = self.graph.constant(mask(checked(*cast)?), width);
                return Ok(self.graph.binary(BinaryOp::And, value, ones));
            }
            Expr::Paren(inner) => return self.evaluate(&parse(inner)?, width, signed),
            Expr::Signed(inner) | Expr::Unsigned(inner) => self.self_determined(inner)?.0,
            Expr::Index(base, index) => self.verilog_slice(base, 1, index)?,
            Expr::Slice(base, own, offset) => self.verilog_slice(base, checked(*own)?, offset)?,
            Expr::IndexReplace(base, index, bit) => {
                // (base & ~(1 << (index)) | ((bit) << (index)))
                let index = self.self_determined(index)?.0;
                let base = self.evaluate(&parse(base)?, width, false)?;
                let one = self.graph.constant(1, width);
                let position = self.graph.binary(BinaryOp::Shl, one, index);
                let others = self.graph.unary(UnaryOp::Not, position);
                let kept = self.graph.binary(BinaryOp::And, base, others);
                let bit = self.evaluate(&parse(bit)?, width, false)?;
                let placed = self.graph.binary(BinaryOp::Shl, bit, index);
                return Ok(self.graph.binary(BinaryOp::Or, kept, placed));
            }
            Expr::Binary(..) | Expr::Unary(..) => {
                return Err(ErrorKind::NotUnderstood("an operator as an operand".into()));
            }
        };
        Ok(self.graph.extend(value, width, signed))
    }

    /// `base[(offset) +: width]`, unknown past the end.
    fn verilog_slice(&mut self, base: &Expr, width: u32, offset: &Expr) -> Result<NodeId, ErrorKind> {
        if let Expr::Signal(name) = base
            && self.lookup(name)?.role == Role::Clock
        {
            return Err(ErrorKind::Clock(name.clone()));
        }
        let base = self.sliced_signal(base)?;
        let offset = match self.constant_integer(offset) {
            Some(value) => self.graph.constant(value, 64),
            None => self.self_determined(offset)?.0,
        };
        let base_width = self.graph.width(base);
        let shifted = self.graph.binary(BinaryOp::Shr, base, offset);
        let known = self.graph.resize(shifted, width, false);
        let ones = self.graph.constant(mask(base_width), base_width);
        let shifted_ones = self.graph.binary(BinaryOp::Shr, ones, offset);
        let exists = self.graph.resize(shifted_ones, width, false);
        if self.graph.constant_value(exists) == Some(mask(width)) {
            return Ok(known);
        }
        let missing = self.graph.unary(UnaryOp::Not, exists);
        let unknown = self.unknown(width);
        let noise = self.graph.binary(BinaryOp::And, unknown, missing);
        Ok(self.graph.binary(BinaryOp::Or, known, noise))
    }

    fn unknown(&mut self, width: u32) -> NodeId {
        let op = Op::Input(FIRST_UNKNOWN + self.unknowns);
        self.unknowns += 1;
        self.graph.intern(Node { op, width })
    }
}
