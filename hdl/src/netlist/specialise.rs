//! Specialisation: constants folded into modules, unused logic removed, each distinct result once.
//!
//! Two passes over the templates, both memoised:
//! 1. *Fold* a template for the inputs that its parent ties. Constants flow through logic, through registers
//!    that can never leave their power-up value, and out of instances, until nothing changes.
//! 2. *Prune* the folded module for the outputs that its parent reads. What no output needs, directly or through
//!    a register or an instance, is dropped together with the ports that fed it.
//!
//! The hierarchy stays: an instance whose rounding mode is tied refers to a module without that port.

use std::collections::{BTreeMap, BTreeSet};

use super::design::{Design, Instance, LocalName, Module, ModuleId, Parameter, Register};
use super::graph::{Graph, NodeId, Op, UnaryOp};

/// The design whose top is the template at position `top`, called `name`.
pub fn specialise(templates: &[Module], top: usize, name: &str) -> Design {
    let mut specialiser = Specialiser { templates, folded: BTreeMap::new(), pruned: BTreeMap::new() };
    let ties = vec![None; templates[top].inputs.len()];
    let demand = vec![true; templates[top].outputs.len()];
    let variant = specialiser.prune(top, &ties, &demand, true);
    Collector::default().collect(&variant, name)
}

type Ties = Vec<Option<u128>>;

/// A template with constants folded: everything in one new graph, indices as in the template.
#[derive(Clone)]
struct Folded {
    graph: Graph,
    outputs: Vec<NodeId>,
    registers: Vec<Register>,
    instance_inputs: Vec<Vec<NodeId>>,
    instance_ties: Vec<Ties>,
    names: Vec<LocalName>,
}

/// A folded module with dead logic removed; instances refer to further variants.
#[derive(Clone)]
struct Variant {
    module: Module,
    children: Vec<std::rc::Rc<Variant>>,
    used_inputs: Vec<bool>,
}

struct Specialiser<'t> {
    templates: &'t [Module],
    folded: BTreeMap<(usize, Ties), std::rc::Rc<Folded>>,
    pruned: BTreeMap<(usize, Ties, Vec<bool>), std::rc::Rc<Variant>>,
}

