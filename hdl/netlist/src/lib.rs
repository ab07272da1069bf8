//! Elaboration: from a rust-hdl module to a typed word graph with the hierarchy kept.
//!
//! ```text
//!  module --probe--> scopes --signals, kernel--> templates --specialise--> Design --flatten--> Flat
//!                      |                                                     |                  |
//!                      +--guard (Rust's and Verilog's reading agree)         +--inventory       +--eval
//!                                                                            +--mutate
//!                                                                            +--crate::verilog
//! ```
//!
//! [`elaborate`] is a pure function of the module: its syntax tree (`Logic::hdl`), its instance tree
//! (`Block::accept`) and its constants. Everything else in this crate and the simulators is derived from the
//! [`Design`] it returns. A block tells its kind by the first entry of `Logic::timing`; `dff` is a register with
//! the ports named there (data, optional enable; output).
//!
//! What a kernel may contain: assignments to locals, outputs, registers and instance inputs; `if`, `match`, `for`
//! over constants; the operators of `Bits`, `Signed`, `bool`; `bit_cast`, `get_bit`, `get_bits`, `replace_bit`,
//! `any`, `all`, `xor`; enums, struct fields, arrays of one dimension, interfaces and links. Words are at most
//! [`MAX_WIDTH`] bits. One clock, no reset, no tristate.

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
    let mut templates = lower::Templates::default();
    let top = templates.add(&scope, name)?;
    let design = specialise::specialise(&templates.list, top, name);
    flatten(&design)?;
    Ok(design)
}
