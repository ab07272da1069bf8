//! The order in which a unit computes and stores.

use super::unit::{Logic, Sink, Slot, Source};
use netlist::{Graph, NodeId, Op};
use std::collections::BTreeSet;

/// The sinks in an order in which each may be stored as soon as it is computed: after all sinks that read it.
/// Registers that read each other in a circle come last, and are stored after all are computed.
pub fn schedule(logic: &Logic) -> (Vec<&Sink>, Vec<&Sink>) {
    let cones: Vec<BTreeSet<Slot>> = logic.sinks.iter().map(|sink| cone(logic, sink.value)).collect();
    let mut readers: Vec<BTreeSet<usize>> = Vec::new();
    for (position, sink) in logic.sinks.iter().enumerate() {
        let reads = |other: &usize| *other != position && cones[*other].contains(&sink.slot);
        readers.push((0..logic.sinks.len()).filter(reads).collect());
    }
    let mut left: BTreeSet<usize> = (0..logic.sinks.len()).collect();
    let mut ordered = Vec::new();
    while let Some(next) = left.iter().copied().find(|&sink| readers[sink].is_disjoint(&left)) {
        left.remove(&next);
        ordered.push(&logic.sinks[next]);
    }
    (ordered, left.into_iter().map(|sink| &logic.sinks[sink]).collect())
}

fn cone(logic: &Logic, root: NodeId) -> BTreeSet<Slot> {
    let (mut seen, mut stack, mut slots) = (BTreeSet::new(), vec![root], BTreeSet::new());
    while let Some(id) = stack.pop() {
        if seen.insert(id) {
            if let Op::Input(source) = logic.graph.op(id)
                && let Source::Memory(slot) = logic.sources[source as usize]
            {
                slots.insert(slot);
            }
            stack.extend(operands(&logic.graph, &logic.sources, id));
        }
    }
    slots
}

/// The operands of a node.
pub fn operands(graph: &Graph, sources: &[Source], id: NodeId) -> Vec<NodeId> {
    match graph.op(id) {
        Op::Input(source) => match sources[source as usize] {
            Source::Memory(_) => Vec::new(),
            Source::LeadingZeros { of, .. } => vec![of],
        },
        op => op.operands().collect(),
    }
}
