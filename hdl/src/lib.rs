//! The hardware: floating-point units and traversal pipelines as synthesizable-style modules.
//!
//! Every module is written once for all formats. Its widths are const generics: `E` exponent bits and `S` significand
//! bits (hidden bit included, as in [`golden::fp::Format`]) are free, the others follow from them, and a constant assertion
//! checks each relation when a module is instantiated. [`formats`] names the usual instances.
//!
//! | generic | value | meaning |
//! |---|---|---|
//! | `E` | | exponent bits |
//! | `S` | | significand bits |
//! | `W` | `E + S` | a value |
//! | `X` | `E + 2` | exponent of an unrounded result |
//! | `R` | `S + 2` | significand of an unrounded result: `S` bits, round bit, sticky bit |
//! | `N` | `S + 4` | sum of two significands: carry, `S` bits, three bits below |
//! | `P` | `2 * S` | product of two significands |
//! | `C` | | comparators that a pipeline has of those that are not needed in every variant |
//! | `T` | | tag that travels with an operation |
//!
//! # Conventions
//! * One clock `clk_i`, no reset: registers start at zero, and a pipeline of `L` cycles is empty after `L` enabled
//!   cycles with `valid_i` low.
//! * `en_i` low holds every register. While it is high, a module of latency `L` accepts one operation per cycle and
//!   shows its result, with `valid_o` and `tag_o`, after `L` rising edges.
//! * Ports end in `_i` or `_o`; every output comes from a register unless the module says otherwise.
//! * Kernels keep to one arithmetic operation per signal of its exact width and cast plain signals only, because
//!   Verilog evaluates an expression in the width of its context and Rust does not.
//! * Kernels assign every output and every input of a submodule exactly once, from a local signal where a choice is to be
//!   made: a default that is overwritten would be a glitch to an event-driven simulator, and parent and child
//!   could wake each other for ever.

pub mod blocks;
pub mod catalogue;
pub mod clocking;
pub mod equivalence;
pub mod formats;
pub mod module;
pub mod netlist;
pub mod pipelines;
pub mod units;
pub mod verilog;
pub mod wave;
mod widths;
