//! The hardware as gates: and-inverter graph, proofs, mapping to a cell library, area, timing and energy.
//!
//! ```text
//!  Flat --blast--> Aig --simulate--> values and toggles
//!                   |----prove-----> equal for all inputs, or a counterexample
//!                   |----map-------> cells --timing, energy, glitch--> delay and energy
//!                   |----aiger-----> files for other tools
//! ```
//!
//! | module | what it holds |
//! |---|---|
//! | [`aig`], [`words`] | and-inverter graphs; sums, products and choices as gates |
//! | [`blast`] | a netlist as gates |
//! | [`restructure`] | shallower graphs of the same function |
//! | [`simulate`], [`aiger`] | 64 lanes and more at once; AIGER files |
//! | [`prove`] | equivalence by sweeping and SAT; exported Verilog, read back |
//! | [`liberty`], [`map`], [`abc`] | the cells of a library, or the embedded ones; mapping for area or delay, by ABC for comparison |
//! | [`timing`], [`energy`], [`glitch`] | static timing, buffers, sizing for a clock; energy from changes of nets, with glitches |
//!
//! Two structures of an adder, proved equal for all operands:
//!
//! ```
//! use gates::aig::{Aig, Lit};
//! use gates::prove::{Limits, Verdict, prove};
//! use gates::words::{self, Adder};
//!
//! let mut aig = Aig::default();
//! let mut word = |name: &str| -> Vec<Lit> { (0..32).map(|bit| aig.add_input(format!("{name}{bit}"))).collect() };
//! let (a, b) = (word("a"), word("b"));
//! let (ripple, _) = words::add(&mut aig, Adder::Ripple, &a, &b, Lit::FALSE);
//! let (sklansky, _) = words::add(&mut aig, Adder::Sklansky, &a, &b, Lit::FALSE);
//! let pairs: Vec<(Lit, Lit)> = ripple.into_iter().zip(sklansky).collect();
//! assert_eq!(prove(&aig, &pairs, Limits::default()).verdict, Verdict::Equal);
//! ```

pub mod abc;
pub mod aig;
pub mod aiger;
pub mod blast;
pub mod energy;
pub mod glitch;
pub mod liberty;
pub mod map;
pub mod multiply;
pub mod prove;
pub mod restructure;
pub mod simulate;
pub mod timing;
pub mod words;
