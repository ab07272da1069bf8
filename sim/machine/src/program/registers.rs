//! The registers of a thread.

/// A register: 0 to 31 integer, 32 to 63 floating point, then those below.
pub type Register = u8;

/// The register that always reads zero.
pub const ZERO: Register = 0;
/// The stack pointer.
pub const STACK_POINTER: Register = 29;
/// The first floating-point register.
pub const FIRST_FLOAT: Register = 32;
/// What a comparison of floats has found: 0 or 1.
pub const CONDITION: Register = 64;
/// What lanes of boxes are loaded to; the scoreboard waits for the last lane that was loaded.
pub const LANE_WORDS: Register = 65;
/// Number of registers.
pub const REGISTERS: usize = 71;
/// What is written to [`ZERO`] goes here, and is read by nothing.
pub const SINK: Register = 255;

/// The register that `operand` names.
#[must_use]
pub fn register(operand: &str) -> Option<Register> {
    let name = operand.strip_prefix('$')?;
    match name {
        "zero" => Some(ZERO),
        "at" => Some(1),
        "gp" => Some(28),
        "sp" => Some(STACK_POINTER),
        "fp" => Some(30),
        "ra" => Some(31),
        "fcc0" => Some(CONDITION),
        _ => match name.strip_prefix('f') {
            Some(number) => number.parse().ok().filter(|n| *n < 32).map(|n: u8| n + FIRST_FLOAT),
            None => name.parse().ok().filter(|n| *n < 32),
        },
    }
}

/// The name of `register` in a listing.
#[must_use]
pub fn name(register: Register) -> String {
    match register {
        ZERO => "$zero".to_owned(),
        STACK_POINTER => "$sp".to_owned(),
        CONDITION => "$fcc0".to_owned(),
        _ if register < FIRST_FLOAT => format!("${register}"),
        _ if register < CONDITION => format!("$f{}", register - FIRST_FLOAT),
        _ => format!("lane word {}", register - LANE_WORDS),
    }
}
