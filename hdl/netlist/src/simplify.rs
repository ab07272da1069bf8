//! Smart constructors of the graph: fold constants, normalise, and rebuild concatenations.
//!
//! Each rule keeps the value for every assignment of the sources (a property test compares with the
//! plain graph). The rules serve three ends: a port tied to a constant removes the logic it selects;
//! shifts by constants and shift-or idioms, which the language uses for want of concatenation, become
//! wiring, so that counts and areas do not charge for them; one meaning has one shape.

use super::graph::{BinaryOp, Graph, Node, NodeId, Op, UnaryOp, apply, mask, operand_width};

impl Graph {
    /// A constant, reduced modulo 2^width.
    pub fn constant(&mut self, value: u128, width: u32) -> NodeId {
        self.intern(Node { op: Op::Constant(value & mask(width)), width })
    }

    /// Any operation by way of the constructor that simplifies it.
    pub fn build(&mut self, op: Op, width: u32) -> NodeId {
        match op {
            Op::Constant(_) | Op::Input(_) | Op::Register(_) | Op::Instance { .. } => {
                self.intern(Node { op, width })
            }
            Op::Unary(op, a) => self.unary(op, a),
            Op::Binary(BinaryOp::Mul, a, b) => self.multiply(a, b, width),
            Op::Binary(op, a, b) => self.binary(op, a, b),
            Op::Mux { select, when_true, when_false } => self.mux(select, when_true, when_false),
            Op::Slice { of, low } => self.slice(of, low, width),
            Op::Concat { high, low } => self.concat(high, low),
            Op::Extend { of, signed } => self.extend(of, width, signed),
        }
    }

    /// A unary operation.
    pub fn unary(&mut self, op: UnaryOp, a: NodeId) -> NodeId {
        let width = if matches!(op, UnaryOp::Not | UnaryOp::Negate) { self.width(a) } else { 1 };
        match (op, self.op(a)) {
            (UnaryOp::Not, Op::Unary(UnaryOp::Not, inner)) => inner,
            (UnaryOp::Not, Op::Binary(BinaryOp::Eq, x, y)) => self.binary(BinaryOp::Ne, x, y),
            (UnaryOp::Not, Op::Binary(BinaryOp::Ne, x, y)) => self.binary(BinaryOp::Eq, x, y),
            (UnaryOp::Not, Op::Binary(BinaryOp::Lt, x, y)) => self.binary(BinaryOp::Le, y, x),
            (UnaryOp::Not, Op::Binary(BinaryOp::Le, x, y)) => self.binary(BinaryOp::Lt, y, x),
            (UnaryOp::Not, Op::Binary(BinaryOp::SignedLt, x, y)) => self.binary(BinaryOp::SignedLe, y, x),
            (UnaryOp::Not, Op::Binary(BinaryOp::SignedLe, x, y)) => self.binary(BinaryOp::SignedLt, y, x),
            (UnaryOp::ReduceAnd | UnaryOp::ReduceOr | UnaryOp::ReduceXor, _) if self.width(a) == 1 => a,
            (UnaryOp::Negate, _) if width == 1 => a,
            (UnaryOp::ReduceOr | UnaryOp::ReduceXor, Op::Extend { of, signed: false }) => self.unary(op, of),
            (UnaryOp::ReduceAnd, Op::Extend { signed: false, .. }) => self.constant(0, 1),
            _ => self.fold(Op::Unary(op, a), width),
        }
    }

