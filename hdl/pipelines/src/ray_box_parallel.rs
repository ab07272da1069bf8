//! Several ray-box pipelines side by side: one ray against all boxes of a wide node in one cycle.

use super::RayBoxPipeline;
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::{Delay, module};
use units::widths::format;

/// Intersection test of a ray with `K` boxes.
///
/// ```text
///                           +----------------+
/// box_min_{x,y,z}_i[K] ---->| W            1 |---> hit_o[K]
/// box_max_{x,y,z}_i[K] ---->| W            W |---> t_entry_o[K]
/// origin_{x,y,z}_i -------->| W              |
/// inv_entry_{x,y,z}_i ----->| W              |
/// inv_exit_{x,y,z}_i ------>| W              |
/// t_min_i, t_max_i -------->| W              |
/// valid_i ----------------->|                |---> valid_o
/// tag_i ------------------->| T            T |---> tag_o
/// en_i, clk_i ------------->| RayBoxParallel |
///                           +----------------+
/// ```
/// Latency 8, `K` boxes per cycle; each box as in [`RayBoxPipeline`].
#[derive(LogicBlock, Clone, Debug)]
pub struct RayBoxParallel<
    const E: usize,
    const S: usize,
    const W: usize,
    const X: usize,
    const R: usize,
    const N: usize,
    const P: usize,
    const K: usize,
    const C: usize,
    const T: usize,
> {
    /// Clock.
    pub clk_i: Signal<In, Clock>,
    /// Enable; low holds.
    pub en_i: Signal<In, Bit>,
    /// Boxes and ray are valid.
    pub valid_i: Signal<In, Bit>,
    /// Tag of this test.
    pub tag_i: Signal<In, Bits<T>>,
    /// Boxes, lower x.
    pub box_min_x_i: [Signal<In, Bits<W>>; K],
    /// Boxes, lower y.
    pub box_min_y_i: [Signal<In, Bits<W>>; K],
    /// Boxes, lower z.
    pub box_min_z_i: [Signal<In, Bits<W>>; K],
    /// Boxes, upper x.
    pub box_max_x_i: [Signal<In, Bits<W>>; K],
    /// Boxes, upper y.
    pub box_max_y_i: [Signal<In, Bits<W>>; K],
    /// Boxes, upper z.
    pub box_max_z_i: [Signal<In, Bits<W>>; K],
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
    /// Results are valid.
    pub valid_o: Signal<Out, Bit>,
    /// Tag of the results.
    pub tag_o: Signal<Out, Bits<T>>,
    /// The ray meets the box inside its interval.
    pub hit_o: [Signal<Out, Bit>; K],
    /// Where it enters.
    pub t_entry_o: [Signal<Out, Bits<W>>; K],

    /// `K` of them; on the heap, because eight would not fit a thread's stack.
    lane: Vec<RayBoxPipeline<E, S, W, X, R, N, P, C, 1>>,
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
    const K: usize,
    const C: usize,
    const T: usize,
> Default for RayBoxParallel<E, S, W, X, R, N, P, K, C, T>
{
    fn default() -> Self {
        let ports = || std::array::from_fn(|_| Signal::default());
        module! {
            box_min_x_i = ports(), box_min_y_i = ports(), box_min_z_i = ports(),
            box_max_x_i = ports(), box_max_y_i = ports(), box_max_z_i = ports(),
            hit_o = std::array::from_fn(|_| Signal::default()),
            t_entry_o = std::array::from_fn(|_| Signal::default()),
            lane = std::iter::repeat_with(RayBoxPipeline::default).take(K).collect();
            clk_i, en_i, valid_i, tag_i, origin_x_i, origin_y_i, origin_z_i, inv_entry_x_i, inv_entry_y_i,
            inv_entry_z_i, inv_exit_x_i, inv_exit_y_i, inv_exit_z_i, t_min_i, t_max_i, valid_o, tag_o, tag,
        }
    }
}

impl<
    const E: usize,
    const S: usize,
    const W: usize,
    const X: usize,
    const R: usize,
    const N: usize,
    const P: usize,
    const K: usize,
    const C: usize,
    const T: usize,
> Logic for RayBoxParallel<E, S, W, X, R, N, P, K, C, T>
{
    #[hdl_gen]
    fn update(&mut self) {
        for i in 0..K {
            self.lane[i].clk_i.next = self.clk_i.val();
            self.lane[i].en_i.next = self.en_i.val();
            self.lane[i].valid_i.next = self.valid_i.val();
            self.lane[i].tag_i.next = 0.into();
            self.lane[i].box_min_x_i.next = self.box_min_x_i[i].val();
            self.lane[i].box_min_y_i.next = self.box_min_y_i[i].val();
            self.lane[i].box_min_z_i.next = self.box_min_z_i[i].val();
            self.lane[i].box_max_x_i.next = self.box_max_x_i[i].val();
            self.lane[i].box_max_y_i.next = self.box_max_y_i[i].val();
            self.lane[i].box_max_z_i.next = self.box_max_z_i[i].val();
            self.lane[i].origin_x_i.next = self.origin_x_i.val();
            self.lane[i].origin_y_i.next = self.origin_y_i.val();
            self.lane[i].origin_z_i.next = self.origin_z_i.val();
            self.lane[i].inv_entry_x_i.next = self.inv_entry_x_i.val();
            self.lane[i].inv_entry_y_i.next = self.inv_entry_y_i.val();
            self.lane[i].inv_entry_z_i.next = self.inv_entry_z_i.val();
            self.lane[i].inv_exit_x_i.next = self.inv_exit_x_i.val();
            self.lane[i].inv_exit_y_i.next = self.inv_exit_y_i.val();
            self.lane[i].inv_exit_z_i.next = self.inv_exit_z_i.val();
            self.lane[i].t_min_i.next = self.t_min_i.val();
            self.lane[i].t_max_i.next = self.t_max_i.val();
            self.hit_o[i].next = self.lane[i].hit_o.val();
            self.t_entry_o[i].next = self.lane[i].t_entry_o.val();
        }
        self.valid_o.next = self.lane[0].valid_o.val();
        self.tag.clk_i.next = self.clk_i.val();
        self.tag.en_i.next = self.en_i.val();
        self.tag.d_i.next = self.tag_i.val();
        self.tag_o.next = self.tag.q_o.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        let format = format::<E, S>().systematic_name();
        named("ray_box_parallel", &format!("x{K}_{format}_c{C}_t{T}"))
    }
}
