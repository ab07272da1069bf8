//! Proofs that two circuits compute the same, for all inputs and states.

mod combinational;
mod miter;
pub mod reference;
mod solver;
mod sums;
mod sweep;
mod theorems;
pub mod verilog;

pub use combinational::{CombinationalError, combinational};
pub use miter::{Miter, MiterError, copy};
pub use sums::{SumCase, Sums};
pub use sweep::{Limits, Proof, Verdict, prove};
pub use theorems::{Theorem, TheoremError};
