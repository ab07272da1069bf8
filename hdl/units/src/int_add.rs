//! Integer adder: forms the second child's offset.

use crate::blocks::{Dff, dff_setup};
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// `sum = a + b mod 2^B`.
///
/// ```text
///            +------------+
///    a_i --->| B        B |---> sum_o
///    b_i --->| B          |
///  valid_i ->|   IntAdd   |---> valid_o
///    tag_i ->| T        T |---> tag_o
///     en_i ->|            |
///    clk_i ->|            |
///            +------------+
/// ```
/// Latency 1. A carry out of bit `B - 1` is lost.
#[derive(LogicBlock, Default, Clone, Debug)]
pub struct IntAdd<const B: usize, const T: usize> {
    /// Clock.
    pub clk_i: Signal<In, Clock>,
    /// Enable; low holds.
    pub en_i: Signal<In, Bit>,
    /// Operands are valid.
    pub valid_i: Signal<In, Bit>,
    /// Tag of this operation.
    pub tag_i: Signal<In, Bits<T>>,
    /// First operand.
    pub a_i: Signal<In, Bits<B>>,
    /// Second operand.
    pub b_i: Signal<In, Bits<B>>,
    /// Sum is valid.
    pub valid_o: Signal<Out, Bit>,
    /// Tag of the sum.
    pub tag_o: Signal<Out, Bits<T>>,
    /// Sum.
    pub sum_o: Signal<Out, Bits<B>>,
    valid: Dff<Bit>,
    tag: Dff<Bits<T>>,
    sum: Dff<Bits<B>>,
}

impl<const B: usize, const T: usize> Logic for IntAdd<B, T> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clk_i, valid, tag, sum);
        if self.en_i.val() {
            self.valid.d.next = self.valid_i.val();
            self.tag.d.next = self.tag_i.val();
            self.sum.d.next = self.a_i.val() + self.b_i.val();
        }
        self.valid_o.next = self.valid.q.val();
        self.tag_o.next = self.tag.q.val();
        self.sum_o.next = self.sum.q.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("int_add", &format!("w{B}_t{T}"))
    }
}
