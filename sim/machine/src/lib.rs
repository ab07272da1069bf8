//! A many-core machine of the TRaX class, timed cycle by cycle.
//!
//! [`description`] says what the machine consists of; [`program`] holds the programs that its threads run, as basic blocks
//! of instructions with their units, dependences and addresses; [`core`] times them. What a ray does is decided by
//! the golden traversal alone: the timing core executes the blocks that correspond to it and computes nothing itself.

pub mod core;
pub mod costs;
pub mod description;
pub mod frame;
pub mod pipelines;
pub mod program;
pub mod reference;
pub mod results;
