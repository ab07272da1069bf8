//! The ray-box pipeline: one slab test per cycle.
//!
//! Each of a box's six planes is met at `t = (plane - origin[axis]) * inv[axis]`, with the reciprocal of its role (exit or
//! entry), every operation rounded to nearest even and none fused. The slabs are then intersected with the ray's
//! interval; the box is hit if the rest is not empty, bounds included.
//!
//! | cycle | work | units |
//! |---|---|---|
//! | 1, 2 | `plane - origin` | 6 FPADD |
//! | 3, 4 | `* inv` | 6 FPMUL |
//! | 5, 6, 7 | fold (see `RayBoxFold`) | 12 FPMIN/MAX |
//! | 8 | compare | 2 FPCMP |
//!
//! `C = 2` is the inventory of the ray-box unit that Lin, Vasiou, Yuksel, Kopta, Brunvand, "Hardware-Accelerated Dual-Split
//! Trees", HPG 2020, compare with; `C = 1` leaves out the redundant comparison.

use super::ray_box_fold::RayBoxFold;
use super::ray_box_select::RayBoxSelect;
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::Delay;
use units::widths::format;
use units::{FpAdd, FpMul};

/// Intersection test of a ray and a box.
///
/// ```text
///                        +----------------+
/// box_min_{x,y,z}_i ---->| W            1 |---> hit_o
/// box_max_{x,y,z}_i ---->| W            W |---> t_entry_o
/// origin_{x,y,z}_i ----->| W              |
/// inv_entry_{x,y,z}_i -->| W              |
/// inv_exit_{x,y,z}_i --->| W              |
/// t_min_i, t_max_i ----->| W              |
/// valid_i -------------->|                |---> valid_o
/// tag_i ---------------->| T            T |---> tag_o
/// en_i, clk_i ---------->| RayBoxPipeline |
///                        +----------------+
/// ```
/// Latency 8, one box per cycle. `t_entry_o` is the distance at which the ray enters the box, at least `t_min_i`, and means
/// nothing without a hit. `hit_o` comes through one gate behind the last registers.
#[derive(LogicBlock, Default, Clone, Debug)]
pub struct RayBoxPipeline<
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
    /// Box and ray are valid.
    pub valid_i: Signal<In, Bit>,
    /// Tag of this test.
    pub tag_i: Signal<In, Bits<T>>,
    /// Box, lower x.
    pub box_min_x_i: Signal<In, Bits<W>>,
    /// Box, lower y.
    pub box_min_y_i: Signal<In, Bits<W>>,
    /// Box, lower z.
    pub box_min_z_i: Signal<In, Bits<W>>,
    /// Box, upper x.
    pub box_max_x_i: Signal<In, Bits<W>>,
    /// Box, upper y.
    pub box_max_y_i: Signal<In, Bits<W>>,
    /// Box, upper z.
    pub box_max_z_i: Signal<In, Bits<W>>,
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
    /// Start of the ray's interval.
    pub t_min_i: Signal<In, Bits<W>>,
    /// End of the ray's interval.
    pub t_max_i: Signal<In, Bits<W>>,
    /// Result is valid.
    pub valid_o: Signal<Out, Bit>,
    /// Tag of the result.
    pub tag_o: Signal<Out, Bits<T>>,
    /// The ray meets the box inside its interval.
    pub hit_o: Signal<Out, Bit>,
    /// Where it enters.
    pub t_entry_o: Signal<Out, Bits<W>>,

    plane: [Signal<Local, Bits<W>>; 6],
    origin: [Signal<Local, Bits<W>>; 6],
    select: RayBoxSelect<W>,
    subtract: [FpAdd<E, S, W, X, R, N, 1>; 6],
    multiply: [FpMul<E, S, W, X, R, P, 1>; 6],
    fold: RayBoxFold<E, S, W, C>,
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
> Logic for RayBoxPipeline<E, S, W, X, R, N, P, C, T>
{
    #[hdl_gen]
    fn update(&mut self) {
        self.plane[0].next = self.box_min_x_i.val();
        self.plane[1].next = self.box_min_y_i.val();
        self.plane[2].next = self.box_min_z_i.val();
        self.plane[3].next = self.box_max_x_i.val();
        self.plane[4].next = self.box_max_y_i.val();
        self.plane[5].next = self.box_max_z_i.val();
        self.origin[0].next = self.origin_x_i.val();
        self.origin[1].next = self.origin_y_i.val();
        self.origin[2].next = self.origin_z_i.val();
        self.origin[3].next = self.origin_x_i.val();
        self.origin[4].next = self.origin_y_i.val();
        self.origin[5].next = self.origin_z_i.val();
        self.select.clk_i.next = self.clk_i.val();
        self.select.en_i.next = self.en_i.val();
        self.select.inv_entry_x_i.next = self.inv_entry_x_i.val();
        self.select.inv_entry_y_i.next = self.inv_entry_y_i.val();
        self.select.inv_entry_z_i.next = self.inv_entry_z_i.val();
        self.select.inv_exit_x_i.next = self.inv_exit_x_i.val();
        self.select.inv_exit_y_i.next = self.inv_exit_y_i.val();
        self.select.inv_exit_z_i.next = self.inv_exit_z_i.val();
        self.select.t_min_i.next = self.t_min_i.val();
        self.select.t_max_i.next = self.t_max_i.val();

        // Cycles 1 to 4: distances.
        for i in 0..6 {
            self.subtract[i].clk_i.next = self.clk_i.val();
            self.subtract[i].en_i.next = self.en_i.val();
            self.subtract[i].valid_i.next = self.valid_i.val();
            self.subtract[i].tag_i.next = 0.into();
            self.subtract[i].a_i.next = self.plane[i].val();
            self.subtract[i].b_i.next = self.origin[i].val();
            self.subtract[i].subtract_i.next = true;
            self.subtract[i].rounding_i.next = 0.into();
            self.multiply[i].clk_i.next = self.clk_i.val();
            self.multiply[i].en_i.next = self.en_i.val();
            self.multiply[i].valid_i.next = self.subtract[i].valid_o.val();
            self.multiply[i].tag_i.next = 0.into();
            self.multiply[i].a_i.next = self.subtract[i].result_o.val();
            self.multiply[i].b_i.next = self.select.inv_o[i].val();
            self.multiply[i].rounding_i.next = 0.into();
            self.fold.t_i[i].next = self.multiply[i].result_o.val();
        }

        // Cycles 5 to 8: fold and compare.
        self.fold.clk_i.next = self.clk_i.val();
        self.fold.en_i.next = self.en_i.val();
        self.fold.valid_i.next = self.multiply[0].valid_o.val();
        self.fold.t_min_i.next = self.select.t_min_o.val();
        self.fold.t_max_i.next = self.select.t_max_o.val();
        self.tag.clk_i.next = self.clk_i.val();
        self.tag.en_i.next = self.en_i.val();
        self.tag.d_i.next = self.tag_i.val();
        self.valid_o.next = self.fold.valid_o.val();
        self.tag_o.next = self.tag.q_o.val();
        self.hit_o.next = self.fold.hit_o.val();
        self.t_entry_o.next = self.fold.t_entry_o.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("ray_box", &format!("{}_c{C}_t{T}", format::<E, S>().systematic_name()))
    }
}
