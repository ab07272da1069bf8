//! Rust text of units, in terms of the operations on lanes of `lanes::sets`.
//!
//! Every value is a `Bit`, a `Word` or a `Double` of the lane set that the text is included for, and never exceeds
//! its width. The text masks the result of an operation that may exceed its width, unless the greatest value that the
//! result can take shows that it does not.

use super::schedule::operands;
use super::unit::{Kind, Place, Slot, Source};
use netlist::{BinaryOp, Graph, NodeId, Op, UnaryOp, mask};
use std::collections::BTreeSet;
use std::fmt::Write;

/// The text of some values of a graph, in the order in which they are asked for.
pub struct Emitter<'u> {
    graph: &'u Graph,
    sources: &'u [Source],
    /// Greatest value of each node.
    greatest: Vec<u128>,
    done: BTreeSet<NodeId>,
    pub text: String,
}

impl<'u> Emitter<'u> {
    /// For a graph whose inputs are these.
    pub fn new(graph: &'u Graph, sources: &'u [Source]) -> Self {
        Self { graph, sources, greatest: greatest(graph), done: BTreeSet::new(), text: String::new() }
    }

    /// Writes text after which the value of `id` is available under its [`name`](Self::name).
    pub fn value(&mut self, id: NodeId) {
        // The walk is depth first with a stack of its own: operands before users, each once.
        let mut stack = vec![(id, false)];
        while let Some((id, ready)) = stack.pop() {
            if self.done.contains(&id) || self.graph.constant_value(id).is_some() {
                continue;
            }
            if ready {
                let expression = self.expression(id);
                let _ = writeln!(self.text, "    let n{} = {expression};", id.0);
                self.done.insert(id);
            } else {
                stack.push((id, true));
                let operands = operands(self.graph, self.sources, id);
                stack.extend(operands.into_iter().rev().map(|operand| (operand, false)));
            }
        }
    }

    /// Writes a value that is available to a slot.
    pub fn store(&mut self, slot: Slot, value: NodeId) {
        let Place { row, bit } = slot.place;
        let value = self.name(value);
        let _ = match Kind::of(slot.width) {
            Kind::Bit => writeln!(self.text, "    store_b(bits, {bit}, chunk, {value});"),
            Kind::Word => writeln!(self.text, "    store_w(rows, {row}, chunk, {value});"),
            Kind::Double => writeln!(self.text, "    store_d(rows, {row}, chunk, {value});"),
        };
    }

    /// The variable of a node, or a constant itself.
    pub fn name(&self, id: NodeId) -> String {
        match self.graph.constant_value(id) {
            Some(value) => constant(self.kind(id), value),
            None => format!("n{}", id.0),
        }
    }

    fn kind(&self, id: NodeId) -> Kind {
        Kind::of(self.graph.width(id))
    }

    fn expression(&self, id: NodeId) -> String {
        let node = self.graph.node(id);
        let kind = Kind::of(node.width);
        match node.op {
            Op::Constant(_) => unreachable!("constants are written where they are used"),
            Op::Input(source) => self.source(self.sources[source as usize]),
            Op::Register(_) | Op::Instance { .. } => unreachable!("units read memory only"),
            Op::Unary(op, a) => self.unary(op, a, node.width),
            Op::Binary(op, a, b) => self.binary(op, a, b, node.width),
            Op::Mux { select, when_true, when_false } => self.mux(kind, select, when_true, when_false),
            Op::Slice { of, low } => self.slice(of, low, node.width),
            Op::Concat { high, low } => self.concat(high, low, kind),
            Op::Extend { of, signed: false } => self.converted(of, kind, 0),
            Op::Extend { of, signed: true } => self.sign_extended(of, node.width),
        }
    }

    fn source(&self, source: Source) -> String {
        match source {
            Source::Memory(slot) => load(slot),
            Source::LeadingZeros { of, most } => {
                // A bit that is set below the value ends the search, also in a value of zero.
                let (up, end) = (32 - self.graph.width(of), 1u128 << (31 - most));
                let value =
                    if up == 0 { self.name(of) } else { format!("shl_const_w::<{up}>({})", self.name(of)) };
                format!("leading_zeros_w(or_w({value}, {}))", constant(Kind::Word, end))
            }
        }
    }

