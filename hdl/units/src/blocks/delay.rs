//! Delay line: a value that has to wait for a unit's result.

use super::{ClockEnable, Dff, module};
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// `L` registers of `B` bits in a row.
///
/// ```text
///          +-------------+
///   d_i -->| B         B |--> q_o
///  en_i -->|  Delay B,L  |
/// clk_i -->|             |
///          +-------------+
/// ```
/// Latency `L` enabled cycles, `L >= 1`.
#[derive(LogicBlock, Clone, Debug)]
pub struct Delay<const B: usize, const L: usize> {
    /// Clock and enable.
    pub clocking: ClockEnable,
    /// Input.
    pub d_i: Signal<In, Bits<B>>,
    /// Input of `L` enabled cycles ago.
    pub q_o: Signal<Out, Bits<B>>,
    previous: Signal<Local, Bits<B>>,
    stage: [Dff<Bits<B>>; L],
}

impl<const B: usize, const L: usize> Default for Delay<B, L> {
    fn default() -> Self {
        const { assert!(L >= 1) };
        module! { stage = std::array::from_fn(|_| Dff::default()); clocking, d_i, q_o, previous }
    }
}

impl<const B: usize, const L: usize> Logic for Delay<B, L> {
    #[hdl_gen]
    fn update(&mut self) {
        self.previous.next = self.d_i.val();
        for i in 0..L {
            self.stage[i].clock.next = self.clocking.clk_i.val();
            self.stage[i].d.next = self.stage[i].q.val();
            if self.clocking.en_i.val() {
                self.stage[i].d.next = self.previous.val();
            }
            self.previous.next = self.stage[i].q.val();
        }
        self.q_o.next = self.previous.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("delay", &format!("w{B}_n{L}"))
    }
}
