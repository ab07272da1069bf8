//! Last four stages of the ray-box pipeline: intersects the three slabs with the ray's interval.
//!
//! | cycle | work | units |
//! |---|---|---|
//! | 5 | per axis `near = minimum(t_lo, t_hi)`, `far = maximum(t_lo, t_hi)`; a NaN propagates | 6 FPMIN/MAX |
//! | 6 | `max(near_x, near_y)`, `max(near_z, t_min)`, `min(far_x, far_y)`, `min(far_z, t_max)`; a NaN is dropped | 4 FPMIN/MAX |
//! | 7 | `entry`, `exit`: maximum and minimum of those | 2 FPMIN/MAX |
//! | 8 | `hit = entry <= exit`, and not `exit < t_min` | 2 FPCMP |
//!
//! A ray parallel to an axis that lies in one of its slab's planes has a NaN distance there; the whole axis then
//! constrains nothing. The second comparison is in the published inventory, where it is read as the test for a box
//! behind the ray's start. As `entry` is at least `t_min` unless that is NaN, it never changes the outcome, and `C = 1`
//! leaves it out with equal results.

use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::{ClockEnable, Delay, Dff, dff_setup, module};
use units::widths::{check_widths, format};
use units::{FpCmp, fp_cmp, fp_min_max};

/// Slab fold and hit test.
///
/// ```text
///                    +------------+
/// t_i[6] ----------->| W        1 |---> hit_o
/// t_min_i, t_max_i ->| W        W |---> t_entry_o
///                    | RayBoxFold |
///                    +------------+
/// ```
/// Latency 4; `t_min_i` and `t_max_i` come one cycle after `t_i`, which is ordered min x, y, z, max x, y, z.
#[derive(LogicBlock, Clone, Debug)]
pub(super) struct RayBoxFold<const E: usize, const S: usize, const W: usize, const C: usize> {
    pub clocking: ClockEnable,
    pub valid_i: Signal<In, Bit>,
    pub t_i: [Signal<In, Bits<W>>; 6],
    pub t_min_i: Signal<In, Bits<W>>,
    pub t_max_i: Signal<In, Bits<W>>,
    pub valid_o: Signal<Out, Bit>,
    pub hit_o: Signal<Out, Bit>,
    pub t_entry_o: Signal<Out, Bits<W>>,

    axis_near: [fp_min_max!(); 3],
    axis_far: [fp_min_max!(); 3],
    entry_half: [fp_min_max!(); 2],
    exit_half: [fp_min_max!(); 2],
    entry: fp_min_max!(),
    leave: fp_min_max!(),
    t_min_wait: Delay<W, 2>,
    accept: [fp_cmp!(); C],
    hit: Signal<Local, Bit>,
    t_entry: Dff<Bits<W>>,
}

impl<const E: usize, const S: usize, const W: usize, const C: usize> Default for RayBoxFold<E, S, W, C> {
    fn default() -> Self {
        check_widths!(W);
        const { assert!(C == 1 || C == 2, "one comparison decides, a second one is redundant") };
        module! {
            accept = std::array::from_fn(|_| FpCmp::default());
            clocking, valid_i, t_i, t_min_i, t_max_i, valid_o, hit_o, t_entry_o,
            axis_near, axis_far, entry_half, exit_half, entry, leave, t_min_wait, hit, t_entry,
        }
    }
}

