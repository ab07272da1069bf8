//! Simulation of the hardware's logic at the speed of the machine, from the elaborated netlist.
//!
//! | engine | netlists | lanes | for |
//! |---|---|---|---|
//! | [`Compiled`](lanes::Compiled) | the catalogue in binary32 and binary16 | 16 | volume; one vector at a time |
//! | [`Interpreter`](interpreter::Interpreter) | any | 64 | formats and modules made at run time, mutants |
//! | [`GateEngine`](blasted::GateEngine) | any, as gates | 64 | toggles and proofs |
//! | [`netlist::Evaluator`] | any | 1 | the reference that the others are compared with |
//! | [`RustHdl`](rust_hdl::RustHdl) | units and pipelines | 1 | the kernels' own text, executed |
//! | [`Verilated`](verilated::Verilated) | any, as Verilog | 1 | the exported text, by an independent tool; no [`Engine`] |
//!
//! Each lane is a copy of the netlist with inputs and registers of its own. All engines are cycle-accurate: registers start at their
//! power-up values, and stalls and bubbles take effect. [`agreement`] compares any engine with the reference, [`check`] compares the
//! hardware with the specification, [`recorder`] writes a waveform of any lane, and [`steps`] takes single traversal steps by netlist.
//!
//! [`Engine`]: netlist::Engine
//!
//! ```
//! use logic::check::volume::volume;
//! use netlist::flatten;
//! use pipelines::catalogue::{StandardFormat, Top};
//!
//! let (top, format) = (Top::DualSplit, StandardFormat::Binary32);
//! let netlist = flatten(&top.design(format)?)?;
//! let totals = volume(top, format, &netlist, 10_000, 1, |_done| ()).expect("the pipeline is compiled");
//! assert!(totals.vectors >= 10_000);
//! assert_eq!(totals.mismatches, 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod agreement;
pub mod blasted;
pub mod check;
pub mod interpreter;
pub mod recorder;
pub mod rust_hdl;
pub mod steps;
pub mod verilated;
