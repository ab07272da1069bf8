//! The arithmetic of a narrow format on native numbers: as [`fp::soft`], but fast enough for whole pictures.
//!
//! A number of any format is a binary32 number. The product of two is exact in binary64; their sum is rounded there to odd
//! (Boldo, Melquiond, "Emulation of FMA and correctly rounded sums: proved algorithms using rounding to odd", IEEE TC 57(4),
//! 2008), from which a second rounding to at most 51 bits is correct in every direction.

use fp::{CANONICAL_NAN, Format, Rounding, Subnormals};

const FRACTION_BITS: u32 = 52;
const SIGN: u64 = 1 << 63;
const INFINITY: u64 = 0x7ff << FRACTION_BITS;

/// Addition, subtraction and multiplication of one format.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NarrowArithmetic {
    /// The format of operands and results.
    pub format: Format,
    /// What happens to subnormals.
    pub subnormals: Subnormals,
    /// Bits of a double's significand that the format does not have.
    dropped: u32,
    /// The format's least subnormal number, and its reciprocal.
    quantum: f64,
    inv_quantum: f64,
    min_normal: f64,
    max_finite: f64,
}

impl NarrowArithmetic {
    /// The arithmetic of `format`.
    #[must_use]
    pub fn new(format: Format, subnormals: Subnormals) -> Self {
        let power = |e: i32| f64::from_bits(((1023 + i64::from(e)) as u64) << FRACTION_BITS);
        let least = 1 - format.bias() - format.fraction_bits() as i32;
        let max_finite = power(format.bias() + 1) - power(format.bias() - format.fraction_bits() as i32);
        Self {
            format,
            subnormals,
            dropped: FRACTION_BITS - format.fraction_bits(),
            quantum: power(least),
            inv_quantum: power(-least),
            min_normal: power(1 - format.bias()),
            max_finite,
        }
    }

    /// `x` in the format. Exact input, or a sum that was rounded to odd.
    #[inline]
    #[must_use]
    pub fn round(&self, x: f64, rounding: Rounding) -> f32 {
        let bits = x.to_bits();
        let sign = bits & SIGN;
        let magnitude = bits ^ sign;
        if magnitude >= INFINITY || magnitude == 0 {
            return if x.is_nan() { f32::from_bits(CANONICAL_NAN) } else { x as f32 };
        }
        let away = rounding.is_away(sign != 0);
        if magnitude < self.min_normal.to_bits() {
            let tiny = self.round_tiny(f64::from_bits(magnitude), rounding, away);
            return f64::from_bits(tiny.to_bits() | sign) as f32;
        }
        let rest = (1u64 << self.dropped) - 1;
        let up_to = match rounding {
            Rounding::NearestEven => (rest >> 1) + (magnitude >> self.dropped & 1),
            Rounding::NearestAway => (rest >> 1) + 1,
            _ if away => rest,
            _ => 0,
        };
        let rounded = (magnitude + up_to) & !rest;
        let max_finite = self.max_finite.to_bits();
        let rounded = match rounding {
            _ if rounded <= max_finite => rounded,
            Rounding::NearestEven | Rounding::NearestAway => INFINITY,
            _ if away => INFINITY,
            _ => max_finite,
        };
        f64::from_bits(rounded | sign) as f32
    }

    /// The positive number `x` below the smallest normal one.
    #[cold]
    fn round_tiny(&self, x: f64, rounding: Rounding, away: bool) -> f64 {
        if self.subnormals == Subnormals::Flush {
            return if away { self.min_normal } else { 0.0 };
        }
        let steps = x * self.inv_quantum;
        let steps = match rounding {
            Rounding::NearestEven => steps.round_ties_even(),
            Rounding::NearestAway => steps.round(),
            _ if away => steps.ceil(),
            _ => steps.floor(),
        };
        steps * self.quantum
    }

    /// An operand: a zero of its sign if it is subnormal and those are flushed.
    #[inline(always)]
    fn operand(&self, x: f32) -> f64 {
        let x = f64::from(x);
        if self.subnormals == Subnormals::Flush && x.abs() < self.min_normal { 0.0f64.copysign(x) } else { x }
    }

    /// `a - b`.
    #[inline]
    #[must_use]
    pub fn subtract(&self, a: f32, b: f32, rounding: Rounding) -> f32 {
        let (a, b) = (self.operand(a), self.operand(b));
        let sum = a - b;
        if sum == 0.0 {
            // x - x is -0 when rounding down; 0 - 0 keeps a sign that both terms have.
            let both_positive = a.is_sign_positive() && b.is_sign_negative();
            return if rounding == Rounding::Down && !both_positive { -0.0 } else { sum as f32 };
        }
        self.round(to_odd(a, b, sum), rounding)
    }

