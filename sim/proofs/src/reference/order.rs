//! Comparison, minimum and maximum by the rank of a number among all numbers, as an integer in two's complement:
//! the magnitude of a positive number, its complement for a negative one, so that -0 ranks just below +0.

use fp::Format;

use super::{ADDER, Parts};
use gates::aig::{Aig, Lit};
use gates::words;

/// A number's rank, biased so that it compares without sign.
fn rank(aig: &mut Aig, word: &[Lit]) -> Vec<Lit> {
    let sign = word[word.len() - 1];
    let mut rank: Vec<Lit> = word[..word.len() - 1].iter().map(|&bit| aig.xor(bit, sign)).collect();
    rank.push(!sign);
    rank
}

/// `a < b` as the borrow of `a - b`.
fn below(aig: &mut Aig, a: &[Lit], b: &[Lit]) -> Lit {
    let (_, carry) = words::add(aig, ADDER, a, &words::not(b), Lit::TRUE);
    !carry
}

/// `a < b`, `a <= b`, `a == b`; all false for a NaN, and -0 equal to +0.
pub fn compare(aig: &mut Aig, format: Format, a: &[Lit], b: &[Lit]) -> [Lit; 3] {
    let (x, y) = (Parts::new(aig, format, a), Parts::new(aig, format, b));
    let (rank_a, rank_b) = (rank(aig, a), rank(aig, b));
    let zeros = aig.and(x.zero, y.zero);
    let ordered = aig.and(!x.nan, !y.nan);
    let less = below(aig, &rank_a, &rank_b);
    let more = below(aig, &rank_b, &rank_a);
    let same = aig.and(!less, !more);
    let equal = aig.or(same, zeros);
    let less = aig.and(less, !zeros);
    let less_or_equal = aig.or(less, equal);
    [less, less_or_equal, equal].map(|outcome| aig.and(ordered, outcome))
}

/// The lesser of two, or the greater if `maximum`; a NaN is dropped unless `propagate`, and any NaN result is canonical.
pub fn min_max(
    aig: &mut Aig,
    format: Format,
    a: &[Lit],
    b: &[Lit],
    maximum: Lit,
    propagate: Lit,
) -> Vec<Lit> {
    let (x, y) = (Parts::new(aig, format, a), Parts::new(aig, format, b));
    let (rank_a, rank_b) = (rank(aig, a), rank(aig, b));
    let a_first = below(aig, &rank_a, &rank_b);
    let greater = words::mux(aig, a_first, b, a);
    let lesser = words::mux(aig, a_first, a, b);
    let chosen = words::mux(aig, maximum, &greater, &lesser);
    let without_a = words::mux(aig, x.nan, b, &chosen);
    let number = words::mux(aig, y.nan, a, &without_a);
    let both = aig.and(x.nan, y.nan);
    let either = aig.or(x.nan, y.nan);
    let propagated = aig.and(propagate, either);
    let nan = aig.or(both, propagated);
    let canonical = words::constant(u128::from(format.canonical_nan()), number.len() as u32);
    words::mux(aig, nan, &canonical, &number)
}
