//! Postpones reductions: `any(x) | any(y)` becomes `any(x | y)`, and likewise a choice whether to add to such a sum.
//!
//! Otherwise a sticky bit that a shifter collects row by row takes a comparison in each row, and comparisons are the
//! costliest operations on lanes.

use super::unit::Kind;
use netlist::{BinaryOp, Graph, NodeId, Op, UnaryOp};

/// The graph with its reductions postponed, and the new id of each old node.
pub fn put_off(graph: &Graph) -> (Graph, Vec<NodeId>) {
    let mut pass = Graph::default();
    let mut map: Vec<NodeId> = Vec::with_capacity(graph.nodes().len());
    for node in graph.nodes() {
        let op = node.op.map_operands(|operand| map[operand.index()]);
        let joined = match op {
            Op::Binary(BinaryOp::Or, a, b) => {
                words(&mut pass, a, b).map(|(a, b)| pass.binary(BinaryOp::Or, a, b))
            }
            Op::Mux { select, when_true, when_false } => {
                words(&mut pass, when_true, when_false).map(|(a, b)| pass.mux(select, a, b))
            }
            _ => None,
        };
        map.push(match joined {
            Some(word) => pass.unary(UnaryOp::ReduceOr, word),
            None => pass.build(op, node.width),
        });
    }
    (pass, map)
}

/// For two bits that are reductions of words, the two words in one width. One of the bits may also be a reduction
/// under a condition.
fn words(graph: &mut Graph, a: NodeId, b: NodeId) -> Option<(NodeId, NodeId)> {
    let (x, y) = match (reduced(graph, a), reduced(graph, b)) {
        (Some(x), Some(y)) => (x, y),
        (Some(x), None) => (x, reduced_if(graph, b)?),
        (None, Some(y)) => (reduced_if(graph, a)?, y),
        (None, None) => return None,
    };
    let width = graph.width(x).max(graph.width(y));
    Some((graph.extend(x, width, false), graph.extend(y, width, false)))
}

/// The word that a bit is the reduction of.
fn reduced(graph: &Graph, bit: NodeId) -> Option<NodeId> {
    let word = match graph.op(bit) {
        Op::Unary(UnaryOp::ReduceOr, word) => word,
        Op::Binary(BinaryOp::Ne, word, zero) if graph.constant_value(zero) == Some(0) => word,
        _ => return None,
    };
    (Kind::of(graph.width(word)) == Kind::Word).then_some(word)
}

/// The same for a reduction that counts only if another bit is set. The word is zero if that bit is not set.
fn reduced_if(graph: &mut Graph, bit: NodeId) -> Option<NodeId> {
    let Op::Binary(BinaryOp::And, a, b) = graph.op(bit) else { return None };
    let (condition, word) = match (reduced(graph, a), reduced(graph, b)) {
        (_, Some(word)) => (a, word),
        (Some(word), None) => (b, word),
        (None, None) => return None,
    };
    let zero = graph.constant(0, graph.width(word));
    Some(graph.mux(condition, word, zero))
}
