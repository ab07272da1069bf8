//! Last three stages of the dual-split pipeline: folds the plane distances into the interval, compares, forms the
//! offsets and selects the return value.
//!
//! | cycle | work |
//! |---|---|
//! | 6 | route the distances by role; combine two exits (minimum) or two entries (maximum) of a dual carve |
//! | 7 | `lower = max(t_min, entry)`, `upper = min(t_max, exit)` |
//! | 8 | near child: `t_min <= upper`; carve: `lower <= upper`; far child: `lower <= t_max`; second offset |
//!
//! The comparators' registers end cycle 8; behind them, one 2:1 multiplexer selects each output.
//!
//! | node | code | near slot | far slot |
//! |---|---|---|---|
//! | split, both accepted | 2 | near child, `t_min..upper` | far child, `lower..t_max` |
//! | split, near accepted | 1 | near child, `t_min..upper` | |
//! | split, far accepted | 1 | far child, `lower..t_max` | |
//! | carve, `lower <= upper` | 1, or 3 with the leaf bit | child or triangle, `lower..upper` | |
//! | bare leaf | 3 | triangle, `t_min..t_max` | |
//! | otherwise | 0 | | |
//!
//! A slot without entry, and the far slot of every code but 2, holds some value that means nothing.

use super::node_header::NodeHeader;
use super::ports::Step;
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::{ClockEnable, Delay, Dff, dff_setup};
use units::widths::format;
use units::{IntAdd, fp_cmp, fp_min_max};

/// Fold, comparison, offset and return-value logic.
///
/// ```text
///               +---------------+
///  t_0_i ------>| W           2 |---> code_o
///  t_1_i ------>| W          32 |---> near_offset_o
///  exit_*_i --->| 1         W,W |---> near_t_min_o, near_t_max_o
///  header_i --->| 32         32 |---> far_offset_o
///  t_min_i ---->| W         W,W |---> far_t_min_o, far_t_max_o
///  t_max_i ---->| W             |
///               | DualSplitFold |
///               +---------------+
/// ```
/// Latency 3.
#[derive(LogicBlock, Default, Clone, Debug)]
pub(super) struct DualSplitFold<const E: usize, const S: usize, const W: usize> {
    pub clocking: ClockEnable,
    pub valid_i: Signal<In, Bit>,
    pub t_0_i: Signal<In, Bits<W>>,
    pub t_1_i: Signal<In, Bits<W>>,
    pub exit_0_i: Signal<In, Bit>,
    pub exit_1_i: Signal<In, Bit>,
    pub header_i: Signal<In, Bits<32>>,
    pub t_min_i: Signal<In, Bits<W>>,
    pub t_max_i: Signal<In, Bits<W>>,
    pub valid_o: Signal<Out, Bit>,
    pub step: Step<W>,

    // Cycle 6.
    route_exit: Signal<Local, Bits<W>>,
    route_entry: Signal<Local, Bits<W>>,
    combine: fp_min_max!(),
    exit_t: Dff<Bits<W>>,
    entry_t: Dff<Bits<W>>,
    two_exits: Dff<Bit>,
    two_entries: Dff<Bit>,
    t_min_6: Dff<Bits<W>>,
    t_max_6: Dff<Bits<W>>,

    // Cycle 7.
    latest_entry: Signal<Local, Bits<W>>,
    earliest_exit: Signal<Local, Bits<W>>,
    runs_down: Signal<Local, Bits<1>>,
    fold_entry: fp_min_max!(),
    fold_exit: fp_min_max!(),
    header_wait: Delay<32, 2>,
    downward: Delay<1, 3>,
    t_min_7: Dff<Bits<W>>,
    t_max_7: Dff<Bits<W>>,

    // Cycle 8.
    near_start: Signal<Local, Bits<W>>,
    accept_near: fp_cmp!(),
    accept_far: fp_cmp!(),
    second_offset: IntAdd<32, 1>,
    fields: NodeHeader,
    first_offset: Dff<Bits<32>>,
    carve: Dff<Bit>,
    leaf: Dff<Bit>,
    lower: Dff<Bits<W>>,
    upper: Dff<Bits<W>>,
    t_min_8: Dff<Bits<W>>,
    t_max_8: Dff<Bits<W>>,

