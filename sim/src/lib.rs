//! What the tool `dualsplit` is made of, as a library: pictures and their comparison, and traversal step by step.

pub mod logic;
pub mod picture;
pub mod unit_costs;
pub mod walk;
