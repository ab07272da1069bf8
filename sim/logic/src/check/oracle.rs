//! The results that the units must give, by the processor's own floating-point arithmetic. The oracle is independent
//! of the integer reference `fp::soft`, and faster.
//!
//! The conversion of operands to `f64` is exact. A product of two significands of at most 24 bits is exact in `f64`.
//! A sum need not be exact. The oracle therefore rounds it to odd (Boldo, Melquiond, "Emulation of FMA and Correctly
//! Rounded Sums: Proved Algorithms Using Rounding to Odd", IEEE Transactions on Computers 57(4), 2008), with the
//! error that Knuth's two-sum gives exactly. Rounding the result to any format of at most 51 bits, in any direction,
//! rounds the exact sum. Nothing overflows or becomes subnormal in `f64`, because its range exceeds the square of the
//! range of every format here.

use fp::{Comparison, Format, NanMode, Rounding};

/// The arithmetic of one format.
#[derive(Clone, Debug)]
pub struct Oracle {
    format: Format,
    /// Values of all bit patterns of a format of at most 16 bits.
    values: Vec<f64>,
}

const F64_FRACTION_BITS: u32 = f64::MANTISSA_DIGITS - 1;
const F64_BIAS: i32 = f64::MAX_EXP - 1;

impl Oracle {
    /// The oracle of `format`.
    #[must_use]
    pub fn new(format: Format) -> Self {
        let patterns = if format.width() <= 16 { 0..format.mask() + 1 } else { 0..0 };
        Self { format, values: patterns.map(|bits| value(format, bits)).collect() }
    }

    #[inline(always)]
    fn value(&self, bits: u32) -> f64 {
        match self.values.get(bits as usize) {
            Some(value) => *value,
            None => value(self.format, bits),
        }
    }

    /// `a + b`, or `a - b` if `subtract`.
    #[inline(always)]
    #[must_use]
    pub fn add(&self, a: u32, b: u32, subtract: bool, rounding: Rounding) -> u32 {
        let (x, y) = (self.value(a), self.value(b));
        let y = if subtract { -y } else { y };
        let sum = x + y;
        if sum == 0.0 {
            // An exact zero: the operands' common sign, or by direction.
            let common = x.is_sign_negative() && y.is_sign_negative();
            let differ = x.is_sign_negative() != y.is_sign_negative();
            let negative = common || differ && rounding == Rounding::Down;
            return if negative { self.format.sign_bit() } else { 0 };
        }
        let shadow = sum - x;
        let error = (x - (sum - shadow)) + (y - shadow);
        // With an infinity or a NaN the error is a NaN, and the sum is exact.
        let inexact = error != 0.0 && !error.is_nan();
        let bits = sum.to_bits();
        let odd = if inexact && bits & 1 == 0 {
            let outwards = (error > 0.0) == (sum > 0.0);
            if outwards { bits + 1 } else { bits - 1 }
        } else {
            bits
        };
        self.round(f64::from_bits(odd), rounding)
    }

    /// `a * b`.
    #[inline(always)]
    #[must_use]
    pub fn mul(&self, a: u32, b: u32, rounding: Rounding) -> u32 {
        self.round(self.value(a) * self.value(b), rounding)
    }

    /// The lesser of `a` and `b`, or the greater.
    #[inline(always)]
    #[must_use]
    pub fn min_max(&self, a: u32, b: u32, maximum: bool, nan_mode: NanMode) -> u32 {
        let (x, y) = (self.value(a), self.value(b));
        if x.is_nan() || y.is_nan() {
            return match nan_mode {
                NanMode::Number if !y.is_nan() => b,
                NanMode::Number if !x.is_nan() => a,
                _ => self.format.canonical_nan(),
            };
        }
        // Zeros of different sign are equal as numbers.
        let a_is_less = x < y || x == y && x.is_sign_negative();
        if a_is_less != maximum { a } else { b }
    }

    /// `a < b`, `a <= b`, `a == b`.
    #[inline(always)]
    #[must_use]
    pub fn compare(&self, a: u32, b: u32) -> Comparison {
        let (x, y) = (self.value(a), self.value(b));
        Comparison { lt: x < y, le: x <= y, eq: x == y }
    }

    /// Rounds an `f64` that is normal, zero, infinite or NaN.
    #[inline(always)]
    fn round(&self, x: f64, rounding: Rounding) -> u32 {
        let format = self.format;
        let sign = if x.is_sign_negative() { format.sign_bit() } else { 0 };
        if x.is_nan() {
            return format.canonical_nan();
        }
        if x == 0.0 || x.is_infinite() {
            return sign | if x == 0.0 { 0 } else { format.infinity() };
        }
        let bits = x.to_bits();
        let exponent = (bits >> F64_FRACTION_BITS & 0x7ff) as i32 - F64_BIAS;
        let significand = bits & ((1 << F64_FRACTION_BITS) - 1) | 1 << F64_FRACTION_BITS;
        let least = 1 - format.bias();
        // Below the least normal number the quantum stays as it is. Far below it, dropping more than 54 bits has the
        // effect of dropping 54.
        let subnormal = (least - exponent).max(0) as u32;
        let dropped = (F64_FRACTION_BITS - format.fraction_bits() + subnormal).min(F64_FRACTION_BITS + 2);
        let (kept, rest, half) =
            (significand >> dropped, significand & ((1 << dropped) - 1), 1u64 << (dropped - 1));
        let away = rounding.is_away(sign != 0);
        let increment = match rounding {
            Rounding::NearestEven => rest > half || rest == half && kept & 1 == 1,
            Rounding::NearestAway => rest >= half,
            Rounding::TowardZero => false,
            Rounding::Down | Rounding::Up => away && rest != 0,
        };
        // The hidden bit adds one to the exponent field.
        let field = (exponent - least).max(0) as u64;
        let magnitude = (field << format.fraction_bits()) + kept + u64::from(increment);
        if magnitude < u64::from(format.infinity()) {
            return sign | magnitude as u32;
        }
        let to_infinity = away || matches!(rounding, Rounding::NearestEven | Rounding::NearestAway);
        sign | if to_infinity { format.infinity() } else { format.max_finite() }
    }
}