    fn unary(&self, op: UnaryOp, a: NodeId, width: u32) -> String {
        let (kind, of_width) = (self.kind(a), self.graph.width(a));
        let (k, x, all) = (suffix(kind), self.name(a), constant(kind, mask(of_width)));
        match (op, kind) {
            (UnaryOp::Not, Kind::Bit) => format!("not_b({x})"),
            (UnaryOp::Not, _) => format!("xor_{k}({x}, {all})"),
            (UnaryOp::Negate, Kind::Bit) => x,
            (UnaryOp::Negate, _) => masked(kind, width, format!("sub_{k}({}, {x})", constant(kind, 0))),
            (UnaryOp::ReduceOr, _) => format!("ne_{k}({x}, {})", constant(kind, 0)),
            (UnaryOp::ReduceAnd, _) => format!("eq_{k}({x}, {all})"),
            (UnaryOp::ReduceXor, Kind::Bit) => x,
            (UnaryOp::ReduceXor, _) => format!("parity_{k}({x})"),
        }
    }

    fn binary(&self, op: BinaryOp, a: NodeId, b: NodeId, width: u32) -> String {
        use BinaryOp::*;
        let (x, y) = (self.name(a), self.name(b));
        let kind = Kind::of(width);
        let of = self.kind(a);
        let (k, o) = (suffix(kind), suffix(of));
        let fits = |greatest: Option<u128>| greatest.is_some_and(|greatest| greatest <= mask(width));
        let unless = |fits: bool, text: String| if fits { text } else { masked(kind, width, text) };
        let (most_a, most_b) = (self.greatest[a.index()], self.greatest[b.index()]);
        match op {
            And => format!("and_{k}({x}, {y})"),
            Or => format!("or_{k}({x}, {y})"),
            Xor => format!("xor_{k}({x}, {y})"),
            Add | Sub if kind == Kind::Bit => format!("xor_b({x}, {y})"),
            Add => unless(fits(most_a.checked_add(most_b)), format!("add_{k}({x}, {y})")),
            Sub => masked(kind, width, format!("sub_{k}({x}, {y})")),
            Mul if of == Kind::Bit => {
                let product = format!("and_b({x}, {y})");
                if kind == Kind::Bit { product } else { bit_to(kind, &product, 1) }
            }
            Mul => {
                let product = match (of, kind) {
                    (Kind::Word, Kind::Double) => format!("mul_wide({x}, {y})"),
                    _ => format!("mul_{k}({x}, {y})"),
                };
                unless(fits(most_a.checked_mul(most_b)), product)
            }
            Eq if of == Kind::Bit => format!("not_b(xor_b({x}, {y}))"),
            Ne if of == Kind::Bit => format!("xor_b({x}, {y})"),
            Lt | SignedLt | Le | SignedLe if of == Kind::Bit => {
                let (low, high) = if matches!(op, Lt | Le) { (x, y) } else { (y, x) };
                match op {
                    Lt | SignedLt => format!("and_b(not_b({low}), {high})"),
                    _ => format!("or_b(not_b({low}), {high})"),
                }
            }
            Eq => format!("eq_{o}({x}, {y})"),
            Ne => format!("ne_{o}({x}, {y})"),
            Lt => format!("lt_{o}({x}, {y})"),
            Le => format!("le_{o}({x}, {y})"),
            SignedLt | SignedLe => {
                let comparison = if op == SignedLt { "signed_lt" } else { "signed_le" };
                let [x, y] = [x, y].map(|operand| self.at_top(operand, a));
                format!("{comparison}_{o}({x}, {y})")
            }
            Shl | Shr if kind == Kind::Bit => {
                let amount = self.kind(b);
                let none = match amount {
                    Kind::Bit => format!("not_b({y})"),
                    _ => format!("eq_{}({y}, {})", suffix(amount), constant(amount, 0)),
                };
                format!("and_b({x}, {none})")
            }
            Shl => {
                let most = if most_b < 128 { most_a.checked_shl(most_b as u32) } else { None };
                let most = most.filter(|shifted| shifted >> most_b == most_a);
                unless(fits(most), format!("shl_{k}({x}, {})", self.amount(b)))
            }
            Shr => format!("shr_{k}({x}, {})", self.amount(b)),
        }
    }

