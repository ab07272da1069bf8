//! Theorems about the hardware, and the circuits that it is proved against.

pub mod reference;
mod sums;
mod theorems;

pub use sums::{SumCase, Sums};
pub use theorems::{Theorem, TheoremError};
