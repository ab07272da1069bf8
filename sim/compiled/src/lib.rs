//! The catalogue of units and pipelines as compiled simulations.
//!
//! The build script writes Rust functions with `codegen`, and this crate compiles them. [`program`] finds the program of a top;
//! [`lanes::Compiled`] runs it.
//!
//! ```
//! use lanes::Compiled;
//! use pipelines::catalogue::{StandardFormat, Top};
//!
//! let program = compiled::program(Top::RayBox, StandardFormat::Binary32).expect("it is compiled");
//! let input = |name: &str| program.inputs[program.input(name).expect("the pipeline has it")].slot;
//! let output = |name: &str| program.outputs[program.output(name).expect("the pipeline has it")].slot;
//!
//! // A ray along z through the box from (-1, -1, 2) to (1, 1, 3), in lane 0.
//! let mut simulation = Compiled::new(program);
//! let box_planes = [("min_x", -1.0), ("min_y", -1.0), ("min_z", 2.0), ("max_x", 1.0), ("max_y", 1.0), ("max_z", 3.0)];
//! for (plane, value) in box_planes {
//!     simulation.words_mut(input(&format!("box_{plane}_i")))[0] = f32::to_bits(value);
//! }
//! for (axis, reciprocal) in [("x", f32::INFINITY), ("y", f32::INFINITY), ("z", 1.0)] {
//!     simulation.words_mut(input(&format!("inv_entry_{axis}_i")))[0] = reciprocal.to_bits();
//!     simulation.words_mut(input(&format!("inv_exit_{axis}_i")))[0] = reciprocal.to_bits();
//! }
//! simulation.words_mut(input("t_max_i"))[0] = f32::INFINITY.to_bits();
//!
//! simulation.flush(0);
//! assert_eq!(simulation.bits(output("hit_o")) & 1, 1);
//! assert_eq!(f32::from_bits(simulation.words(output("t_entry_o"))[0]), 2.0);
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