    /// A choice. If the condition implies that the first value needs no mask, the text leaves the mask out. If one
    /// bit is the other bit with something added to it, the text adds that only if it is chosen.
    fn mux(&self, kind: Kind, select: NodeId, when_true: NodeId, when_false: NodeId) -> String {
        let (s, f) = (self.name(select), self.name(when_false));
        if kind == Kind::Bit {
            return match self.graph.op(when_true) {
                Op::Binary(BinaryOp::Or, a, b) if a == when_false => {
                    format!("or_b({f}, and_b({s}, {}))", self.name(b))
                }
                Op::Binary(BinaryOp::Or, a, b) if b == when_false => {
                    format!("or_b({f}, and_b({s}, {}))", self.name(a))
                }
                _ => format!("select_b({s}, {}, {f})", self.name(when_true)),
            };
        }
        let t = self.unmasked_if(select, when_true).unwrap_or_else(|| self.name(when_true));
        format!("select_{}({s}, {t}, {f})", suffix(kind))
    }

    /// The text of a difference that does not wrap around, or of a left shift that loses nothing, if `condition` holds.
    fn unmasked_if(&self, condition: NodeId, id: NodeId) -> Option<String> {
        let k = suffix(self.kind(id));
        match self.graph.op(id) {
            Op::Binary(BinaryOp::Sub, a, b) => {
                let (least, _) = self.bounds_if(condition, a);
                (least >= self.graph.constant_value(b)?)
                    .then(|| format!("sub_{k}({}, {})", self.name(a), self.name(b)))
            }
            Op::Concat { high, low } if self.graph.constant_value(low) == Some(0) => {
                let Op::Slice { of, low: 0 } = self.graph.op(high) else { return None };
                let (_, most) = self.bounds_if(condition, of);
                let fits = most <= mask(self.graph.width(high)) && self.kind(of) == self.kind(id);
                fits.then(|| format!("shl_const_{k}::<{}>({})", self.graph.width(low), self.name(of)))
            }
            _ => None,
        }
    }

    /// The least and the greatest value of `id` where `condition` holds.
    fn bounds_if(&self, condition: NodeId, id: NodeId) -> (u128, u128) {
        let constant = |id| self.graph.constant_value(id);
        let most = self.greatest[id.index()];
        match self.graph.op(condition) {
            Op::Binary(BinaryOp::And, a, b) => {
                let ((least_a, most_a), (least_b, most_b)) = (self.bounds_if(a, id), self.bounds_if(b, id));
                (least_a.max(least_b), most_a.min(most_b))
            }
            Op::Binary(BinaryOp::Le, a, b) if b == id => (constant(a).unwrap_or(0), most),
            Op::Binary(BinaryOp::Lt, a, b) if b == id => (constant(a).map_or(0, |a| a + 1), most),
            Op::Binary(BinaryOp::Le, a, b) if a == id => (0, constant(b).map_or(most, |b| b.min(most))),
            Op::Binary(BinaryOp::Lt, a, b) if a == id => {
                (0, constant(b).map_or(most, |b| b.saturating_sub(1).min(most)))
            }
            _ => (0, most),
        }
    }

    /// A shift's amount as a word, in which an amount beyond the width stays beyond it.
    fn amount(&self, b: NodeId) -> String {
        match self.kind(b) {
            Kind::Double => format!("saturate({})", self.name(b)),
            _ => self.converted(b, Kind::Word, 0),
        }
    }

    /// A value of the operand's width moved to the top of its lane, where its sign is the lane's.
    fn at_top(&self, text: String, like: NodeId) -> String {
        let (width, kind) = (self.graph.width(like), self.kind(like));
        let lane = if kind == Kind::Word { 32 } else { 64 };
        if width == lane { text } else { format!("shl_const_{}::<{}>({text})", suffix(kind), lane - width) }
    }

    fn slice(&self, of: NodeId, low: u32, width: u32) -> String {
        let (from, to, x) = (self.kind(of), Kind::of(width), self.name(of));
        let f = suffix(from);
        if to == Kind::Bit {
            return format!("test_{f}({x}, {})", constant(from, 1 << low));
        }
        let shifted = if low == 0 { x } else { format!("shr_const_{f}::<{low}>({x})") };
        let narrowed = if from == to { shifted } else { format!("narrow({shifted})") };
        if self.greatest[of.index()] >> low <= mask(width) { narrowed } else { masked(to, width, narrowed) }
    }

