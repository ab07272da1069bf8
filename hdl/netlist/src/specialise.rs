//! Specialisation: constants folded into modules, unused logic removed, each distinct result once.
//!
//! Two passes over the templates, both memoised:
//! 1. *Fold* a template for the inputs that its parent ties. Constants flow through logic, through registers
//!    that can never leave their power-up value, and out of instances, until nothing changes.
//! 2. *Prune* the folded module for the outputs that its parent reads. What no output needs, directly or through
//!    a register or an instance, is dropped together with the ports that fed it.
//!
//! The hierarchy stays: an instance whose rounding mode is tied refers to a module without that port.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::compact::{Collector, Compact, Live, Variant};
use super::design::{Design, Instance, Module, ModuleId, Parameter, Register};
use super::fold::{Folded, Ties, fold_registers};
use super::graph::{NodeId, Op};

/// The design whose top is the template at position `top`, called `name`.
pub fn specialise(templates: &[Module], top: usize, name: &str) -> Design {
    let mut specialiser = Specialiser { templates, folded: BTreeMap::new(), pruned: BTreeMap::new() };
    let ties = vec![None; templates[top].inputs.len()];
    let demand = vec![true; templates[top].outputs.len()];
    let variant = specialiser.prune(top, &ties, &demand, true);
    Collector::default().collect(&variant, name)
}

struct Specialiser<'t> {
    templates: &'t [Module],
    folded: BTreeMap<(usize, Ties), Rc<Folded>>,
    pruned: BTreeMap<(usize, Ties, Vec<bool>), Rc<Variant>>,
}

impl Specialiser<'_> {
    fn fold(&mut self, template: usize, ties: &Ties) -> Rc<Folded> {
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
        let folded = Rc::new(folded);
        self.folded.insert(memo, folded.clone());
        folded
    }

    fn prune(&mut self, template: usize, ties: &Ties, demand: &[bool], keep_ports: bool) -> Rc<Variant> {
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
        let variant = Rc::new(Variant { module, children, used_inputs });
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
