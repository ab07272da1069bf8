//! The ports that every clocked module has.

use rust_hdl_core::prelude::*;

/// Clock and enable of a module. A parent passes its own on: `ClockEnable::link(&mut self.clocking, &mut self.adder.clocking)`.
///
/// As of every bundle, the fields are the module's ports by their own names.
#[derive(LogicInterface, Default, Clone, Debug)]
pub struct ClockEnable {
    /// Clock.
    pub clk_i: Signal<In, Clock>,
    /// Enable; low holds every register.
    pub en_i: Signal<In, Bit>,
}
