//! Shapes for which the processor has one instruction: shifts row by row, and the search for the leading one.
//!
//! The language has neither cheap shifts by signals nor a count of leading zeros, so the units are written as rows of
//! multiplexers. This module recognises rows of the following shapes in the word graph. The instruction that replaces
//! a row computes exactly the same for all values.
//!
//! * *Shift right*: `v[i+1] = a[i] ? v[i] >> 2^i : v[i]` from `i = 0` upwards gives `v[0] >> a`.
//! * *Lost bits*: `s[i+1] = a[i] ? s[i] | any(v[i] & (2^2^i - 1)) : s[i]` beside it gives `(v[0] >> a) << a != v[0]`.
//! * *Normalise*: `c = v < 2^(w-d)`, `v' = c ? v << d : v`, `n' = c ? n + d : n` for `d = 2^j` down to 1 gives
//!   `z = min(leading zeros of v, 2^(j+1) - 1)`, `v << z` and `n + z`. With a budget, `c = v < 2^(w-d) & d <= b` and
//!   `b' = c ? b - d : b`, it gives the same with `z = min(that, b)`, and `b - z`: each row takes off a power of two
//!   while both are at least as large, so the rows take off the binary digits of the lesser.

use super::unit::Kind;
use netlist::{BinaryOp, Graph, NodeId, Op, UnaryOp, mask};
use std::collections::BTreeMap;

/// What a node computes, in terms of nodes before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Idiom {
    /// `value >> amount[bits-1:0]`.
    ShiftRight(Shift),
    /// Whether that shift loses any bit that is set.
    Lost(Shift),
    /// `value << zeros`.
    Normalised(Zeros),
    /// `base + zeros`.
    Counted(Zeros, NodeId),
    /// `base - zeros`, where `base` is the budget.
    Spent(Zeros, NodeId),
}

/// A shift by the low bits of an amount.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shift {
    pub value: NodeId,
    pub amount: NodeId,
    pub bits: u32,
}

/// The least of the leading zeros of a value, of `most`, and of a budget if there is one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Zeros {
    pub value: NodeId,
    pub most: u32,
    pub budget: Option<NodeId>,
}

/// The nodes of a module that end a recognised shape, with the shape.
pub fn find(graph: &Graph) -> BTreeMap<NodeId, Idiom> {
    let mut finder =
        Finder { graph, shifts: BTreeMap::new(), rows: BTreeMap::new(), counts: BTreeMap::new() };
    let mut found = BTreeMap::new();
    for (id, _) in graph.iter() {
        if let Some(idiom) = finder.idiom(id) {
            found.insert(id, idiom);
        }
    }
    found
}

/// A row of the search for the leading one, which shifts the value or counts beside it.
#[derive(Clone, Copy)]
struct Row {
    zeros: Zeros,
    distance: u32,
    condition: NodeId,
    /// The budget before this row.
    budget: Option<NodeId>,
}

struct Finder<'g> {
    graph: &'g Graph,
    /// Rows of shifts, by their result.
    shifts: BTreeMap<NodeId, Idiom>,
    /// Rows that shift a value, by their result.
    rows: BTreeMap<NodeId, Row>,
    /// Rows that count, by their result, with the number before the first.
    counts: BTreeMap<NodeId, (Row, NodeId)>,
}

