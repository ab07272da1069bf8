//! The dual-split pipeline: one step of dual-split-tree traversal per cycle.
//!
//! The distance to each of a node's two planes is `t = (plane - origin[axis]) * inv[axis]`, with the reciprocal of the
//! plane's role (exit or entry), every operation rounded to nearest even and none fused. All node types flow through
//! the same units; multiplexers select operands and results, and nothing branches. What a step computes bit for
//! bit is stated by [`golden::dst::step()`].
//!
//! | cycle | work | units |
//! |---|---|---|
//! | 1 | decode, ray-component and plane selection | (2 FPCMP with `C = 2`) |
//! | 2, 3 | `plane - origin` | 2 FPADD |
//! | 4, 5 | `* inv` | 2 FPMUL |
//! | 6 | combine two exits or two entries | 1 FPMIN/MAX |
//! | 7 | fold into the interval | 2 FPMIN/MAX |
//! | 8 | compare, second offset, return value | 2 FPCMP, 1 INTADD |
//!
//! `C = 2` is the inventory of Lin, Vasiou, Yuksel, Kopta, Brunvand, "Hardware-Accelerated Dual-Split Trees", HPG 2020:
//! 1 INTADD, 2 FPADD, 2 FPMUL, 3 FPMIN/MAX, 4 FPCMP in 8 cycles. `C = 0` leaves out the two comparators that the sign bits
//! make redundant (see `DualSplitSelect`); its outputs are the same for every input.
//!
//! | `code_o` | meaning | near slot | far slot |
//! |---|---|---|---|
//! | 0 | miss | | |
//! | 1 | one child | the child | |
//! | 2 | two children | the nearer | the farther |
//! | 3 | leaf | first triangle | |

use super::dual_split_fold::DualSplitFold;
use super::dual_split_select::DualSplitSelect;
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::Delay;
use units::widths::format;
use units::{FpAdd, FpMul};

/// One traversal step of a dual-split tree.
///
/// ```text
///                       +--------------------+
/// header_i ------------>| 32               2 |---> code_o
/// plane_0_i, plane_1_i ->| W               32 |---> near_offset_o
/// origin_{x,y,z}_i ---->| W                W |---> near_t_min_o, near_t_max_o
/// inv_entry_{x,y,z}_i ->| W               32 |---> far_offset_o
/// inv_exit_{x,y,z}_i -->| W                W |---> far_t_min_o, far_t_max_o
/// t_min_i, t_max_i ---->| W                  |
/// valid_i ------------->|                    |---> valid_o
/// tag_i --------------->| T                T |---> tag_o
/// en_i, clk_i --------->| DualSplitPipeline  |
///                       +--------------------+
/// ```
/// Latency 8, one node per cycle. `header_i`, `plane_0_i` and `plane_1_i` are a node's three words. The outputs other
/// than `valid_o` and `tag_o` come through one 2:1 multiplexer behind the last registers.
#[derive(LogicBlock, Default, Clone, Debug)]
pub struct DualSplitPipeline<
    const E: usize,
    const S: usize,
    const W: usize,
    const X: usize,
    const R: usize,
    const N: usize,
    const P: usize,
    const C: usize,
    const T: usize,
