//! The one rounder behind every operation.
//!
//! The exact result is handed over as a window of `S + 2` bits and the OR of all that is below it, `lost_i`. `exponent_i` is the
//! exponent of the window's second bit. If the top bit is clear, the result starts at the second bit, unless the exponent is 0,
//! which makes it subnormal. Whoever fills the window need know where its leading one is to within one place only.
//!
//! Field and fraction are packed into one word before the increment, so that a carry out of the fraction runs into the
//! exponent: the largest subnormal becomes the smallest normal number, and the largest number becomes infinity, without a
//! case of their own. For the same reason, a window may hold the complement of a negative number: what is shifted in below
//! is all ones, and the increment that `complement_i` asks for completes the negation.
//!
//! | code | direction | increments if | beyond the largest number |
//! |---|---|---|---|
//! | 0 | nearest, ties to even | round & (sticky or last) | infinity |
//! | 1 | toward zero | never | largest number |
//! | 2 | down | inexact & negative | infinity if negative, else largest number |
//! | 3 | up | inexact & positive | infinity if positive, else largest number |
//! | 4 | nearest, ties away | round | infinity |
//!
//! Codes 5 to 7 are reserved and round toward zero.

use crate::blocks::module;
use crate::widths::{check_widths, format};
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// Rounds an exact result into a word.
///
/// ```text
///                     +-----------+
///           sign_i -->| 1         |
///       exponent_i -->| X         |
///         window_i -->| R       W |--> result_o
///           lost_i -->| 1         |
///     complement_i -->| 1         |
/// nan_i, infinity_i ->| 1 Rounder |
///       rounding_i -->| 3         |
///                     +-----------+
/// ```
/// Combinational. Requires `0 <= exponent < 2^(X-1)`, and, if the exponent exceeds 1, that one of the window's upper two bits is set
/// or the window is zero. `nan_i` overrides all else and gives the canonical NaN; `infinity_i` overrides exponent and
/// window.
#[derive(LogicBlock, Clone, Debug)]
pub(super) struct Rounder<const E: usize, const S: usize, const W: usize, const X: usize, const R: usize> {
    pub sign_i: Signal<In, Bit>,
    pub exponent_i: Signal<In, Bits<X>>,
    pub window_i: Signal<In, Bits<R>>,
    pub lost_i: Signal<In, Bit>,
    pub complement_i: Signal<In, Bit>,
    pub nan_i: Signal<In, Bit>,
    pub infinity_i: Signal<In, Bit>,
    pub rounding_i: Signal<In, Bits<3>>,
    pub result_o: Signal<Out, Bits<W>>,
    top_index: Constant<Bits<8>>,
    second_index: Constant<Bits<8>>,
    fraction_mask: Constant<Bits<R>>,
    fraction_bits: Constant<Bits<8>>,
    special_exponent: Constant<Bits<X>>,
    last_exponent: Constant<Bits<X>>,
    max_finite: Constant<Bits<W>>,
    infinity: Constant<Bits<W>>,
    canonical_nan: Constant<Bits<W>>,
    sign_bit: Constant<Bits<W>>,
    top: Signal<Local, Bit>,
    kept: Signal<Local, Bits<R>>,
    sticky: Signal<Local, Bit>,
    inexact: Signal<Local, Bit>,
    away: Signal<Local, Bit>,
    to_infinity: Signal<Local, Bit>,
    increment: Signal<Local, Bit>,
    overflow: Signal<Local, Bit>,
    exponent: Signal<Local, Bits<X>>,
    fraction: Signal<Local, Bits<R>>,
    field: Signal<Local, Bits<W>>,
    encoded: Signal<Local, Bits<W>>,
    magnitude: Signal<Local, Bits<W>>,
    word: Signal<Local, Bits<W>>,
}