    /// `a * b`.
    #[inline]
    #[must_use]
    pub fn multiply(&self, a: f32, b: f32, rounding: Rounding) -> f32 {
        self.round(self.operand(a) * self.operand(b), rounding)
    }
}

/// `a - b` rounded to odd, given that it rounds to the nearest double `sum`, which is not zero.
#[inline(always)]
fn to_odd(a: f64, b: f64, sum: f64) -> f64 {
    // Knuth's two-sum; nothing overflows, as `a` and `b` are single-precision numbers. NaN for infinite operands.
    let back = sum - a;
    let error = (a - (sum - back)) - (b + back);
    let even = sum.to_bits() & 1 == 0;
    if error == 0.0 || !even || error.is_nan() {
        return sum;
    }
    let outward = (error > 0.0) == (sum > 0.0);
    f64::from_bits(if outward { sum.to_bits() + 1 } else { sum.to_bits() - 1 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use fp::Arithmetic;
    use proptest::prelude::*;

    /// Compares one pair of operands with the integer reference in all directions.
    fn check(soft: Arithmetic, a: u32, b: u32) -> Result<(), TestCaseError> {
        let narrow = NarrowArithmetic::new(soft.format, soft.subnormals);
        let (x, y) = (soft.to_f32(a), soft.to_f32(b));
        let bits = |value: f32| Arithmetic::new(soft.format).from_f32(value, Rounding::TowardZero);
        for rounding in Rounding::ALL {
            let difference = narrow.subtract(x, y, rounding);
            let expected = soft.fp_add(a, b, true, rounding);
            prop_assert_eq!(
                soft.to_f32(expected).to_bits(),
                difference.to_bits(),
                "{:x} - {:x} {:?}",
                a,
                b,
                rounding
            );
            prop_assert_eq!(bits(difference), expected);
            let product = narrow.multiply(x, y, rounding);
            let expected = soft.fp_mul(a, b, rounding);
            prop_assert_eq!(
                soft.to_f32(expected).to_bits(),
                product.to_bits(),
                "{:x} * {:x} {:?}",
                a,
                b,
                rounding
            );
        }
        Ok(())
    }

    const SUBNORMALS: [Subnormals; 2] = [Subnormals::Keep, Subnormals::Flush];

    #[test]
    fn every_pair_of_every_8_bit_format() {
        for exponent_bits in 3..=6 {
            let format = Format::new(exponent_bits, 8 - exponent_bits).unwrap();
            for subnormals in SUBNORMALS {
                let soft = Arithmetic { format, subnormals };
                for a in 0..=format.mask() {
                    for b in 0..=format.mask() {
                        check(soft, a, b).unwrap();
                    }
                }
            }
        }
    }

    /// Bit patterns, half of them with exponents near each other.
    fn operands() -> impl Strategy<Value = (u32, u32)> {
        prop_oneof![
            any::<(u32, u32)>(),
            any::<(u32, u32, u32)>()
                .prop_map(|(a, b, near)| (a, (a & 0xff80_0000) ^ (near << 30) ^ (b & 0x01ff_ffff))),
            (
                prop::sample::select(vec![0, 1, 0x7f, 0x80, 0xff, 0x7f_ffff, 0x80_0000, u32::MAX >> 1]),
                any::<u32>()
            ),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 20_000, ..ProptestConfig::default() })]

        #[test]
        fn any_pair_of_any_format(
            (a, b) in operands(),
            exponent_bits in 2u32..=8,
            significand_bits in 2u32..=24,
            flush in any::<bool>(),
        ) {
            let Ok(format) = Format::new(exponent_bits, significand_bits) else { return Ok(()) };
            // The upper bits, so that signs and exponents of narrow formats are as the strategy made them.
            let [a, b] = [a, b].map(|x| x >> (32 - format.width()));
            check(Arithmetic { format, subnormals: SUBNORMALS[usize::from(flush)] }, a, b)?;
        }

        #[test]
        fn conversion(bits in any::<u32>(), exponent_bits in 2u32..=8, significand_bits in 2u32..=24) {
            let Ok(format) = Format::new(exponent_bits, significand_bits) else { return Ok(()) };
            let x = f32::from_bits(bits);
            for subnormals in SUBNORMALS {
                let (soft, narrow) = (Arithmetic { format, subnormals }, NarrowArithmetic::new(format, subnormals));
                for rounding in Rounding::ALL {
                    let expected = soft.to_f32(soft.from_f32(x, rounding));
                    prop_assert_eq!(narrow.round(f64::from(x), rounding).to_bits(), expected.to_bits());
                }
            }
        }
    }
}