impl<const E: usize, const S: usize, const W: usize, const C: usize> Logic for RayBoxFold<E, S, W, C> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clocking.clk_i, t_entry);

        // Cycle 5: slabs.
        for i in 0..3 {
            ClockEnable::link(&mut self.clocking, &mut self.axis_near[i].clocking);
            self.axis_near[i].valid_i.next = self.valid_i.val();
            self.axis_near[i].tag_i.next = 0.into();
            self.axis_near[i].a_i.next = self.t_i[i].val();
            self.axis_near[i].b_i.next = self.t_i[i + 3].val();
            self.axis_near[i].maximum_i.next = false;
            self.axis_near[i].propagate_nan_i.next = true;
            ClockEnable::link(&mut self.clocking, &mut self.axis_far[i].clocking);
            self.axis_far[i].valid_i.next = self.valid_i.val();
            self.axis_far[i].tag_i.next = 0.into();
            self.axis_far[i].a_i.next = self.t_i[i].val();
            self.axis_far[i].b_i.next = self.t_i[i + 3].val();
            self.axis_far[i].maximum_i.next = true;
            self.axis_far[i].propagate_nan_i.next = true;
        }

        // Cycles 6 and 7: fold.
        for i in 0..2 {
            ClockEnable::link(&mut self.clocking, &mut self.entry_half[i].clocking);
            self.entry_half[i].valid_i.next = self.axis_near[i].valid_o.val();
            self.entry_half[i].tag_i.next = 0.into();
            self.entry_half[i].maximum_i.next = true;
            self.entry_half[i].propagate_nan_i.next = false;
            ClockEnable::link(&mut self.clocking, &mut self.exit_half[i].clocking);
            self.exit_half[i].valid_i.next = self.axis_far[i].valid_o.val();
            self.exit_half[i].tag_i.next = 0.into();
            self.exit_half[i].maximum_i.next = false;
            self.exit_half[i].propagate_nan_i.next = false;
        }
        self.entry_half[0].a_i.next = self.axis_near[0].result_o.val();
        self.entry_half[0].b_i.next = self.axis_near[1].result_o.val();
        self.entry_half[1].a_i.next = self.axis_near[2].result_o.val();
        self.entry_half[1].b_i.next = self.t_min_i.val();
        self.exit_half[0].a_i.next = self.axis_far[0].result_o.val();
        self.exit_half[0].b_i.next = self.axis_far[1].result_o.val();
        self.exit_half[1].a_i.next = self.axis_far[2].result_o.val();
        self.exit_half[1].b_i.next = self.t_max_i.val();
        ClockEnable::link(&mut self.clocking, &mut self.entry.clocking);
        self.entry.valid_i.next = self.entry_half[0].valid_o.val();
        self.entry.tag_i.next = 0.into();
        self.entry.a_i.next = self.entry_half[0].result_o.val();
        self.entry.b_i.next = self.entry_half[1].result_o.val();
        self.entry.maximum_i.next = true;
        self.entry.propagate_nan_i.next = false;
        ClockEnable::link(&mut self.clocking, &mut self.leave.clocking);
        self.leave.valid_i.next = self.exit_half[0].valid_o.val();
        self.leave.tag_i.next = 0.into();
        self.leave.a_i.next = self.exit_half[0].result_o.val();
        self.leave.b_i.next = self.exit_half[1].result_o.val();
        self.leave.maximum_i.next = false;
        self.leave.propagate_nan_i.next = false;
        ClockEnable::link(&mut self.clocking, &mut self.t_min_wait.clocking);
        self.t_min_wait.d_i.next = self.t_min_i.val();

        // Cycle 8: compare.
        for i in 0..C {
            ClockEnable::link(&mut self.clocking, &mut self.accept[i].clocking);
            self.accept[i].valid_i.next = self.entry.valid_o.val();
            self.accept[i].tag_i.next = 0.into();
        }
        self.accept[0].a_i.next = self.entry.result_o.val();
        self.accept[0].b_i.next = self.leave.result_o.val();
        self.hit.next = self.accept[0].le_o.val();
        for i in 1..C {
            self.accept[i].a_i.next = self.leave.result_o.val();
            self.accept[i].b_i.next = self.t_min_wait.q_o.val();
            self.hit.next = self.hit.val() & !self.accept[i].lt_o.val();
        }
        if self.clocking.en_i.val() {
            self.t_entry.d.next = self.entry.result_o.val();
        }
        self.hit_o.next = self.hit.val();
        self.valid_o.next = self.accept[0].valid_o.val();
        self.t_entry_o.next = self.t_entry.q.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("ray_box_fold", &format!("{}_c{C}", format::<E, S>().systematic_name()))
    }
}
