//! Elaboration, guard, inventory and mutations on small modules of every language feature.

mod elaboration;
mod errors;
mod guarding;
mod modules;
mod mutating;
mod random;
mod support;
mod tools;
mod units;
mod verilog;