impl Specialiser<'_> {
    fn fold(&mut self, template: usize, ties: &Ties) -> std::rc::Rc<Folded> {
        let memo = (template, ties.clone());
        if let Some(known) = self.folded.get(&memo) {
            return known.clone();
        }
        let module = &self.templates[template];
        let mut instance_constants: BTreeMap<(u32, u32), u128> = BTreeMap::new();
        let folded = loop {
            let mut folded = fold_registers(module, ties, &instance_constants);
            let mut found_more = false;
            for (i, instance) in module.instances.iter().enumerate() {
                let child_ties: Ties =
                    folded.instance_inputs[i].iter().map(|&n| folded.graph.constant_value(n)).collect();
                let child = self.fold(instance.module.index(), &child_ties);
                for (o, &output) in child.outputs.iter().enumerate() {
                    if let Some(value) = child.graph.constant_value(output) {
                        found_more |= instance_constants.insert((i as u32, o as u32), value).is_none();
                    }
                }
                folded.instance_ties.push(child_ties);
            }
            if !found_more {
                break folded;
            }
        };
        let folded = std::rc::Rc::new(folded);
        self.folded.insert(memo, folded.clone());
        folded
    }

    fn prune(
        &mut self,
        template: usize,
        ties: &Ties,
        demand: &[bool],
        keep_ports: bool,
    ) -> std::rc::Rc<Variant> {
        let memo = (template, ties.clone(), demand.to_vec());
        if let Some(known) = self.pruned.get(&memo) {
            return known.clone();
        }
        let folded = self.fold(template, ties);
        let module = &self.templates[template];
        let live = self.live(module, &folded, demand);
        let mut compact = Compact::new(&folded, &live);
        let used_inputs: Vec<bool> = (0..module.inputs.len())
            .map(|i| ties[i].is_none() && (keep_ports || live.inputs.contains(&(i as u32))))
            .collect();
        compact.number_inputs(&used_inputs);
        let mut children = Vec::new();
        let mut instances = Vec::new();
        for (&i, outputs) in &live.instances {
            let instance = &module.instances[i as usize];
            let child =
                self.prune(instance.module.index(), &folded.instance_ties[i as usize], outputs, false);
            compact.number_instance(i, outputs);
            instances.push((i, instance.name.clone(), child.used_inputs.clone()));
            children.push(child);
        }
        let instances: Vec<Instance> = instances
            .into_iter()
            .enumerate()
            .map(|(position, (i, name, used))| Instance {
                name,
                module: ModuleId(position as u32),
                inputs: (folded.instance_inputs[i as usize].iter().zip(used))
                    .filter(|(_, used)| *used)
                    .map(|(&node, _)| compact.node(node))
                    .collect(),
            })
            .collect();
        let registers: Vec<Register> = (live.registers.iter())
            .map(|&r| {
                let register = &folded.registers[r as usize];
                Register {
                    data: compact.node(register.data),
                    enable: register.enable.map(|enable| compact.node(enable)),
                    ..register.clone()
                }
            })
            .collect();
        let outputs: Vec<_> = (module.outputs.iter().zip(demand).enumerate())
            .filter(|(_, (_, demanded))| **demanded)
            .map(|(o, ((port, _), _))| (port.clone(), compact.node(folded.outputs[o])))
            .collect();
        let tied = module.inputs.iter().zip(ties).filter_map(|(port, tie)| {
            tie.map(|value| Parameter {
                name: port.name.clone(),
                width: port.width,
                value,
                is_tied_input: true,
            })
        });
        let clocked = !registers.is_empty() || children.iter().any(|child| child.module.clock.is_some());
        let module = Module {
            name: module.name.clone(),
            kind: module.kind.clone(),
            generics: module.generics.clone(),
            parameters: module.parameters.iter().cloned().chain(tied).collect(),
            clock: module.clock.clone().filter(|_| clocked),
            inputs: (module.inputs.iter().zip(&used_inputs))
                .filter(|(_, used)| **used)
                .map(|(port, _)| port.clone())
                .collect(),
            outputs,
            names: compact.names(&folded.names),
            graph: compact.graph,
            registers,
            instances,
        };
        let variant = std::rc::Rc::new(Variant { module, children, used_inputs });
        self.pruned.insert(memo, variant.clone());
        variant
    }

    /// What the demanded outputs need.
    fn live(&mut self, module: &Module, folded: &Folded, demand: &[bool]) -> Live {
        let mut live = Live::default();
        let mut pending: Vec<NodeId> =
            folded.outputs.iter().zip(demand).filter(|(_, d)| **d).map(|(&n, _)| n).collect();
        while let Some(node) = pending.pop() {
            if !live.nodes.insert(node) {
                continue;
            }
            pending.extend(folded.graph.op(node).operands());
            match folded.graph.op(node) {
                Op::Input(input) => {
                    live.inputs.insert(input);
                }
                Op::Register(register) if live.registers.insert(register) => {
                    let register = &folded.registers[register as usize];
                    pending.push(register.data);
                    pending.extend(register.enable);
                }
                Op::Instance { instance, output } => {
                    let template = module.instances[instance as usize].module.index();
                    let outputs = live
                        .instances
                        .entry(instance)
                        .or_insert_with(|| vec![false; self.templates[template].outputs.len()]);
                    outputs[output as usize] = true;
                    let outputs = outputs.clone();
                    let child =
                        self.prune(template, &folded.instance_ties[instance as usize], &outputs, false);
                    let inputs = &folded.instance_inputs[instance as usize];
                    pending
                        .extend(inputs.iter().zip(&child.used_inputs).filter(|(_, u)| **u).map(|(&n, _)| n));
                }
                _ => {}
            }
        }
        live
    }
}

