//! Counts the zeros above the leading one.

use crate::blocks::module;
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// `count` = number of clear bits above the highest set bit of `value`.
///
/// ```text
///            +--------------+
/// value_i -->| S          X |--> count_o
///            | LeadingZeros |
///            +--------------+
/// ```
/// Combinational: a binary search of five rows. For a zero value the count means nothing.
///
/// Row `i` asks whether the upper `2^(4 - i)` bits are zero. The answers for all places, of which each row needs one, are known before
/// the search (`any`), so that a row waits for the row above but for no gathering of bits.
#[derive(LogicBlock, Clone, Debug)]
pub(super) struct LeadingZeros<const S: usize, const X: usize> {
    pub value_i: Signal<In, Bits<S>>,
    pub count_o: Signal<Out, Bits<X>>,
    top_index: Constant<Bits<8>>,
    /// `2^(4 - i)`: the shift of row `i`.
    distance: [Constant<Bits<X>>; ROWS],
    /// Bit `j` of `any[i]` is set if one of the value's bits `j` down to `j + 1 - 2^(4 - i)` is; row `i` has shifted it.
    any: [Signal<Local, Bits<S>>; ROWS],
    count: Signal<Local, Bits<X>>,
}

/// Enough for every significand up to 31 bits.
const ROWS: usize = 5;

impl<const S: usize, const X: usize> Default for LeadingZeros<S, X> {
    fn default() -> Self {
        const { assert!(S < 32 && X >= ROWS) };
        module! {
            top_index = Constant::new((S as u64 - 1).into()),
            distance = std::array::from_fn(|i| Constant::new((1u64 << (ROWS - 1 - i)).into()));
            value_i, count_o, any, count,
        }
    }
}

impl<const S: usize, const X: usize> Logic for LeadingZeros<S, X> {
    #[hdl_gen]
    fn update(&mut self) {
        self.any[4].next = self.value_i.val();
        self.any[3].next = self.any[4].val() | (self.any[4].val() << 1);
        self.any[2].next = self.any[3].val() | (self.any[3].val() << 2);
        self.any[1].next = self.any[2].val() | (self.any[2].val() << 4);
        self.any[0].next = self.any[1].val() | (self.any[1].val() << 8);
        self.count.next = 0.into();
        for i in 0..5 {
            if !self.any[i].val().get_bit(self.top_index.val().index()) {
                for j in 0..5 {
                    self.any[j].next = self.any[j].val() << self.distance[i].val();
                }
                self.count.next = self.count.val() | self.distance[i].val();
            }
        }
        self.count_o.next = self.count.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("leading_zeros", &format!("w{S}_x{X}"))
    }
}
