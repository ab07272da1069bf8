//! Addition and multiplication in fixed point: every number as an integer multiple of the smallest subnormal, exact
//! integer arithmetic, one rounding at the end. For formats of a few bits: the integers have as many bits as there are
//! exponents.

use fp::Format;

use super::{ADDER, Parts};
use gates::aig::{Aig, Lit};
use gates::words;

/// The magnitude of a finite number in multiples of the smallest subnormal.
fn fixed(aig: &mut Aig, format: Format, parts: &Parts) -> Vec<Lit> {
    let normal = words::any(aig, &parts.exponent);
    let mut significand = parts.fraction.clone();
    significand.push(normal);
    // The field of a normal number counts from 1; its shift counts from 0, like that of subnormals.
    let all_ones = vec![Lit::TRUE; parts.exponent.len()];
    let (less_one, _) = words::add(aig, ADDER, &parts.exponent, &all_ones, Lit::FALSE);
    let shift: Vec<Lit> = less_one.into_iter().map(|bit| aig.and(bit, normal)).collect();
    significand.resize(fixed_bits(format), Lit::FALSE);
    words::shift(aig, &significand, &shift, true)
}

/// Bits of the largest finite number as such an integer.
fn fixed_bits(format: Format) -> usize {
    format.fraction_bits() as usize + (1 << (format.width() - 1 - format.fraction_bits())) - 2
}

/// Signed sum `a + b`, or `a - b`; `rounding` is the units' code of a direction.
pub fn add(aig: &mut Aig, format: Format, a: &[Lit], b: &[Lit], subtract: Lit, rounding: &[Lit]) -> Vec<Lit> {
    let x = Parts::new(aig, format, a);
    let mut y = Parts::new(aig, format, b);
    y.sign = aig.xor(y.sign, subtract);
    // Two's complement with room for the sum and the sign.
    let signed = |aig: &mut Aig, parts: &Parts| {
        let mut word = fixed(aig, format, parts);
        word.extend([Lit::FALSE; 2]);
        conditional_negate(aig, &word, parts.sign)
    };
    let (u, v) = (signed(aig, &x), signed(aig, &y));
    let (sum, _) = words::add(aig, ADDER, &u, &v, Lit::FALSE);
    let negative = sum[sum.len() - 1];
    let magnitude = conditional_negate(aig, &sum, negative);
    let zero = !words::any(aig, &magnitude);
    let zero_sign = zero_sign(aig, &x, &y, rounding);
    let finite_sign = aig.mux(zero, zero_sign, negative);
    let special = SpecialSum::new(aig, &x, &y);
    let sign = aig.mux(special.infinity, special.sign, finite_sign);
    round(aig, format, sign, &magnitude, 0, special.infinity, special.nan, rounding)
}

/// The sign of an exact zero: that of both operands, or +, or - when rounding down.
pub(super) fn zero_sign(aig: &mut Aig, x: &Parts, y: &Parts, rounding: &[Lit]) -> Lit {
    let both_negative = aig.and(x.sign, y.sign);
    let same_sign = !aig.xor(x.sign, y.sign);
    let down = words::equal(aig, rounding, &words::constant(2, 3));
    aig.mux(same_sign, both_negative, down)
}

/// The part of a sum that infinities and NaNs decide.
pub(super) struct SpecialSum {
    /// An operand is infinite.
    pub infinity: Lit,
    /// The sign of that infinity.
    pub sign: Lit,
    /// The sum is a NaN.
    pub nan: Lit,
}

impl SpecialSum {
    pub fn new(aig: &mut Aig, x: &Parts, y: &Parts) -> Self {
        let infinity = aig.or(x.infinity, y.infinity);
        let sign = aig.mux(x.infinity, x.sign, y.sign);
        let both_infinite = aig.and(x.infinity, y.infinity);
        let differ = aig.xor(x.sign, y.sign);
        let opposed = aig.and(both_infinite, differ);
        let any_nan = aig.or(x.nan, y.nan);
        Self { infinity, sign, nan: aig.or(any_nan, opposed) }
    }
}

/// Product; `rounding` is the units' code of a direction.
pub fn mul(aig: &mut Aig, format: Format, a: &[Lit], b: &[Lit], rounding: &[Lit]) -> Vec<Lit> {
    let (x, y) = (Parts::new(aig, format, a), Parts::new(aig, format, b));
    let (u, v) = (fixed(aig, format, &x), fixed(aig, format, &y));
    // Shift and add.
    let width = u.len() + v.len();
    let mut product = vec![Lit::FALSE; width];
    for (weight, &bit) in v.iter().enumerate() {
        let mut row = vec![Lit::FALSE; weight];
        row.extend(u.iter().map(|&other| aig.and(other, bit)));
        row.resize(width, Lit::FALSE);
        product = words::add(aig, ADDER, &product, &row, Lit::FALSE).0;
    }
    let sign = aig.xor(x.sign, y.sign);
    let infinity = aig.or(x.infinity, y.infinity);
    let zero = aig.or(x.zero, y.zero);
    let undefined = aig.and(infinity, zero);
    let any_nan = aig.or(x.nan, y.nan);
    let nan = aig.or(any_nan, undefined);
    // One unit of the product is the square of the smallest subnormal.
    let below = format.bias() as usize - 1 + format.fraction_bits() as usize;
    round(aig, format, sign, &product, below, infinity, nan, rounding)
}

fn conditional_negate(aig: &mut Aig, word: &[Lit], negate: Lit) -> Vec<Lit> {
    let flipped: Vec<Lit> = word.iter().map(|&bit| aig.xor(bit, negate)).collect();
    let zero = vec![Lit::FALSE; word.len()];
    words::add(aig, ADDER, &flipped, &zero, negate).0
}

