//! What the tool `dualsplit` is made of, as a library: pictures and their comparison, traversal step by step, waveforms'
//! inputs, the hardware as gates, its area and energy, and the machine that it is part of.

pub mod drive;
pub mod estimate;
pub mod gates;
pub mod machine;
pub mod picture;
pub mod plot;
pub mod report;
pub mod unit_costs;
pub mod walk;
