//! The circuits that the hardware is proved against. They compute the same in another way, which follows the words of
//! the specification. They share word operators with the hardware's gates, and nothing of its design.

pub mod aligned;
pub mod exact;
pub mod order;
pub mod pipelines;

use fp::Format;
use gates::aig::{Aig, Lit};
use gates::words::{self, Adder};

/// Carries of the references: none of the structures that the hardware's gates use by default.
pub(super) const ADDER: Adder = Adder::Ripple;

/// A floating-point word of a format, taken apart.
#[derive(Clone, Debug)]
pub struct Parts {
    /// Bits of the fraction, without the hidden bit.
    pub fraction: Vec<Lit>,
    /// Bits of the exponent field.
    pub exponent: Vec<Lit>,
    /// The sign.
    pub sign: Lit,
    /// Whether the word is a NaN.
    pub nan: Lit,
    /// Whether it is an infinity.
    pub infinity: Lit,
    /// Whether it is a zero.
    pub zero: Lit,
}

impl Parts {
    /// Takes a word apart.
    pub fn new(aig: &mut Aig, format: Format, word: &[Lit]) -> Self {
        let (fraction, rest) = word.split_at(format.fraction_bits() as usize);
        let (exponent, sign) = rest.split_at(rest.len() - 1);
        let special = words::all(aig, exponent);
        let fraction_any = words::any(aig, fraction);
        let exponent_any = words::any(aig, exponent);
        Self {
            nan: aig.and(special, fraction_any),
            infinity: aig.and(special, !fraction_any),
            zero: aig.and(!fraction_any, !exponent_any),
            fraction: fraction.to_vec(),
            exponent: exponent.to_vec(),
            sign: sign[0],
        }
    }
}
