//! First stage of the dual-split pipeline: decodes a node and selects what its two planes are tested with.
//!
//! All node types become two plane tests. Plane 0 and plane 1 have an axis and a side each; the side says whether the
//! plane bounds a box from below (its min side):
//!
//! | node | axis of plane 0, 1 | min side of plane 0, 1 |
//! |---|---|---|
//! | split | bits 30:29, both | 0, 1 |
//! | single carve | bits 28:27, both | 0, 1 |
//! | dual carve | bit 30; bit 29 + 1 | bit 28; bit 27 |
//!
//! In a split, the left child's max plane is the exit of the near child if the ray runs upwards, and the entry of the
//! far child if it runs downwards; that is the rule of a single carve, so that both decode alike. For a bare leaf the
//! result of the tests is ignored.
//!
//! With `C = 2`, two comparators tell whether each ray component runs downwards, as in the published unit. IEEE
//! comparison cannot see the sign of a zero or of a NaN, which the sign bit supplies, and as that bit alone
//! suffices, `C = 0` drops both comparators with equal results.

use super::node_header::NodeHeader;
use super::ports::{Node, Origin, Ray, Reciprocals};
use super::ray_select::RaySelect;
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::{ClockEnable, Delay, Dff, Valid, dff_setup, module};
use units::widths::{check_widths, format};
use units::{FpCmp, fp_cmp};

/// Node decoding, ray-component and plane selection, and the operands' waiting lines.
///
/// ```text
///                 +-----------------+
///  header_i ----->| 32           W,W |---> plane_o[2], origin_o[2]   after 1 cycle, for the subtraction
///  plane_*_i ---->| W             W |---> inv_o[2]                  after 3 cycles, for the multiplication
///  origin_*_i --->| W           W,W |---> t_min_o, t_max_o         \
///  inv_*_*_i ---->| W            32 |---> header_o                  after 5 cycles, for the folds
///  t_min_i ------>| W             1 |---> exit_o[2]                 /
///  t_max_i ------>| W               |
///                 | DualSplitSelect |
///                 +-----------------+
/// ```
#[derive(LogicBlock, Clone, Debug)]
pub(super) struct DualSplitSelect<const E: usize, const S: usize, const W: usize, const C: usize> {
    pub clocking: ClockEnable,
    pub valid_i: Signal<In, Bit>,
    pub node: Node<W>,
    pub ray: Ray<W>,
    pub valid_o: Signal<Out, Bit>,
    pub plane_o: [Signal<Out, Bits<W>>; 2],
    pub origin_o: [Signal<Out, Bits<W>>; 2],
    pub inv_o: [Signal<Out, Bits<W>>; 2],
    pub t_min_o: Signal<Out, Bits<W>>,
    pub t_max_o: Signal<Out, Bits<W>>,
    pub header_o: Signal<Out, Bits<32>>,
    pub exit_o: [Signal<Out, Bit>; 2],

    // Cycle 1.
    fields: NodeHeader,
    dual: Signal<Local, Bit>,
    single_code: Constant<Bits<2>>,
    axis: [Signal<Local, Bits<2>>; 2],
    min_side: [Signal<Local, Bit>; 2],
    select: [RaySelect<W>; 2],
    role: [fp_cmp!(); C],
    valid: Valid,
    plane_0: Dff<Bits<W>>,
    plane_1: Dff<Bits<W>>,
    origin: [Dff<Bits<W>>; 2],
    negative: [Dff<Bit>; 2],
    side: [Dff<Bit>; 2],

    // Waiting lines.
    runs_down: [Signal<Local, Bit>; 2],
    leaving: [Signal<Local, Bits<1>>; 2],
    inv_wait: [Delay<W, 3>; 2],
    exit_wait: [Delay<1, 4>; 2],
    header_wait: Delay<32, 5>,
    t_min_wait: Delay<W, 5>,
    t_max_wait: Delay<W, 5>,
}

impl<const E: usize, const S: usize, const W: usize, const C: usize> Default for DualSplitSelect<E, S, W, C> {
    fn default() -> Self {
        check_widths!(W);
        const { assert!(C == 0 || C == 2, "either both roles are compared or none") };
        module! {
            single_code = Constant::new(u64::from(golden::dst::header::SINGLE).into()),
            role = std::array::from_fn(|_| FpCmp::default());
            clocking, valid_i, node, ray,
            valid_o, plane_o, origin_o, inv_o, t_min_o, t_max_o, header_o, exit_o,
            fields, dual, axis, min_side, select, valid, plane_0, plane_1, origin, negative, side,
            runs_down, leaving, inv_wait, exit_wait, header_wait, t_min_wait, t_max_wait,
        }
    }
}

