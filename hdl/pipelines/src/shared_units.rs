//! The multiprocessor's shared arithmetic: eight adders and eight multipliers that its threads use singly, or of
//! which a subset is routed at run time into one of the pipelines.
//!
//! | `mode_i` | adders and multipliers of the pipeline | left to the threads, of each |
//! |---|---|---|
//! | 0 | none | 0 to 7 |
//! | 1, ray-box | 0 to 5 | 6, 7 |
//! | 2, dual-split | 0, 1 | 2 to 7 |
//!
//! (Lin, Vasiou, Yuksel, Kopta, Brunvand, "Hardware-Accelerated Dual-Split Trees", HPG 2020; the code 3 is reserved and acts
//! as 0.) Minimum, maximum, comparison and selection belong to the pipelines alone. What sharing costs is the
//! multiplexers in front of the units: a unit that both pipelines use has three sources for each operand, one that
//! only the ray-box pipeline uses has two, and units 6 and 7 have none.

use super::dual_split_fold::DualSplitFold;
use super::dual_split_select::DualSplitSelect;
use super::ports::{Bounds, Interval, Node, Ray, Reciprocals, Step};
use super::ray_box_fold::RayBoxFold;
use super::ray_box_select::RayBoxSelect;
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::{ClockEnable, Delay};
use units::widths::format;
use units::{FpAdd, FpMul};

/// Eight adders and eight multipliers with the routing of both pipelines.
///
/// ```text
///                           +-------------+
/// mode_i ------------------>| 2         W |---> add_result_o[8]    threads' operations
/// add_a_i[8], add_b_i[8] -->| W         W |---> mul_result_o[8]
/// add_subtract_i[8] ------->| 1         T |---> add_tag_o[8], mul_tag_o[8]
/// mul_a_i[8], mul_b_i[8] -->| W         1 |---> add_valid_o[8], mul_valid_o[8]
/// add_tag_i, mul_tag_i[8] ->| T           |
/// add_valid_i[8], mul_* --->| 1           |
/// header_i, plane_*_i ----->| 32, W     1 |---> node_valid_o       DualSplitPipeline's outputs
/// box_*_*_i --------------->| W         1 |---> box_valid_o        RayBoxPipeline's outputs
/// origin_*_i, inv_*_*_i --->| W         T |---> tag_o              of whichever pipeline it is
/// t_min_i, t_max_i -------->| W           |
/// valid_i, tag_i ---------->| 1, T        |
/// en_i, clk_i ------------->| SharedUnits |
///                           +-------------+
/// ```
/// Threads' operations have latency 2, the pipelines 8; all round to nearest even. `mode_i` may change only while nothing
/// is in flight. An operation that a thread starts on a unit that the pipeline has is lost: its result is not valid.
#[derive(LogicBlock, Default, Clone, Debug)]
pub struct SharedUnits<
    const E: usize,
    const S: usize,
    const W: usize,
    const X: usize,
    const R: usize,
    const N: usize,
    const P: usize,
    const T: usize,
