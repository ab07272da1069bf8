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

/// Implements [`Clocked`] for modules whose clock port is in the field `clocking`.
#[macro_export]
macro_rules! clocked {
    ($($module:ident<$($width:ident),*>),* $(,)?) => { $(
        impl<$(const $width: usize),*> $crate::clocking::Clocked for $module<$($width),*> {
            fn clk_i(&mut self) -> &mut ::rust_hdl_core::prelude::Signal<
                ::rust_hdl_core::prelude::In,
                ::rust_hdl_core::prelude::Clock,
            > {
                &mut self.clocking.clk_i
            }
        }
    )* };
}

pub use crate::clocked;

use crate::{FpAdd, FpCmp, FpMinMax, FpMul, IntAdd};
clocked! {
    FpAdd<E, S, W, X, R, N, T>,
    FpMul<E, S, W, X, R, P, T>,
    FpCmp<E, S, W, T>,
    FpMinMax<E, S, W, T>,
    IntAdd<B, T>,
}
