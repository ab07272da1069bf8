//! Elaboration, guard, inventory and mutations on small modules of every language feature.

mod elaboration;
mod modules;
mod support;
mod tools;
mod units;
mod verilog;
