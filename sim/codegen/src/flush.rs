//! A pipeline as a function: the outputs that it shows after its inputs have been held and enabled for the latency.
//!
//! After enough cycles of constant inputs, a register that is always enabled holds the value of its data. Where no
//! register depends on itself, all outputs therefore settle to the logic with every register replaced by its data.

use super::unit::ENABLE;
use netlist::{Flat, Graph, NodeId, Op};

/// The logic from inputs to outputs; [`Op::Input`] counts the netlist's inputs. An error names a register that depends on
/// itself, or is not always enabled.
pub fn flush(flat: &Flat) -> Result<(Graph, Vec<NodeId>), String> {
    let mut flusher = Flusher { flat, graph: Graph::default(), values: vec![State::New; flat.nodes.len()] };
    let outputs = flat.outputs.iter().map(|(_, node)| flusher.value(*node)).collect::<Result<_, _>>()?;
    Ok((flusher.graph, outputs))
}

#[derive(Clone, Copy)]
enum State {
    New,
    Open,
    Done(NodeId),
}

struct Flusher<'f> {
    flat: &'f Flat,
    graph: Graph,
    values: Vec<State>,
}

impl Flusher<'_> {
    fn value(&mut self, id: NodeId) -> Result<NodeId, String> {
        let node = self.flat.nodes[id.index()];
        match self.values[id.index()] {
            State::Done(value) => return Ok(value),
            State::Open => {
                return Err(format!("the value of {:?} depends on itself across registers", node.op));
            }
            State::New => self.values[id.index()] = State::Open,
        }
        let value = match node.op {
            Op::Input(input) if self.flat.inputs[input as usize].name == ENABLE => self.graph.constant(1, 1),
            Op::Register(register) => {
                let register = &self.flat.registers[register as usize];
                if let Some(enable) = register.enable {
                    let enable = self.value(enable)?;
                    if self.graph.constant_value(enable) != Some(1) {
                        return Err(format!("the register `{}` is not always enabled", register.name));
                    }
                }
                self.value(register.data)?
            }
            op => {
                let operands: Vec<NodeId> =
                    op.operands().map(|operand| self.value(operand)).collect::<Result<_, _>>()?;
                let mut operands = operands.into_iter();
                let bound = op.map_operands(|operand| operands.next().unwrap_or(operand));
                self.graph.build(bound, node.width)
            }
        };
        self.values[id.index()] = State::Done(value);
        Ok(value)
    }
}