#[derive(Default)]
struct Live {
    nodes: BTreeSet<NodeId>,
    inputs: BTreeSet<u32>,
    registers: BTreeSet<u32>,
    /// Outputs that are read, of each instance that has any.
    instances: BTreeMap<u32, Vec<bool>>,
}

/// Folds assuming that every register keeps its power-up value, and drops the assumption where the next value
/// then differs, until it holds: the largest set of registers that never change.
fn fold_registers(module: &Module, ties: &Ties, instances: &BTreeMap<(u32, u32), u128>) -> Folded {
    let mut constant: Vec<bool> = vec![true; module.registers.len()];
    loop {
        let mut graph = Graph::default();
        let map = rewrite(&module.graph, &mut graph, |graph, op, width| match op {
            Op::Input(i) => ties[i as usize].map(|value| graph.constant(value, width)),
            Op::Register(r) if constant[r as usize] => {
                Some(graph.constant(module.registers[r as usize].initial, width))
            }
            Op::Instance { instance, output } => {
                instances.get(&(instance, output)).map(|&value| graph.constant(value, width))
            }
            _ => None,
        });
        let at = |node: NodeId| map[node.index()];
        let mut stable = true;
        for (assumed, register) in constant.iter_mut().zip(&module.registers) {
            let disabled = register.enable.is_some_and(|e| graph.constant_value(at(e)) == Some(0));
            if *assumed && !disabled && graph.constant_value(at(register.data)) != Some(register.initial) {
                *assumed = false;
                stable = false;
            }
        }
        if !stable {
            continue;
        }
        let mut registers = Vec::with_capacity(module.registers.len());
        for (r, register) in module.registers.iter().enumerate() {
            let mut folded =
                Register { data: at(register.data), enable: register.enable.map(at), ..register.clone() };
            extract_enable(&mut graph, r as u32, &mut folded);
            folded.enable = folded.enable.filter(|&enable| graph.constant_value(enable) != Some(1));
            registers.push(folded);
        }
        return Folded {
            outputs: module.outputs.iter().map(|(_, node)| at(*node)).collect(),
            registers,
            instance_inputs: (module.instances.iter())
                .map(|instance| instance.inputs.iter().map(|&node| at(node)).collect())
                .collect(),
            instance_ties: Vec::new(),
            names: (module.names.iter())
                .map(|local| LocalName { node: at(local.node), ..local.clone() })
                .collect(),
            graph,
        };
    }
}

/// Copies every node into `into` by way of the simplifying constructors; `replace` may put another node in the
/// place of a source. Returns the new id of each node.
fn rewrite(
    from: &Graph,
    into: &mut Graph,
    mut replace: impl FnMut(&mut Graph, Op, u32) -> Option<NodeId>,
) -> Vec<NodeId> {
    let mut map: Vec<NodeId> = Vec::with_capacity(from.nodes().len());
    for node in from.nodes() {
        let new = match replace(into, node.op, node.width) {
            Some(replacement) => replacement,
            None => into.build(node.op.map_operands(|id| map[id.index()]), node.width),
        };
        map.push(new);
    }
    map
}

/// Turns `q <= c ? x : q` into `if (c) q <= x`.
fn extract_enable(graph: &mut Graph, register: u32, folded: &mut Register) {
    while let Op::Mux { select, when_true, when_false } = graph.op(folded.data) {
        let holds = |node| graph.op(node) == Op::Register(register);
        let (condition, data) = if holds(when_false) {
            (select, when_true)
        } else if holds(when_true) {
            (graph.unary(UnaryOp::Not, select), when_false)
        } else {
            return;
        };
        folded.data = data;
        folded.enable = Some(match folded.enable {
            Some(enable) => graph.binary(super::graph::BinaryOp::And, enable, condition),
            None => condition,
        });
    }
}

/// Copies live nodes into a graph of their own, ports renumbered.
struct Compact<'f> {
    folded: &'f Folded,
    live: &'f Live,
    graph: Graph,
    map: BTreeMap<NodeId, NodeId>,
    inputs: BTreeMap<u32, u32>,
    registers: BTreeMap<u32, u32>,
    instances: BTreeMap<u32, (u32, Vec<bool>)>,
}

