//! Integer reference of the floating-point units, for every format, rounding direction and subnormal policy.
//!
//! Each operation forms the exact result as `significand * 2^exponent` and rounds it once. Operands and results are
//! bit patterns in the low bits of a `u32`. Functions and argument order are those of the RTL units in the crate
//! `units`.
//!
//! # Flushed subnormals
//! With [`Subnormals::Flush`], a subnormal operand of an addition or multiplication counts as a zero of its sign. A
//! result is too small if, before rounding, its magnitude is not zero and below the smallest normal number. Where the
//! rounding direction points away from zero, such a result becomes the smallest normal number of its sign; elsewhere
//! it becomes a zero of its sign. Directed rounding thus stays directed, and a bound stays a bound. Comparisons,
//! minimum and maximum never flush.

use super::format::Format;

/// Rounding direction; the discriminant is the code on the RTL's port (RISC-V's `frm`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Rounding {
    /// To nearest, ties to the even significand.
    #[default]
    NearestEven = 0,
    /// Towards zero.
    TowardZero = 1,
    /// Towards negative infinity.
    Down = 2,
    /// Towards positive infinity.
    Up = 3,
    /// To nearest, ties away from zero.
    NearestAway = 4,
}

impl Rounding {
    /// All five directions.
    pub const ALL: [Self; 5] = [Self::NearestEven, Self::TowardZero, Self::Down, Self::Up, Self::NearestAway];

    /// Whether a result of this sign is rounded away from zero whenever it is inexact.
    #[must_use]
    pub const fn is_away(self, negative: bool) -> bool {
        match self {
            Self::Down => negative,
            Self::Up => !negative,
            _ => false,
        }
    }
}

/// What happens to numbers below the smallest normal one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Subnormals {
    /// Gradual underflow, as IEEE 754 requires.
    #[default]
    Keep,
    /// Subnormals count as zeros, as the module's header states.
    Flush,
}

/// Which of IEEE 754-2019's two pairs of minimum and maximum is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NanMode {
    /// `minimumNumber`, `maximumNumber`: a NaN operand is dropped.
    Number,
    /// `minimum`, `maximum`: a NaN operand propagates.
    Propagate,
}

/// The outcome of a comparison; all false if an operand is NaN.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// `a < b`.
    pub lt: bool,
    /// `a <= b`.
    pub le: bool,
    /// `a == b`.
    pub eq: bool,
}

/// The units of one format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Arithmetic {
    /// Format of operands and results.
    pub format: Format,
    /// What happens to subnormals.
    pub subnormals: Subnormals,
}

/// A finite number: `significand * 2^exponent`, negative if so flagged.
#[derive(Clone, Copy)]
struct Exact {
    negative: bool,
    significand: u128,
    exponent: i32,
}

/// An operand by class; every NaN is the same.
#[derive(Clone, Copy)]
enum Value {
    Nan,
    Infinite { negative: bool },
    Finite(Exact),
}

/// Bits kept below the larger addend; anything that is shifted out further is only sticky.
const GUARD_BITS: i32 = 64;

impl Arithmetic {
    /// The IEEE 754 arithmetic of `format`.
    #[must_use]
    pub const fn new(format: Format) -> Self {
        Self { format, subnormals: Subnormals::Keep }
    }

    /// `a + b`, or `a - b` if `subtract`.
    #[must_use]
    pub fn fp_add(&self, a: u32, b: u32, subtract: bool, rounding: Rounding) -> u32 {
        let b = if subtract { b ^ self.format.sign_bit() } else { b };
        match (self.unpack(a), self.unpack(b)) {
            (Value::Nan, _) | (_, Value::Nan) => self.format.canonical_nan(),
            (Value::Infinite { negative: a }, Value::Infinite { negative: b }) if a != b => {
                self.format.canonical_nan()
            }
            (Value::Infinite { negative }, _) | (_, Value::Infinite { negative }) => self.infinity(negative),
            (Value::Finite(a), Value::Finite(b)) => self.round(sum(a, b, rounding), rounding),
        }
    }