> {
    /// Clock.
    pub clk_i: Signal<In, Clock>,
    /// Enable; low holds.
    pub en_i: Signal<In, Bit>,
    /// Node and ray are valid.
    pub valid_i: Signal<In, Bit>,
    /// Tag of this step.
    pub tag_i: Signal<In, Bits<T>>,
    /// The node's first word.
    pub header_i: Signal<In, Bits<32>>,
    /// The node's second word: plane 0.
    pub plane_0_i: Signal<In, Bits<W>>,
    /// The node's third word: plane 1.
    pub plane_1_i: Signal<In, Bits<W>>,
    /// Ray origin, x.
    pub origin_x_i: Signal<In, Bits<W>>,
    /// Ray origin, y.
    pub origin_y_i: Signal<In, Bits<W>>,
    /// Ray origin, z.
    pub origin_z_i: Signal<In, Bits<W>>,
    /// Reciprocal of the direction for entry planes, x.
    pub inv_entry_x_i: Signal<In, Bits<W>>,
    /// Reciprocal of the direction for entry planes, y.
    pub inv_entry_y_i: Signal<In, Bits<W>>,
    /// Reciprocal of the direction for entry planes, z.
    pub inv_entry_z_i: Signal<In, Bits<W>>,
    /// Reciprocal of the direction for exit planes, x.
    pub inv_exit_x_i: Signal<In, Bits<W>>,
    /// Reciprocal of the direction for exit planes, y.
    pub inv_exit_y_i: Signal<In, Bits<W>>,
    /// Reciprocal of the direction for exit planes, z.
    pub inv_exit_z_i: Signal<In, Bits<W>>,
    /// Start of the interval inside the node.
    pub t_min_i: Signal<In, Bits<W>>,
    /// End of the interval inside the node.
    pub t_max_i: Signal<In, Bits<W>>,
    /// Result is valid.
    pub valid_o: Signal<Out, Bit>,
    /// Tag of the result.
    pub tag_o: Signal<Out, Bits<T>>,
    /// Return value.
    pub code_o: Signal<Out, Bits<2>>,
    /// Near slot: offset in words, or first triangle.
    pub near_offset_o: Signal<Out, Bits<32>>,
    /// Near slot: start of the interval.
    pub near_t_min_o: Signal<Out, Bits<W>>,
    /// Near slot: end of the interval.
    pub near_t_max_o: Signal<Out, Bits<W>>,
    /// Far slot: offset in words.
    pub far_offset_o: Signal<Out, Bits<32>>,
    /// Far slot: start of the interval.
    pub far_t_min_o: Signal<Out, Bits<W>>,
    /// Far slot: end of the interval.
    pub far_t_max_o: Signal<Out, Bits<W>>,

    select: DualSplitSelect<E, S, W, C>,
    subtract: [FpAdd<E, S, W, X, R, N, 1>; 2],
    multiply: [FpMul<E, S, W, X, R, P, 1>; 2],
    fold: DualSplitFold<E, S, W>,
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
    const C: usize,
    const T: usize,
> Logic for DualSplitPipeline<E, S, W, X, R, N, P, C, T>
{
    #[hdl_gen]
    fn update(&mut self) {
        // Cycle 1: decode and select.
        self.select.clk_i.next = self.clk_i.val();
        self.select.en_i.next = self.en_i.val();
        self.select.valid_i.next = self.valid_i.val();
        self.select.header_i.next = self.header_i.val();
        self.select.plane_0_i.next = self.plane_0_i.val();
        self.select.plane_1_i.next = self.plane_1_i.val();
        self.select.origin_x_i.next = self.origin_x_i.val();
        self.select.origin_y_i.next = self.origin_y_i.val();
        self.select.origin_z_i.next = self.origin_z_i.val();
        self.select.inv_entry_x_i.next = self.inv_entry_x_i.val();
        self.select.inv_entry_y_i.next = self.inv_entry_y_i.val();
        self.select.inv_entry_z_i.next = self.inv_entry_z_i.val();
        self.select.inv_exit_x_i.next = self.inv_exit_x_i.val();
        self.select.inv_exit_y_i.next = self.inv_exit_y_i.val();
        self.select.inv_exit_z_i.next = self.inv_exit_z_i.val();
        self.select.t_min_i.next = self.t_min_i.val();
        self.select.t_max_i.next = self.t_max_i.val();

        // Cycles 2 to 5: distances.
        for i in 0..2 {
            self.subtract[i].clk_i.next = self.clk_i.val();
            self.subtract[i].en_i.next = self.en_i.val();
            self.subtract[i].valid_i.next = self.select.valid_o.val();
            self.subtract[i].tag_i.next = 0.into();
            self.subtract[i].a_i.next = self.select.plane_o[i].val();
            self.subtract[i].b_i.next = self.select.origin_o[i].val();
            self.subtract[i].subtract_i.next = true;
            self.subtract[i].rounding_i.next = 0.into();
            self.multiply[i].clk_i.next = self.clk_i.val();
            self.multiply[i].en_i.next = self.en_i.val();
            self.multiply[i].valid_i.next = self.subtract[i].valid_o.val();
            self.multiply[i].tag_i.next = 0.into();
            self.multiply[i].a_i.next = self.subtract[i].result_o.val();
            self.multiply[i].b_i.next = self.select.inv_o[i].val();
            self.multiply[i].rounding_i.next = 0.into();
        }

        // Cycles 6 to 8: fold, compare, return.
        self.fold.clk_i.next = self.clk_i.val();
        self.fold.en_i.next = self.en_i.val();
        self.fold.valid_i.next = self.multiply[0].valid_o.val();
        self.fold.t_0_i.next = self.multiply[0].result_o.val();
        self.fold.t_1_i.next = self.multiply[1].result_o.val();
        self.fold.exit_0_i.next = self.select.exit_o[0].val();
        self.fold.exit_1_i.next = self.select.exit_o[1].val();
        self.fold.header_i.next = self.select.header_o.val();
        self.fold.t_min_i.next = self.select.t_min_o.val();
        self.fold.t_max_i.next = self.select.t_max_o.val();
        self.tag.clk_i.next = self.clk_i.val();
        self.tag.en_i.next = self.en_i.val();
        self.tag.d_i.next = self.tag_i.val();
        self.valid_o.next = self.fold.valid_o.val();
        self.tag_o.next = self.tag.q_o.val();
        self.code_o.next = self.fold.code_o.val();
        self.near_offset_o.next = self.fold.near_offset_o.val();
        self.near_t_min_o.next = self.fold.near_t_min_o.val();
        self.near_t_max_o.next = self.fold.near_t_max_o.val();
        self.far_offset_o.next = self.fold.far_offset_o.val();
        self.far_t_min_o.next = self.fold.far_t_min_o.val();
        self.far_t_max_o.next = self.fold.far_t_max_o.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("dual_split", &format!("{}_c{C}_t{T}", format::<E, S>().systematic_name()))
    }
}
