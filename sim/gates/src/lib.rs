//! The hardware as gates: and-inverter graph, proofs, mapping to a cell library, area, timing and energy.
//!
//! ```text
//!  Flat --blast--> Aig --simulate--> values and toggles
//!                   |---aiger------> files for other tools
//! ```

pub mod aig;
pub mod aiger;
pub mod blast;
pub mod energy;
pub mod glitch;
pub mod liberty;
pub mod map;
pub mod multiply;
pub mod prove;
pub mod simulate;
pub mod timing;
pub mod words;
