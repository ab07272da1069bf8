//! Constants through one module: ties, registers that never change, constant outputs of instances.

use std::collections::BTreeMap;

use super::design::{LocalName, Module, Register};
use super::graph::{BinaryOp, Graph, NodeId, Op, UnaryOp};

/// The value of each input that is tied.
pub type Ties = Vec<Option<u128>>;

/// A template with constants folded: everything in one new graph, indices as in the template.
#[derive(Clone)]
pub struct Folded {
    pub graph: Graph,
    pub outputs: Vec<NodeId>,
    pub registers: Vec<Register>,
    pub instance_inputs: Vec<Vec<NodeId>>,
    pub instance_ties: Vec<Ties>,
    pub names: Vec<LocalName>,
}

/// Folds with the largest set of registers that never change. It first assumes that every register keeps its power-up
/// value. It then drops the assumption for each register whose next value differs, until all remaining assumptions
/// hold.
pub fn fold_registers(module: &Module, ties: &Ties, instances: &BTreeMap<(u32, u32), u128>) -> Folded {
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
            Some(enable) => graph.binary(BinaryOp::And, enable, condition),
            None => condition,
        });
    }
}
