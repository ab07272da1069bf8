//! The hierarchy dissolved: one list of nodes in evaluation order, for simulators and mappers.

use std::collections::BTreeMap;

use super::design::{Design, Module, ModuleId, Port, SignalType};
use super::error::{ElaborateError, ErrorKind, Location};
use super::graph::{Node, NodeId, Op};

/// Index of a scope in [`Flat::scopes`].
pub type ScopeId = u32;

/// An instance in the flattened hierarchy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FlatScope {
    /// Name of the instance; the module's for the top.
    pub name: String,
    /// Names from below the top to here, joined by dots; empty for the top.
    pub path: String,
    /// The module instantiated.
    pub module: ModuleId,
    /// The scope that holds the instance; none for the top.
    pub parent: Option<ScopeId>,
}

/// A node of the flattened netlist.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlatNode {
    /// The operation; operands are positions in [`Flat::nodes`]. Never [`Op::Instance`].
    pub op: Op,
    /// Width of the result in bits.
    pub width: u32,
    /// Longest distance from a source in nodes; sources have level 0.
    pub level: u32,
    /// The instance that the node comes from.
    pub scope: ScopeId,
    /// The node in the graph of that instance's module.
    pub origin: NodeId,
}

/// A register of the flattened netlist.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FlatRegister {
    /// Name in its module.
    pub name: String,
    /// The instance that the register comes from.
    pub scope: ScopeId,
    /// Width in bits.
    pub width: u32,
    /// Value at power-up.
    pub initial: u128,
    /// The node that carries the present value.
    pub output: NodeId,
    /// The node with the next value.
    pub data: NodeId,
    /// The node with the clock enable.
    pub enable: Option<NodeId>,
}

/// A named value of the flattened netlist.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FlatName {
    /// The instance whose name it is.
    pub scope: ScopeId,
    /// Name in the module: a port, register or local.
    pub name: String,
    /// The node that carries the value.
    pub node: NodeId,
    /// How the bits are meant.
    pub signal_type: SignalType,
}

/// A flattened netlist. Nodes come after their operands, so position order is an evaluation order.
#[derive(Clone, Debug, PartialEq)]
pub struct Flat {
    /// Inputs of the top without the clock; the index of [`Op::Input`].
    pub inputs: Vec<Port>,
    /// Outputs of the top with the node that drives each.
    pub outputs: Vec<(Port, NodeId)>,
    /// All nodes that the outputs and registers need.
    pub nodes: Vec<FlatNode>,
    /// All registers; the index of [`Op::Register`].
    pub registers: Vec<FlatRegister>,
    /// All instances; the top is the first.
    pub scopes: Vec<FlatScope>,
    /// All named values that exist, by scope and declaration.
    pub names: Vec<FlatName>,
}

impl Flat {
    /// Position of the input with this name.
    #[must_use]
    pub fn input(&self, name: &str) -> Option<usize> {
        self.inputs.iter().position(|port| port.name == name)
    }

    /// Position of the output with this name.
    #[must_use]
    pub fn output(&self, name: &str) -> Option<usize> {
        self.outputs.iter().position(|(port, _)| port.name == name)
    }

    /// Number of levels of logic between sources and sinks.
    #[must_use]
    pub fn depth(&self) -> u32 {
        self.nodes.iter().map(|node| node.level).max().unwrap_or(0)
    }
}

/// Flattens a design.
///
/// # Errors
/// [`ErrorKind::CombinationalLoop`] when a value depends on itself within a cycle, across instances included.
pub fn flatten(design: &Design) -> Result<Flat, ElaborateError> {
    let mut flattener = Flattener::new(design);
    let top = design.top();
    let mut outputs = Vec::new();
    for (port, node) in &top.outputs {
        outputs.push((port.clone(), flattener.resolve(0, *node)?));
    }
    // A register gets its number when the walk reaches it, and its inputs may reach further registers.
    let mut done = 0;
    while let Some(&(scope, position)) = flattener.pending.get(done) {
        let register = &flattener.module(scope).registers[position];
        let data = flattener.resolve(scope, register.data)?;
        let enable = register.enable.map(|enable| flattener.resolve(scope, enable)).transpose()?;
        let flat = &mut flattener.registers[done];
        (flat.data, flat.enable) = (data, enable);
        done += 1;
    }
    let names = flattener.names();
    Ok(Flat {
        inputs: top.inputs.clone(),
        outputs,
        nodes: flattener.nodes,
        registers: flattener.registers,
        scopes: flattener.scopes,
        names,
    })
}

