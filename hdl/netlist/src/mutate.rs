//! Mutations: small faults put into an elaborated design, to show that a test notices them.
//!
//! A mutation names a module and a value in it, so a table of them reads like the faults an engineer makes, and
//! applies at run time: nothing is recompiled. It holds for every instance of the module.

use std::collections::BTreeMap;
use std::fmt;

use super::design::{Design, Module, Register};
use super::graph::{BinaryOp, Graph, Node, NodeId, Op, UnaryOp, mask};

/// A fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutation {
    /// Name or kind of the module; a kind stands for all its specialisations that have the value.
    pub module: String,
    /// The value: a local, a register, an output or an input of the module.
    pub value: String,
    /// What is done to it.
    pub change: Change,
}

/// What is done to a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// The operands of the operation that computes it change places: `a - b` becomes `b - a`, a choice takes
    /// the other value.
    SwapOperands,
    /// The operation that computes it becomes another one of the same shape.
    Operator(BinaryOp),
    /// All its bits are inverted.
    Invert,
    /// One bit has a fixed value.
    StuckBit {
        /// Position from the lowest bit.
        bit: u32,
        /// The value.
        value: bool,
    },
    /// All bits have fixed values.
    Constant(u128),
    /// One is added, modulo 2^width.
    Increment,
    /// It and another value of the same width change places.
    Exchange(String),
    /// Another value of the same width is taken instead.
    Replace(String),
    /// Some bits are taken from another value of the same width.
    TakeBits {
        /// The other value.
        other: String,
        /// Position of the lowest bit taken.
        low: u32,
        /// Number of bits.
        count: u32,
    },
    /// A register passes its data through: one cycle less.
    Bypass,
    /// The value arrives one cycle later.
    Delay,
    /// A register ignores its clock enable.
    IgnoreEnable,
}

impl fmt::Display for Mutation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { module, value, change } = self;
        match change {
            Change::SwapOperands => write!(f, "{module}.{value}: operands swapped"),
            Change::Operator(op) => write!(f, "{module}.{value}: operator {op:?}"),
            Change::Invert => write!(f, "{module}.{value}: inverted"),
            Change::StuckBit { bit, value: stuck } => {
                write!(f, "{module}.{value}: bit {bit} stuck at {}", u8::from(*stuck))
            }
            Change::Constant(constant) => write!(f, "{module}.{value}: always {constant:#x}"),
            Change::Increment => write!(f, "{module}.{value}: one too many"),
            Change::Exchange(other) => write!(f, "{module}.{value}: exchanged with {other}"),
            Change::Replace(other) => write!(f, "{module}.{value}: {other} instead"),
            Change::TakeBits { other, low, count } => {
                write!(f, "{module}.{value}: {count} bits from {low} of {other} instead")
            }
            Change::Bypass => write!(f, "{module}.{value}: register missing"),
            Change::Delay => write!(f, "{module}.{value}: one register too many"),
            Change::IgnoreEnable => write!(f, "{module}.{value}: enable ignored"),
        }
    }
}

/// Why a mutation cannot be applied.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MutationError {
    /// No module has that name or kind, or none of them has the value.
    #[error("no value `{value}` in a module `{module}`")]
    NotFound {
        /// The module asked for.
        module: String,
        /// The value asked for.
        value: String,
    },
    /// The change makes no sense for the value.
    #[error("{0}: not applicable to this value")]
    NotApplicable(String),
    /// The change would make a value depend on itself.
    #[error("{0}: makes a combinational loop")]
    Loop(String),
}

/// The design with a fault in it. The result is for simulation: it may hold logic that nothing needs.
///
/// # Errors
/// [`MutationError`] when the design has no such value or the change does not fit it.
pub fn mutate(design: &Design, mutation: &Mutation) -> Result<Design, MutationError> {
    let mut mutant = design.clone();
    let mut found = false;
    for module in &mut mutant.modules {
        if module.name != mutation.module && module.kind != mutation.module {
            continue;
        }
        if let Some(target) = find(module, &mutation.value) {
            *module = apply_to(module, target, mutation)?;
            found = true;
        }
    }
    if found {
        Ok(mutant)
    } else {
        Err(MutationError::NotFound { module: mutation.module.clone(), value: mutation.value.clone() })
    }
}

