//! Right shift that remembers whether it lost anything.

use crate::blocks::module;
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// `result = value >> amount`, with its last bit set too if a one was shifted out.
///
/// ```text
///             +---------------+
///  value_i -->| N           N |--> result_o
/// amount_i -->| A StickyShift |
///             +---------------+
/// ```
/// Combinational: one multiplexer row for each bit of the amount, which may exceed `N`.
#[derive(LogicBlock, Clone, Debug)]
pub(super) struct StickyShift<const N: usize, const A: usize> {
    pub value_i: Signal<In, Bits<N>>,
    pub amount_i: Signal<In, Bits<A>>,
    pub result_o: Signal<Out, Bits<N>>,
    /// `2^i`, or `N` where that is less: the shift of row `i`.
    distance: [Constant<Bits<8>>; A],
    /// The bits that row `i` loses.
    lost_mask: [Constant<Bits<N>>; A],
    value: Signal<Local, Bits<N>>,
    lost: Signal<Local, Bits<N>>,
    sticky: Signal<Local, Bit>,
}

impl<const N: usize, const A: usize> Default for StickyShift<N, A> {
    fn default() -> Self {
        const { assert!(N < 64 && A < 64) };
        let distance = |i: usize| if i < 6 { N.min(1 << i) } else { N };
        module! {
            distance = std::array::from_fn(|i| Constant::new((distance(i) as u64).into())),
            lost_mask = std::array::from_fn(|i| Constant::new(((1u64 << distance(i)) - 1).into()));
            value_i, amount_i, result_o, value, lost, sticky,
        }
    }
}

impl<const N: usize, const A: usize> Logic for StickyShift<N, A> {
    #[hdl_gen]
    fn update(&mut self) {
        self.value.next = self.value_i.val();
        self.sticky.next = false;
        for i in 0..A {
            self.lost.next = self.value.val() & self.lost_mask[i].val();
            if self.amount_i.val().get_bit(i) {
                self.sticky.next = self.sticky.val() | self.lost.val().any();
                self.value.next = self.value.val() >> self.distance[i].val();
            }
        }
        if self.sticky.val() {
            self.value.next = self.value.val() | 1;
        }
        self.result_o.next = self.value.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("sticky_shift", &format!("w{N}_a{A}"))
    }
}
