//! The multiplier array: product of two significands.
//!
//! With `a = a_h * 2^16 + a_l` and `b` likewise, `a * b = a_h b_h * 2^32 + (a_h b_l + a_l b_h) * 2^16 + a_l b_l`; each
//! partial product is one of `rust-hdl`'s 16 x 16 bits. A significand of 16 bits or fewer has no high part, and
//! three of the four products fold away.
//!
//! A leaf module of its own, so that a proof can treat it as a black box and synthesis can choose its multiplier.

use crate::widths::derived_width;
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// `product = a * b`.
///
/// ```text
///        +--------------------+
/// a_i -->| S                P |--> product_o
/// b_i -->| S                  |
///        | SignificandProduct |
///        +--------------------+
/// ```
/// Combinational, unsigned, exact: `P = 2 S`, `S <= 24`.
#[derive(LogicBlock, Default, Clone, Debug)]
pub struct SignificandProduct<const S: usize, const P: usize> {
    /// First factor.
    pub a_i: Signal<In, Bits<S>>,
    /// Second factor.
    pub b_i: Signal<In, Bits<S>>,
    /// Product.
    pub product_o: Signal<Out, Bits<P>>,
    a_high: Signal<Local, Bits<S>>,
    b_high: Signal<Local, Bits<S>>,
    a_0: Signal<Local, Bits<16>>,
    a_1: Signal<Local, Bits<16>>,
    b_0: Signal<Local, Bits<16>>,
    b_1: Signal<Local, Bits<16>>,
    low: Signal<Local, Bits<32>>,
    cross_0: Signal<Local, Bits<32>>,
    cross_1: Signal<Local, Bits<32>>,
    middle: Signal<Local, Bits<32>>,
    high: Signal<Local, Bits<32>>,
    middle_wide: Signal<Local, Bits<P>>,
    high_wide: Signal<Local, Bits<P>>,
    sum: Signal<Local, Bits<P>>,
}

impl<const S: usize, const P: usize> Logic for SignificandProduct<S, P> {
    #[hdl_gen]
    fn update(&mut self) {
        self.a_high.next = self.a_i.val() >> 16;
        self.b_high.next = self.b_i.val() >> 16;
        self.a_0.next = bit_cast::<16, S>(self.a_i.val());
        self.b_0.next = bit_cast::<16, S>(self.b_i.val());
        self.a_1.next = bit_cast::<16, S>(self.a_high.val());
        self.b_1.next = bit_cast::<16, S>(self.b_high.val());

        self.low.next = self.a_0.val() * self.b_0.val();
        self.cross_0.next = self.a_0.val() * self.b_1.val();
        self.cross_1.next = self.a_1.val() * self.b_0.val();
        self.high.next = self.a_1.val() * self.b_1.val();
        // Each cross product has at most 16 + 8 bits, so that their sum fits.
        self.middle.next = self.cross_0.val() + self.cross_1.val();

        self.middle_wide.next = bit_cast::<P, 32>(self.middle.val());
        self.middle_wide.next = self.middle_wide.val() << 16;
        self.high_wide.next = bit_cast::<P, 32>(self.high.val());
        self.high_wide.next = self.high_wide.val() << 32;
        self.sum.next = self.middle_wide.val() + self.high_wide.val();
        self.product_o.next = self.sum.val() + bit_cast::<P, 32>(self.low.val());
    }

    fn timing(&self) -> Vec<TimingInfo> {
        const { assert!(P == derived_width!(P, 0, S) && S <= 24) };
        named("significand_product", &format!("w{S}"))
    }
}