    /// `a * b`.
    #[must_use]
    pub fn fp_mul(&self, a: u32, b: u32, rounding: Rounding) -> u32 {
        let negative = self.format.is_negative(a) != self.format.is_negative(b);
        match (self.unpack(a), self.unpack(b)) {
            (Value::Nan, _) | (_, Value::Nan) => self.format.canonical_nan(),
            (Value::Infinite { .. }, Value::Finite(x)) | (Value::Finite(x), Value::Infinite { .. })
                if x.significand == 0 =>
            {
                self.format.canonical_nan()
            }
            (Value::Infinite { .. }, _) | (_, Value::Infinite { .. }) => self.infinity(negative),
            (Value::Finite(a), Value::Finite(b)) => {
                let significand = a.significand * b.significand;
                self.round(Exact { negative, significand, exponent: a.exponent + b.exponent }, rounding)
            }
        }
    }

    /// The lesser of `a` and `b`, or the greater if `maximum`; -0 orders below +0.
    #[must_use]
    pub fn fp_min_max(&self, a: u32, b: u32, maximum: bool, nan_mode: NanMode) -> u32 {
        match (self.format.is_nan(a), self.format.is_nan(b)) {
            (true, true) => self.format.canonical_nan(),
            (true, false) | (false, true) if nan_mode == NanMode::Propagate => self.format.canonical_nan(),
            (true, false) => b,
            (false, true) => a,
            (false, false) if (self.rank(a) < self.rank(b)) != maximum => a,
            (false, false) => b,
        }
    }

    /// `a < b`, `a <= b` and `a == b`, with -0 equal to +0.
    #[must_use]
    pub fn fp_cmp(&self, a: u32, b: u32) -> Comparison {
        if self.format.is_nan(a) || self.format.is_nan(b) {
            return Comparison { lt: false, le: false, eq: false };
        }
        // Both zeros get rank 0.
        let value = |x| if self.format.magnitude(x) == 0 { 0 } else { self.rank(x) };
        let (a, b) = (value(a), value(b));
        Comparison { lt: a < b, le: a <= b, eq: a == b }
    }

    /// The native number `x`, rounded into the format.
    #[must_use]
    pub fn from_f32(&self, x: f32, rounding: Rounding) -> u32 {
        match Self::new(Format::BINARY32).unpack(x.to_bits()) {
            Value::Nan => self.format.canonical_nan(),
            Value::Infinite { negative } => self.infinity(negative),
            Value::Finite(exact) => self.round(exact, rounding),
        }
    }

    /// The number with the given bits as a native number, which holds every format's numbers exactly. Subnormals are
    /// converted, not flushed.
    #[must_use]
    pub fn to_f32(&self, bits: u32) -> f32 {
        let native = Self::new(Format::BINARY32);
        f32::from_bits(match Self::new(self.format).unpack(bits) {
            Value::Nan => native.format.canonical_nan(),
            Value::Infinite { negative } => native.infinity(negative),
            Value::Finite(exact) => native.round(exact, Rounding::NearestEven),
        })
    }

    /// Position in the total order of numbers with -0 directly below +0.
    fn rank(&self, bits: u32) -> i64 {
        let magnitude = i64::from(self.format.magnitude(bits));
        if self.format.is_negative(bits) { -1 - magnitude } else { magnitude }
    }

    fn infinity(&self, negative: bool) -> u32 {
        self.signed(self.format.infinity(), negative)
    }

    fn signed(&self, magnitude: u32, negative: bool) -> u32 {
        if negative { magnitude | self.format.sign_bit() } else { magnitude }
    }

    /// Exponent of the least significant bit of the smallest normal number and of all subnormals.
    fn least_exponent(&self) -> i32 {
        1 - self.format.bias() - self.format.fraction_bits() as i32
    }

