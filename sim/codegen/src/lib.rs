//! Writes the simulation of a netlist as Rust text.
//!
//! A build script adds its designs to [`Programs`] and writes them. `lanes::include_programs!` includes the result in the crate that
//! compiles the functions. The text is the same on every machine. The crate `compiled` shows both halves.
//!
//! | module | what it does |
//! |---|---|
//! | `unit` | finds the units: modules whose outputs come from registers, each of which becomes a function |
//! | `idioms` | finds shapes for which the processor has instructions |
//! | `reduce` | shortens what is computed |
//! | `schedule` | orders the stores of a unit |
//! | `emit` | writes the text |
//! | `flush` | makes a pipeline a function of its inputs alone |
//!
//! ```
//! use codegen::Programs;
//! use netlist::{BinaryOp, Design, Graph, Module, Node, Op, Port, SignalType};
//!
//! // A module that adds two words of 16 bits.
//! let port = |name: &str| Port { name: name.into(), width: 16, signal_type: SignalType::Bits };
//! let mut graph = Graph::default();
//! let [a, b] = [0, 1].map(|input| graph.intern(Node { op: Op::Input(input), width: 16 }));
//! let sum = graph.intern(Node { op: Op::Binary(BinaryOp::Add, a, b), width: 16 });
//! let adder = Module {
//!     name: "adder".into(),
//!     kind: "adder".into(),
//!     generics: String::new(),
//!     parameters: vec![],
//!     clock: None,
//!     inputs: vec![port("a"), port("b")],
//!     outputs: vec![(port("sum"), sum)],
//!     graph,
//!     registers: vec![],
//!     instances: vec![],
//!     names: vec![],
//! };
//!
//! let mut programs = Programs::default();
//! programs.add(&Design { modules: vec![adder] }, "\"adder\"", false);
//! let folder = std::env::temp_dir().join(format!("codegen-{}", std::process::id()));
//! std::fs::create_dir_all(&folder)?;
//! programs.write(&folder, "example", "&'static str");
//! let text = std::fs::read_to_string(folder.join("scalar_example.rs"))?;
//! assert!(text.contains("fn program_0_adder_settle"));
//! # std::fs::remove_dir_all(&folder)?;
//! # Ok::<(), std::io::Error>(())
//! ```

mod emit;
mod flush;
mod idioms;
mod logic;
mod program;
mod reduce;
mod schedule;
mod unit;

pub use program::Programs;
