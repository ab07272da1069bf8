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
/// Combinational: a binary search of five rows. For a zero value the count is 31 or less and means nothing.
#[derive(LogicBlock, Clone, Debug)]
pub(super) struct LeadingZeros<const S: usize, const X: usize> {
    pub value_i: Signal<In, Bits<S>>,
    pub count_o: Signal<Out, Bits<X>>,
    /// `2^(4 - i)`: the shift of row `i`.
    distance: [Constant<Bits<X>>; ROWS],
    /// A value below this has at least `distance[i]` leading zeros; zero where that is all of the bits or more.
    limit: [Constant<Bits<S>>; ROWS],
    value: Signal<Local, Bits<S>>,
    count: Signal<Local, Bits<X>>,
}

/// Enough for every significand up to 31 bits.
const ROWS: usize = 5;

impl<const S: usize, const X: usize> Default for LeadingZeros<S, X> {
    fn default() -> Self {
        const { assert!(S < 32) };
        let distance = |i: usize| 1usize << (ROWS - 1 - i);
        // A row that is too far for the value never shifts, so that its distance is free.
        let reachable = |i: usize| distance(i) < S;
        module! {
            distance = std::array::from_fn(|i| {
                Constant::new((if reachable(i) { distance(i) as u64 } else { 0 }).into())
            }),
            limit = std::array::from_fn(|i| {
                Constant::new((if reachable(i) { 1u64 << (S - distance(i)) } else { 0 }).into())
            });
            value_i, count_o, value, count,
        }
    }
}

impl<const S: usize, const X: usize> Logic for LeadingZeros<S, X> {
    #[hdl_gen]
    fn update(&mut self) {
        self.value.next = self.value_i.val();
        self.count.next = 0.into();
        for i in 0..5 {
            if self.value.val() < self.limit[i].val() {
                self.value.next = self.value.val() << self.distance[i].val();
                self.count.next = self.count.val() + self.distance[i].val();
            }
        }
        self.count_o.next = self.count.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("leading_zeros", &format!("w{S}_x{X}"))
    }
}
