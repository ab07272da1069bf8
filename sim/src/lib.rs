//! What the tool `dualsplit` is made of, as a library: pictures and their comparison, traversal step by step, the hardware
//! as gates, and its area and energy.

pub mod charts;
pub mod estimate;
pub mod gates;
pub mod needs;
pub mod picture;
pub mod plot;
pub mod report;
pub mod stress;
pub mod unit_costs;
pub mod walk;
