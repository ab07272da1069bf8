//! Elaboration, guard, inventory and mutations on small modules of every language feature.

mod elaboration;
mod errors;
mod guarding;
mod modules;
mod mutating;
mod packages;
mod random;
mod support;
mod units;
mod verilog;