/// The exact value of a bit pattern.
fn value(format: Format, bits: u32) -> f64 {
    if format == Format::BINARY32 {
        return f64::from(f32::from_bits(bits));
    }
    let magnitude = format.magnitude(bits);
    let size = if magnitude > format.infinity() {
        f64::NAN
    } else if magnitude == format.infinity() {
        f64::INFINITY
    } else {
        let (field, fraction) = (magnitude >> format.fraction_bits(), magnitude & (format.min_normal() - 1));
        let significand = if field == 0 { fraction } else { fraction | format.min_normal() };
        let quantum = field.max(1) as i32 - format.bias() - format.fraction_bits() as i32;
        f64::from(significand) * power_of_two(quantum)
    };
    if format.is_negative(bits) { -size } else { size }
}

fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((exponent + F64_BIAS) as u64) << F64_FRACTION_BITS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fp::Arithmetic;
    use fp::operands::Operands;
    use softfloat_sys::{
        f16_add, f16_mul, f32_add, f32_mul, float16_t, float32_t, softfloat_roundingMode_write_helper,
    };

    fn assert_golden(oracle: &Oracle, a: u32, b: u32) {
        let golden = Arithmetic::new(oracle.format);
        for rounding in Rounding::ALL {
            for subtract in [false, true] {
                let (found, expected) =
                    (oracle.add(a, b, subtract, rounding), golden.fp_add(a, b, subtract, rounding));
                assert_eq!(found, expected, "{} {a:x} {b:x} {subtract} {rounding:?}", oracle.format);
            }
            let (found, expected) = (oracle.mul(a, b, rounding), golden.fp_mul(a, b, rounding));
            assert_eq!(found, expected, "{} {a:x} * {b:x} {rounding:?}", oracle.format);
        }
        for (maximum, mode) in
            [false, true].into_iter().flat_map(|m| [(m, NanMode::Number), (m, NanMode::Propagate)])
        {
            let (found, expected) =
                (oracle.min_max(a, b, maximum, mode), golden.fp_min_max(a, b, maximum, mode));
            assert_eq!(found, expected, "{} {a:x} {b:x} {maximum} {mode:?}", oracle.format);
        }
        assert_eq!(oracle.compare(a, b), golden.fp_cmp(a, b), "{} {a:x} {b:x}", oracle.format);
    }

    #[test]
    fn the_oracle_is_golden_on_all_pairs_of_8_bits() {
        for format in [Format::E5M2, Format::E4M3] {
            let oracle = Oracle::new(format);
            for a in 0..256 {
                (0..256).for_each(|b| assert_golden(&oracle, a, b));
            }
        }
    }

    #[test]
    fn the_oracle_is_golden_on_boundary_and_random_operands() {
        for format in [Format::BINARY32, Format::TF32, Format::BFLOAT16, Format::BINARY16] {
            let oracle = Oracle::new(format);
            let mut stream = Operands::new(format, 3);
            for _ in 0..50_000 {
                let (a, b) = stream.pair();
                assert_golden(&oracle, a, b);
            }
        }
    }

    /// `SoftFloat` 3e, the reference implementation. Its codes of rounding directions are RISC-V's.
    #[test]
    fn the_oracle_is_softfloat() {
        let (half, single) = (Oracle::new(Format::BINARY16), Oracle::new(Format::BINARY32));
        let (mut halves, mut singles) =
            (Operands::new(Format::BINARY16, 5), Operands::new(Format::BINARY32, 5));
        for rounding in Rounding::ALL {
            for _ in 0..200_000 {
                let ((a, b), (c, d)) = (halves.pair(), singles.pair());
                let [x, y] = [a, b].map(|v| float16_t { v: v as u16 });
                let [p, q] = [c, d].map(|v| float32_t { v });
                // SAFETY: the functions have no other state than the rounding direction, which is this thread's own.
                let (sums, products) = unsafe {
                    softfloat_roundingMode_write_helper(rounding as u8);
                    ((f16_add(x, y).v, f32_add(p, q).v), (f16_mul(x, y).v, f32_mul(p, q).v))
                };
                assert_eq!(half.add(a, b, false, rounding), u32::from(sums.0), "{a:x} + {b:x} {rounding:?}");
                assert_eq!(single.add(c, d, false, rounding), sums.1, "{c:x} + {d:x} {rounding:?}");
                assert_eq!(half.mul(a, b, rounding), u32::from(products.0), "{a:x} * {b:x} {rounding:?}");
                assert_eq!(single.mul(c, d, rounding), products.1, "{c:x} * {d:x} {rounding:?}");
            }
        }
    }
}
