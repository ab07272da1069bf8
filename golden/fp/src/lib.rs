//! The floating-point policy: what minimum, maximum and NaN mean, for golden and RTL alike.
//!
//! | operation | NaN operand | zeros |
//! |---|---|---|
//! | [`minimum_number`], [`maximum_number`] | dropped; NaN only if both are | -0 < +0 |
//! | [`minimum`], [`maximum`] | propagates | -0 < +0 |
//! | `<`, `<=`, `==` | false | -0 == +0 |
//! | `+`, `-`, `*` | propagates | IEEE 754 |
//!
//! Every NaN result is the canonical quiet NaN ([`CANONICAL_NAN`]), whatever the operands' payloads. Because -0 orders below +0,
//! each of the four functions is commutative and associative bit for bit. An interval therefore does not depend on the order in
//! which planes are folded into it. Names and semantics are those of IEEE 754-2019, section 9.6. Subnormals are kept; rounding is
//! to nearest even unless a function says otherwise.
//!
//! | module | what it holds |
//! |---|---|
//! | [`mod@format`] | binary formats by their widths |
//! | [`soft`] | what the floating-point units compute, by integer arithmetic, in every format |
//! | [`operands`] | operands for tests, the special values among them |
//!
//! ```
//! use fp::{Arithmetic, Format, Rounding, minimum_number};
//!
//! assert_eq!(minimum_number(f32::NAN, 1.0), 1.0);
//! assert!(minimum_number(0.0, -0.0).is_sign_negative());
//!
//! let half = Arithmetic::new(Format::BINARY16);
//! let tenth = half.from_f32(0.1, Rounding::NearestEven);
//! let up = half.fp_add(tenth, half.from_f32(1.0, Rounding::NearestEven), false, Rounding::Up);
//! let down = half.fp_add(tenth, half.from_f32(1.0, Rounding::NearestEven), false, Rounding::Down);
//! assert_eq!((half.to_f32(down), half.to_f32(up)), (1.0996094, 1.1005859));
//! ```

pub mod format;
pub mod operands;
pub mod soft;

pub use format::{Format, FormatError};
pub use soft::{Arithmetic, Comparison, NanMode, Rounding, Subnormals};

/// The bits of the only NaN that any operation produces: quiet, positive, empty payload (RISC-V's choice).
pub const CANONICAL_NAN: u32 = 0x7fc0_0000;

/// `x`, with every NaN replaced by the canonical one.
#[inline(always)]
#[must_use]
pub fn canonical(x: f32) -> f32 {
    if x.is_nan() { f32::from_bits(CANONICAL_NAN) } else { x }
}

/// Whether `a` orders before `b` with -0 < +0; false if either is NaN.
#[inline(always)]
fn before(a: f32, b: f32) -> bool {
    a < b || (a == b && a.is_sign_negative() && b.is_sign_positive())
}

/// IEEE 754-2019 `minimumNumber`: a NaN operand is dropped.
#[inline(always)]
#[must_use]
pub fn minimum_number(a: f32, b: f32) -> f32 {
    if before(a, b) || b.is_nan() { canonical(a) } else { b }
}

/// IEEE 754-2019 `maximumNumber`: a NaN operand is dropped.
#[inline(always)]
#[must_use]
pub fn maximum_number(a: f32, b: f32) -> f32 {
    if before(b, a) || b.is_nan() { canonical(a) } else { b }
}

/// IEEE 754-2019 `minimum`: a NaN operand propagates.
#[inline(always)]
#[must_use]
pub fn minimum(a: f32, b: f32) -> f32 {
    if a.is_nan() || b.is_nan() { f32::from_bits(CANONICAL_NAN) } else { minimum_number(a, b) }
}

/// IEEE 754-2019 `maximum`: a NaN operand propagates.
#[inline(always)]
#[must_use]
pub fn maximum(a: f32, b: f32) -> f32 {
    if a.is_nan() || b.is_nan() { f32::from_bits(CANONICAL_NAN) } else { maximum_number(a, b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPECIALS: [u32; 12] = [
        0x0000_0000,
        0x8000_0000,
        0x0000_0001,
        0x8000_0001,
        0x3f80_0000,
        0xbf80_0000,
        0x7f7f_ffff,
        0x7f80_0000,
        0xff80_0000,
        0x7fc0_0000,
        0xffc1_2345,
        0x7f80_0001,
    ];

    /// The order of the table in the module header, written without comparing floats.
    fn rank(bits: u32) -> Option<i64> {
        let magnitude = i64::from(bits & 0x7fff_ffff);
        (magnitude <= 0x7f80_0000).then_some(if bits >> 31 == 0 { magnitude } else { -1 - magnitude })
    }

    #[test]
    fn every_pair_of_specials_follows_the_table() {
        for a in SPECIALS {
            for b in SPECIALS {
                let (x, y) = (f32::from_bits(a), f32::from_bits(b));
                let (least, greatest) = match (rank(a), rank(b)) {
                    (Some(i), Some(j)) => (if i <= j { a } else { b }, if i >= j { a } else { b }),
                    (Some(_), None) => (a, a),
                    (None, Some(_)) => (b, b),
                    (None, None) => (CANONICAL_NAN, CANONICAL_NAN),
                };
                assert_eq!(minimum_number(x, y).to_bits(), least, "{a:08x} {b:08x}");
                assert_eq!(maximum_number(x, y).to_bits(), greatest, "{a:08x} {b:08x}");
                let nan = rank(a).is_none() || rank(b).is_none();
                assert_eq!(minimum(x, y).to_bits(), if nan { CANONICAL_NAN } else { least });
                assert_eq!(maximum(x, y).to_bits(), if nan { CANONICAL_NAN } else { greatest });
            }
        }
    }
}
