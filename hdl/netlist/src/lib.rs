//! Elaboration: from a `rust-hdl` module to a typed word graph that keeps the hierarchy.
//!
//! ```text
//!  module --probe--> scopes --signals, kernel--> templates --specialise--> Design --flatten--> Flat
//!                      |                                                     |                  |
//!                      +--guard (Rust's and Verilog's reading agree)         +--inventory       +--eval
//!                                                                            +--mutate
//!                                                                            +--verilog
//! ```
//!
//! [`elaborate`] is a pure function of the module: of its syntax tree (`Logic::hdl`), its instance tree (`Block::accept`) and its
//! constants. Everything else in this crate and the simulators is derived from the [`Design`] that it returns. A block tells its
//! kind by the first entry of `Logic::timing`. The kind `dff` is a register with the ports named there: data, an optional enable,
//! and output; `dff_reset` is one that the hardware's reset clears.
//!
//! A kernel may contain assignments to locals, outputs, registers and instance inputs; `if`, `match`, and `for` over constants; the
//! operators of `Bits`, `Signed` and `bool`; `bit_cast`, `get_bit`, `get_bits`, `replace_bit`, `any`, `all` and `xor`; enums, struct
//! fields, arrays of one dimension, interfaces and links. Words are at most [`MAX_WIDTH`] bits wide. A design has one clock
//! and no tristate. Its reset is no signal of the source: the Verilog has it as a port, and simulations start where it ends.
//!
//! ```
//! use netlist::{Evaluator, elaborate, flatten, verilog};
//! use rust_hdl_core::prelude::*;
//!
//! #[derive(LogicBlock, Default)]
//! struct Average {
//!     a_i: Signal<In, Bits<8>>,
//!     b_i: Signal<In, Bits<8>>,
//!     mean_o: Signal<Out, Bits<8>>,
//!     sum: Signal<Local, Bits<9>>,
//! }
//!
//! impl Logic for Average {
//!     #[hdl_gen]
//!     fn update(&mut self) {
//!         self.sum.next = bit_cast::<9, 8>(self.a_i.val()) + bit_cast::<9, 8>(self.b_i.val());
//!         self.mean_o.next = self.sum.val().get_bits::<8>(1);
//!     }
//!
//!     fn timing(&self) -> Vec<TimingInfo> {
//!         netlist::module::named("average", "")
//!     }
//! }
//!
//! let mut module = Average::default();
//! module.connect_all();
//! let design = elaborate(&module, "average")?;
//! assert!(verilog::text(&design).contains("module average"));
//!
//! let flat = flatten(&design)?;
//! let mut simulation = Evaluator::new(&flat);
//! assert_eq!(simulation.cycle(&[100, 201]), [150]);
//! # Ok::<(), netlist::ElaborateError>(())
//! ```

mod compact;
mod design;
mod engine;
mod error;
mod eval;
mod flatten;
mod fold;
mod graph;
mod guard;
mod index;
mod inventory;
mod kernel;
mod keywords;
mod lower;
pub mod module;
mod mutate;
mod probe;
mod rust_semantics;
mod signals;
mod simplify;
mod source;
mod specialise;
mod statements;
mod tag;
pub mod verilog;
mod verilog_semantics;
pub mod wave;

pub use design::{Design, Instance, LocalName, Module, ModuleId, Parameter, Port, Register, SignalType};
pub use engine::Engine;
pub use error::{ElaborateError, ErrorKind, Location};
pub use eval::{Evaluator, evaluate};
pub use flatten::{Flat, FlatName, FlatNode, FlatRegister, FlatScope, ScopeId, flatten};
pub use graph::{
    BinaryOp, Graph, MAX_WIDTH, Node, NodeId, Op, UnaryOp, apply, as_signed, mask, operand_width,
};
pub use guard::{Disagreement, GuardError, GuardReport, guard};
pub use inventory::{Inventory, ModuleInventory, OperationCount, inventory, latency_cycles, register_depths};
pub use keywords::is_keyword;
pub use mutate::{Change, Mutation, MutationError, mutate, mutations};

pub use tag::elaborate_with_tag;

use rust_hdl_core::prelude::Block;

/// Elaborates a module; the result's top is called `name`.
///
/// # Errors
/// Anything that the language or the project's style forbids, with instance path and statement; see
/// [`ErrorKind`].
pub fn elaborate(module: &dyn Block, name: &str) -> Result<Design, ElaborateError> {
    if is_keyword(name) {
        return Err(lower::at_module(name, ErrorKind::Keyword(name.to_owned())));
    }
    let scope = probe::read(module, name)
        .ok_or_else(|| lower::at_module(name, ErrorKind::NotUnderstood("a module without scope".into())))?;
    elaborate_scope(&scope, name)
}

fn elaborate_scope(scope: &probe::Scope, name: &str) -> Result<Design, ElaborateError> {
    let mut templates = lower::Templates::default();
    let top = templates.add(scope, name)?;
    let design = specialise::specialise(&templates.list, top, name);
    flatten(&design)?;
    Ok(design)
}
