//! Proofs that two circuits compute the same, for all inputs and states.

mod combinational;
mod miter;
mod solver;
mod sweep;
pub mod verilog;

pub use combinational::{CombinationalError, combinational};
pub use miter::{Miter, MiterError, copy};
pub use sweep::{Limits, Proof, Verdict, prove};
