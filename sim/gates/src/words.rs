//! Word operators as gates. Words are least significant bit first.

use super::aig::{Aig, Lit};
use super::liberty::Library;
use super::liberty::function::variable;

/// How sums are carried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Adder {
    /// Bit by bit: fewest gates, depth linear in the width.
    Ripple,
    /// Brent and Kung, "A Regular Layout for Parallel Adders", 1982: twice the logarithm deep, few gates more than ripple.
    #[default]
    BrentKung,
    /// Sklansky, "Conditional-Sum Addition Logic", 1960: as deep as the logarithm, with wide fan-out.
    Sklansky,
}

/// How products are formed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Multiplier {
    /// All partial products, reduced by a tree of full adders.
    #[default]
    Tree,
    /// Radix-4 Booth digits of the second factor, reduced by the same tree.
    Booth,
}

/// How one of several words is chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Selection {
    /// One multiplexer of two words behind the other, as written.
    Chain,
    /// Conditions that exclude each other, each with a gate for every bit of its word, and an OR of those, which are joined
    /// two at a time.
    #[default]
    AndOr,
    /// The same, joined three at a time.
    AndOrThrees,
}

/// The structures chosen for arithmetic and selection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Structures {
    /// For sums, differences and the last addition of products.
    pub adder: Adder,
    /// For products.
    pub multiplier: Multiplier,
    /// For choices among three words or more.
    pub selection: Selection,
}

impl Structures {
    /// The structures that suit a library: words are joined in threes where a cell takes three pairs.
    #[must_use]
    pub fn fitted(self, library: &Library) -> Self {
        let pairs = [0, 2, 4].map(|i| variable(i) & variable(i + 1));
        let three = pairs[0] | pairs[1] | pairs[2];
        let has_three = [three, !three].iter().any(|&function| library.smallest(6, function).is_some());
        let selection = match self.selection {
            Selection::AndOr if has_three => Selection::AndOrThrees,
            other => other,
        };
        Self { selection, ..self }
    }
}

/// The word of a constant.
#[must_use]
pub fn constant(value: u128, width: u32) -> Vec<Lit> {
    (0..width).map(|bit| Lit::constant(value >> bit & 1 == 1)).collect()
}

/// Every bit inverted.
#[must_use]
pub fn not(a: &[Lit]) -> Vec<Lit> {
    a.iter().map(|&bit| !bit).collect()
}

/// `select ? when_true : when_false`, bit by bit.
pub fn mux(aig: &mut Aig, select: Lit, when_true: &[Lit], when_false: &[Lit]) -> Vec<Lit> {
    when_true.iter().zip(when_false).map(|(&t, &f)| aig.mux(select, t, f)).collect()
}

/// The word whose condition holds. Exactly one condition must hold. The words are joined `group` at a time.
pub fn select_one(aig: &mut Aig, choices: &[(Lit, &[Lit])], group: usize) -> Vec<Lit> {
    let width = choices.first().map_or(0, |(_, word)| word.len());
    (0..width)
        .map(|bit| {
            let terms: Vec<Lit> =
                choices.iter().map(|&(condition, word)| aig.and(condition, word[bit])).collect();
            let joined: Vec<Lit> = terms.chunks(group).map(|terms| any(aig, terms)).collect();
            any(aig, &joined)
        })
        .collect()
}

/// A gate for each pair of bits.
pub fn zip(aig: &mut Aig, a: &[Lit], b: &[Lit], gate: fn(&mut Aig, Lit, Lit) -> Lit) -> Vec<Lit> {
    a.iter().zip(b).map(|(&a, &b)| gate(aig, a, b)).collect()
}

/// A balanced tree of one gate over all bits; `empty` for no bits.
pub fn reduce(aig: &mut Aig, bits: &[Lit], empty: Lit, gate: fn(&mut Aig, Lit, Lit) -> Lit) -> Lit {
    match bits {
        [] => empty,
        [bit] => *bit,
        _ => {
            let (low, high) = bits.split_at(bits.len() / 2);
            let low = reduce(aig, low, empty, gate);
            let high = reduce(aig, high, empty, gate);
            gate(aig, low, high)
        }
    }
}

/// Whether any bit is set.
pub fn any(aig: &mut Aig, bits: &[Lit]) -> Lit {
    reduce(aig, bits, Lit::FALSE, Aig::or)
}

/// Whether all bits are set.
pub fn all(aig: &mut Aig, bits: &[Lit]) -> Lit {
    reduce(aig, bits, Lit::TRUE, Aig::and)
}

/// `a == b`.
pub fn equal(aig: &mut Aig, a: &[Lit], b: &[Lit]) -> Lit {
    let differ = zip(aig, a, b, Aig::xor);
    !any(aig, &differ)
}

