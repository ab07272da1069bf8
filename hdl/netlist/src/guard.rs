//! The guard against kernels whose simulation and exported Verilog differ.
//!
//! rust-hdl prints a kernel's expressions as they stand, and Verilog reads them by other rules: operands are
//! widened to their context before the operation, literals have 32 bits, precedence differs, bits beyond a
//! signal are unknown. `bit_cast::<9, 8>(a + b)` keeps a carry in Verilog that Rust drops. The guard executes
//! every kernel by both rules into one graph. Where hash-consing makes the two results one node they are equal
//! for all inputs; the others are compared on corner and random values of the kernel's inputs, instance
//! outputs and registers, each taken as free.
//!
//! The guard also reports a kernel that relies on an invariant of its inputs, such as an index that never reaches the
//! end: the exported module cannot know the invariant.

use std::collections::BTreeSet;

use rust_hdl_core::ast::Verilog;
use rust_hdl_core::prelude::Block;

use super::error::{ElaborateError, ErrorKind, Location};
use super::eval::evaluate;
use super::graph::{Graph, Op, mask};
use super::kernel::{Semantics, display_name, execute, execute_comparing};
use super::lower::at_module;
use super::probe::{self, Scope};
use super::signals::{Destination, Role, Signals};
use super::verilog_semantics::FIRST_UNKNOWN;
use base::split_mix::hash;

/// Stimuli for each kernel whose two readings are not the same graph.
const VECTORS: u64 = 4096;

/// What the guard did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GuardReport {
    /// Distinct kernels executed.
    pub kernels: u32,
    /// Values that both readings compute by the same node: equal for all inputs.
    pub values_identical: u32,
    /// Values compared on [`GuardReport::vectors`] stimuli.
    pub values_simulated: u32,
    /// Stimuli applied, over all kernels.
    pub vectors: u64,
}

/// A value on which Rust and Verilog differ.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{at}: `{target}` is {rust:#x} in Rust but {verilog:#x} in the exported Verilog, for {}; \
     keep one operation per local of its exact width, cast plain signals only, parenthesise mixed operators",
    format_inputs(.inputs)
)]
pub struct Disagreement {
    /// The first statement that differs, or the module if only an index beyond a signal does.
    pub at: Location,
    /// The output, register or instance input that differs.
    pub target: String,
    /// Its value by Rust's rules.
    pub rust: u128,
    /// Its value by Verilog's rules.
    pub verilog: u128,
    /// The stimulus: values of the kernel's inputs.
    pub inputs: Vec<(String, u128)>,
}

fn format_inputs(inputs: &[(String, u128)]) -> String {
    inputs.iter().map(|(name, value)| format!("{name} = {value:#x}")).collect::<Vec<_>>().join(", ")
}

/// Why a module does not pass the guard.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum GuardError {
    /// A kernel does not elaborate.
    #[error(transparent)]
    Elaborate(#[from] ElaborateError),
    /// A kernel means different things to Rust and to Verilog.
    #[error(transparent)]
    Disagreement(Box<Disagreement>),
}

/// Checks every kernel of a module.
///
/// # Errors
/// [`GuardError`] for the first kernel, in instance order, whose readings differ or that does not elaborate.
pub fn guard(module: &dyn Block) -> Result<GuardReport, GuardError> {
    let path = "top";
    let scope = probe::read(module, path)
        .ok_or_else(|| at_module(path, ErrorKind::NotUnderstood("a module without scope".into())))?;
    let mut report = GuardReport::default();
    visit(&scope, path, &mut BTreeSet::new(), &mut report)?;
    Ok(report)
}

fn visit(
    scope: &Scope,
    path: &str,
    seen: &mut BTreeSet<String>,
    report: &mut GuardReport,
) -> Result<(), GuardError> {
    for child in scope.children.iter().filter(|child| !child.is_register()) {
        visit(child, &format!("{path}.{}", display_name(&child.name)), seen, report)?;
    }
    let interfaces: Vec<_> = scope.children.iter().map(|child| (&child.name, &child.atoms)).collect();
    let is_new = seen.insert(format!("{:?} {:?} {interfaces:?}", scope.atoms, scope.code));
    if is_new { check(scope, path, report) } else { Ok(()) }
}

