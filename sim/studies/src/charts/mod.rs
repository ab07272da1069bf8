//! Sweeps of one scene that chart a cost against an error.

pub mod cost;
pub mod fidelity;
pub mod pareto;
pub mod precision;