/// Every mutation of a standard set that applies to the design: each named value inverted, incremented, stuck
/// in its lowest and highest bit, its operands swapped; each register bypassed, delayed, its enable ignored.
#[must_use]
pub fn mutations(design: &Design) -> Vec<Mutation> {
    let mut list = Vec::new();
    for module in &design.modules {
        let locals = module.names.iter().map(|local| (&local.name, local.node));
        let outputs = module.outputs.iter().map(|(port, node)| (&port.name, *node));
        let mut add = |value: &str, change| {
            list.push(Mutation { module: module.name.clone(), value: value.to_owned(), change });
        };
        for (name, node) in locals.chain(outputs) {
            let Node { op, width } = module.graph.node(node);
            add(name, Change::Invert);
            if width > 1 {
                add(name, Change::Increment);
                add(name, Change::StuckBit { bit: 0, value: false });
                add(name, Change::StuckBit { bit: width - 1, value: true });
            }
            match op {
                Op::Mux { .. } => add(name, Change::SwapOperands),
                Op::Binary(op, a, b) if a != b && !op.is_commutative() => add(name, Change::SwapOperands),
                _ => {}
            }
        }
        for register in &module.registers {
            add(&register.name, Change::Bypass);
            add(&register.name, Change::Delay);
            if register.enable.is_some() {
                add(&register.name, Change::IgnoreEnable);
            }
        }
    }
    list.retain(|mutation| mutate(design, mutation).is_ok());
    list
}

fn find(module: &Module, name: &str) -> Option<NodeId> {
    let source = |op: Op| module.graph.iter().find(|(_, node)| node.op == op).map(|(id, _)| id);
    let local = module.names.iter().find(|local| local.name == name).map(|local| local.node);
    let register = || {
        let position = module.registers.iter().position(|register| register.name == name)?;
        source(Op::Register(position as u32))
    };
    let output = || module.outputs.iter().find(|(port, _)| port.name == name).map(|(_, node)| *node);
    let input = || {
        let position = module.inputs.iter().position(|port| port.name == name)?;
        source(Op::Input(position as u32))
    };
    local.or_else(register).or_else(output).or_else(input)
}

fn apply_to(module: &Module, target: NodeId, mutation: &Mutation) -> Result<Module, MutationError> {
    let not_applicable = || MutationError::NotApplicable(mutation.to_string());
    let mut mutant = module.clone();
    let mut rebuild = Rebuild {
        module,
        graph: Graph::default(),
        map: BTreeMap::new(),
        substitutes: BTreeMap::new(),
        text: mutation.to_string(),
    };
    let other = |name: &str| {
        let other = find(module, name).ok_or_else(not_applicable)?;
        let same_width = module.graph.width(other) == module.graph.width(target);
        if same_width && other != target { Ok(other) } else { Err(not_applicable()) }
    };
    let register_of = |node: NodeId| match module.graph.op(node) {
        Op::Register(register) => Ok(register as usize),
        _ => Err(not_applicable()),
    };
    let width = module.graph.width(target);
    match &mutation.change {
        Change::Exchange(name) => {
            let other = other(name)?;
            rebuild.substitutes.insert(target, Substitute::Original(other));
            rebuild.substitutes.insert(other, Substitute::Original(target));
        }
        Change::Replace(name) => {
            rebuild.substitutes.insert(target, Substitute::Value(other(name)?));
        }
        Change::TakeBits { other: name, low, count } => {
            let kept = mask(width) & !(mask(*count) << low);
            let (target_node, other_node) = (rebuild.original(target)?, other(name)?);
            let other_node = rebuild.original(other_node)?;
            let graph = &mut rebuild.graph;
            let (kept, taken) = (graph.constant(kept, width), graph.constant(mask(width) & !kept, width));
            let left = graph.binary(BinaryOp::And, target_node, kept);
            let right = graph.binary(BinaryOp::And, other_node, taken);
            let spliced = graph.binary(BinaryOp::Or, left, right);
            rebuild.substitutes.insert(target, Substitute::New(spliced));
        }
        Change::Bypass => {
            let data = module.registers[register_of(target)?].data;
            rebuild.substitutes.insert(target, Substitute::Value(data));
        }
        Change::IgnoreEnable => {
            let register = register_of(target)?;
            mutant.registers[register].enable.take().ok_or_else(not_applicable)?;
        }
        Change::Delay => {
            let op = Op::Register(mutant.registers.len() as u32);
            let delayed = rebuild.graph.intern(Node { op, width });
            rebuild.substitutes.insert(target, Substitute::New(delayed));
        }
        Change::StuckBit { bit, .. } if *bit >= width => return Err(not_applicable()),
        Change::Constant(value) if *value > mask(width) => return Err(not_applicable()),
        _ => {
            let original = rebuild.original(target)?;
            let changed = change_value(&mut rebuild.graph, original, &mutation.change);
            let changed = changed.filter(|&node| node != original).ok_or_else(not_applicable)?;
            rebuild.substitutes.insert(target, Substitute::New(changed));
        }
    }
    for register in &mut mutant.registers {
        register.data = rebuild.node(register.data)?;
        register.enable = register.enable.map(|enable| rebuild.node(enable)).transpose()?;
    }
    for (_, node) in &mut mutant.outputs {
        *node = rebuild.node(*node)?;
    }
    for node in mutant.instances.iter_mut().flat_map(|instance| &mut instance.inputs) {
        *node = rebuild.node(*node)?;
    }
    if mutation.change == Change::Delay {
        mutant.registers.push(Register {
            name: format!("{}_delayed", mutation.value),
            width,
            signal_type: super::design::SignalType::Bits,
            initial: 0,
            has_reset: false,
            data: rebuild.original(target)?,
            enable: None,
        });
    }
    for local in &mut mutant.names {
        local.node = rebuild.node(local.node)?;
    }
    mutant.graph = rebuild.graph;
    Ok(mutant)
}