> {
    /// Clock and enable.
    pub clocking: ClockEnable,
    /// Routing.
    pub mode_i: Signal<In, Bits<2>>,
    /// Threads: addition is valid.
    pub add_valid_i: [Signal<In, Bit>; 8],
    /// Threads: tag of the addition.
    pub add_tag_i: [Signal<In, Bits<T>>; 8],
    /// Threads: first operand of the addition.
    pub add_a_i: [Signal<In, Bits<W>>; 8],
    /// Threads: second operand of the addition.
    pub add_b_i: [Signal<In, Bits<W>>; 8],
    /// Threads: subtract.
    pub add_subtract_i: [Signal<In, Bit>; 8],
    /// Threads: multiplication is valid.
    pub mul_valid_i: [Signal<In, Bit>; 8],
    /// Threads: tag of the multiplication.
    pub mul_tag_i: [Signal<In, Bits<T>>; 8],
    /// Threads: first factor.
    pub mul_a_i: [Signal<In, Bits<W>>; 8],
    /// Threads: second factor.
    pub mul_b_i: [Signal<In, Bits<W>>; 8],
    /// Pipeline: operands are valid.
    pub valid_i: Signal<In, Bit>,
    /// Pipeline: tag of this operation.
    pub tag_i: Signal<In, Bits<T>>,
    /// Node.
    pub node: Node<W>,
    /// Box.
    pub bounds: Bounds<W>,
    /// Ray.
    pub ray: Ray<W>,
    /// Threads: sum is valid.
    pub add_valid_o: [Signal<Out, Bit>; 8],
    /// Threads: tag of the sum.
    pub add_tag_o: [Signal<Out, Bits<T>>; 8],
    /// Threads: sum.
    pub add_result_o: [Signal<Out, Bits<W>>; 8],
    /// Threads: product is valid.
    pub mul_valid_o: [Signal<Out, Bit>; 8],
    /// Threads: tag of the product.
    pub mul_tag_o: [Signal<Out, Bits<T>>; 8],
    /// Threads: product.
    pub mul_result_o: [Signal<Out, Bits<W>>; 8],
    /// Pipeline: tag of the result.
    pub tag_o: Signal<Out, Bits<T>>,
    /// Dual-split: result is valid.
    pub node_valid_o: Signal<Out, Bit>,
    /// What the step returns.
    pub step: Step<W>,
    /// Ray-box: result is valid.
    pub box_valid_o: Signal<Out, Bit>,
    /// Ray-box: the ray meets the box inside its interval.
    pub hit_o: Signal<Out, Bit>,
    /// Ray-box: where it enters.
    pub t_entry_o: Signal<Out, Bits<W>>,

    ray_box: Signal<Local, Bit>,
    dual_split: Signal<Local, Bit>,
    plane: [Signal<Local, Bits<W>>; 6],
    origin: [Signal<Local, Bits<W>>; 6],
    taken: [Signal<Local, Bit>; 8],
    add_valid: [Signal<Local, Bit>; 8],
    add_a: [Signal<Local, Bits<W>>; 8],
    add_b: [Signal<Local, Bits<W>>; 8],
    add_subtract: [Signal<Local, Bit>; 8],
    mul_valid: [Signal<Local, Bit>; 8],
    mul_a: [Signal<Local, Bits<W>>; 8],
    mul_b: [Signal<Local, Bits<W>>; 8],
    add: [FpAdd<E, S, W, X, R, N, T>; 8],
    mul: [FpMul<E, S, W, X, R, P, T>; 8],
    box_select: RayBoxSelect<W>,
    box_fold: RayBoxFold<E, S, W, 2>,
    node_select: DualSplitSelect<E, S, W, 2>,
    node_fold: DualSplitFold<E, S, W>,
    tag: Delay<T, 8>,
}

impl<
    const E: usize,
    const S: usize,
    const W: usize,
    const X: usize,
    const R: usize,
    const N: usize,
    const P: usize,
    const T: usize,
