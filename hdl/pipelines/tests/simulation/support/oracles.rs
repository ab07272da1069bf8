//! Operations of the rounding units and what every oracle says of them.

use fp::operands::{Operands, patterns};
use fp::{Arithmetic, Format, Rounding};
use rustc_apfloat::ieee::Single;
use rustc_apfloat::{Float, Round};

/// An operation of a rounding unit on two operands.
#[derive(Clone, Copy, Debug)]
pub struct Operation {
    pub kind: Kind,
    pub a: u32,
    pub b: u32,
    pub rounding: Rounding,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Add,
    Subtract,
    Multiply,
}

impl Operation {
    /// The result in `arithmetic`, after all oracles that know the format have agreed on it.
    pub fn expected(self, arithmetic: &Arithmetic) -> u32 {
        let Self { kind, a, b, rounding } = self;
        let golden = match kind {
            Kind::Add => arithmetic.fp_add(a, b, false, rounding),
            Kind::Subtract => arithmetic.fp_add(a, b, true, rounding),
            Kind::Multiply => arithmetic.fp_mul(a, b, rounding),
        };
        if *arithmetic == Arithmetic::new(Format::BINARY32) {
            assert_eq!(golden, self.softfloat(), "golden and SoftFloat disagree on {self:x?}");
            assert_eq!(golden, self.apfloat(), "golden and apfloat disagree on {self:x?}");
            if rounding == Rounding::NearestEven {
                assert_eq!(golden, self.native(), "golden and this machine disagree on {self:x?}");
            }
        }
        golden
    }

    fn native(self) -> u32 {
        let (a, b) = (f32::from_bits(self.a), f32::from_bits(self.b));
        let result = match self.kind {
            Kind::Add => a + b,
            Kind::Subtract => a - b,
            Kind::Multiply => a * b,
        };
        fp::canonical(result).to_bits()
    }

    fn apfloat(self) -> u32 {
        let round = match self.rounding {
            Rounding::NearestEven => Round::NearestTiesToEven,
            Rounding::TowardZero => Round::TowardZero,
            Rounding::Down => Round::TowardNegative,
            Rounding::Up => Round::TowardPositive,
            Rounding::NearestAway => Round::NearestTiesToAway,
        };
        let (a, b) = (Single::from_bits(u128::from(self.a)), Single::from_bits(u128::from(self.b)));
        let result = match self.kind {
            Kind::Add => a.add_r(b, round),
            Kind::Subtract => a.sub_r(b, round),
            Kind::Multiply => a.mul_r(b, round),
        };
        if result.value.is_nan() { fp::CANONICAL_NAN } else { result.value.to_bits() as u32 }
    }

    fn softfloat(self) -> u32 {
        use softfloat_sys::{f32_add, f32_mul, f32_sub, float32_t, softfloat_roundingMode_write_helper};
        let (a, b) = (float32_t { v: self.a }, float32_t { v: self.b });
        // SAFETY: these functions take plain words; the rounding mode is the thread's own.
        let result = unsafe {
            // SoftFloat's codes are RISC-V's, as are ours.
            softfloat_roundingMode_write_helper(self.rounding as u8);
            match self.kind {
                Kind::Add => f32_add(a, b),
                Kind::Subtract => f32_sub(a, b),
                Kind::Multiply => f32_mul(a, b),
            }
        };
        result.v
    }
}

/// A boundary pattern with another one, in any direction: every `stride`-th of all such operations; then `random` drawn
/// pairs. A stride that is prime to five and to the number of patterns meets every pattern in every direction.
pub fn operations(kinds: &[Kind], format: Format, stride: usize, random: usize, seed: u64) -> Vec<Operation> {
    let all = patterns(format);
    let mut stream = Operands::new(format, seed);
    let mut list = Vec::new();
    for &kind in kinds {
        for i in (0..all.len() * all.len() * 5).step_by(stride) {
            let (a, b) = (all[i / 5 / all.len()], all[i / 5 % all.len()]);
            list.push(Operation { kind, a, b, rounding: Rounding::ALL[i % 5] });
        }
        for i in 0..random {
            let (a, b) = stream.pair();
            list.push(Operation { kind, a, b, rounding: Rounding::ALL[i % 5] });
        }
    }
    list
}

/// Every pair of values of a small format.
pub fn exhaustive(kind: Kind, format: Format, rounding: Rounding) -> impl Iterator<Item = Operation> {
    let codes = 1u32 << format.width();
    (0..codes).flat_map(move |a| (0..codes).map(move |b| Operation { kind, a, b, rounding }))
}

/// The arithmetic of a format given by its widths.
pub fn arithmetic<const E: usize, const S: usize>() -> Arithmetic {
    Arithmetic::new(Format::new(E as u32, S as u32).unwrap())
}
