//! Writes the simulation of a netlist as Rust text.
//!
//! A build script adds the designs to [`Programs`] and writes them; `lanes::include_programs!` includes the result where the
//! functions are to be compiled. The text is the same on every machine.

mod emit;
mod flush;
mod idioms;
mod logic;
mod program;
mod reduce;
mod schedule;
mod unit;

pub use program::Programs;
