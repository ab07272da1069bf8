//! What is found out with the crates of dualsplit: precision, stability, needs and fidelity.

pub mod charts;
pub mod drive;
pub mod fidelity;
pub mod needs;
pub mod stress;
pub mod walk;