impl Finder<'_> {
    fn idiom(&mut self, id: NodeId) -> Option<Idiom> {
        let shift = self.shift_right(id).map(Idiom::ShiftRight).or_else(|| self.lost(id).map(Idiom::Lost));
        if let Some(idiom) = shift {
            self.shifts.insert(id, idiom);
            // A single row stays a multiplexer, which costs no more.
            let (Idiom::ShiftRight(shift) | Idiom::Lost(shift)) = idiom else { return None };
            return (shift.bits > 1).then_some(idiom);
        }
        let Op::Mux { select, when_true, when_false } = self.graph.op(id) else { return None };
        let row = self.row(select)?;
        // Only a search that goes down to single zeros, from more than one, is complete.
        let is_complete = row.distance == 1 && row.zeros.most > 1 && row.zeros.most < 32;
        if self.is_shifted_left(when_true, when_false, row.distance)
            && self.searched(select) == Some(when_false)
        {
            self.rows.insert(id, row);
            return is_complete.then_some(Idiom::Normalised(row.zeros));
        }
        if let Some(base) = self.counted_from(when_true, when_false, &row) {
            self.counts.insert(id, (row, base));
            return is_complete.then_some(Idiom::Counted(row.zeros, base));
        }
        let first = row.zeros.budget?;
        let takes = self.is_binary_with_constant(BinaryOp::Sub, when_true, when_false, row.distance);
        (is_complete && takes && row.budget == Some(when_false)).then_some(Idiom::Spent(row.zeros, first))
    }

    /// The row that a condition decides.
    fn row(&self, condition: NodeId) -> Option<Row> {
        let (value, distance, budget) = self.condition(condition)?;
        let row = |zeros| Some(Row { zeros, distance, condition, budget });
        let Some(before) = self.rows.get(&value) else {
            return row(Zeros { value, most: distance, budget });
        };
        let follows = before.distance == 2 * distance
            && match (before.budget, budget) {
                (None, None) => true,
                (Some(whole), Some(rest)) => self.is_spent(rest, whole, before),
                _ => false,
            };
        if follows {
            row(Zeros { most: before.zeros.most + distance, ..before.zeros })
        } else {
            row(Zeros { value, most: distance, budget })
        }
    }

    /// `rest = condition ? whole - distance : whole`.
    fn is_spent(&self, rest: NodeId, whole: NodeId, row: &Row) -> bool {
        let Op::Mux { select, when_true, when_false } = self.graph.op(rest) else { return false };
        select == row.condition
            && when_false == whole
            && self.is_binary_with_constant(BinaryOp::Sub, when_true, whole, row.distance)
    }

    /// The number that a count starts from.
    fn counted_from(&self, when_true: NodeId, when_false: NodeId, row: &Row) -> Option<NodeId> {
        let constant = |id| self.graph.constant_value(id);
        let adds = self.is_binary_with_constant(BinaryOp::Add, when_true, when_false, row.distance)
            || constant(when_false)
                .is_some_and(|n| constant(when_true) == Some(n + u128::from(row.distance)));
        if !adds {
            return None;
        }
        // The first row starts from any number, a later one from the count of the row before it.
        match self.counts.get(&when_false) {
            Some((before, base)) => {
                let value = self.searched(row.condition)?;
                let follows =
                    self.rows.get(&value).is_some_and(|shifted| shifted.condition == before.condition);
                follows.then_some(*base)
            }
            None => (row.zeros.most == row.distance).then_some(when_false),
        }
    }

    /// The value that a condition looks at.
    fn searched(&self, condition: NodeId) -> Option<NodeId> {
        self.condition(condition).map(|(value, ..)| value)
    }

    /// `value < 2^(width - distance)`, and `distance <= budget` if there is one.
    fn condition(&self, id: NodeId) -> Option<(NodeId, u32, Option<NodeId>)> {
        match self.graph.op(id) {
            Op::Binary(BinaryOp::Lt, value, limit) => {
                let (limit, width) = (self.graph.constant_value(limit)?, self.graph.width(value));
                let distance = width.checked_sub(limit.ilog2())?;
                let fits = limit.is_power_of_two() && distance.is_power_of_two();
                (fits && Kind::of(width) == Kind::Word).then_some((value, distance, None))
            }
            Op::Binary(BinaryOp::And, a, b) => {
                let with = |below: NodeId, within: NodeId| {
                    let (value, distance, None) = self.condition(below)? else { return None };
                    let Op::Binary(BinaryOp::Le, least, budget) = self.graph.op(within) else { return None };
                    let is_distance = self.graph.constant_value(least) == Some(distance.into());
                    let fits = is_distance && Kind::of(self.graph.width(budget)) == Kind::Word;
                    fits.then_some((value, distance, Some(budget)))
                };
                with(a, b).or_else(|| with(b, a))
            }
            _ => None,
        }
    }

    /// `id = value << distance`.
    fn is_shifted_left(&self, id: NodeId, value: NodeId, distance: u32) -> bool {
        let Op::Concat { high, low } = self.graph.op(id) else { return false };
        self.graph.constant_value(low) == Some(0)
            && self.graph.width(low) == distance
            && self.graph.op(high) == (Op::Slice { of: value, low: 0 })
    }

    fn is_binary_with_constant(&self, op: BinaryOp, id: NodeId, value: NodeId, number: u32) -> bool {
        let Op::Binary(found, a, b) = self.graph.op(id) else { return false };
        let is_number = |id| self.graph.constant_value(id) == Some(number.into());
        found == op && (a == value && is_number(b) || op.is_commutative() && b == value && is_number(a))
    }

    /// A row of a shifter: `bit ? value >> 2^i : value`.
    fn shift_right(&self, id: NodeId) -> Option<Shift> {
        let Op::Mux { select, when_true, when_false } = self.graph.op(id) else { return None };
        let Op::Slice { of: amount, low: row } = self.graph.op(select) else { return None };
        let width = self.graph.width(when_false);
        let is_shifted = match self.graph.op(when_true) {
            Op::Constant(0) => self.distance(row) >= width,
            Op::Extend { of, signed: false } => {
                self.graph.op(of) == Op::Slice { of: when_false, low: self.distance(row) }
                    && self.graph.width(of) + self.distance(row) == width
            }
            _ => false,
        };
        if !is_shifted || Kind::of(width) != Kind::Word {
            return None;
        }
        if row == 0 {
            return Some(Shift { value: when_false, amount, bits: 1 });
        }
        self.shift_before(when_false, amount, row)
    }

    /// The shift by the bits of `amount` below `row` that has the result `id`.
    fn shift_before(&self, id: NodeId, amount: NodeId, row: u32) -> Option<Shift> {
        match self.shifts.get(&id) {
            Some(Idiom::ShiftRight(shift)) if shift.amount == amount && shift.bits == row => {
                Some(Shift { bits: row + 1, ..*shift })
            }
            _ => None,
        }
    }

    /// A row of a sticky bit beside a shifter: `bit ? before | any(low bits of value) : before`.
    fn lost(&self, id: NodeId) -> Option<Shift> {
        match self.graph.op(id) {
            Op::Binary(BinaryOp::And, a, b) => {
                let first = |bit: NodeId, lost: NodeId| {
                    let Op::Slice { of: amount, low: 0 } = self.graph.op(bit) else { return None };
                    let value = self.low_bits_of(lost, 0)?;
                    Some(Shift { value, amount, bits: 1 })
                };
                first(a, b).or_else(|| first(b, a))
            }
            Op::Mux { select, when_true, when_false } => {
                let Op::Slice { of: amount, low: row } = self.graph.op(select) else { return None };
                let Op::Binary(BinaryOp::Or, a, b) = self.graph.op(when_true) else { return None };
                let lost = if a == when_false { b } else { a };
                let Some(Idiom::Lost(before)) = self.shifts.get(&when_false) else { return None };
                let shifted = self.shift_before(self.low_bits_of(lost, row)?, amount, row)?;
                let beside = before.value == shifted.value && before.amount == amount && before.bits == row;
                (beside && (a == when_false || b == when_false)).then_some(shifted)
            }
            _ => None,
        }
    }

    /// The value for which a bit says whether a row loses anything of it.
    fn low_bits_of(&self, bit: NodeId, row: u32) -> Option<NodeId> {
        let Op::Unary(UnaryOp::ReduceOr, bits) = self.graph.op(bit) else { return None };
        let (width, distance) = (self.graph.width(bits), self.distance(row));
        if Kind::of(width) != Kind::Word {
            return None;
        }
        if distance >= width {
            return Some(bits);
        }
        let Op::Binary(BinaryOp::And, a, b) = self.graph.op(bits) else { return None };
        let low = Some(mask(distance));
        match (self.graph.constant_value(a), self.graph.constant_value(b)) {
            (_, found) if found == low => Some(a),
            (found, _) if found == low => Some(b),
            _ => None,
        }
    }

    /// How far a row shifts; a distance beyond the width is cut off, as it gives the same.
    fn distance(&self, row: u32) -> u32 {
        1 << row.min(16)
    }
}
