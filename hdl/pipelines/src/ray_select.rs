//! Picks the components of a ray that one plane of a node is tested with.
//!
//! The sign bit of the entry reciprocal says on which side of a box the ray enters: if it is set, the ray runs towards
//! smaller coordinates and leaves through a box's min side. A plane is thus an exit if that bit equals the plane's
//! side, and its role picks one of the axis' two reciprocals.

use super::ports::{Origin, Reciprocals};
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::module;

/// Ray-component selection for one plane.
///
/// ```text
///                   +-----------+
///        axis_i --->| 2       W |---> origin_o
///    min_side_i --->| 1       W |---> inv_o
///  origin_*_i --->  | W       W |---> inv_entry_o
///  inv_entry_*_i -->| W         |
///  inv_exit_*_i --->| W       1 |---> negative_o, exit_o
///                   | RaySelect |
///                   +-----------+
/// ```
/// Combinational: three 3:1 multiplexers and one 2:1. The axis code 3, which no valid node has, selects z.
#[derive(LogicBlock, Clone, Debug)]
pub(super) struct RaySelect<const W: usize> {
    pub axis_i: Signal<In, Bits<2>>,
    pub min_side_i: Signal<In, Bit>,
    pub ray_origin: Origin<W>,
    pub reciprocals: Reciprocals<W>,
    pub origin_o: Signal<Out, Bits<W>>,
    pub inv_o: Signal<Out, Bits<W>>,
    pub inv_entry_o: Signal<Out, Bits<W>>,
    pub negative_o: Signal<Out, Bit>,
    pub exit_o: Signal<Out, Bit>,
    sign_index: Constant<Bits<8>>,
    origin: Signal<Local, Bits<W>>,
    inv_entry: Signal<Local, Bits<W>>,
    inv_exit: Signal<Local, Bits<W>>,
    inv: Signal<Local, Bits<W>>,
    negative: Signal<Local, Bit>,
    leaving: Signal<Local, Bit>,
}

impl<const W: usize> Default for RaySelect<W> {
    fn default() -> Self {
        module! {
            sign_index = Constant::new((W as u64 - 1).into());
            axis_i, min_side_i, ray_origin, reciprocals, origin_o, inv_o, inv_entry_o, negative_o, exit_o,
            origin, inv_entry, inv_exit, inv, negative, leaving,
        }
    }
}

impl<const W: usize> Logic for RaySelect<W> {
    #[hdl_gen]
    fn update(&mut self) {
        self.origin.next = self.ray_origin.origin_z_i.val();
        self.inv_entry.next = self.reciprocals.inv_entry_z_i.val();
        self.inv_exit.next = self.reciprocals.inv_exit_z_i.val();
        if self.axis_i.val() == 0 {
            self.origin.next = self.ray_origin.origin_x_i.val();
            self.inv_entry.next = self.reciprocals.inv_entry_x_i.val();
            self.inv_exit.next = self.reciprocals.inv_exit_x_i.val();
        }
        if self.axis_i.val() == 1 {
            self.origin.next = self.ray_origin.origin_y_i.val();
            self.inv_entry.next = self.reciprocals.inv_entry_y_i.val();
            self.inv_exit.next = self.reciprocals.inv_exit_y_i.val();
        }
        self.negative.next = self.inv_entry.val().get_bit(self.sign_index.val().index());
        self.leaving.next = self.negative.val() == self.min_side_i.val();
        self.inv.next = self.inv_entry.val();
        if self.leaving.val() {
            self.inv.next = self.inv_exit.val();
        }
        self.origin_o.next = self.origin.val();
        self.inv_o.next = self.inv.val();
        self.inv_entry_o.next = self.inv_entry.val();
        self.negative_o.next = self.negative.val();
        self.exit_o.next = self.leaving.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("ray_select", &format!("w{W}"))
    }
}
