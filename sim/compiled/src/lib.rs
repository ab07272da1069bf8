//! The catalogue of units and pipelines as compiled simulations.
//!
//! The build script writes Rust functions with `codegen`, and this crate compiles them. [`program`] finds the program of a top;
//! [`lanes::Compiled`] runs it.
//!
//! ```
//! use lanes::{Compiled, LANES};
//! use netlist::Engine;
//! use pipelines::catalogue::{StandardFormat, Top};
//!
//! let program = compiled::program(Top::FpMul, StandardFormat::Binary32).expect("it is compiled");
//! let port = |name| program.input(name).expect("the multiplier has it");
//! let mut simulation = Compiled::new(program);
//! for lane in 0..LANES {
//!     simulation.set_input(port("en_i"), lane, 1);
//!     simulation.set_input(port("a_i"), lane, (lane as f32).to_bits().into());
//!     simulation.set_input(port("b_i"), lane, 0.5_f32.to_bits().into());
//! }
//! for _ in 0..2 {
//!     simulation.settle();
//!     simulation.clock();
//! }
//! simulation.settle();
//! let result = program.output("result_o").expect("the multiplier has it");
//! assert_eq!(simulation.output(result, 7), u128::from(3.5_f32.to_bits()));
//! ```

use lanes::Program;
use pipelines::catalogue::{StandardFormat, Top};

mod catalogue {
    use pipelines::catalogue::{StandardFormat, Top};
    lanes::include_programs!("catalogue");
}

/// The program of `top` in `format`, if there is one.
#[must_use]
pub fn program(top: Top, format: StandardFormat) -> Option<&'static Program> {
    // The integer adder is the same in every format.
    let format = if top == Top::IntAdd { StandardFormat::Binary32 } else { format };
    programs().iter().find(|(key, _)| *key == (top, format)).map(|(_, program)| program)
}

/// All programs.
#[must_use]
pub fn programs() -> &'static [((Top, StandardFormat), Program)] {
    &catalogue::PROGRAMS
}
