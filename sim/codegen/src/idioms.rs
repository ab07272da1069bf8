//! Shapes for which the processor has one instruction: shifts row by row, and the search for the leading one.
//!
//! The language has neither cheap shifts by signals nor a count of leading zeros, so the units are written as rows of
//! multiplexers. This module recognises rows of the following shapes in the word graph. The instruction that replaces
//! a row computes exactly the same for all values.
//!
//! * *Shift right*: `v[i+1] = a[i] ? v[i] >> 2^i : v[i]` from `i = 0` upwards gives `v[0] >> a`.
//! * *Lost bits*: `s[i+1] = a[i] ? s[i] | any(v[i] & (2^2^i - 1)) : s[i]` beside it gives `(v[0] >> a) << a != v[0]`.
//! * *Leading zeros*: `c = top bit of w[d]`, `v' = c ? v : v << d`, `n' = c ? n : n | d`, and `w[k]' = c ? w[k] : w[k] << d`
//!   for all narrower windows, for `d = 2^j` down to 1 from `n = 0`, gives `n = min(leading zeros of v, 2^(j+1) - 1)`. Bit `i`
//!   of the window `w[k]` is set if one of the `k` bits of `v` from bit `i` downwards is; a wider window is
//!   `w[2k] = w[k] | w[k] << k`.

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
    /// The number of leading zeros.
    LeadingZeros(Zeros),
}

/// A shift by the low bits of an amount.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shift {
    pub value: NodeId,
    pub amount: NodeId,
    pub bits: u32,
}

/// The leading zeros of a value, or `most` if it has more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Zeros {
    pub value: NodeId,
    pub most: u32,
}

/// The nodes of a module that end a recognised shape, with the shape.
pub fn find(graph: &Graph) -> BTreeMap<NodeId, Idiom> {
    let mut finder =
        Finder { graph, shifts: BTreeMap::new(), windows: BTreeMap::new(), counts: BTreeMap::new() };
    let mut found = BTreeMap::new();
    for (id, _) in graph.iter() {
        if let Some(idiom) = finder.idiom(id) {
            found.insert(id, idiom);
        }
    }
    found
}

/// The search for the leading one of a value, behind some rows.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Search {
    zeros: Zeros,
    /// The condition of the last row, and how far it shifts.
    last: Option<(NodeId, u32)>,
}

/// A value as a search has shifted it, seen through a window of so many bits.
#[derive(Clone, Copy)]
struct Window {
    search: Search,
    width: u32,
}

struct Finder<'g> {
    graph: &'g Graph,
    /// Rows of shifts, by their result.
    shifts: BTreeMap<NodeId, Idiom>,
    /// Windows wider than a bit or behind a row, by their result.
    windows: BTreeMap<NodeId, Window>,
    /// Counts, by their result.
    counts: BTreeMap<NodeId, Search>,
}

impl Search {
    /// Behind one more row.
    fn behind(self, condition: NodeId, distance: u32) -> Self {
        let zeros = Zeros { most: self.zeros.most + distance, ..self.zeros };
        Self { zeros, last: Some((condition, distance)) }
    }
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
        if let Some(window) = self.wider(id).or_else(|| self.shifted(id)) {
            self.windows.insert(id, window);
            return None;
        }
        let search = self.counted(id)?;
        self.counts.insert(id, search);
        // Only a search that goes down to single zeros, from more than one, is complete.
        let is_complete =
            matches!(search.last, Some((_, 1))) && search.zeros.most > 1 && search.zeros.most < 32;
        is_complete.then_some(Idiom::LeadingZeros(search.zeros))
    }

    /// Any node is the value of a search without rows.
    fn window(&self, id: NodeId) -> Window {
        let search = Search { zeros: Zeros { value: id, most: 0 }, last: None };
        self.windows.get(&id).copied().unwrap_or(Window { search, width: 1 })
    }

    /// `window | window << width`.
    fn wider(&self, id: NodeId) -> Option<Window> {
        let Op::Binary(BinaryOp::Or, a, b) = self.graph.op(id) else { return None };
        let with = |narrow: NodeId, other: NodeId| {
            let Window { search, width } = self.window(narrow);
            self.is_shifted_left(other, narrow, width).then_some(Window { search, width: 2 * width })
        };
        with(a, b).or_else(|| with(b, a))
    }

    /// `condition ? window : window << distance`.
    fn shifted(&self, id: NodeId) -> Option<Window> {
        let Op::Mux { select, when_true, when_false } = self.graph.op(id) else { return None };
        let (before, distance) = self.condition(select)?;
        let Window { search, width } = self.window(when_true);
        let is_row = search == before && self.is_shifted_left(when_false, when_true, distance);
        is_row.then(|| Window { search: before.behind(select, distance), width })
    }

    /// `condition ? count : count | distance`.
    fn counted(&self, id: NodeId) -> Option<Search> {
        let Op::Mux { select, when_true, when_false } = self.graph.op(id) else { return None };
        let (before, distance) = self.condition(select)?;
        let constant = |id| self.graph.constant_value(id);
        let is_row = match self.counts.get(&when_true) {
            Some(&counted) => {
                let Op::Binary(BinaryOp::Or, a, b) = self.graph.op(when_false) else { return None };
                let is_distance = |id| constant(id) == Some(distance.into());
                counted == before && (a == when_true && is_distance(b) || b == when_true && is_distance(a))
            }
            None => {
                let is_first = before.last.is_none() && constant(when_true) == Some(0);
                is_first && constant(when_false) == Some(distance.into())
            }
        };
        is_row.then(|| before.behind(select, distance))
    }

    /// The search before the row that a condition decides, the top bit of a window, and how far the row shifts.
    fn condition(&self, id: NodeId) -> Option<(Search, u32)> {
        let Op::Slice { of, low } = self.graph.op(id) else { return None };
        let Window { search, width: distance } = self.window(of);
        let width = self.graph.width(of);
        let is_top_bit = low + 1 == width && self.graph.width(id) == 1 && Kind::of(width) == Kind::Word;
        let follows = search.last.is_none_or(|(_, before)| before == 2 * distance);
        (is_top_bit && follows).then_some((search, distance))
    }

    /// `id = value << distance`.
    fn is_shifted_left(&self, id: NodeId, value: NodeId, distance: u32) -> bool {
        let Op::Concat { high, low } = self.graph.op(id) else { return false };
        self.graph.constant_value(low) == Some(0)
            && self.graph.width(low) == distance
            && self.graph.op(high) == (Op::Slice { of: value, low: 0 })
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