> Logic for SharedUnits<E, S, W, X, R, N, P, T>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.ray_box.next = self.mode_i.val() == 1;
        self.dual_split.next = self.mode_i.val() == 2;

        // Ray and operands of both pipelines.
        self.plane[0].next = self.bounds.box_min_x_i.val();
        self.plane[1].next = self.bounds.box_min_y_i.val();
        self.plane[2].next = self.bounds.box_min_z_i.val();
        self.plane[3].next = self.bounds.box_max_x_i.val();
        self.plane[4].next = self.bounds.box_max_y_i.val();
        self.plane[5].next = self.bounds.box_max_z_i.val();
        self.origin[0].next = self.ray.origin.origin_x_i.val();
        self.origin[1].next = self.ray.origin.origin_y_i.val();
        self.origin[2].next = self.ray.origin.origin_z_i.val();
        self.origin[3].next = self.ray.origin.origin_x_i.val();
        self.origin[4].next = self.ray.origin.origin_y_i.val();
        self.origin[5].next = self.ray.origin.origin_z_i.val();
        ClockEnable::link(&mut self.clocking, &mut self.box_select.clocking);
        Reciprocals::<W>::link(&mut self.ray.reciprocals, &mut self.box_select.reciprocals);
        Interval::<W>::link(&mut self.ray.interval, &mut self.box_select.interval);
        ClockEnable::link(&mut self.clocking, &mut self.node_select.clocking);
        self.node_select.valid_i.next = self.valid_i.val() & self.dual_split.val();
        Node::<W>::link(&mut self.node, &mut self.node_select.node);
        Ray::<W>::link(&mut self.ray, &mut self.node_select.ray);

        // The threads have every unit ...
        for i in 0..8 {
            self.add_valid[i].next = self.add_valid_i[i].val();
            self.add_a[i].next = self.add_a_i[i].val();
            self.add_b[i].next = self.add_b_i[i].val();
            self.add_subtract[i].next = self.add_subtract_i[i].val();
            self.mul_valid[i].next = self.mul_valid_i[i].val();
            self.mul_a[i].next = self.mul_a_i[i].val();
            self.mul_b[i].next = self.mul_b_i[i].val();
            self.taken[i].next = false;
        }
        // ... except six of each in ray-box mode ...
        for i in 0..6 {
            if self.ray_box.val() {
                self.add_valid[i].next = self.valid_i.val();
                self.add_a[i].next = self.plane[i].val();
                self.add_b[i].next = self.origin[i].val();
                self.add_subtract[i].next = true;
                self.mul_valid[i].next = self.add[i].valid_o.val();
                self.mul_a[i].next = self.add[i].result_o.val();
                self.mul_b[i].next = self.box_select.inv_o[i].val();
                self.taken[i].next = true;
            }
            self.box_fold.t_i[i].next = self.mul[i].result_o.val();
        }
        // ... and two of each in dual-split mode.
        for i in 0..2 {
            if self.dual_split.val() {
                self.add_valid[i].next = self.node_select.valid_o.val();
                self.add_a[i].next = self.node_select.plane_o[i].val();
                self.add_b[i].next = self.node_select.origin_o[i].val();
                self.add_subtract[i].next = true;
                self.mul_valid[i].next = self.add[i].valid_o.val();
                self.mul_a[i].next = self.add[i].result_o.val();
                self.mul_b[i].next = self.node_select.inv_o[i].val();
                self.taken[i].next = true;
            }
        }
        for i in 0..8 {
            ClockEnable::link(&mut self.clocking, &mut self.add[i].clocking);
            self.add[i].valid_i.next = self.add_valid[i].val();
            self.add[i].tag_i.next = self.add_tag_i[i].val();
            self.add[i].a_i.next = self.add_a[i].val();
            self.add[i].b_i.next = self.add_b[i].val();
            self.add[i].subtract_i.next = self.add_subtract[i].val();
            self.add[i].rounding_i.next = 0.into();
            self.add_valid_o[i].next = self.add[i].valid_o.val() & !self.taken[i].val();
            self.add_tag_o[i].next = self.add[i].tag_o.val();
            self.add_result_o[i].next = self.add[i].result_o.val();
            ClockEnable::link(&mut self.clocking, &mut self.mul[i].clocking);
            self.mul[i].valid_i.next = self.mul_valid[i].val();
            self.mul[i].tag_i.next = self.mul_tag_i[i].val();
            self.mul[i].a_i.next = self.mul_a[i].val();
            self.mul[i].b_i.next = self.mul_b[i].val();
            self.mul[i].rounding_i.next = 0.into();
            self.mul_valid_o[i].next = self.mul[i].valid_o.val() & !self.taken[i].val();
            self.mul_tag_o[i].next = self.mul[i].tag_o.val();
            self.mul_result_o[i].next = self.mul[i].result_o.val();
        }

        // Results of the pipelines.
        ClockEnable::link(&mut self.clocking, &mut self.box_fold.clocking);
        self.box_fold.valid_i.next = self.mul[0].valid_o.val() & self.ray_box.val();
        self.box_fold.t_min_i.next = self.box_select.t_min_o.val();
        self.box_fold.t_max_i.next = self.box_select.t_max_o.val();
        ClockEnable::link(&mut self.clocking, &mut self.node_fold.clocking);
        self.node_fold.valid_i.next = self.mul[0].valid_o.val() & self.dual_split.val();
        self.node_fold.t_0_i.next = self.mul[0].result_o.val();
        self.node_fold.t_1_i.next = self.mul[1].result_o.val();
        self.node_fold.exit_0_i.next = self.node_select.exit_o[0].val();
        self.node_fold.exit_1_i.next = self.node_select.exit_o[1].val();
        self.node_fold.header_i.next = self.node_select.header_o.val();
        self.node_fold.t_min_i.next = self.node_select.t_min_o.val();
        self.node_fold.t_max_i.next = self.node_select.t_max_o.val();
        ClockEnable::link(&mut self.clocking, &mut self.tag.clocking);
        self.tag.d_i.next = self.tag_i.val();
        self.tag_o.next = self.tag.q_o.val();
        self.node_valid_o.next = self.node_fold.valid_o.val();
        Step::<W>::link(&mut self.step, &mut self.node_fold.step);
        self.box_valid_o.next = self.box_fold.valid_o.val();
        self.hit_o.next = self.box_fold.hit_o.val();
        self.t_entry_o.next = self.box_fold.t_entry_o.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("shared_units", &format!("{}_t{T}", format::<E, S>().systematic_name()))
    }
}