    fn unpack(&self, bits: u32) -> Value {
        let format = self.format;
        let (negative, magnitude) = (format.is_negative(bits), format.magnitude(bits));
        if magnitude > format.infinity() {
            return Value::Nan;
        }
        if magnitude == format.infinity() {
            return Value::Infinite { negative };
        }
        let biased = magnitude >> format.fraction_bits();
        let fraction = u128::from(magnitude & (format.min_normal() - 1));
        let (significand, exponent) = match biased {
            0 if self.subnormals == Subnormals::Flush => (0, self.least_exponent()),
            0 => (fraction, self.least_exponent()),
            _ => (fraction | u128::from(format.min_normal()), self.least_exponent() + biased as i32 - 1),
        };
        Value::Finite(Exact { negative, significand, exponent })
    }

    /// Rounds: the one place that does.
    fn round(&self, exact: Exact, rounding: Rounding) -> u32 {
        let Exact { negative, significand, exponent } = exact;
        if significand == 0 {
            return self.signed(0, negative);
        }
        let away = rounding.is_away(negative);
        let leading = exponent + 127 - significand.leading_zeros() as i32;
        let tiny = leading < 1 - self.format.bias();
        if tiny && self.subnormals == Subnormals::Flush {
            return self.signed(if away { self.format.min_normal() } else { 0 }, negative);
        }
        let quantum = (leading - self.format.fraction_bits() as i32).max(self.least_exponent());
        let dropped = quantum - exponent;
        let (kept, above_half, half, inexact) = if dropped <= 0 {
            (significand << -dropped, false, false, false)
        } else if dropped > 127 {
            // Far below half of the quantum: operands have at most 128 - 24 bits.
            (0, false, false, true)
        } else {
            let kept = significand >> dropped;
            let rest = significand - (kept << dropped);
            let middle = 1 << (dropped - 1);
            (kept, rest > middle, rest == middle, rest != 0)
        };
        let increment = match rounding {
            Rounding::NearestEven => above_half || (half && kept & 1 == 1),
            Rounding::NearestAway => above_half || half,
            Rounding::TowardZero => false,
            Rounding::Down | Rounding::Up => inexact && away,
        };
        // The hidden bit of a normal number adds one to the exponent field, as does a carry out of the significand.
        let field = (quantum - self.least_exponent()) as u128;
        let magnitude = (field << self.format.fraction_bits()) + kept + u128::from(increment);
        let overflow = magnitude >= u128::from(self.format.infinity());
        let nearest = matches!(rounding, Rounding::NearestEven | Rounding::NearestAway);
        self.signed(
            match (overflow, nearest || away) {
                (false, _) => magnitude as u32,
                (true, true) => self.format.infinity(),
                (true, false) => self.format.max_finite(),
            },
            negative,
        )
    }
}

/// The sum of two finite numbers, exact but for a sticky bit far below the larger one's last place.
fn sum(a: Exact, b: Exact, rounding: Rounding) -> Exact {
    let (high, low) = if a.exponent >= b.exponent { (a, b) } else { (b, a) };
    let distance = (high.exponent - low.exponent).min(GUARD_BITS);
    let exponent = high.exponent - distance;
    // An operand has at most 24 bits, so that shifting by 64 or more leaves nothing.
    let shift = (exponent - low.exponent).min(GUARD_BITS);
    let significand = low.significand >> shift;
    let sticky = significand << shift != low.significand;
    let signed =
        |x: Exact, magnitude: u128| if x.negative { -(magnitude as i128) } else { magnitude as i128 };
    let total = signed(high, high.significand << distance) + signed(low, significand | u128::from(sticky));
    let negative = match total {
        0 if a.negative == b.negative => a.negative,
        0 => rounding == Rounding::Down,
        _ => total < 0,
    };
    Exact { negative, significand: total.unsigned_abs(), exponent }
}

#[cfg(test)]
#[path = "soft_tests.rs"]
mod tests;
