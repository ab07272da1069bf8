//! Addition of numbers whose exponents are a known distance apart, for formats of any width: the sum is an exact integer
//! in units of the last place of the lesser exponent, and its shift is a constant.
//!
//! Rounding is needed only where the integer has more bits than a significand, and then the result is normal: a sum that
//! is subnormal, or loses leading digits to cancellation, is a multiple of that unit and therefore exact.

use fp::Format;

use super::exact::{CutResult, SpecialSum, zero_sign};
use super::{ADDER, Parts};
use gates::aig::{Aig, Lit};
use gates::words;

/// The sum when an operand's exponent field is all ones.
pub fn special(aig: &mut Aig, format: Format, a: &[Lit], b: &[Lit], subtract: Lit) -> Vec<Lit> {
    let (x, y) = operands(aig, format, a, b, subtract);
    let special = SpecialSum::new(aig, &x, &y);
    let mut word = words::constant(u128::from(format.infinity()), format.width() - 1);
    word.push(special.sign);
    let canonical = words::constant(u128::from(format.canonical_nan()), format.width());
    words::mux(aig, special.nan, &canonical, &word)
}

fn operands(aig: &mut Aig, format: Format, a: &[Lit], b: &[Lit], subtract: Lit) -> (Parts, Parts) {
    let x = Parts::new(aig, format, a);
    let mut y = Parts::new(aig, format, b);
    y.sign = aig.xor(y.sign, subtract);
    (x, y)
}

/// The sum of finite operands where `a`'s exponent is `difference` more than `b`'s. The exponent of a subnormal is that of
/// the smallest normal numbers.
pub fn add(
    aig: &mut Aig,
    format: Format,
    (a, b): (&[Lit], &[Lit]),
    difference: i32,
    subtract: Lit,
    rounding: &[Lit],
) -> Vec<Lit> {
    let (x, y) = operands(aig, format, a, b, subtract);
    let (high, low) = if difference < 0 { (&y, &x) } else { (&x, &y) };
    let distance = difference.unsigned_abs() as usize;
    let significand = |aig: &mut Aig, parts: &Parts| {
        let mut word = parts.fraction.clone();
        word.push(words::any(aig, &parts.exponent));
        word
    };
    // Two bits for the carry and the sign.
    let width = distance + format.fraction_bits() as usize + 3;
    let mut high_word = vec![Lit::FALSE; distance];
    high_word.extend(significand(aig, high));
    high_word.resize(width, Lit::FALSE);
    let mut low_word = significand(aig, low);
    low_word.resize(width, Lit::FALSE);
    let minus = aig.xor(high.sign, low.sign);
    let term: Vec<Lit> = low_word.iter().map(|&bit| aig.xor(bit, minus)).collect();
    let (sum, _) = words::add(aig, ADDER, &high_word, &term, minus);
    // Only a difference of numbers with one exponent can be negative.
    let negative = if distance == 0 { sum[width - 1] } else { Lit::FALSE };
    let flipped: Vec<Lit> = sum[..width - 1].iter().map(|&bit| aig.xor(bit, negative)).collect();
    let (magnitude, _) = words::add(aig, ADDER, &flipped, &vec![Lit::FALSE; width - 1], negative);
    let zero = !words::any(aig, &magnitude);
    let zero_sign = zero_sign(aig, &x, &y, rounding);
    let nonzero_sign = aig.xor(high.sign, negative);
    let sign = aig.mux(zero, zero_sign, nonzero_sign);
    let normal = words::any(aig, &low.exponent);
    let mut exponent = low.exponent.clone();
    // A subnormal counts as of exponent 1.
    exponent[0] = aig.or(exponent[0], !normal);
    let cut = cut(aig, format, sign, &magnitude, &exponent, distance);
    let mut word = cut.rounded(aig, format, rounding);
    word.push(sign);
    word
}

/// A magnitude in units of the last place of numbers of `exponent`, cut to the fraction.
fn cut(
    aig: &mut Aig,
    format: Format,
    sign: Lit,
    magnitude: &[Lit],
    exponent: &[Lit],
    distance: usize,
) -> CutResult {
    let fraction_bits = format.fraction_bits() as usize;
    let exponent_bits = exponent.len();
    let mut fraction = vec![Lit::FALSE; fraction_bits];
    // Two bits more than a field: what overflows, and the sign of a difference.
    let mut field = vec![Lit::FALSE; exponent_bits + 2];
    let mut long_exponent = exponent.to_vec();
    long_exponent.resize(exponent_bits + 2, Lit::FALSE);
    let (mut guard, mut sticky) = (Lit::FALSE, Lit::FALSE);
    // Whether a one is below each position.
    let mut below = vec![Lit::FALSE];
    for &bit in magnitude {
        below.push(aig.or(below[below.len() - 1], bit));
    }
    let gather = |aig: &mut Aig, into: &mut [Lit], here: Lit, from: &[Lit]| {
        for (slot, &bit) in into.iter_mut().zip(from) {
            let taken = aig.and(here, bit);
            *slot = aig.or(*slot, taken);
        }
    };
    let mut free = Lit::TRUE;
    // Two numbers far apart lose at most one leading digit.
    let last = if distance >= 2 { distance + fraction_bits - 1 } else { 0 };
    for leading in (last..magnitude.len()).rev() {
        let here = aig.and(free, magnitude[leading]);
        free = aig.and(free, !magnitude[leading]);
        let moved = leading as i64 - fraction_bits as i64;
        let step =
            words::constant((moved as u128) & ((1 << (exponent_bits + 2)) - 1), exponent_bits as u32 + 2);
        let (own_field, _) = words::add(aig, ADDER, &long_exponent, &step, Lit::FALSE);
        if moved > 0 {
            let moved = moved as usize;
            gather(aig, &mut fraction, here, &magnitude[moved..moved + fraction_bits]);
            gather(aig, &mut field, here, &own_field);
            gather(aig, std::slice::from_mut(&mut guard), here, &[magnitude[moved - 1]]);
            gather(aig, std::slice::from_mut(&mut sticky), here, &[below[moved - 1]]);
        } else {
            // Exact; normal if the exponent allows a leading one.
            let negative = own_field[exponent_bits + 1];
            let zero = !words::any(aig, &own_field);
            let too_small = aig.or(negative, zero);
            let fits = aig.and(here, !too_small);
            let mut word = vec![Lit::FALSE; moved.unsigned_abs() as usize];
            word.extend_from_slice(&magnitude[..leading]);
            gather(aig, &mut fraction, fits, &word);
            gather(aig, &mut field, fits, &own_field);
            let subnormal = aig.and(here, too_small);
            // One unit of the last place of exponent 1 is the smallest subnormal.
            let all_ones = vec![Lit::TRUE; exponent_bits];
            let (shift, _) = words::add(aig, ADDER, exponent, &all_ones, Lit::FALSE);
            let shifted = words::shift(aig, &magnitude[..fraction_bits], &shift, true);
            gather(aig, &mut fraction, subnormal, &shifted);
        }
    }
    let mut body = fraction;
    body.extend_from_slice(&field[..exponent_bits]);
    let beyond = words::any(aig, &field[exponent_bits..]);
    let all_ones = words::all(aig, &field[..exponent_bits]);
    let overflow = aig.or(beyond, all_ones);
    CutResult { sign, body, guard, sticky, overflow }
}