impl<const E: usize, const S: usize, const W: usize, const C: usize> Logic for DualSplitSelect<E, S, W, C> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clocking.clk_i, valid, plane_0, plane_1);

        // Cycle 1: decode.
        self.fields.header_i.next = self.node.header_i.val();
        self.dual.next = self.fields.carve_o.val() & (self.fields.kind_o.val() != self.single_code.val());
        self.axis[0].next = self.fields.kind_o.val();
        self.axis[1].next = self.fields.kind_o.val();
        self.min_side[0].next = false;
        self.min_side[1].next = true;
        if self.fields.carve_o.val() {
            self.axis[0].next = self.fields.size_o.val();
            self.axis[1].next = self.fields.size_o.val();
        }
        if self.dual.val() {
            self.axis[0].next = self.fields.kind_o.val() >> 1;
            self.axis[1].next = 1.into();
            if self.fields.kind_o.val().get_bit(0) {
                self.axis[1].next = 2.into();
            }
            self.min_side[0].next = self.fields.size_o.val().get_bit(1);
            self.min_side[1].next = self.fields.size_o.val().get_bit(0);
        }

        // Select and register.
        if self.clocking.en_i.val() {
            self.valid.d.next = self.valid_i.val();
            self.plane_0.d.next = self.node.plane_0_i.val();
            self.plane_1.d.next = self.node.plane_1_i.val();
        }
        self.valid_o.next = self.valid.q.val();
        self.plane_o[0].next = self.plane_0.q.val();
        self.plane_o[1].next = self.plane_1.q.val();
        for i in 0..2 {
            self.select[i].axis_i.next = self.axis[i].val();
            self.select[i].min_side_i.next = self.min_side[i].val();
            Origin::<W>::link(&mut self.ray.origin, &mut self.select[i].ray_origin);
            Reciprocals::<W>::link(&mut self.ray.reciprocals, &mut self.select[i].reciprocals);
            self.origin[i].clock.next = self.clocking.clk_i.val();
            self.negative[i].clock.next = self.clocking.clk_i.val();
            self.side[i].clock.next = self.clocking.clk_i.val();
            self.origin[i].d.next = self.origin[i].q.val();
            self.negative[i].d.next = self.negative[i].q.val();
            self.side[i].d.next = self.side[i].q.val();
            if self.clocking.en_i.val() {
                self.origin[i].d.next = self.select[i].origin_o.val();
                self.negative[i].d.next = self.select[i].negative_o.val();
                self.side[i].d.next = self.min_side[i].val();
            }
            self.origin_o[i].next = self.origin[i].q.val();
            self.runs_down[i].next = self.negative[i].q.val();
        }
        for i in 0..C {
            ClockEnable::link(&mut self.clocking, &mut self.role[i].clocking);
            self.role[i].valid_i.next = self.valid_i.val();
            self.role[i].tag_i.next = 0.into();
            self.role[i].a_i.next = self.select[i].inv_entry_o.val();
            self.role[i].b_i.next = 0.into();
            self.runs_down[i].next = self.role[i].lt_o.val() | self.negative[i].q.val();
        }

        // Operands wait for the stage that needs them.
        for i in 0..2 {
            ClockEnable::link(&mut self.clocking, &mut self.inv_wait[i].clocking);
            self.inv_wait[i].d_i.next = self.select[i].inv_o.val();
            self.inv_o[i].next = self.inv_wait[i].q_o.val();
            ClockEnable::link(&mut self.clocking, &mut self.exit_wait[i].clocking);
            self.leaving[i].next = 0.into();
            if self.runs_down[i].val() == self.side[i].q.val() {
                self.leaving[i].next = 1.into();
            }
            self.exit_wait[i].d_i.next = self.leaving[i].val();
            self.exit_o[i].next = self.exit_wait[i].q_o.val().any();
        }
        ClockEnable::link(&mut self.clocking, &mut self.header_wait.clocking);
        self.header_wait.d_i.next = self.node.header_i.val();
        self.header_o.next = self.header_wait.q_o.val();
        ClockEnable::link(&mut self.clocking, &mut self.t_min_wait.clocking);
        self.t_min_wait.d_i.next = self.ray.interval.t_min_i.val();
        self.t_min_o.next = self.t_min_wait.q_o.val();
        ClockEnable::link(&mut self.clocking, &mut self.t_max_wait.clocking);
        self.t_max_wait.d_i.next = self.ray.interval.t_max_i.val();
        self.t_max_o.next = self.t_max_wait.q_o.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("dual_split_select", &format!("{}_c{C}", format::<E, S>().systematic_name()))
    }
}
