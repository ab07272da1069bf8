//! From the probed instance tree to one graph per distinct block, nothing specialised yet.

use std::collections::{BTreeMap, BTreeSet};

use rust_hdl_core::ast::Verilog;

use super::design::{Instance, LocalName, Module, ModuleId, Register};
use super::error::{ElaborateError, ErrorKind, Location};
use super::graph::{Graph, NodeId};
use super::kernel::{Outcome, Semantics, Version, execute};
use super::probe::Scope;
use super::signals::{Destination, Signals};

/// The distinct blocks of an instance tree, children first. In a template, [`ModuleId`] is a position here,
/// all ports are kept and the module's name is its kind.
#[derive(Default)]
pub struct Templates {
    /// The distinct blocks.
    pub list: Vec<Module>,
    by_shape: BTreeMap<String, usize>,
}

impl Templates {
    /// Lowers a block and everything beneath it; returns its position.
    pub fn add(&mut self, scope: &Scope, path: &str) -> Result<usize, ElaborateError> {
        let whole = |kind| at_module(path, kind);
        let mut children = Vec::new();
        for child in scope.children.iter().filter(|child| !child.is_register()) {
            let template = self.add(child, &format!("{path}.{}", child.name.replace('$', ".")))?;
            children.push((child.name.clone(), template));
        }
        let signals = Signals::of(scope).map_err(whole)?;
        let registers: Vec<_> =
            signals.registers.iter().map(|r| (&r.name, r.width, r.initial, r.has_reset)).collect();
        let (kind, _) = kind_of(scope);
        let shape =
            format!("{kind:?} {:?} {:?} {registers:?} {children:?}", scope.atoms, code_key(&scope.code));
        if let Some(&known) = self.by_shape.get(&shape) {
            return Ok(known);
        }
        let mut module = lower(scope, &signals, path)?;
        for (instance, (_, template)) in module.instances.iter_mut().zip(&children) {
            instance.module = ModuleId(*template as u32);
        }
        self.list.push(module);
        self.by_shape.insert(shape, self.list.len() - 1);
        Ok(self.list.len() - 1)
    }
}

/// What a block calls itself, and the values of its generics: its first timing entry is `kind parameters`. A block
/// without such an entry has the name of its field, without array position.
pub fn kind_of(scope: &Scope) -> (String, String) {
    match &scope.timing {
        Some(timing) => {
            let (kind, parameters) = timing.name.split_once(' ').unwrap_or((&timing.name, ""));
            (kind.to_owned(), parameters.to_owned())
        }
        None => (scope.name.split('$').next().unwrap_or_default().to_owned(), String::new()),
    }
}

/// The error of a module as a whole.
pub fn at_module(path: &str, kind: ErrorKind) -> ElaborateError {
    ElaborateError { at: Location { path: path.to_owned(), statement: String::new() }, kind }
}

fn code_key(code: &Verilog) -> String {
    format!("{code:?}")
}

fn lower(scope: &Scope, signals: &Signals, path: &str) -> Result<Module, ElaborateError> {
    let mut graph = Graph::default();
    let empty = Vec::new();
    let block = match &scope.code {
        Verilog::Combinatorial(block) => block,
        Verilog::Empty => &empty,
        Verilog::Custom(_) | Verilog::Blackbox(_) | Verilog::Wrapper(_) => {
            let kind = ErrorKind::NotUnderstood(
                "hand-written Verilog in a block that is no register; write a kernel".into(),
            );
            return Err(at_module(path, kind));
        }
    };
    let outcome = execute(block, signals, &mut graph, Semantics::Rust, path)?;
    let names = local_names(signals, &outcome);
    let (kind, generics) = kind_of(scope);
    let mut drivers: BTreeMap<Key, NodeId> = BTreeMap::new();
    for (target, &node) in signals.targets.iter().zip(&outcome.values) {
        drivers.insert(key(target.destination), node);
    }
    let instances = scope.children.iter().filter(|child| !child.is_register()).enumerate();
    Ok(Module {
        name: kind.clone(),
        kind,
        generics,
        parameters: signals.parameters.clone(),
        clock: signals.clock.clone(),
        inputs: signals.inputs.clone(),
        outputs: (signals.outputs.iter().enumerate())
            .map(|(i, port)| (port.clone(), drivers[&Key::Output(i)]))
            .collect(),
        registers: (signals.registers.iter().enumerate())
            .map(|(i, declared)| Register {
                name: declared.name.clone(),
                width: declared.width,
                signal_type: declared.signal_type.clone(),
                initial: declared.initial,
                has_reset: declared.has_reset,
                data: drivers[&Key::Data(i)],
                enable: declared.has_enable.then(|| drivers[&Key::Enable(i)]),
            })
            .collect(),
        instances: instances
            .map(|(i, child)| Instance {
                name: child.name.clone(),
                module: ModuleId(0),
                inputs: drivers
                    .range(Key::Input(i, 0)..=Key::Input(i, usize::MAX))
                    .map(|(_, &node)| node)
                    .collect(),
            })
            .collect(),
        names,
        graph,
    })
}

#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Key {
    Ignored,
    Output(usize),
    Data(usize),
    Enable(usize),
    Input(usize, usize),
}

fn key(destination: Destination) -> Key {
    match destination {
        Destination::Local | Destination::Clock => Key::Ignored,
        Destination::Output(i) => Key::Output(i),
        Destination::RegisterData(i) => Key::Data(i),
        Destination::RegisterEnable(i) => Key::Enable(i),
        Destination::InstanceInput(i, j) => Key::Input(i, j),
    }
}

/// Names for the values of the local signals: the last value of `t` is `t`, earlier ones `t_1`, `t_2`, ...
fn local_names(signals: &Signals, outcome: &Outcome) -> Vec<LocalName> {
    let mut taken: BTreeSet<String> = signals.by_name.keys().cloned().collect();
    let mut versions: BTreeMap<usize, Vec<NodeId>> = BTreeMap::new();
    let is_local = |version: &&Version| signals.targets[version.target].destination == Destination::Local;
    let named: Vec<&Version> = outcome.versions.iter().filter(is_local).collect();
    for version in &named {
        let list = versions.entry(version.target).or_default();
        if !list.contains(&version.node) {
            list.push(version.node);
        }
    }
    let mut names: BTreeMap<(usize, NodeId), String> = BTreeMap::new();
    for (&target, list) in &versions {
        let base = &signals.targets[target].name;
        for (position, &node) in list.iter().enumerate() {
            let name = if node == outcome.values[target] {
                base.clone()
            } else {
                let mut name = format!("{base}_{}", position + 1);
                while !taken.insert(name.clone()) {
                    name.push('_');
                }
                name
            };
            names.insert((target, node), name);
        }
    }
    let mut result = Vec::new();
    for version in named {
        if let Some(name) = names.remove(&(version.target, version.node)) {
            let signal_type = signals.targets[version.target].signal_type.clone();
            let is_last = version.node == outcome.values[version.target];
            result.push(LocalName { name, node: version.node, is_last, signal_type });
        }
    }
    result
}
