//! Expressions: each operand has the width that its operation wants.

use super::constant::constant;
use super::emit::Emitter;
use crate::{BinaryOp, NodeId, Op, UnaryOp, mask};

impl Emitter<'_> {
    /// A node where it is used.
    pub(super) fn operand(&mut self, id: NodeId) -> String {
        match self.names.get(&id) {
            Some(name) => {
                let name = name.clone();
                let width = self.module.graph.width(id);
                self.mark(&name, mask(width));
                name
            }
            None => self.expression(id, false),
        }
    }

    /// A node as the whole right side of an assignment or the whole of a connection.
    pub(super) fn standalone(&mut self, id: NodeId) -> String {
        if self.names.contains_key(&id) { self.operand(id) } else { self.expression(id, true) }
    }

    fn mark(&mut self, name: &str, bits: u128) {
        if let Some((read, _)) = self.read.get_mut(name) {
            *read |= bits;
        }
    }

    /// The expression of a node from its operands; in parentheses unless it stands alone or needs none.
    pub(super) fn expression(&mut self, id: NodeId, alone: bool) -> String {
        let graph = &self.module.graph;
        let node = graph.node(id);
        let text = match node.op {
            Op::Constant(value) => return constant(value, node.width),
            Op::Input(_) | Op::Register(_) | Op::Instance { .. } => return self.operand(id),
            Op::Unary(op, a) => {
                let symbol = match op {
                    UnaryOp::Not => "~",
                    UnaryOp::Negate => "-",
                    UnaryOp::ReduceAnd => "&",
                    UnaryOp::ReduceOr => "|",
                    UnaryOp::ReduceXor => "^",
                };
                let operand = self.operand(a);
                if op == UnaryOp::Not {
                    return format!("~{operand}");
                }
                // `|~x` is no reduction of an inversion to every parser.
                if operand.starts_with('~') {
                    format!("{symbol}({operand})")
                } else {
                    format!("{symbol}{operand}")
                }
            }
            Op::Binary(BinaryOp::Mul, a, b) => {
                let pad = node.width - graph.width(a);
                let mut padded = |operand| match pad {
                    0 => self.operand(operand),
                    _ => format!("{{{}, {}}}", constant(0, pad), self.operand(operand)),
                };
                format!("{} * {}", padded(a), padded(b))
            }
            Op::Binary(op @ (BinaryOp::SignedLt | BinaryOp::SignedLe), a, b) => {
                let symbol = if op == BinaryOp::SignedLt { "<" } else { "<=" };
                format!("$signed({}) {symbol} $signed({})", self.operand(a), self.operand(b))
            }
            // A constant reads better on the right.
            Op::Binary(op @ (BinaryOp::Lt | BinaryOp::Le), a, b) if graph.constant_value(a).is_some() => {
                let symbol = if op == BinaryOp::Lt { ">" } else { ">=" };
                format!("{} {symbol} {}", self.operand(b), self.operand(a))
            }
            Op::Binary(op, a, b) => format!("{} {} {}", self.operand(a), symbol(op), self.operand(b)),
            Op::Mux { select, when_true, when_false } => format!(
                "{} ? {} : {}",
                self.operand(select),
                self.operand(when_true),
                self.operand(when_false)
            ),
            Op::Slice { of, low } => return self.slice(of, low, node.width),
            Op::Concat { .. } => {
                let mut parts = Vec::new();
                self.concatenation(id, true, &mut parts);
                return format!("{{{}}}", parts.join(", "));
            }
            Op::Extend { of, signed: false } => {
                let pad = constant(0, node.width - graph.width(of));
                let mut parts = vec![pad];
                self.concatenation(of, false, &mut parts);
                return format!("{{{}}}", parts.join(", "));
            }
            Op::Extend { of, signed: true } => {
                let (width, pad) = (graph.width(of), node.width - graph.width(of));
                if width == 1 {
                    return format!("{{{}{{{}}}}}", node.width, self.operand(of));
                }
                let sign = self.slice(of, width - 1, 1);
                return format!("{{{{{pad}{{{sign}}}}}, {}}}", self.operand(of));
            }
        };
        if alone { text } else { format!("({text})") }
    }

    /// The parts of a concatenation, nested ones without a name taken apart.
    fn concatenation(&mut self, id: NodeId, is_root: bool, parts: &mut Vec<String>) {
        match self.module.graph.op(id) {
            Op::Concat { high, low } if is_root || !self.names.contains_key(&id) => {
                self.concatenation(high, false, parts);
                self.concatenation(low, false, parts);
            }
            _ => parts.push(self.operand(id)),
        }
    }

    fn slice(&mut self, of: NodeId, low: u32, width: u32) -> String {
        let name = match self.names.get(&of) {
            Some(name) => name.clone(),
            None => unreachable!("a node whose bits are selected has a wire"),
        };
        if self.module.graph.width(of) == width {
            self.mark(&name, mask(width));
            return name;
        }
        self.mark(&name, mask(width) << low);
        if width == 1 { format!("{name}[{low}]") } else { format!("{name}[{}:{low}]", low + width - 1) }
    }
}

fn symbol(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::And => "&",
        BinaryOp::Or => "|",
        BinaryOp::Xor => "^",
        BinaryOp::Add => "+",
        BinaryOp::Sub => "-",
        BinaryOp::Mul => "*",
        BinaryOp::Eq => "==",
        BinaryOp::Ne => "!=",
        BinaryOp::Lt | BinaryOp::SignedLt => "<",
        BinaryOp::Le | BinaryOp::SignedLe => "<=",
        BinaryOp::Shl => "<<",
        BinaryOp::Shr => ">>",
    }
}
