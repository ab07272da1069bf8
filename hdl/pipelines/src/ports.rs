//! Bundles of ports that several modules of the pipelines have. The fields are a module's ports by their own names, and a
//! parent passes a bundle on as a whole: `Ray::<W>::link(&mut self.ray, &mut self.select.ray)`.

use rust_hdl_core::prelude::*;

/// A ray: where it starts, the reciprocals of its direction, and the interval that is left of it.
#[derive(LogicInterface, Default, Clone, Debug)]
pub struct Ray<const W: usize> {
    /// Where it starts.
    pub origin: Origin<W>,
    /// Its direction.
    pub reciprocals: Reciprocals<W>,
    /// What is left of it.
    pub interval: Interval<W>,
}

/// Origin of a ray.
#[derive(LogicInterface, Default, Clone, Debug)]
pub struct Origin<const W: usize> {
    /// Ray origin, x.
    pub origin_x_i: Signal<In, Bits<W>>,
    /// Ray origin, y.
    pub origin_y_i: Signal<In, Bits<W>>,
    /// Ray origin, z.
    pub origin_z_i: Signal<In, Bits<W>>,
}

/// Reciprocals of a ray's direction, one for the planes where it enters a box and one for those where it leaves.
#[derive(LogicInterface, Default, Clone, Debug)]
pub struct Reciprocals<const W: usize> {
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
}

/// Interval of a ray inside a node.
#[derive(LogicInterface, Default, Clone, Debug)]
pub struct Interval<const W: usize> {
    /// Start of the interval.
    pub t_min_i: Signal<In, Bits<W>>,
    /// End of the interval.
    pub t_max_i: Signal<In, Bits<W>>,
}

/// A dual-split node's three words.
#[derive(LogicInterface, Default, Clone, Debug)]
pub struct Node<const W: usize> {
    /// First word: the header.
    pub header_i: Signal<In, Bits<32>>,
    /// Second word: plane 0.
    pub plane_0_i: Signal<In, Bits<W>>,
    /// Third word: plane 1.
    pub plane_1_i: Signal<In, Bits<W>>,
}

/// A box.
#[derive(LogicInterface, Default, Clone, Debug)]
pub struct Bounds<const W: usize> {
    /// Lower x.
    pub box_min_x_i: Signal<In, Bits<W>>,
    /// Lower y.
    pub box_min_y_i: Signal<In, Bits<W>>,
    /// Lower z.
    pub box_min_z_i: Signal<In, Bits<W>>,
    /// Upper x.
    pub box_max_x_i: Signal<In, Bits<W>>,
    /// Upper y.
    pub box_max_y_i: Signal<In, Bits<W>>,
    /// Upper z.
    pub box_max_z_i: Signal<In, Bits<W>>,
}

/// What a dual-split step returns.
#[derive(LogicInterface, Default, Clone, Debug)]
pub struct Step<const W: usize> {
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
}