fn check(scope: &Scope, path: &str, report: &mut GuardReport) -> Result<(), GuardError> {
    let Verilog::Combinatorial(block) = &scope.code else { return Ok(()) };
    let signals = Signals::of(scope).map_err(|kind| at_module(path, kind))?;
    let mut graph = Graph::default();
    let rust = execute(block, &signals, &mut graph, Semantics::Rust, path)?;
    let verilog = execute(block, &signals, &mut graph, Semantics::Verilog, path)?;
    report.kernels += 1;
    let mut differing = Vec::new();
    for (target, (&r, &v)) in signals.targets.iter().zip(rust.values.iter().zip(&verilog.values)) {
        match target.destination {
            Destination::Local | Destination::Clock => {}
            _ if r == v => report.values_identical += 1,
            _ => differing.push((target, r, v)),
        }
    }
    report.values_simulated += differing.len() as u32;
    if differing.is_empty() {
        return Ok(());
    }
    report.vectors += VECTORS;
    for vector in 0..VECTORS {
        let mut stimulus = Stimulus::new(vector);
        let values = evaluate(&graph, |op, width| stimulus.value(op, width));
        for &(target, r, v) in &differing {
            if values[r.index()] != values[v.index()] {
                let at =
                    Location { path: path.to_owned(), statement: origin(scope, &signals, path, vector)? };
                return Err(GuardError::Disagreement(Box::new(Disagreement {
                    at,
                    target: display_name(&target.name),
                    rust: values[r.index()],
                    verilog: values[v.index()],
                    inputs: inputs(&signals, &graph, &values),
                })));
            }
        }
    }
    Ok(())
}

/// The first executed statement whose expression differs for a stimulus.
fn origin(scope: &Scope, signals: &Signals, path: &str, vector: u64) -> Result<String, ElaborateError> {
    let Verilog::Combinatorial(block) = &scope.code else { return Ok(String::new()) };
    let mut graph = Graph::default();
    let outcome = execute_comparing(block, signals, &mut graph, path)?;
    let mut stimulus = Stimulus::new(vector);
    let values = evaluate(&graph, |op, width| stimulus.value(op, width));
    let value = |node: super::graph::NodeId| values[node.index()];
    let first = outcome.comparisons.iter().find(|c| value(c.path) == 1 && value(c.rust) != value(c.verilog));
    Ok(first.map(|comparison| comparison.statement.clone()).unwrap_or_default())
}

fn inputs(signals: &Signals, graph: &Graph, values: &[u128]) -> Vec<(String, u128)> {
    let mut list = Vec::new();
    for (id, node) in graph.iter() {
        let named = signals.by_name.iter().find(|(_, signal)| signal.role == Role::Source(node.op));
        if let Some((name, _)) = named {
            list.push((display_name(name), values[id.index()]));
        }
    }
    list
}

/// Values for the sources of a graph, a pure function of the vector's number and the source.
struct Stimulus {
    vector: u64,
}

impl Stimulus {
    fn new(vector: u64) -> Self {
        Self { vector }
    }

    /// One in four sources has a corner value and one in eight copies a value shared by all sources.
    fn value(&mut self, op: Op, width: u32) -> u128 {
        let source = match op {
            Op::Input(i) if i >= FIRST_UNKNOWN => (3 << 60) | u64::from(i),
            Op::Input(i) => u64::from(i),
            Op::Register(i) => (1 << 60) | u64::from(i),
            Op::Instance { instance, output } => (2 << 60) | u64::from(instance) << 24 | u64::from(output),
            _ => 0,
        };
        let random = hash(self.vector ^ hash(source));
        let shared = u128::from(hash(self.vector.wrapping_mul(3))) << 64 | u128::from(hash(self.vector));
        let wide = u128::from(hash(random)) << 64 | u128::from(hash(random ^ 1));
        let value = match random % 16 {
            0 => 0,
            1 => mask(width),
            2 => 1,
            3 => 1 << (width - 1),
            4 | 5 => shared,
            6 => wide & 7,
            _ => wide,
        };
        value & mask(width)
    }
}
