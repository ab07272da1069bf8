//! What the tool `dualsplit` is made of, as a library: pictures and charts, fast simulation of the hardware, the hardware as
//! gates with its area and energy, and the machine that it is part of.

pub mod charts;
pub mod drive;
pub mod estimate;
pub mod fidelity;
pub mod gates;
pub mod logic;
pub mod machine;
pub mod needs;
pub mod picture;
pub mod plot;
pub mod report;
pub mod stress;
pub mod unit_costs;
pub mod walk;