struct Flattener<'d> {
    design: &'d Design,
    scopes: Vec<FlatScope>,
    /// Scope of each instance of a scope.
    children: Vec<Vec<ScopeId>>,
    /// Position of each scope among the instances of its parent.
    positions: Vec<usize>,
    nodes: Vec<FlatNode>,
    registers: Vec<FlatRegister>,
    pending: Vec<(ScopeId, usize)>,
    map: BTreeMap<(ScopeId, NodeId), State>,
}

#[derive(Clone, Copy)]
enum State {
    Open,
    Done(NodeId),
}

impl<'d> Flattener<'d> {
    fn new(design: &'d Design) -> Self {
        let mut flattener = Self {
            design,
            scopes: Vec::new(),
            children: Vec::new(),
            positions: Vec::new(),
            nodes: Vec::new(),
            registers: Vec::new(),
            pending: Vec::new(),
            map: BTreeMap::new(),
        };
        flattener.add_scope(design.top().name.clone(), String::new(), design.top_id(), None, 0);
        flattener
    }

    fn add_scope(
        &mut self,
        name: String,
        path: String,
        module: ModuleId,
        parent: Option<ScopeId>,
        position: usize,
    ) -> ScopeId {
        let id = self.scopes.len() as ScopeId;
        self.scopes.push(FlatScope { name, path: path.clone(), module, parent });
        self.children.push(Vec::new());
        self.positions.push(position);
        for (position, instance) in self.design.module(module).instances.iter().enumerate() {
            let name = instance.name.clone();
            let below = if path.is_empty() { name.clone() } else { format!("{path}.{name}") };
            let child = self.add_scope(name, below, instance.module, Some(id), position);
            self.children[id as usize].push(child);
        }
        id
    }

