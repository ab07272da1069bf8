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

use super::ports::{Bounds, Interval, Ray, Reciprocals};
use super::ray_box_fold::RayBoxFold;
use super::ray_box_select::RayBoxSelect;
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::{ClockEnable, Delay};
use units::widths::format;
use units::{fp_add, fp_mul};

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
///
/// ```text
/// cycle      0   1   2       8   9   10
/// clk_i      ~\_/~\_/~\_ ... ~\_/~\_/~\_/
/// en_i       ~~~~~~~~~~~ ... ~~~~~~~~~~~~
/// valid_i    ~~~~~~~~\__ ... ____________
/// box, ray   X A X B X-- ... ------------
/// valid_o    ___________ ... /~~~~~~~\___
/// hit_o, ... ----------- ... X A X B X---
/// ```
///
/// A ray along the diagonal, and a box from 1 to 2 on each axis:
///
/// ```
/// use units::clocking::Clocked;
///
/// let word = |number: f32| u64::from(number.to_bits()).into();
/// let mut unit = pipelines::formats::binary32::RayBoxPipeline::default();
/// unit.clocking.en_i.next = true;
/// unit.valid_i.next = true;
/// let (low, high) = (word(1.0), word(2.0));
/// let to = &mut unit.bounds;
/// (to.box_min_x_i.next, to.box_min_y_i.next, to.box_min_z_i.next) = (low, low, low);
/// (to.box_max_x_i.next, to.box_max_y_i.next, to.box_max_z_i.next) = (high, high, high);
/// let inv = &mut unit.ray.reciprocals;
/// (inv.inv_entry_x_i.next, inv.inv_entry_y_i.next, inv.inv_entry_z_i.next) = (low, low, low);
/// (inv.inv_exit_x_i.next, inv.inv_exit_y_i.next, inv.inv_exit_z_i.next) = (low, low, low);
/// unit.ray.interval.t_max_i.next = word(10.0);
///
/// let latency_cycles = (1..20).find(|_| {
///     unit.tick();
///     unit.valid_o.val()
/// });
/// assert_eq!((latency_cycles, unit.hit_o.val()), (Some(8), true));
/// assert_eq!(f32::from_bits(unit.t_entry_o.val().to_u32()), 1.0);
/// ```
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
    /// Clock and enable.
    pub clocking: ClockEnable,
    /// Box and ray are valid.
    pub valid_i: Signal<In, Bit>,
    /// Tag of this test.
    pub tag_i: Signal<In, Bits<T>>,
    /// Box.
    pub bounds: Bounds<W>,
    /// Ray.
    pub ray: Ray<W>,
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
    subtract: [fp_add!(); 6],
    multiply: [fp_mul!(); 6],
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
        ClockEnable::link(&mut self.clocking, &mut self.select.clocking);
        Reciprocals::<W>::link(&mut self.ray.reciprocals, &mut self.select.reciprocals);
        Interval::<W>::link(&mut self.ray.interval, &mut self.select.interval);

        // Cycles 1 to 4: distances.
        for i in 0..6 {
            ClockEnable::link(&mut self.clocking, &mut self.subtract[i].clocking);
            self.subtract[i].valid_i.next = self.valid_i.val();
            self.subtract[i].tag_i.next = 0.into();
            self.subtract[i].a_i.next = self.plane[i].val();
            self.subtract[i].b_i.next = self.origin[i].val();
            self.subtract[i].subtract_i.next = true;
            self.subtract[i].rounding_i.next = 0.into();
            ClockEnable::link(&mut self.clocking, &mut self.multiply[i].clocking);
            self.multiply[i].valid_i.next = self.subtract[i].valid_o.val();
            self.multiply[i].tag_i.next = 0.into();
            self.multiply[i].a_i.next = self.subtract[i].result_o.val();
            self.multiply[i].b_i.next = self.select.inv_o[i].val();
            self.multiply[i].rounding_i.next = 0.into();
            self.fold.t_i[i].next = self.multiply[i].result_o.val();
        }

        // Cycles 5 to 8: fold and compare.
        ClockEnable::link(&mut self.clocking, &mut self.fold.clocking);
        self.fold.valid_i.next = self.multiply[0].valid_o.val();
        self.fold.t_min_i.next = self.select.t_min_o.val();
        self.fold.t_max_i.next = self.select.t_max_o.val();
        ClockEnable::link(&mut self.clocking, &mut self.tag.clocking);
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
