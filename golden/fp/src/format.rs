//! Binary interchange formats: widths, special values, names.
//!
//! Every format here is IEEE-like: one sign bit, a biased exponent whose all-ones code means infinity or NaN, and a
//! significand whose leading bit is hidden. [`Format::significand_bits`] counts that hidden bit (it is IEEE 754's
//! precision `p`), so that a value occupies `exponent_bits + significand_bits` bits.
//!
//! | name | exponent bits | significand bits | width |
//! |---|---|---|---|
//! | `binary32` | 8 | 24 | 32 |
//! | `tf32` | 8 | 11 | 19 |
//! | `bfloat16` | 8 | 8 | 16 |
//! | `binary16` | 5 | 11 | 16 |
//! | `e5m2` | 5 | 3 | 8 |
//! | `e4m3` | 4 | 4 | 8 |
//! | `eXmY` | X | Y + 1 | X + Y + 1 |

use std::fmt;
use std::str::FromStr;

/// A binary floating-point format no wider than binary32.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Format {
    exponent_bits: u32,
    significand_bits: u32,
}

/// The formats that have a name of their own.
const NAMED: [(&str, Format); 6] = [
    ("binary32", Format::BINARY32),
    ("tf32", Format::TF32),
    ("bfloat16", Format::BFLOAT16),
    ("binary16", Format::BINARY16),
    ("e5m2", Format::E5M2),
    ("e4m3", Format::E4M3),
];

/// Why a format cannot be had.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FormatError {
    /// The name is neither a known one nor of the form `eXmY`.
    #[error(
        "unknown format `{0}`: use binary32, tf32, bfloat16, binary16, e5m2, e4m3, or eXmY with X exponent and Y \
         fraction bits"
    )]
    UnknownName(String),
    /// The exponent's width is outside the supported range.
    #[error("{0} exponent bits are not supported: use 2 to 8")]
    ExponentBits(u32),
    /// The significand's width is outside the supported range.
    #[error("{0} significand bits (fraction bits plus one) are not supported: use 2 to 24")]
    SignificandBits(u32),
    /// The significand has more bits than the exponent has codes.
    #[error(
        "{significand_bits} significand bits exceed the {codes} codes of the exponent: widen the exponent or narrow \
         the fraction"
    )]
    Unbalanced {
        /// Significand bits asked for.
        significand_bits: u32,
        /// Number of exponent codes.
        codes: u32,
    },
}

impl Format {
    /// IEEE 754 single precision.
    pub const BINARY32: Self = Self { exponent_bits: 8, significand_bits: 24 };
    /// Single precision's range with half precision's significand.
    pub const TF32: Self = Self { exponent_bits: 8, significand_bits: 11 };
    /// The upper half of a binary32.
    pub const BFLOAT16: Self = Self { exponent_bits: 8, significand_bits: 8 };
    /// IEEE 754 half precision.
    pub const BINARY16: Self = Self { exponent_bits: 5, significand_bits: 11 };
    /// The upper half of a binary16.
    pub const E5M2: Self = Self { exponent_bits: 5, significand_bits: 3 };
    /// Eight bits with infinities and NaNs as in IEEE 754 (unlike the variant that has only NaN).
    pub const E4M3: Self = Self { exponent_bits: 4, significand_bits: 4 };

    /// The format with these widths; `significand_bits` includes the hidden bit.
    ///
    /// # Errors
    /// If a width is outside the range that the units support: 2 to 8 exponent bits, 2 to 24 significand bits and
    /// no more significand bits than exponent codes (so that the subnormals span fewer binades than the normals).
    pub const fn new(exponent_bits: u32, significand_bits: u32) -> Result<Self, FormatError> {
        if exponent_bits < 2 || exponent_bits > 8 {
            Err(FormatError::ExponentBits(exponent_bits))
        } else if significand_bits < 2 || significand_bits > 24 {
            Err(FormatError::SignificandBits(significand_bits))
        } else if significand_bits > 1 << exponent_bits {
            Err(FormatError::Unbalanced { significand_bits, codes: 1 << exponent_bits })
        } else {
            Ok(Self { exponent_bits, significand_bits })
        }
    }

    /// Width of the biased exponent.
    #[must_use]
    pub const fn exponent_bits(self) -> u32 {
        self.exponent_bits
    }

    /// Precision: the stored fraction bits and the hidden bit.
    #[must_use]
    pub const fn significand_bits(self) -> u32 {
        self.significand_bits
    }

    /// Stored bits of the significand.
    #[must_use]
    pub const fn fraction_bits(self) -> u32 {
        self.significand_bits - 1
    }

    /// Width of a value.
    #[must_use]
    pub const fn width(self) -> u32 {
        self.exponent_bits + self.significand_bits
    }