    // Output selection.
    is_split: Signal<Local, Bit>,
    near: Signal<Local, Bit>,
    far: Signal<Local, Bit>,
    negative: Signal<Local, Bit>,
    code: Signal<Local, Bits<2>>,
    near_offset: Signal<Local, Bits<32>>,
    near_t_min: Signal<Local, Bits<W>>,
    near_t_max: Signal<Local, Bits<W>>,
    far_offset: Signal<Local, Bits<32>>,
}

impl<const E: usize, const S: usize, const W: usize> Logic for DualSplitFold<E, S, W> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(
            self,
            clocking.clk_i,
            exit_t,
            entry_t,
            two_exits,
            two_entries,
            t_min_6,
            t_max_6,
            t_min_7,
            t_max_7
        );
        dff_setup!(self, clocking.clk_i, first_offset, carve, leaf, lower, upper, t_min_8, t_max_8);

        // Cycle 6: a bound that no plane moves is folded with itself.
        self.route_exit.next = self.t_1_i.val();
        self.route_entry.next = self.t_0_i.val();
        if self.exit_0_i.val() {
            self.route_exit.next = self.t_0_i.val();
            self.route_entry.next = self.t_1_i.val();
            if self.exit_1_i.val() {
                self.route_entry.next = self.t_min_i.val();
            }
        } else if !self.exit_1_i.val() {
            self.route_exit.next = self.t_max_i.val();
        }
        ClockEnable::link(&mut self.clocking, &mut self.combine.clocking);
        self.combine.valid_i.next = self.valid_i.val();
        self.combine.tag_i.next = 0.into();
        self.combine.a_i.next = self.t_0_i.val();
        self.combine.b_i.next = self.t_1_i.val();
        self.combine.maximum_i.next = !self.exit_0_i.val();
        self.combine.propagate_nan_i.next = false;

        // Cycle 7: fold.
        ClockEnable::link(&mut self.clocking, &mut self.fold_entry.clocking);
        self.fold_entry.valid_i.next = self.combine.valid_o.val();
        self.fold_entry.tag_i.next = 0.into();
        self.fold_entry.a_i.next = self.t_min_6.q.val();
        self.latest_entry.next = self.entry_t.q.val();
        if self.two_entries.q.val() {
            self.latest_entry.next = self.combine.result_o.val();
        }
        self.fold_entry.b_i.next = self.latest_entry.val();
        self.fold_entry.maximum_i.next = true;
        self.fold_entry.propagate_nan_i.next = false;
        ClockEnable::link(&mut self.clocking, &mut self.fold_exit.clocking);
        self.fold_exit.valid_i.next = self.combine.valid_o.val();
        self.fold_exit.tag_i.next = 0.into();
        self.fold_exit.a_i.next = self.t_max_6.q.val();
        self.earliest_exit.next = self.exit_t.q.val();
        if self.two_exits.q.val() {
            self.earliest_exit.next = self.combine.result_o.val();
        }
        self.fold_exit.b_i.next = self.earliest_exit.val();
        self.fold_exit.maximum_i.next = false;
        self.fold_exit.propagate_nan_i.next = false;
        ClockEnable::link(&mut self.clocking, &mut self.header_wait.clocking);
        self.header_wait.d_i.next = self.header_i.val();
        self.fields.header_i.next = self.header_wait.q_o.val();
        ClockEnable::link(&mut self.clocking, &mut self.downward.clocking);
        self.runs_down.next = 0.into();
        if !self.exit_0_i.val() {
            self.runs_down.next = 1.into();
        }
        self.downward.d_i.next = self.runs_down.val();

        // Cycle 8: compare, and add the size of the left child to its offset.
        ClockEnable::link(&mut self.clocking, &mut self.accept_near.clocking);
        self.accept_near.valid_i.next = self.fold_entry.valid_o.val();
        self.accept_near.tag_i.next = 0.into();
        self.near_start.next = self.t_min_7.q.val();
        if self.fields.carve_o.val() {
            self.near_start.next = self.fold_entry.result_o.val();
        }
        self.accept_near.a_i.next = self.near_start.val();
        self.accept_near.b_i.next = self.fold_exit.result_o.val();
        ClockEnable::link(&mut self.clocking, &mut self.accept_far.clocking);
        self.accept_far.valid_i.next = self.fold_exit.valid_o.val();
        self.accept_far.tag_i.next = 0.into();
        self.accept_far.a_i.next = self.fold_entry.result_o.val();
        self.accept_far.b_i.next = self.t_max_7.q.val();
        ClockEnable::link(&mut self.clocking, &mut self.second_offset.clocking);
        self.second_offset.valid_i.next = self.fold_entry.valid_o.val();
        self.second_offset.tag_i.next = 0.into();
        self.second_offset.a_i.next = self.fields.offset_o.val();
        self.second_offset.b_i.next = bit_cast::<32, 2>(self.fields.size_o.val());

        if self.clocking.en_i.val() {
            self.exit_t.d.next = self.route_exit.val();
            self.entry_t.d.next = self.route_entry.val();
            self.two_exits.d.next = self.exit_0_i.val() & self.exit_1_i.val();
            self.two_entries.d.next = !self.exit_0_i.val() & !self.exit_1_i.val();
            self.t_min_6.d.next = self.t_min_i.val();
            self.t_max_6.d.next = self.t_max_i.val();
            self.t_min_7.d.next = self.t_min_6.q.val();
            self.t_max_7.d.next = self.t_max_6.q.val();
            self.first_offset.d.next = self.fields.offset_o.val();
            self.carve.d.next = self.fields.carve_o.val();
            self.leaf.d.next = self.fields.leaf_o.val();
            self.lower.d.next = self.fold_entry.result_o.val();
            self.upper.d.next = self.fold_exit.result_o.val();
            self.t_min_8.d.next = self.t_min_7.q.val();
            self.t_max_8.d.next = self.t_max_7.q.val();
        }

        // Output selection.
        self.is_split.next = !self.carve.q.val() & !self.leaf.q.val();
        self.near.next = self.accept_near.le_o.val();
        self.far.next = self.accept_far.le_o.val();
        self.negative.next = self.downward.q_o.val().any();
        self.code.next = 0.into();
        if self.is_split.val() {
            if self.near.val() | self.far.val() {
                self.code.next = 1.into();
            }
            if self.near.val() & self.far.val() {
                self.code.next = 2.into();
            }
        } else if self.leaf.q.val() {
            if !self.carve.q.val() | self.near.val() {
                self.code.next = 3.into();
            }
        } else if self.near.val() {
            self.code.next = 1.into();
        }
        // A ray that runs downwards meets the right child, which has the second offset, first.
        self.near_offset.next = self.first_offset.q.val();
        if self.is_split.val() & (self.near.val() == self.negative.val()) {
            self.near_offset.next = self.second_offset.sum_o.val();
        }
        self.near_t_min.next = self.t_min_8.q.val();
        if self.carve.q.val() | (self.is_split.val() & !self.near.val()) {
            self.near_t_min.next = self.lower.q.val();
        }
        self.near_t_max.next = self.t_max_8.q.val();
        if self.carve.q.val() | (self.is_split.val() & self.near.val()) {
            self.near_t_max.next = self.upper.q.val();
        }
        self.far_offset.next = self.second_offset.sum_o.val();
        if self.negative.val() {
            self.far_offset.next = self.first_offset.q.val();
        }
        self.step.code_o.next = self.code.val();
        self.step.near_offset_o.next = self.near_offset.val();
        self.step.near_t_min_o.next = self.near_t_min.val();
        self.step.near_t_max_o.next = self.near_t_max.val();
        self.step.far_offset_o.next = self.far_offset.val();
        self.step.far_t_min_o.next = self.lower.q.val();
        self.step.far_t_max_o.next = self.t_max_8.q.val();
        self.valid_o.next = self.accept_near.valid_o.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("dual_split_fold", &format::<E, S>().systematic_name())
    }
}
