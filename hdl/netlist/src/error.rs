//! What elaboration rejects, and where.

use std::fmt;

/// Where in a design an error is: an instance path and, inside a kernel, a statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location {
    /// Instance names from the top, joined by dots.
    pub path: String,
    /// The statement in Rust-like notation; empty for an error of the module as a whole.
    pub statement: String,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.statement.is_empty() {
            write!(f, "{}", self.path)
        } else {
            write!(f, "{}: `{}`", self.path, self.statement)
        }
    }
}

/// An error of elaboration: where, and what.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{at}: {kind}")]
pub struct ElaborateError {
    /// Where the design is at fault.
    pub at: Location,
    /// What is wrong, with the remedy.
    pub kind: ErrorKind,
}

/// What is wrong with a design, with the remedy.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ErrorKind {
    /// Operands, or a value and its target, differ in width.
    #[error("width mismatch: {left} bits against {right} bits; use bit_cast on the plain signal")]
    WidthMismatch {
        /// Width of the left operand or the target.
        left: u32,
        /// Width of the right operand or the value.
        right: u32,
    },
    /// A width of zero or above [`MAX_WIDTH`](super::MAX_WIDTH).
    #[error("a width of {0} bits; widths are 1 to 128")]
    UnsupportedWidth(usize),
    /// A value is assigned on some paths only.
    #[error("`{0}` keeps its old value on some paths (a latch); assign a default first")]
    Latch(String),
    /// A signal is read before the kernel assigns it.
    #[error("`{0}` is read before it is assigned; move the assignment up")]
    ReadBeforeWrite(String),
    /// A local, an output or an instance's input that nothing assigns.
    #[error("`{0}` is never assigned; assign it in the kernel or remove it")]
    Undriven(String),
    /// Something drives a signal that is already driven from elsewhere.
    #[error("`{0}` has another driver: inputs are driven by the parent, outputs of an instance by itself")]
    MultipleDrivers(String),
    /// Values depend on themselves without a register between.
    #[error("combinational loop through {}; break it with a register", .0.join(" -> "))]
    CombinationalLoop(Vec<String>),
    /// A name that is no signal, constant, enum label or loop variable.
    #[error(
        "unresolved name `{0}`; a const generic or const item cannot be read in a kernel, use a Constant field"
    )]
    Unresolved(String),
    /// A name that Verilog or SystemVerilog reserves.
    #[error("`{0}` is a keyword of SystemVerilog; rename it")]
    Keyword(String),
    /// An expression or statement outside the supported language.
    #[error("not understood: {0}")]
    NotUnderstood(String),
    /// A clock that does not come straight from the clock of the top module.
    #[error(
        "the clock of `{0}` is not this module's clock; clock gating and second clocks are not supported"
    )]
    Clock(String),
}
