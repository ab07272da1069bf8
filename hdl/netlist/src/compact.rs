//! What is left of a module when dead logic is gone, and the design that the results make up.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::design::{Design, LocalName, Module, ModuleId};
use super::fold::Folded;
use super::graph::{Graph, NodeId, Op};

/// A folded module with dead logic removed; instances refer to further variants.
#[derive(Clone)]
pub struct Variant {
    pub module: Module,
    pub children: Vec<Rc<Variant>>,
    pub used_inputs: Vec<bool>,
}

/// What the demanded outputs of a module need.
#[derive(Default)]
pub struct Live {
    pub nodes: BTreeSet<NodeId>,
    pub inputs: BTreeSet<u32>,
    pub registers: BTreeSet<u32>,
    /// Outputs that are read, of each instance that has any.
    pub instances: BTreeMap<u32, Vec<bool>>,
}

/// Copies live nodes into a graph of their own, ports renumbered.
pub struct Compact<'f> {
    folded: &'f Folded,
    live: &'f Live,
    pub graph: Graph,
    map: BTreeMap<NodeId, NodeId>,
    inputs: BTreeMap<u32, u32>,
    registers: BTreeMap<u32, u32>,
    instances: BTreeMap<u32, (u32, Vec<bool>)>,
}

impl<'f> Compact<'f> {
    pub fn new(folded: &'f Folded, live: &'f Live) -> Self {
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

    pub fn number_inputs(&mut self, used: &[bool]) {
        let kept = (0u32..).zip(used).filter(|(_, used)| **used).map(|(old, _)| old);
        self.inputs = kept.zip(0..).collect();
    }

    pub fn number_instance(&mut self, old: u32, outputs: &[bool]) {
        let new = self.instances.len() as u32;
        self.instances.insert(old, (new, outputs.to_vec()));
    }

    /// The copy of a live node. All live nodes are copied at the first call, in the order of the old graph.
    pub fn node(&mut self, old: NodeId) -> NodeId {
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
    pub fn names(&self, names: &[LocalName]) -> Vec<LocalName> {
        let live = |name: &LocalName| {
            let &node = self.map.get(&name.node)?;
            let is_constant = self.graph.constant_value(node).is_some();
            (!is_constant).then(|| LocalName { node, ..name.clone() })
        };
        names.iter().filter_map(live).collect()
    }
}

/// Gathers the variants of a hierarchy into a design, equal ones once, under names that no other top's modules have: those
/// of all but the top begin with the top's name, so that designs of different tops can be compiled together.
#[derive(Default)]
pub struct Collector {
    modules: Vec<Module>,
    known: Vec<(*const Variant, ModuleId)>,
}

impl Collector {
    pub fn collect(mut self, top: &Rc<Variant>, name: &str) -> Design {
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
            let prefix = format!("{name}_");
            let stem = match module.kind.starts_with(&prefix) {
                true => module.kind.clone(),
                false => prefix + &module.kind,
            };
            loop {
                *count += 1;
                module.name = match totals[&module.kind] {
                    1 if *count == 1 => stem.clone(),
                    _ => format!("{stem}_v{count}"),
                };
                if used.insert(module.name.clone()) {
                    break;
                }
            }
        }
        Design { modules: self.modules }
    }

    fn add(&mut self, variant: &Rc<Variant>) -> ModuleId {
        let pointer = Rc::as_ptr(variant);
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