    fn concat(&self, high: NodeId, low: NodeId, kind: Kind) -> String {
        let k = suffix(kind);
        let upper = self.converted(high, kind, self.graph.width(low));
        match (self.graph.constant_value(low), self.kind(low)) {
            (Some(0), _) => upper,
            (_, Kind::Bit) => format!("or_bit_{k}({upper}, {})", self.name(low)),
            _ => format!("or_{k}({upper}, {})", self.converted(low, kind, 0)),
        }
    }

    /// The value as one of `kind`, which is not narrower, shifted left.
    fn converted(&self, id: NodeId, kind: Kind, shift: u32) -> String {
        let widened = match (self.kind(id), kind) {
            (Kind::Bit, Kind::Word | Kind::Double) => return bit_to(kind, &self.name(id), 1 << shift),
            (Kind::Word, Kind::Double) => format!("widen({})", self.name(id)),
            _ => self.name(id),
        };
        if shift == 0 { widened } else { format!("shl_const_{}::<{shift}>({widened})", suffix(kind)) }
    }

    fn sign_extended(&self, of: NodeId, width: u32) -> String {
        let (from, kind) = (self.graph.width(of), Kind::of(width));
        if from == 1 {
            return bit_to(kind, &self.name(of), mask(width));
        }
        let lane = if kind == Kind::Word { 32 } else { 64 };
        let (k, x) = (suffix(kind), self.converted(of, kind, 0));
        masked(kind, width, format!("sar_const_{k}::<{0}>(shl_const_{k}::<{0}>({x}))", lane - from))
    }
}

fn suffix(kind: Kind) -> &'static str {
    match kind {
        Kind::Bit => "b",
        Kind::Word => "w",
        Kind::Double => "d",
    }
}

fn constant(kind: Kind, value: u128) -> String {
    match kind {
        Kind::Bit => format!("bit({})", value == 1),
        Kind::Word => format!("word({value:#x})"),
        Kind::Double => format!("double({value:#x})"),
    }
}

/// A bit as the value that it stands for when set.
fn bit_to(kind: Kind, bit: &str, value: u128) -> String {
    format!("select_{}({bit}, {}, {})", suffix(kind), constant(kind, value), constant(kind, 0))
}

fn masked(kind: Kind, width: u32, text: String) -> String {
    match kind {
        Kind::Word if width < 32 => format!("and_w({text}, {})", constant(kind, mask(width))),
        Kind::Double if width < 64 => format!("and_d({text}, {})", constant(kind, mask(width))),
        _ => text,
    }
}

/// An upper bound of each node's value.
fn greatest(graph: &Graph) -> Vec<u128> {
    let mut most: Vec<u128> = Vec::with_capacity(graph.nodes().len());
    for node in graph.nodes() {
        let of = |id: NodeId| most[id.index()];
        // All ones up to the leading one.
        let ones = |value: u128| if value == 0 { 0 } else { u128::MAX >> value.leading_zeros() };
        let bound = match node.op {
            Op::Constant(value) => Some(value),
            Op::Binary(BinaryOp::And, a, b) => Some(of(a).min(of(b))),
            Op::Binary(BinaryOp::Or | BinaryOp::Xor, a, b) => Some(ones(of(a) | of(b))),
            Op::Binary(BinaryOp::Add, a, b) => of(a).checked_add(of(b)),
            Op::Binary(BinaryOp::Mul, a, b) => of(a).checked_mul(of(b)),
            Op::Binary(BinaryOp::Shr, a, _) => Some(of(a)),
            Op::Mux { when_true, when_false, .. } => Some(of(when_true).max(of(when_false))),
            Op::Slice { of: a, low } => Some(of(a) >> low),
            Op::Concat { high, low } => Some((of(high) << graph.width(low)).saturating_add(of(low))),
            Op::Extend { of: a, signed: false } => Some(of(a)),
            _ => None,
        };
        let all = mask(node.width);
        // A sum or product beyond the width wraps around; the result may then be any value.
        most.push(
            bound
                .filter(|bound| *bound <= all || matches!(node.op, Op::Slice { .. }))
                .unwrap_or(all)
                .min(all),
        );
    }
    most
}

/// Reads a slot of the memory that a function has.
fn load(slot: Slot) -> String {
    match Kind::of(slot.width) {
        Kind::Bit => format!("load_b(bits, {}, chunk)", slot.place.bit),
        Kind::Word => format!("load_w(rows, {}, chunk)", slot.place.row),
        Kind::Double => format!("load_d(rows, {}, chunk)", slot.place.row),
    }
}
