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
use super::ports::{Node, Ray, Step};
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::{ClockEnable, Delay};
use units::widths::format;
use units::{fp_add, fp_mul};

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
///
/// ```text
/// cycle      0   1   2       8   9   10
/// clk_i      ~\_/~\_/~\_ ... ~\_/~\_/~\_/
/// en_i       ~~~~~~~~~~~ ... ~~~~~~~~~~~~
/// valid_i    ~~~~~~~~\__ ... ____________
/// node, ray  X A X B X-- ... ------------
/// valid_o    ___________ ... /~~~~~~~\___
/// step       ----------- ... X A X B X---
/// ```
///
/// A ray along x from the origin and a node that splits x at 1 (left child, 6 words ahead) and at 2 (right child, one word
/// behind it):
///
/// ```
/// use units::clocking::Clocked;
///
/// let word = |number: f32| u64::from(number.to_bits()).into();
/// let mut unit = pipelines::formats::binary32::DualSplitPipeline::default();
/// unit.clocking.en_i.next = true;
/// unit.valid_i.next = true;
/// unit.node.header_i.next = (1u64 << 27 | 6).into();
/// (unit.node.plane_0_i.next, unit.node.plane_1_i.next) = (word(1.0), word(2.0));
/// let inv = &mut unit.ray.reciprocals;
/// (inv.inv_entry_x_i.next, inv.inv_exit_x_i.next) = (word(1.0), word(1.0));
/// unit.ray.interval.t_max_i.next = word(10.0);
///
/// let latency_cycles = (1..20).find(|_| {
///     unit.tick();
///     unit.valid_o.val()
/// });
/// let step = &unit.step;
/// assert_eq!((latency_cycles, step.code_o.val().to_u8()), (Some(8), 2));
/// assert_eq!((step.near_offset_o.val().to_u32(), step.far_offset_o.val().to_u32()), (6, 7));
/// let bounds = [&step.near_t_min_o, &step.near_t_max_o, &step.far_t_min_o, &step.far_t_max_o];
/// assert_eq!(bounds.map(|bound| f32::from_bits(bound.val().to_u32())), [0.0, 1.0, 2.0, 10.0]);
/// ```
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
    /// Clock and enable.
    pub clocking: ClockEnable,
    /// Node and ray are valid.
    pub valid_i: Signal<In, Bit>,
    /// Tag of this step.
    pub tag_i: Signal<In, Bits<T>>,
    /// Node.
    pub node: Node<W>,
    /// Ray.
    pub ray: Ray<W>,
    /// Result is valid.
    pub valid_o: Signal<Out, Bit>,
    /// Tag of the result.
    pub tag_o: Signal<Out, Bits<T>>,
    /// What the step returns.
    pub step: Step<W>,

    select: DualSplitSelect<E, S, W, C>,
    subtract: [fp_add!(); 2],
    multiply: [fp_mul!(); 2],
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
        ClockEnable::link(&mut self.clocking, &mut self.select.clocking);
        self.select.valid_i.next = self.valid_i.val();
        Node::<W>::link(&mut self.node, &mut self.select.node);
        Ray::<W>::link(&mut self.ray, &mut self.select.ray);

        // Cycles 2 to 5: distances.
        for i in 0..2 {
            ClockEnable::link(&mut self.clocking, &mut self.subtract[i].clocking);
            self.subtract[i].valid_i.next = self.select.valid_o.val();
            self.subtract[i].tag_i.next = 0.into();
            self.subtract[i].a_i.next = self.select.plane_o[i].val();
            self.subtract[i].b_i.next = self.select.origin_o[i].val();
            self.subtract[i].subtract_i.next = true;
            self.subtract[i].rounding_i.next = 0.into();
            ClockEnable::link(&mut self.clocking, &mut self.multiply[i].clocking);
            self.multiply[i].valid_i.next = self.subtract[i].valid_o.val();
            self.multiply[i].tag_i.next = 0.into();
            self.multiply[i].a_i.next = self.subtract[i].result_o.val();
            self.multiply[i].b_i.next = self.select.inv_o[i].val();
            self.multiply[i].rounding_i.next = 0.into();
        }

        // Cycles 6 to 8: fold, compare, return.
        ClockEnable::link(&mut self.clocking, &mut self.fold.clocking);
        self.fold.valid_i.next = self.multiply[0].valid_o.val();
        self.fold.t_0_i.next = self.multiply[0].result_o.val();
        self.fold.t_1_i.next = self.multiply[1].result_o.val();
        self.fold.exit_0_i.next = self.select.exit_o[0].val();
        self.fold.exit_1_i.next = self.select.exit_o[1].val();
        self.fold.header_i.next = self.select.header_o.val();
        self.fold.t_min_i.next = self.select.t_min_o.val();
        self.fold.t_max_i.next = self.select.t_max_o.val();
        ClockEnable::link(&mut self.clocking, &mut self.tag.clocking);
        self.tag.d_i.next = self.tag_i.val();
        self.valid_o.next = self.fold.valid_o.val();
        self.tag_o.next = self.tag.q_o.val();
        Step::<W>::link(&mut self.step, &mut self.fold.step);
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("dual_split", &format!("{}_c{C}_t{T}", format::<E, S>().systematic_name()))
    }
}