    /// The biased exponent of 1.0.
    #[must_use]
    pub const fn bias(self) -> i32 {
        (1 << (self.exponent_bits - 1)) - 1
    }

    /// All bits of a value.
    #[must_use]
    pub const fn mask(self) -> u32 {
        u32::MAX >> (32 - self.width())
    }

    /// The sign bit.
    #[must_use]
    pub const fn sign_bit(self) -> u32 {
        1 << (self.width() - 1)
    }

    /// Positive infinity; magnitudes above it are NaNs.
    #[must_use]
    pub const fn infinity(self) -> u32 {
        ((1 << self.exponent_bits) - 1) << self.fraction_bits()
    }

    /// The only NaN that an operation produces: quiet, positive, empty payload.
    #[must_use]
    pub const fn canonical_nan(self) -> u32 {
        self.infinity() | 1 << (self.fraction_bits() - 1)
    }

    /// The largest finite number.
    #[must_use]
    pub const fn max_finite(self) -> u32 {
        self.infinity() - 1
    }

    /// The smallest positive number that is not subnormal.
    #[must_use]
    pub const fn min_normal(self) -> u32 {
        1 << self.fraction_bits()
    }

    /// `bits` without the sign.
    #[must_use]
    pub const fn magnitude(self, bits: u32) -> u32 {
        bits & (self.mask() >> 1)
    }

    /// Whether the sign bit of `bits` is set.
    #[must_use]
    pub const fn is_negative(self, bits: u32) -> bool {
        bits & self.sign_bit() != 0
    }

    /// Whether `bits` is a NaN.
    #[must_use]
    pub const fn is_nan(self, bits: u32) -> bool {
        self.magnitude(bits) > self.infinity()
    }

    /// The form `eXmY`, which names every format.
    #[must_use]
    pub fn systematic_name(self) -> String {
        format!("e{}m{}", self.exponent_bits, self.fraction_bits())
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match NAMED.iter().find(|(_, format)| format == self) {
            Some((name, _)) => f.write_str(name),
            None => f.write_str(&self.systematic_name()),
        }
    }
}

impl FromStr for Format {
    type Err = FormatError;

    fn from_str(name: &str) -> Result<Self, FormatError> {
        if let Some((_, format)) = NAMED.iter().find(|(known, _)| *known == name) {
            return Ok(*format);
        }
        let widths = || {
            let (exponent, fraction) = name.strip_prefix('e')?.split_once('m')?;
            Some((exponent.parse::<u32>().ok()?, fraction.parse::<u32>().ok()?))
        };
        let (exponent_bits, fraction_bits) = widths().ok_or_else(|| FormatError::UnknownName(name.into()))?;
        Self::new(exponent_bits, fraction_bits.saturating_add(1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_format_parses_from_what_it_prints() {
        let mut formats = 0;
        for exponent_bits in 0..10 {
            for significand_bits in 0..26 {
                let Ok(format) = Format::new(exponent_bits, significand_bits) else { continue };
                assert_eq!(
                    (format.exponent_bits(), format.significand_bits()),
                    (exponent_bits, significand_bits)
                );
                assert_eq!(format.to_string().parse(), Ok(format));
                assert_eq!(format.systematic_name().parse(), Ok(format));
                formats += 1;
            }
        }
        // Exponents of 2 and 3 bits allow 2..=4 and 2..=8 significand bits, 4 bits 2..=16, the rest 2..=24.
        assert_eq!(formats, 3 + 7 + 15 + 4 * 23);
    }

    #[test]
    fn binary32_is_the_native_format() {
        let format = Format::BINARY32;
        assert_eq!(format.mask(), u32::MAX);
        assert_eq!(format.infinity(), f32::INFINITY.to_bits());
        assert_eq!(format.max_finite(), f32::MAX.to_bits());
        assert_eq!(format.min_normal(), f32::MIN_POSITIVE.to_bits());
        assert_eq!(format.canonical_nan(), crate::CANONICAL_NAN);
        assert_eq!(format.bias(), 127);
        assert_eq!((format.exponent_bits(), format.significand_bits(), format.width()), (8, 24, 32));
    }

    #[test]
    fn wrong_names_say_what_is_allowed() {
        for (name, part) in [
            ("binary64", "unknown format `binary64`"),
            ("e5", "eXmY"),
            ("e5m-1", "unknown"),
            ("e9m3", "9 exponent bits"),
            ("e8m24", "25 significand bits"),
            ("e5m0", "1 significand bits"),
            ("e2m9", "exceed the 4 codes"),
            ("e5m4294967295", "significand bits"),
        ] {
            let message = name.parse::<Format>().unwrap_err().to_string();
            assert!(message.contains(part), "{name}: {message}");
        }
    }
}
