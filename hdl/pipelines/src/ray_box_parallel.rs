//! Several ray-box pipelines side by side: one ray against all boxes of a wide node in one cycle.

use super::RayBoxPipeline;
use super::ports::{Bounds, Ray};
use netlist::module::named;
use rust_hdl_core::prelude::*;
use units::blocks::{ClockEnable, Delay, module};
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
    /// Clock and enable.
    pub clocking: ClockEnable,
    /// Boxes and ray are valid.
    pub valid_i: Signal<In, Bit>,
    /// Tag of this test.
    pub tag_i: Signal<In, Bits<T>>,
    /// Boxes.
    pub bounds: [Bounds<W>; K],
    /// Ray.
    pub ray: Ray<W>,
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
        module! {
            bounds = std::array::from_fn(|_| Bounds::default()),
            hit_o = std::array::from_fn(|_| Signal::default()),
            t_entry_o = std::array::from_fn(|_| Signal::default()),
            lane = std::iter::repeat_with(RayBoxPipeline::default).take(K).collect();
            clocking, valid_i, tag_i, ray, valid_o, tag_o, tag,
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
            ClockEnable::link(&mut self.clocking, &mut self.lane[i].clocking);
            self.lane[i].valid_i.next = self.valid_i.val();
            self.lane[i].tag_i.next = 0.into();
            Bounds::<W>::link(&mut self.bounds[i], &mut self.lane[i].bounds);
            Ray::<W>::link(&mut self.ray, &mut self.lane[i].ray);
            self.hit_o[i].next = self.lane[i].hit_o.val();
            self.t_entry_o[i].next = self.lane[i].t_entry_o.val();
        }
        self.valid_o.next = self.lane[0].valid_o.val();
        ClockEnable::link(&mut self.clocking, &mut self.tag.clocking);
        self.tag.d_i.next = self.tag_i.val();
        self.tag_o.next = self.tag.q_o.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        let format = format::<E, S>().systematic_name();
        named("ray_box_parallel", &format!("x{K}_{format}_c{C}_t{T}"))
    }
}
