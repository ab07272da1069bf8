//! Integer adder: forms the second child's offset.

use crate::blocks::{ClockEnable, Dff, Valid, dff_setup};
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
///
/// Two operations with one stall:
///
/// ```text
/// cycle      0   1   2   3   4
/// clk_i      ~\_/~\_/~\_/~\_/~\_/
/// en_i       ~~~~~~~~\___/~~~~~~~
/// valid_i    ~~~~~~~~\___________
/// a_i, b_i   X A X B X-----------
/// valid_o    ____/~~~~~~~~~~~\___
/// sum_o      ----X A X B     X---
/// ```
///
/// The same in the simulator:
///
/// ```
/// use units::clocking::Clocked;
///
/// let mut unit = units::IntAdd::<8, 1>::default();
/// let operands = [(20u64, 22), (255, 2)];
/// let mut shown = Vec::new();
/// for cycle in 0..4 {
///     unit.clocking.en_i.next = cycle != 2;
///     unit.valid_i.next = cycle < 2;
///     let (a, b) = operands[cycle % 2];
///     unit.a_i.next = a.into();
///     unit.b_i.next = b.into();
///     unit.tick();
///     shown.push(unit.valid_o.val().then(|| unit.sum_o.val().to_u64()));
/// }
/// assert_eq!(shown, [Some(42), Some(1), Some(1), None]);
/// ```
#[derive(LogicBlock, Default, Clone, Debug)]
pub struct IntAdd<const B: usize, const T: usize> {
    /// Clock and enable.
    pub clocking: ClockEnable,
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
    valid: Valid,
    tag: Dff<Bits<T>>,
    sum: Dff<Bits<B>>,
}

impl<const B: usize, const T: usize> Logic for IntAdd<B, T> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clocking.clk_i, valid, tag, sum);
        if self.clocking.en_i.val() {
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
