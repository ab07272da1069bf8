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
//! Each lane is a copy of the netlist with inputs and registers of its own. All engines are cycle-accurate, with registers at
//! their power-up values, stalls and bubbles. [`agreement`] compares any of them with the reference, [`check`] with the
//! specification; [`recorder`] makes a waveform of any lane; [`steps`] does single traversal steps by netlist.

pub mod agreement;
pub mod blasted;
pub mod check;
pub mod interpreter;
pub mod recorder;
pub mod rust_hdl;
pub mod steps;
pub mod verilated;
