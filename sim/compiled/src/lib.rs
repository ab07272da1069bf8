//! The compiled simulation of the catalogue: functions that the build script has written.

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
