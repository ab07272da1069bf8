//! Runs a module in `rust-hdl`'s own simulator, one clock cycle at a time.
//!
//! The simulator executes the kernels' Rust text, which makes it the first witness of what a module does. It is meant
//! for thousands of cycles; the compiled netlist is for millions.

use rust_hdl_core::prelude::*;

/// Passes over the hierarchy after which a clock edge must have settled; a design of depth `d` needs about `3 d`.
const SETTLING_PASSES: usize = 100;

/// A module with a clock.
pub trait Clocked: Block {
    /// The clock port.
    fn clk_i(&mut self) -> &mut Signal<In, Clock>;

    /// Lets the present inputs settle, then applies one rising edge and lets it settle.
    ///
    /// # Panics
    /// If the module oscillates.
    fn tick(&mut self)
    where
        Self: Sized,
    {
        for level in [false, true] {
            self.clk_i().next = Clock { clk: level };
            assert!(
                simulate(self, SETTLING_PASSES),
                "the module does not settle: it has a combinational loop"
            );
        }
    }
}

/// Implements [`Clocked`] for modules whose clock port is the field `clk_i`.
macro_rules! clocked {
    ($($module:ident<$($width:ident),*>),* $(,)?) => { $(
        impl<$(const $width: usize),*> Clocked for $module<$($width),*> {
            fn clk_i(&mut self) -> &mut Signal<In, Clock> {
                &mut self.clk_i
            }
        }
    )* };
}

use crate::pipelines::{DualSplitPipeline, RayBoxParallel, RayBoxPipeline, SharedUnits};
use crate::units::{FpAdd, FpCmp, FpMinMax, FpMul, IntAdd};
clocked! {
    DualSplitPipeline<E, S, W, X, R, N, P, C, T>,
    RayBoxPipeline<E, S, W, X, R, N, P, C, T>,
    RayBoxParallel<E, S, W, X, R, N, P, K, C, T>,
    SharedUnits<E, S, W, X, R, N, P, T>,
    FpAdd<E, S, W, X, R, N, T>,
    FpMul<E, S, W, X, R, P, T>,
    FpCmp<E, S, W, T>,
    FpMinMax<E, S, W, T>,
    IntAdd<B, T>,
}