    /// A binary operation other than [`BinaryOp::Mul`], whose result may be wider than its operands.
    pub fn binary(&mut self, op: BinaryOp, a: NodeId, b: NodeId) -> NodeId {
        let (ca, cb) = (self.constant_value(a), self.constant_value(b));
        let width = self.width(a);
        let all = mask(width);
        let result_width = if op.is_comparison() { 1 } else { width };
        let node = Op::Binary(op, a, b);
        if ca.is_some() && cb.is_some() {
            return self.fold(node, result_width);
        }
        match op {
            BinaryOp::And => match (ca, cb) {
                (Some(0), _) | (_, Some(0)) => return self.constant(0, width),
                (Some(c), _) if c == all => return b,
                (_, Some(c)) if c == all => return a,
                _ if a == b => return a,
                _ if self.are_complements(a, b) => return self.constant(0, width),
                _ => {}
            },
            BinaryOp::Or => match (ca, cb) {
                (Some(c), _) | (_, Some(c)) if c == all => return self.constant(all, width),
                (Some(0), _) => return b,
                (_, Some(0)) => return a,
                _ if a == b => return a,
                _ if self.are_complements(a, b) => return self.constant(all, width),
                _ => {}
            },
            BinaryOp::Xor => match (ca, cb) {
                (Some(0), _) => return b,
                (_, Some(0)) => return a,
                (Some(c), _) if c == all => return self.unary(UnaryOp::Not, b),
                (_, Some(c)) if c == all => return self.unary(UnaryOp::Not, a),
                _ if a == b => return self.constant(0, width),
                _ if self.are_complements(a, b) => return self.constant(all, width),
                _ => {}
            },
            BinaryOp::Add => match (ca, cb) {
                (Some(0), _) => return b,
                (_, Some(0)) => return a,
                _ => {}
            },
            BinaryOp::Sub => match (ca, cb) {
                (_, Some(0)) => return a,
                (Some(0), _) => return self.unary(UnaryOp::Negate, b),
                _ if a == b => return self.constant(0, width),
                _ => {}
            },
            BinaryOp::Eq | BinaryOp::Ne => {
                if a == b {
                    return self.constant(u128::from(op == BinaryOp::Eq), 1);
                }
                if width == 1 {
                    match (op, ca.or(cb), if ca.is_some() { b } else { a }) {
                        (BinaryOp::Eq, Some(1), other) | (BinaryOp::Ne, Some(0), other) => return other,
                        (_, Some(_), other) => return self.unary(UnaryOp::Not, other),
                        _ => {}
                    }
                }
            }
            BinaryOp::Lt | BinaryOp::SignedLt if a == b => return self.constant(0, 1),
            BinaryOp::Le | BinaryOp::SignedLe if a == b => return self.constant(1, 1),
            BinaryOp::Lt if cb == Some(0) || ca == Some(all) => return self.constant(0, 1),
            BinaryOp::Le if ca == Some(0) || cb == Some(all) => return self.constant(1, 1),
            BinaryOp::Shl | BinaryOp::Shr => {
                if let Some(amount) = cb {
                    return self.shift_by_constant(op, a, amount);
                }
                if ca == Some(0) {
                    return a;
                }
            }
            BinaryOp::Mul => return self.multiply(a, b, width),
            _ => {}
        }
        if matches!(op, BinaryOp::Or | BinaryOp::Xor | BinaryOp::Add)
            && let Some(joined) = self.join(a, b).or_else(|| self.join(b, a))
        {
            return joined;
        }
        self.intern(Node { op: node, width: result_width })
    }