fn change_value(graph: &mut Graph, original: NodeId, change: &Change) -> Option<NodeId> {
    let width = graph.width(original);
    Some(match (change, graph.op(original)) {
        (Change::SwapOperands, Op::Binary(BinaryOp::Shl | BinaryOp::Shr | BinaryOp::Mul, ..)) => return None,
        (Change::SwapOperands, Op::Binary(op, a, b)) => graph.binary(op, b, a),
        (Change::SwapOperands, Op::Mux { select, when_true, when_false }) => {
            graph.mux(select, when_false, when_true)
        }
        (Change::SwapOperands, Op::Concat { high, low }) => graph.concat(low, high),
        (Change::Operator(new), Op::Binary(old, a, b))
            if new.is_comparison() == old.is_comparison()
                && graph.width(a) == graph.width(b)
                && ![*new, old].contains(&BinaryOp::Mul) =>
        {
            graph.binary(*new, a, b)
        }
        (Change::Invert, _) => graph.unary(UnaryOp::Not, original),
        (Change::StuckBit { bit, value }, _) => {
            let (op, constant) =
                if *value { (BinaryOp::Or, 1 << bit) } else { (BinaryOp::And, mask(width) & !(1 << bit)) };
            let constant = graph.constant(constant, width);
            graph.binary(op, original, constant)
        }
        (Change::Constant(value), _) => graph.constant(*value, width),
        (Change::Increment, _) => {
            let one = graph.constant(1, width);
            graph.binary(BinaryOp::Add, original, one)
        }
        _ => return None,
    })
}

#[derive(Clone, Copy)]
enum Substitute {
    /// A node of the new graph.
    New(NodeId),
    /// A node of the old graph, itself substituted where it is.
    Value(NodeId),
    /// A node of the old graph as it was.
    Original(NodeId),
}

/// Copies a graph on demand, some nodes substituted.
struct Rebuild<'m> {
    module: &'m Module,
    graph: Graph,
    map: BTreeMap<(NodeId, bool), Option<NodeId>>,
    substitutes: BTreeMap<NodeId, Substitute>,
    text: String,
}

impl Rebuild<'_> {
    fn node(&mut self, old: NodeId) -> Result<NodeId, MutationError> {
        match self.substitutes.get(&old) {
            Some(Substitute::New(new)) => Ok(*new),
            Some(Substitute::Original(other)) => self.original(*other),
            Some(Substitute::Value(other)) => {
                let other = *other;
                self.guarded((old, true), |rebuild| rebuild.node(other))
            }
            None => self.original(old),
        }
    }

    fn original(&mut self, old: NodeId) -> Result<NodeId, MutationError> {
        self.guarded((old, false), |rebuild| {
            let node = rebuild.module.graph.node(old);
            let mut operands = Vec::with_capacity(3);
            for operand in node.op.operands() {
                operands.push(rebuild.node(operand)?);
            }
            let mut operands = operands.into_iter();
            let op = node.op.map_operands(|operand| operands.next().unwrap_or(operand));
            Ok(rebuild.graph.build(op, node.width))
        })
    }

    /// Computes an entry of the map once; an entry that needs itself is a loop.
    fn guarded(
        &mut self,
        key: (NodeId, bool),
        compute: impl FnOnce(&mut Self) -> Result<NodeId, MutationError>,
    ) -> Result<NodeId, MutationError> {
        match self.map.get(&key) {
            Some(Some(done)) => return Ok(*done),
            Some(None) => return Err(MutationError::Loop(self.text.clone())),
            None => {}
        }
        self.map.insert(key, None);
        let node = compute(self)?;
        self.map.insert(key, Some(node));
        Ok(node)
    }
}
