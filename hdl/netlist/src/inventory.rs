//! What a design consists of, counted in its elaborated hierarchy.

use std::collections::BTreeMap;

use serde::Serialize;

use super::design::{Design, Module};
use super::error::ElaborateError;
use super::flatten::{Flat, flatten};
use super::graph::{BinaryOp, Op, UnaryOp};

/// Counts for a design; serialises to JSON with these names.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Inventory {
    /// Name of the top module.
    pub name: String,
    /// Number of instances of each kind of module beneath the top, specialisations of a kind together.
    pub units: BTreeMap<String, u32>,
    /// Registers on every path from an input to an output, if all have the same number: the latency in cycles. Clock
    /// enables do not count as data. The latency is also absent for designs with feedback or without a data path.
    pub latency_cycles: Option<u32>,
    /// Fewest and most registers between inputs and each output that depends on any; absent with feedback.
    pub output_latency_cycles: Option<BTreeMap<String, (u32, u32)>>,
    /// Bits of all registers.
    pub register_bits: u64,
    /// Bits of all two-way multiplexers: a choice between two words of n bits counts n.
    pub multiplexer_bits: u64,
    /// Longest chain of nodes between registers.
    pub logic_levels: u32,
    /// Each module of the design, children first.
    pub modules: Vec<ModuleInventory>,
}

/// Counts for one module, without those of its instances.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct ModuleInventory {
    /// Name in the design.
    pub name: String,
    /// Kind in the source.
    pub kind: String,
    /// Times that it exists in the flattened hierarchy.
    pub instances: u32,
    /// Bits of its own registers.
    pub register_bits: u64,
    /// Bits of its own two-way multiplexers.
    pub multiplexer_bits: u64,
    /// Its own operations by kind: how many, and the bits of their results together (of the operands, for
    /// comparisons and reductions). Wiring and masking with constants are not listed.
    pub operations: BTreeMap<String, OperationCount>,
}

/// Number and size of the operations of one kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct OperationCount {
    /// Nodes.
    pub count: u32,
    /// Bits of all of them.
    pub bits: u64,
}

/// Counts a design.
///
/// # Errors
/// When the design has a combinational loop.
pub fn inventory(design: &Design) -> Result<Inventory, ElaborateError> {
    let flat = flatten(design)?;
    let mut instances = vec![0u32; design.modules.len()];
    let mut units: BTreeMap<String, u32> = BTreeMap::new();
    for scope in &flat.scopes {
        instances[scope.module.index()] += 1;
        if scope.parent.is_some() {
            *units.entry(design.module(scope.module).kind.clone()).or_default() += 1;
        }
    }
    let modules: Vec<ModuleInventory> =
        design.modules.iter().zip(instances).map(|(module, count)| count_module(module, count)).collect();
    let output_latency_cycles = latencies(&flat);
    let total =
        |bits: fn(&ModuleInventory) -> u64| modules.iter().map(|m| u64::from(m.instances) * bits(m)).sum();
    Ok(Inventory {
        name: design.top().name.clone(),
        units,
        latency_cycles: output_latency_cycles.as_ref().and_then(common_latency),
        output_latency_cycles,
        register_bits: total(|module| module.register_bits),
        multiplexer_bits: total(|module| module.multiplexer_bits),
        logic_levels: flat.depth(),
        modules,
    })
}

fn count_module(module: &Module, instances: u32) -> ModuleInventory {
    let mut operations: BTreeMap<String, OperationCount> = BTreeMap::new();
    let mut multiplexer_bits = 0;
    for node in module.graph.nodes() {
        if let Op::Mux { .. } = node.op {
            multiplexer_bits += u64::from(node.width);
        }
        let is_mask = matches!(node.op, Op::Binary(BinaryOp::And | BinaryOp::Or | BinaryOp::Xor, a, b)
            if module.graph.constant_value(a).or(module.graph.constant_value(b)).is_some());
        if let Some(name) = operation_name(node.op).filter(|_| !is_mask) {
            let bits = match node.op {
                Op::Binary(op, a, _) if op.is_comparison() => module.graph.width(a),
                Op::Unary(UnaryOp::ReduceAnd | UnaryOp::ReduceOr | UnaryOp::ReduceXor, a) => {
                    module.graph.width(a)
                }
                _ => node.width,
            };
            let entry = operations.entry(name.to_owned()).or_default();
            entry.count += 1;
            entry.bits += u64::from(bits);
        }
    }
    ModuleInventory {
        name: module.name.clone(),
        kind: module.kind.clone(),
        instances,
        register_bits: module.registers.iter().map(|register| u64::from(register.width)).sum(),
        multiplexer_bits,
        operations,
    }
}