    /// The unsigned product of two operands of one width, modulo 2^width.
    pub fn multiply(&mut self, a: NodeId, b: NodeId, width: u32) -> NodeId {
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(0), _) | (_, Some(0)) => self.constant(0, width),
            (Some(1), _) => self.extend(b, width, false),
            (_, Some(1)) => self.extend(a, width, false),
            _ => self.fold(Op::Binary(BinaryOp::Mul, a, b), width),
        }
    }

    /// `select ? when_true : when_false`. One-bit choices against a constant become gates, so that what
    /// is left as a multiplexer chooses between two values.
    pub fn mux(&mut self, select: NodeId, when_true: NodeId, when_false: NodeId) -> NodeId {
        if let Some(value) = self.constant_value(select) {
            return if value == 1 { when_true } else { when_false };
        }
        if when_true == when_false {
            return when_true;
        }
        if let Op::Unary(UnaryOp::Not, inner) = self.op(select) {
            return self.mux(inner, when_false, when_true);
        }
        let width = self.width(when_true);
        if width == 1 {
            match (self.constant_value(when_true), self.constant_value(when_false)) {
                (Some(1), Some(0)) => return select,
                (Some(0), Some(1)) => return self.unary(UnaryOp::Not, select),
                (Some(1), _) => return self.binary(BinaryOp::Or, select, when_false),
                (_, Some(0)) => return self.binary(BinaryOp::And, select, when_true),
                (Some(0), _) => {
                    let inverted = self.unary(UnaryOp::Not, select);
                    return self.binary(BinaryOp::And, inverted, when_false);
                }
                (_, Some(1)) => {
                    let inverted = self.unary(UnaryOp::Not, select);
                    return self.binary(BinaryOp::Or, inverted, when_true);
                }
                _ => {}
            }
        }
        // The outer choice decides the inner one when both test the same bit.
        let when_true = match self.op(when_true) {
            Op::Mux { select: s, when_true: inner, .. } if s == select => inner,
            _ => when_true,
        };
        let when_false = match self.op(when_false) {
            Op::Mux { select: s, when_false: inner, .. } if s == select => inner,
            _ => when_false,
        };
        if when_true == when_false {
            return when_true;
        }
        self.fold(Op::Mux { select, when_true, when_false }, width)
    }

    /// Bits `low + width - 1 ..= low`.
    pub fn slice(&mut self, of: NodeId, low: u32, width: u32) -> NodeId {
        let of_width = self.width(of);
        if width == of_width {
            return of;
        }
        match self.op(of) {
            Op::Slice { of: inner, low: inner_low } => self.slice(inner, inner_low + low, width),
            Op::Concat { high, low: part } => {
                let split = self.width(part);
                if low + width <= split {
                    self.slice(part, low, width)
                } else if low >= split {
                    self.slice(high, low - split, width)
                } else {
                    let upper = self.slice(high, 0, low + width - split);
                    let lower = self.slice(part, low, split - low);
                    self.concat(upper, lower)
                }
            }
            Op::Extend { of: inner, signed } => {
                let inner_width = self.width(inner);
                if low + width <= inner_width {
                    self.slice(inner, low, width)
                } else if !signed && low >= inner_width {
                    self.constant(0, width)
                } else if low < inner_width {
                    let kept = self.slice(inner, low, inner_width - low);
                    self.extend(kept, width, signed)
                } else {
                    self.fold(Op::Slice { of, low }, width)
                }
            }
            _ => self.fold(Op::Slice { of, low }, width),
        }
    }

    /// `{high, low}`, nested to the right, neighbouring slices and constants merged.
    pub fn concat(&mut self, high: NodeId, low: NodeId) -> NodeId {
        let width = self.width(high) + self.width(low);
        if self.constant_value(high) == Some(0) {
            return self.extend(low, width, false);
        }
        match (self.op(high), self.op(low)) {
            (Op::Concat { high: first, low: second }, _) => {
                let rest = self.concat(second, low);
                return self.concat(first, rest);
            }
            (Op::Extend { of, signed: false }, _) => {
                let narrow = self.concat(of, low);
                return self.extend(narrow, width, false);
            }
            (Op::Slice { of: x, low: m }, Op::Slice { of: y, low: n })
                if x == y && m == n + self.width(low) =>
            {
                return self.slice(x, n, width);
            }
            (Op::Slice { of: x, low: m }, Op::Concat { high: next, low: rest }) => {
                if let Op::Slice { of: y, low: n } = self.op(next)
                    && x == y
                    && m == n + self.width(next)
                {
                    let merged = self.slice(x, n, self.width(high) + self.width(next));
                    return self.concat(merged, rest);
                }
            }
            (Op::Constant(c), Op::Concat { high: next, low: rest }) => {
                if let Some(d) = self.constant_value(next) {
                    let next_width = self.width(next);
                    let merged = self.constant((c << next_width) | d, self.width(high) + next_width);
                    return self.concat(merged, rest);
                }
            }
            _ => {}
        }
        self.fold(Op::Concat { high, low }, width)
    }

    /// Extension to `width`, which is at least the operand's.
    pub fn extend(&mut self, of: NodeId, width: u32, signed: bool) -> NodeId {
        if self.width(of) == width {
            return of;
        }
        match self.op(of) {
            Op::Extend { of: inner, signed: inner_signed } if inner_signed == signed || !inner_signed => {
                self.extend(inner, width, inner_signed)
            }
            _ => self.fold(Op::Extend { of, signed }, width),
        }
    }

    /// Extension or truncation to `width`.
    pub fn resize(&mut self, of: NodeId, width: u32, signed: bool) -> NodeId {
        if width < self.width(of) { self.slice(of, 0, width) } else { self.extend(of, width, signed) }
    }

    fn fold(&mut self, op: Op, width: u32) -> NodeId {
        let mut values = [0; 3];
        for (value, operand) in values.iter_mut().zip(op.operands()) {
            match self.constant_value(operand) {
                Some(constant) => *value = constant,
                None => return self.intern(Node { op, width }),
            }
        }
        let operand_width = operand_width(op, |id| self.width(id));
        self.constant(apply(op, width, operand_width, values), width)
    }

    fn shift_by_constant(&mut self, op: BinaryOp, a: NodeId, amount: u128) -> NodeId {
        let width = self.width(a);
        if amount >= u128::from(width) {
            return self.constant(0, width);
        }
        let amount = amount as u32;
        if amount == 0 {
            return a;
        }
        let kept = self.slice(a, if op == BinaryOp::Shr { amount } else { 0 }, width - amount);
        if op == BinaryOp::Shr {
            self.extend(kept, width, false)
        } else {
            let zeros = self.constant(0, amount);
            self.concat(kept, zeros)
        }
    }

    fn are_complements(&self, a: NodeId, b: NodeId) -> bool {
        self.op(a) == Op::Unary(UnaryOp::Not, b) || self.op(b) == Op::Unary(UnaryOp::Not, a)
    }

    /// The concatenation that `upper | lower` is when `lower` fits below the lowest possible bit of `upper`.
    fn join(&mut self, upper: NodeId, lower: NodeId) -> Option<NodeId> {
        let width = self.width(upper);
        let split = self.trailing_zeros(upper);
        if split == 0 || split >= width || width - self.leading_zeros(lower) > split {
            return None;
        }
        let high = self.slice(upper, split, width - split);
        let low = self.slice(lower, 0, split);
        Some(self.concat(high, low))
    }

    fn trailing_zeros(&self, id: NodeId) -> u32 {
        let width = self.width(id);
        match self.op(id) {
            Op::Constant(value) => value.trailing_zeros().min(width),
            Op::Concat { high, low } => {
                let zeros = self.trailing_zeros(low);
                if zeros == self.width(low) { zeros + self.trailing_zeros(high) } else { zeros }
            }
            Op::Extend { of, .. } => {
                let zeros = self.trailing_zeros(of);
                if zeros == self.width(of) { width } else { zeros }
            }
            _ => 0,
        }
    }

    fn leading_zeros(&self, id: NodeId) -> u32 {
        let width = self.width(id);
        match self.op(id) {
            Op::Constant(value) => value.leading_zeros() - (128 - width),
            Op::Concat { high, .. } => {
                let zeros = self.leading_zeros(high);
                if zeros == self.width(high) { zeros } else { zeros.min(width) }
            }
            Op::Extend { of, signed: false } => width - self.width(of) + self.leading_zeros(of),
            _ => 0,
        }
    }
}
