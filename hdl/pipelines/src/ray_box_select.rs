//! First stage of the ray-box pipeline: picks the reciprocal of each plane's role, and lets operands wait.
//!
//! A ray that runs upwards on an axis enters through the box's min plane and leaves through its max plane; the sign bit
//! of the entry reciprocal tells the direction.

use super::ports::{Interval, Reciprocals};
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::{ClockEnable, Delay, module};

/// Reciprocal selection and waiting lines of a ray-box test.
///
/// ```text
///                        +--------------+
/// inv_entry_{x,y,z}_i -->| W          W |---> inv_o[6]           after 2 cycles, for the multiplication
/// inv_exit_{x,y,z}_i --->| W          W |---> t_min_o, t_max_o   after 5 cycles, for the folds
/// t_min_i, t_max_i ----->| W            |
///                        | RayBoxSelect |
///                        +--------------+
/// ```
/// `inv_o` is ordered min x, y, z, max x, y, z.
#[derive(LogicBlock, Clone, Debug)]
pub(super) struct RayBoxSelect<const W: usize> {
    pub clocking: ClockEnable,
    pub reciprocals: Reciprocals<W>,
    pub interval: Interval<W>,
    pub inv_o: [Signal<Out, Bits<W>>; 6],
    pub t_min_o: Signal<Out, Bits<W>>,
    pub t_max_o: Signal<Out, Bits<W>>,
    sign_index: Constant<Bits<8>>,
    inv_entry: [Signal<Local, Bits<W>>; 3],
    inv_exit: [Signal<Local, Bits<W>>; 3],
    inv_low: [Signal<Local, Bits<W>>; 3],
    inv_high: [Signal<Local, Bits<W>>; 3],
    inv_wait: [Delay<W, 2>; 6],
    t_min_wait: Delay<W, 5>,
    t_max_wait: Delay<W, 5>,
}

impl<const W: usize> Default for RayBoxSelect<W> {
    fn default() -> Self {
        module! {
            sign_index = Constant::new((W as u64 - 1).into());
            clocking, reciprocals, interval, inv_o, t_min_o, t_max_o, inv_entry, inv_exit, inv_low, inv_high, inv_wait, t_min_wait, t_max_wait,
        }
    }
}

impl<const W: usize> Logic for RayBoxSelect<W> {
    #[hdl_gen]
    fn update(&mut self) {
        self.inv_entry[0].next = self.reciprocals.inv_entry_x_i.val();
        self.inv_entry[1].next = self.reciprocals.inv_entry_y_i.val();
        self.inv_entry[2].next = self.reciprocals.inv_entry_z_i.val();
        self.inv_exit[0].next = self.reciprocals.inv_exit_x_i.val();
        self.inv_exit[1].next = self.reciprocals.inv_exit_y_i.val();
        self.inv_exit[2].next = self.reciprocals.inv_exit_z_i.val();
        for i in 0..3 {
            self.inv_low[i].next = self.inv_entry[i].val();
            self.inv_high[i].next = self.inv_exit[i].val();
            if self.inv_entry[i].val().get_bit(self.sign_index.val().index()) {
                self.inv_low[i].next = self.inv_exit[i].val();
                self.inv_high[i].next = self.inv_entry[i].val();
            }
            self.inv_wait[i].d_i.next = self.inv_low[i].val();
            self.inv_wait[i + 3].d_i.next = self.inv_high[i].val();
        }
        for i in 0..6 {
            ClockEnable::link(&mut self.clocking, &mut self.inv_wait[i].clocking);
            self.inv_o[i].next = self.inv_wait[i].q_o.val();
        }
        ClockEnable::link(&mut self.clocking, &mut self.t_min_wait.clocking);
        self.t_min_wait.d_i.next = self.interval.t_min_i.val();
        self.t_min_o.next = self.t_min_wait.q_o.val();
        ClockEnable::link(&mut self.clocking, &mut self.t_max_wait.clocking);
        self.t_max_wait.d_i.next = self.interval.t_max_i.val();
        self.t_max_o.next = self.t_max_wait.q_o.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("ray_box_select", &format!("w{W}"))
    }
}