    fn module(&self, scope: ScopeId) -> &'d Module {
        self.design.module(self.scopes[scope as usize].module)
    }

    /// Where the value of a node comes from: the same node, or one across ports.
    fn across_ports(
        &self,
        mut scope: ScopeId,
        mut node: NodeId,
    ) -> Result<(ScopeId, NodeId), ElaborateError> {
        let mut passed = Vec::new();
        loop {
            if passed.contains(&(scope, node)) {
                return Err(self.loop_error(&passed, (scope, node)));
            }
            passed.push((scope, node));
            match self.module(scope).graph.op(node) {
                Op::Instance { instance, output } => {
                    scope = self.children[scope as usize][instance as usize];
                    node = self.module(scope).outputs[output as usize].1;
                }
                Op::Input(input) => {
                    let Some(parent) = self.scopes[scope as usize].parent else { return Ok((scope, node)) };
                    let position = self.positions[scope as usize];
                    node = self.module(parent).instances[position].inputs[input as usize];
                    scope = parent;
                }
                _ => return Ok((scope, node)),
            }
        }
    }

    /// The flat node of a node, made with everything that the node needs. The walk is depth first with a stack of its
    /// own, because logic may be deeper than a thread's stack.
    fn resolve(&mut self, scope: ScopeId, node: NodeId) -> Result<NodeId, ElaborateError> {
        let start = self.across_ports(scope, node)?;
        let mut stack = vec![start];
        while let Some(&(scope, node)) = stack.last() {
            if let Some(State::Done(_)) = self.map.get(&(scope, node)) {
                stack.pop();
                continue;
            }
            let found = self.module(scope).graph.node(node);
            self.map.insert((scope, node), State::Open);
            let mut waiting = false;
            for operand in found.op.operands() {
                let key = self.across_ports(scope, operand)?;
                match self.map.get(&key) {
                    Some(State::Done(_)) => {}
                    Some(State::Open) => return Err(self.loop_error(&stack, key)),
                    None => {
                        stack.push(key);
                        waiting = true;
                        break;
                    }
                }
            }
            if !waiting {
                let flat = self.emit(scope, node, found)?;
                self.map.insert((scope, node), State::Done(flat));
                stack.pop();
            }
        }
        Ok(self.done(start))
    }

    fn done(&self, key: (ScopeId, NodeId)) -> NodeId {
        match self.map.get(&key) {
            Some(State::Done(id)) => *id,
            _ => unreachable!("operands are resolved before their users"),
        }
    }

    fn emit(&mut self, scope: ScopeId, origin: NodeId, node: Node) -> Result<NodeId, ElaborateError> {
        let id = NodeId(self.nodes.len() as u32);
        let op = match node.op {
            Op::Register(position) => {
                let register = &self.module(scope).registers[position as usize];
                self.registers.push(FlatRegister {
                    name: register.name.clone(),
                    scope,
                    width: register.width,
                    initial: register.initial,
                    output: id,
                    data: id,
                    enable: None,
                });
                self.pending.push((scope, position as usize));
                Op::Register(self.registers.len() as u32 - 1)
            }
            op => {
                let mut operands = Vec::with_capacity(3);
                for operand in op.operands() {
                    operands.push(self.done(self.across_ports(scope, operand)?));
                }
                let mut operands = operands.into_iter();
                op.map_operands(|operand| operands.next().unwrap_or(operand))
            }
        };
        let level = op.operands().map(|id| self.nodes[id.index()].level + 1).max().unwrap_or(0);
        self.nodes.push(FlatNode { op, width: node.width, level, scope, origin });
        Ok(id)
    }

    fn loop_error(&self, stack: &[(ScopeId, NodeId)], closing: (ScopeId, NodeId)) -> ElaborateError {
        let from = stack.iter().position(|key| *key == closing).unwrap_or(0);
        let mut path: Vec<String> =
            stack[from..].iter().rev().filter_map(|&(scope, node)| self.name_of(scope, node)).collect();
        path.dedup();
        let at = Location { path: self.design.top().name.clone(), statement: String::new() };
        ElaborateError { at, kind: ErrorKind::CombinationalLoop(path) }
    }

    fn name_of(&self, scope: ScopeId, node: NodeId) -> Option<String> {
        let module = self.module(scope);
        let local = module.names.iter().find(|local| local.node == node).map(|local| &local.name);
        let output = module.outputs.iter().find(|(_, driver)| *driver == node).map(|(port, _)| &port.name);
        let path = &self.scopes[scope as usize].path;
        let name = local.or(output)?;
        Some(if path.is_empty() { name.clone() } else { format!("{path}.{name}") })
    }

    fn names(&self) -> Vec<FlatName> {
        let mut names = Vec::new();
        for scope in 0..self.scopes.len() as ScopeId {
            let module = self.module(scope);
            let mut add = |name: &str, node: NodeId, signal_type: &SignalType| {
                let source = self.across_ports(scope, node).ok();
                if let Some(State::Done(flat)) = source.and_then(|key| self.map.get(&key)) {
                    let (name, signal_type) = (name.to_owned(), signal_type.clone());
                    names.push(FlatName { scope, name, node: *flat, signal_type });
                }
            };
            for (node, found) in module.graph.iter() {
                match found.op {
                    Op::Input(i) => {
                        let port = &module.inputs[i as usize];
                        add(&port.name, node, &port.signal_type);
                    }
                    Op::Register(r) => {
                        let register = &module.registers[r as usize];
                        add(&register.name, node, &register.signal_type);
                    }
                    _ => {}
                }
            }
            module.names.iter().for_each(|local| add(&local.name, local.node, &local.signal_type));
            module.outputs.iter().for_each(|(port, node)| add(&port.name, *node, &port.signal_type));
        }
        names
    }
}