/// The nearest word of a magnitude in units of the smallest subnormal divided by 2^`below`, in the direction of the
/// three-bit code `rounding`: 0 to nearest even, 2 down, 3 up, 4 to nearest with ties away, any other toward zero.
///
/// For each exponent there is one candidate: the fraction that a magnitude with its leading one there is cut to. The
/// leading one chooses.
#[allow(clippy::too_many_arguments)]
fn round(
    aig: &mut Aig,
    format: Format,
    sign: Lit,
    magnitude: &[Lit],
    below: usize,
    infinity: Lit,
    nan: Lit,
    rounding: &[Lit],
) -> Vec<Lit> {
    let fraction_bits = format.fraction_bits() as usize;
    let bit = |position: usize| magnitude.get(position).copied().unwrap_or(Lit::FALSE);
    let field_bits = format.width() as usize - 1;
    let mut body = vec![Lit::FALSE; field_bits];
    let (mut guard, mut sticky) = (Lit::FALSE, Lit::FALSE);
    let mut overflow = Lit::FALSE;
    // No leading one above the candidate's.
    let mut free = Lit::TRUE;
    let largest_exponent = (1u128 << (field_bits - fraction_bits)) - 2;
    for leading in (below + fraction_bits..magnitude.len()).rev() {
        let here = aig.and(free, bit(leading));
        free = aig.and(free, !bit(leading));
        let exponent = (leading - below - fraction_bits + 1) as u128;
        if exponent > largest_exponent {
            overflow = aig.or(overflow, here);
            continue;
        }
        choose(
            aig,
            here,
            magnitude,
            leading - fraction_bits,
            exponent,
            fraction_bits,
            (&mut body, &mut guard, &mut sticky),
        );
    }
    // A subnormal: no leading one in any of these.
    choose(aig, free, magnitude, below, 0, fraction_bits, (&mut body, &mut guard, &mut sticky));
    let cut = CutResult { sign, body, guard, sticky, overflow };
    let finite = cut.rounded(aig, format, rounding);
    let infinity_word = words::constant(u128::from(format.infinity()), field_bits as u32);
    let mut word = words::mux(aig, infinity, &infinity_word, &finite);
    word.push(sign);
    let canonical = words::constant(u128::from(format.canonical_nan()), format.width());
    words::mux(aig, nan, &canonical, &word)
}

/// A magnitude cut to a format's fraction.
pub(super) struct CutResult {
    pub sign: Lit,
    /// Fraction and exponent field.
    pub body: Vec<Lit>,
    /// The first bit that is cut off.
    pub guard: Lit,
    /// Whether a later one is set.
    pub sticky: Lit,
    /// The magnitude is beyond the largest number before it is rounded.
    pub overflow: Lit,
}

impl CutResult {
    /// Rounds in the direction of the three-bit code `rounding`, without the sign.
    pub fn rounded(self, aig: &mut Aig, format: Format, rounding: &[Lit]) -> Vec<Lit> {
        let Self { sign, body, guard, sticky, overflow } = self;
        let field_bits = body.len();
        let mut code = |value| words::equal(aig, rounding, &words::constant(value, 3));
        let [even, down, up, ties_away] = [0, 2, 3, 4].map(&mut code);
        let tie_break = aig.or(sticky, body[0]);
        let nearest_even = aig.and(guard, tie_break);
        let inexact = aig.or(guard, sticky);
        let directed_down = aig.and(down, sign);
        let directed_up = aig.and(up, !sign);
        let away = aig.or(directed_down, directed_up);
        let terms = [aig.and(even, nearest_even), aig.and(ties_away, guard), aig.and(away, inexact)];
        let increment = words::any(aig, &terms);
        let zero = vec![Lit::FALSE; field_bits];
        let (rounded, _) = words::add(aig, ADDER, &body, &zero, increment);
        let infinity_word = words::constant(u128::from(format.infinity()), field_bits as u32);
        let reached = words::equal(aig, &rounded, &infinity_word);
        let overflow = aig.or(overflow, reached);
        let to_infinity = words::any(aig, &[even, ties_away, away]);
        let largest = words::constant(u128::from(format.max_finite()), field_bits as u32);
        let beyond = words::mux(aig, to_infinity, &infinity_word, &largest);
        words::mux(aig, overflow, &beyond, &rounded)
    }
}

/// If `here`, adds body, guard and sticky of a magnitude that is cut below bit `low`.
fn choose(
    aig: &mut Aig,
    here: Lit,
    magnitude: &[Lit],
    low: usize,
    exponent: u128,
    fraction_bits: usize,
    (body, guard, sticky): (&mut [Lit], &mut Lit, &mut Lit),
) {
    let bit = |position: usize| magnitude.get(position).copied().unwrap_or(Lit::FALSE);
    for (position, slot) in body.iter_mut().enumerate() {
        let candidate = if position < fraction_bits {
            bit(low + position)
        } else {
            Lit::constant(exponent >> (position - fraction_bits) & 1 == 1)
        };
        let taken = aig.and(here, candidate);
        *slot = aig.or(*slot, taken);
    }
    let first_lost = if low > 0 { bit(low - 1) } else { Lit::FALSE };
    let taken = aig.and(here, first_lost);
    *guard = aig.or(*guard, taken);
    let rest = words::any(aig, &magnitude[..low.saturating_sub(1).min(magnitude.len())]);
    let taken = aig.and(here, rest);
    *sticky = aig.or(*sticky, taken);
}