/// `a < b`, unsigned: by halves, as deep as the logarithm.
pub fn less(aig: &mut Aig, a: &[Lit], b: &[Lit]) -> Lit {
    let pairs: Vec<(Lit, Lit)> = a.iter().copied().zip(b.iter().copied()).collect();
    compare(aig, &pairs).0
}

/// `a < b` and `a == b`.
fn compare(aig: &mut Aig, pairs: &[(Lit, Lit)]) -> (Lit, Lit) {
    match pairs {
        [] => (Lit::FALSE, Lit::TRUE),
        [(a, b)] => {
            let less = aig.and(!*a, *b);
            (less, !aig.xor(*a, *b))
        }
        _ => {
            let (low, high) = pairs.split_at(pairs.len() / 2);
            let (low_less, low_equal) = compare(aig, low);
            let (high_less, high_equal) = compare(aig, high);
            let below = aig.and(high_equal, low_less);
            (aig.or(high_less, below), aig.and(high_equal, low_equal))
        }
    }
}

/// The word with its sign bit inverted: two's complement order becomes unsigned order.
#[must_use]
pub fn bias(word: &[Lit]) -> Vec<Lit> {
    let mut word = word.to_vec();
    if let Some(sign) = word.last_mut() {
        *sign = !*sign;
    }
    word
}

/// `a + b + carry`, modulo 2^width, and the carry out.
pub fn add(aig: &mut Aig, kind: Adder, a: &[Lit], b: &[Lit], carry: Lit) -> (Vec<Lit>, Lit) {
    let propagate = zip(aig, a, b, Aig::xor);
    let carries = match kind {
        Adder::Ripple => {
            let mut carries = vec![carry];
            for (bit, (&a, &b)) in a.iter().zip(b).enumerate() {
                let generate = aig.and(a, b);
                let passed = aig.and(propagate[bit], carries[bit]);
                carries.push(aig.or(generate, passed));
            }
            carries
        }
        Adder::BrentKung | Adder::Sklansky => {
            let mut generate = zip(aig, a, b, Aig::and);
            // The carry in is a generate below the lowest bit.
            let mut pairs = vec![(carry, Lit::FALSE)];
            pairs.extend(generate.drain(..).zip(propagate.iter().copied()));
            prefix(aig, kind, &mut pairs);
            pairs.into_iter().map(|(generate, _)| generate).collect()
        }
    };
    let sum = propagate.iter().zip(&carries).map(|(&p, &c)| aig.xor(p, c)).collect();
    (sum, carries[a.len()])
}

/// Replaces each (generate, propagate) by that of all positions up to it.
fn prefix(aig: &mut Aig, kind: Adder, pairs: &mut [(Lit, Lit)]) {
    let mut combine = |pairs: &mut [(Lit, Lit)], high: usize, low: usize| {
        let ((g, p), (below_g, below_p)) = (pairs[high], pairs[low]);
        let passed = aig.and(p, below_g);
        pairs[high] = (aig.or(g, passed), aig.and(p, below_p));
    };
    let length = pairs.len();
    let rows = usize::BITS - (length - 1).leading_zeros();
    for row in 0..rows {
        let span = 1 << row;
        for position in span..length {
            let joins = match kind {
                Adder::Sklansky => position & span != 0,
                _ => position % (2 * span) == 2 * span - 1,
            };
            if joins {
                let low =
                    if kind == Adder::Sklansky { (position & !(span - 1)) - 1 } else { position - span };
                combine(pairs, position, low);
            }
        }
    }
    if kind == Adder::BrentKung {
        for span in (0..rows).rev().map(|row| 1 << row) {
            for position in ((3 * span - 1)..length).step_by(2 * span) {
                combine(pairs, position, position - span);
            }
        }
    }
}

/// `a - b` modulo 2^width.
pub fn subtract(aig: &mut Aig, kind: Adder, a: &[Lit], b: &[Lit]) -> Vec<Lit> {
    add(aig, kind, a, &not(b), Lit::TRUE).0
}

/// `value` shifted by an amount of any width, `left` or right; zero when the amount reaches the width.
pub fn shift(aig: &mut Aig, value: &[Lit], amount: &[Lit], left: bool) -> Vec<Lit> {
    let width = value.len();
    let rows = (usize::BITS - (width - 1).leading_zeros()) as usize;
    let mut word = value.to_vec();
    for (row, &select) in amount.iter().enumerate().take(rows) {
        let distance = 1 << row;
        let moved: Vec<Lit> = (0..width)
            .map(|bit| {
                let from = if left { bit.checked_sub(distance) } else { Some(bit + distance) };
                from.and_then(|from| word.get(from)).copied().unwrap_or(Lit::FALSE)
            })
            .collect();
        word = mux(aig, select, &moved, &word);
    }
    if amount.len() > rows {
        let beyond = any(aig, &amount[rows..]);
        word = word.into_iter().map(|bit| aig.and(bit, !beyond)).collect();
    }
    word
}