impl<const E: usize, const S: usize, const W: usize, const X: usize, const R: usize> Default
    for Rounder<E, S, W, X, R>
{
    fn default() -> Self {
        check_widths!(W, X, R);
        let format = format::<E, S>();
        let word = |bits: u32| Constant::new(u64::from(bits).into());
        module! {
            top_index = Constant::new((R as u64 - 1).into()),
            second_index = Constant::new((R as u64 - 2).into()),
            fraction_mask = Constant::new((u64::from(format.min_normal()) - 1).into()),
            fraction_bits = Constant::new(u64::from(format.fraction_bits()).into()),
            special_exponent = Constant::new(((1u64 << E) - 1).into()),
            last_exponent = Constant::new(((1u64 << E) - 2).into()),
            max_finite = word(format.max_finite()),
            infinity = word(format.infinity()),
            canonical_nan = word(format.canonical_nan()),
            sign_bit = word(format.sign_bit());
            sign_i, exponent_i, window_i, lost_i, complement_i, nan_i, infinity_i, rounding_i, result_o,
            top, kept, sticky, inexact, away, to_infinity, increment, overflow, exponent, fraction, field, encoded,
            magnitude, word,
        }
    }
}

impl<const E: usize, const S: usize, const W: usize, const X: usize, const R: usize> Logic
    for Rounder<E, S, W, X, R>
{
    #[hdl_gen]
    fn update(&mut self) {
        // The significand with its round bit at the bottom, and whether anything is below.
        self.top.next = self.window_i.val().get_bit(self.top_index.val().index());
        self.kept.next = self.window_i.val();
        self.sticky.next = self.lost_i.val();
        if self.top.val() | !self.exponent_i.val().any() {
            self.kept.next = self.window_i.val() >> 1;
            self.sticky.next = self.lost_i.val() | self.window_i.val().get_bit(0);
        }

        // Direction.
        self.inexact.next = self.kept.val().get_bit(0) | self.sticky.val();
        self.away.next = ((self.rounding_i.val() == 2) & self.sign_i.val())
            | ((self.rounding_i.val() == 3) & !self.sign_i.val());
        self.to_infinity.next = (self.rounding_i.val() == 0) | (self.rounding_i.val() == 4) | self.away.val();
        self.increment.next = self.away.val() & self.inexact.val();
        if self.rounding_i.val() == 0 {
            self.increment.next =
                self.kept.val().get_bit(0) & (self.sticky.val() | self.kept.val().get_bit(1));
        }
        if self.rounding_i.val() == 4 {
            self.increment.next = self.kept.val().get_bit(0);
        }

        // Packing and increment.
        self.exponent.next = 0.into();
        if self.window_i.val().get_bit(self.second_index.val().index()) {
            self.exponent.next = self.exponent_i.val();
        }
        if self.top.val() {
            self.exponent.next = self.exponent_i.val() + 1;
        }
        self.fraction.next = self.kept.val() >> 1;
        self.fraction.next = self.fraction.val() & self.fraction_mask.val();
        self.field.next = bit_cast::<W, X>(self.exponent.val());
        self.field.next = self.field.val() << self.fraction_bits.val();
        self.encoded.next = self.field.val() | bit_cast::<W, R>(self.fraction.val());
        self.magnitude.next = self.encoded.val();
        if self.increment.val() | self.complement_i.val() {
            self.magnitude.next = self.encoded.val() + 1;
        }

        // Results outside the normal range. An increment that overflows gives infinity by itself.
        self.overflow.next = (self.exponent_i.val() >= self.special_exponent.val())
            | (self.top.val() & (self.exponent_i.val() == self.last_exponent.val()));
        if self.overflow.val() {
            self.magnitude.next = self.max_finite.val();
            if self.to_infinity.val() {
                self.magnitude.next = self.infinity.val();
            }
        }
        if self.infinity_i.val() {
            self.magnitude.next = self.infinity.val();
        }
        self.word.next = self.magnitude.val();
        if self.sign_i.val() {
            self.word.next = self.magnitude.val() | self.sign_bit.val();
        }
        if self.nan_i.val() {
            self.word.next = self.canonical_nan.val();
        }
        self.result_o.next = self.word.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("rounder", &format::<E, S>().systematic_name())
    }
}
