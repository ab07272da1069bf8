//! Splits a word into the fields that the arithmetic units compute with.
//!
//! A finite value is `(-1)^sign * significand * 2^(exponent - bias - (S - 1))`. A subnormal has the exponent code of the
//! smallest normal number, 1, and a clear leading bit, so that the formula holds for it and for zero too.

use crate::blocks::module;
use crate::widths::{check_widths, format};
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// Fields and class of a word.
///
/// ```text
///            +------------+
///            |          1 |---> sign_o
/// word_i --->| W        E |---> encoded_exponent_o, exponent_o
///            |  FpUnpack  |
///            |          S |---> significand_o
///            |          1 |---> nan_o, infinity_o
///            +------------+
/// ```
/// Combinational. `encoded_exponent_o` is ready before `exponent_o`, which is 1 for a subnormal. For NaN and infinity, exponent and
/// significand mean nothing.
#[derive(LogicBlock, Clone, Debug)]
pub(super) struct FpUnpack<const E: usize, const S: usize, const W: usize> {
    pub word_i: Signal<In, Bits<W>>,
    pub sign_o: Signal<Out, Bit>,
    pub encoded_exponent_o: Signal<Out, Bits<E>>,
    pub exponent_o: Signal<Out, Bits<E>>,
    pub significand_o: Signal<Out, Bits<S>>,
    pub nan_o: Signal<Out, Bit>,
    pub infinity_o: Signal<Out, Bit>,
    sign_index: Constant<Bits<8>>,
    fraction_bits: Constant<Bits<8>>,
    fraction_mask: Constant<Bits<S>>,
    hidden_bit: Constant<Bits<S>>,
    special_exponent: Constant<Bits<E>>,
    shifted: Signal<Local, Bits<W>>,
    encoded_exponent: Signal<Local, Bits<E>>,
    exponent: Signal<Local, Bits<E>>,
    significand: Signal<Local, Bits<S>>,
    fraction: Signal<Local, Bits<S>>,
    special: Signal<Local, Bit>,
}

impl<const E: usize, const S: usize, const W: usize> Default for FpUnpack<E, S, W> {
    fn default() -> Self {
        check_widths!(W);
        let format = format::<E, S>();
        let hidden_bit = u64::from(format.min_normal());
        module! {
            sign_index = Constant::new((W as u64 - 1).into()),
            fraction_bits = Constant::new((S as u64 - 1).into()),
            fraction_mask = Constant::new((hidden_bit - 1).into()),
            hidden_bit = Constant::new(hidden_bit.into()),
            special_exponent = Constant::new(Bits::mask());
            word_i, sign_o, encoded_exponent_o, exponent_o, significand_o, nan_o, infinity_o, shifted, encoded_exponent, exponent, fraction,
            significand, special,
        }
    }
}

impl<const E: usize, const S: usize, const W: usize> Logic for FpUnpack<E, S, W> {
    #[hdl_gen]
    fn update(&mut self) {
        self.shifted.next = self.word_i.val() >> self.fraction_bits.val();
        self.encoded_exponent.next = bit_cast::<E, W>(self.shifted.val());
        self.fraction.next = bit_cast::<S, W>(self.word_i.val()) & self.fraction_mask.val();
        self.special.next = self.encoded_exponent.val() == self.special_exponent.val();
        self.exponent.next = self.encoded_exponent.val();
        self.significand.next = self.fraction.val() | self.hidden_bit.val();
        if !self.encoded_exponent.val().any() {
            self.exponent.next = 1.into();
            self.significand.next = self.fraction.val();
        }

        self.sign_o.next = self.word_i.val().get_bit(self.sign_index.val().index());
        self.encoded_exponent_o.next = self.encoded_exponent.val();
        self.exponent_o.next = self.exponent.val();
        self.significand_o.next = self.significand.val();
        self.nan_o.next = self.special.val() & self.fraction.val().any();
        self.infinity_o.next = self.special.val() & !self.fraction.val().any();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("fp_unpack", &format::<E, S>().systematic_name())
    }
}
