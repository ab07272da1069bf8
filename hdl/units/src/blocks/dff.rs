//! Registers: the only elements with state.

use netlist::module;
use rust_hdl_core::prelude::*;

/// A rising-edge register that starts at zero.
///
/// ```text
///        +-----+
///   d -->|     |--> q
///        | Dff |
/// clock >|     |
///        +-----+
/// ```
#[derive(LogicBlock, Default, Clone, Debug)]
pub struct Dff<T: Synth> {
    /// Next value.
    pub d: Signal<In, T>,
    /// Value.
    pub q: Signal<Out, T>,
    /// Clock.
    pub clock: Signal<In, Clock>,
}

impl<T: Synth> Logic for Dff<T> {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.q.next = self.d.val();
        }
    }

    fn connect(&mut self) {
        self.q.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(verilog(T::default()))
    }

    fn timing(&self) -> Vec<TimingInfo> {
        module::register()
    }
}

/// A register of one bit that reset clears: whether the operation beside it exists.
///
/// Reset is no signal of the source, which starts at zero as any [`Dff`] does. The exported Verilog has it as a port.
#[derive(LogicBlock, Default, Clone, Debug)]
pub struct Valid {
    /// Next value.
    pub d: Signal<In, Bit>,
    /// Value.
    pub q: Signal<Out, Bit>,
    /// Clock.
    pub clock: Signal<In, Clock>,
}

impl Logic for Valid {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.q.next = self.d.val();
        }
    }

    fn connect(&mut self) {
        self.q.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(verilog(Bit::default()))
    }

    fn timing(&self) -> Vec<TimingInfo> {
        module::reset_register()
    }
}

/// A register as `rust-hdl` exports it.
fn verilog<T: Synth>(initial: T) -> String {
    format!(
        "initial begin\n   q = {:x};\nend\n\nalways @(posedge clock) begin\n   q <= d;\nend\n",
        initial.verilog()
    )
}

/// Clocks the listed registers and lets each hold its value, until a later assignment says otherwise.
///
/// The name and the form are those that `rust-hdl`'s kernel translator knows; the clock is a bundle's.
#[macro_export]
macro_rules! dff_setup {
    ($self:ident, $bundle:ident.$clock:ident, $($register:ident),+ $(,)?) => {
        $(
            $self.$register.clock.next = $self.$bundle.$clock.val();
            $self.$register.d.next = $self.$register.q.val();
        )+
    };
}