fn operation_name(op: Op) -> Option<&'static str> {
    Some(match op {
        Op::Unary(UnaryOp::Not, _) => "not",
        Op::Unary(UnaryOp::Negate, _) => "negate",
        Op::Unary(_, _) => "reduce",
        Op::Binary(op, _, _) => match op {
            BinaryOp::And => "and",
            BinaryOp::Or => "or",
            BinaryOp::Xor => "xor",
            BinaryOp::Add => "add",
            BinaryOp::Sub => "subtract",
            BinaryOp::Mul => "multiply",
            BinaryOp::Eq | BinaryOp::Ne => "equal",
            BinaryOp::Lt | BinaryOp::Le | BinaryOp::SignedLt | BinaryOp::SignedLe => "less",
            BinaryOp::Shl | BinaryOp::Shr => "shift",
        },
        Op::Mux { .. } => "multiplexer",
        Op::Constant(_) | Op::Input(_) | Op::Register(_) | Op::Instance { .. } => return None,
        Op::Slice { .. } | Op::Concat { .. } | Op::Extend { .. } => return None,
    })
}

fn common_latency(outputs: &BTreeMap<String, (u32, u32)>) -> Option<u32> {
    let mut all = outputs.values();
    let &(first, _) = all.next()?;
    outputs.values().all(|&(least, most)| least == first && most == first).then_some(first)
}

/// Registers on every path from an input to an output, if they are equally many.
#[must_use]
pub fn latency_cycles(flat: &Flat) -> Option<u32> {
    common_latency(&latencies(flat)?)
}

/// Fewest and most registers between inputs and each output; outputs that depend on no input are left out.
/// `None` when a register depends on itself.
fn latencies(flat: &Flat) -> Option<BTreeMap<String, (u32, u32)>> {
    let nodes = register_depths(flat)?;
    let outputs = flat.outputs.iter();
    Some(outputs.filter_map(|(port, id)| Some((port.name.clone(), nodes[id.index()]?))).collect())
}

/// Fewest and most registers between the inputs and each node, by position in [`Flat::nodes`]; none for a node that
/// depends on no input. `None` when a register depends on itself. Clock enables do not count as data.
#[must_use]
pub fn register_depths(flat: &Flat) -> Option<Vec<Option<(u32, u32)>>> {
    // A register may come before its data in position order, so the loop repeats until nothing changes. If it takes
    // more rounds than there are registers, the design has feedback.
    let mut registers: Vec<Option<(u32, u32)>> = vec![None; flat.registers.len()];
    for _ in 0..=flat.registers.len() {
        let mut nodes: Vec<Option<(u32, u32)>> = Vec::with_capacity(flat.nodes.len());
        for node in &flat.nodes {
            nodes.push(match node.op {
                Op::Input(_) => Some((0, 0)),
                Op::Register(register) => registers[register as usize],
                op => op.operands().filter_map(|id| nodes[id.index()]).reduce(widest),
            });
        }
        let next: Vec<_> = (flat.registers.iter())
            .map(|register| nodes[register.data.index()].map(|(least, most)| (least + 1, most + 1)))
            .collect();
        if next == registers {
            return Some(nodes);
        }
        registers = next;
    }
    None
}

fn widest(a: (u32, u32), b: (u32, u32)) -> (u32, u32) {
    (a.0.min(b.0), a.1.max(b.1))
}