impl<'f> Compact<'f> {
    fn new(folded: &'f Folded, live: &'f Live) -> Self {
        let registers = live.registers.iter().zip(0..).map(|(&old, new)| (old, new)).collect();
        Self {
            folded,
            live,
            graph: Graph::default(),
            map: BTreeMap::new(),
            inputs: BTreeMap::new(),
            registers,
            instances: BTreeMap::new(),
        }
    }

    fn number_inputs(&mut self, used: &[bool]) {
        let kept = (0u32..).zip(used).filter(|(_, used)| **used).map(|(old, _)| old);
        self.inputs = kept.zip(0..).collect();
    }

    fn number_instance(&mut self, old: u32, outputs: &[bool]) {
        let new = self.instances.len() as u32;
        self.instances.insert(old, (new, outputs.to_vec()));
    }

    /// The copy of a live node. All live nodes are copied at the first call, in the order of the old graph.
    fn node(&mut self, old: NodeId) -> NodeId {
        if self.map.is_empty() {
            for &id in &self.live.nodes {
                let mut node = self.folded.graph.node(id);
                node.op = match node.op {
                    Op::Input(i) => Op::Input(self.inputs[&i]),
                    Op::Register(r) => Op::Register(self.registers[&r]),
                    Op::Instance { instance, output } => {
                        let (new, outputs) = &self.instances[&instance];
                        let position = outputs[..output as usize].iter().filter(|read| **read).count();
                        Op::Instance { instance: *new, output: position as u32 }
                    }
                    op => op.map_operands(|operand| self.map[&operand]),
                };
                let new = self.graph.intern(node);
                self.map.insert(id, new);
            }
        }
        self.map[&old]
    }

    /// The names of live values. Constants need none.
    fn names(&self, names: &[LocalName]) -> Vec<LocalName> {
        let live = |name: &LocalName| {
            let &node = self.map.get(&name.node)?;
            let is_constant = self.graph.constant_value(node).is_some();
            (!is_constant).then(|| LocalName { node, ..name.clone() })
        };
        names.iter().filter_map(live).collect()
    }
}

/// Gathers the variants of a hierarchy into a design, equal ones once, under unique names.
#[derive(Default)]
struct Collector {
    modules: Vec<Module>,
    known: Vec<(*const Variant, ModuleId)>,
}

impl Collector {
    fn collect(mut self, top: &std::rc::Rc<Variant>, name: &str) -> Design {
        let id = self.add(top);
        let mut used = BTreeSet::from([name.to_owned()]);
        let mut totals: BTreeMap<String, u32> = BTreeMap::new();
        for module in &self.modules {
            *totals.entry(module.kind.clone()).or_default() += 1;
        }
        let mut counts: BTreeMap<String, u32> = BTreeMap::new();
        for (position, module) in self.modules.iter_mut().enumerate() {
            if position == id.index() {
                name.clone_into(&mut module.name);
                continue;
            }
            let count = counts.entry(module.kind.clone()).or_default();
            loop {
                *count += 1;
                module.name = match totals[&module.kind] {
                    1 if *count == 1 => module.kind.clone(),
                    _ => format!("{}_v{count}", module.kind),
                };
                if used.insert(module.name.clone()) {
                    break;
                }
            }
        }
        Design { modules: self.modules }
    }

    fn add(&mut self, variant: &std::rc::Rc<Variant>) -> ModuleId {
        let pointer = std::rc::Rc::as_ptr(variant);
        if let Some((_, id)) = self.known.iter().find(|(known, _)| *known == pointer) {
            return *id;
        }
        let mut module = variant.module.clone();
        for (instance, child) in module.instances.iter_mut().zip(&variant.children) {
            instance.module = self.add(child);
        }
        let id = match self.modules.iter().position(|known| *known == module) {
            Some(position) => ModuleId(position as u32),
            None => {
                self.modules.push(module);
                ModuleId(self.modules.len() as u32 - 1)
            }
        };
        self.known.push((pointer, id));
        id
    }
}
