//! The logic of a unit: the word graphs of its module and of all that dissolves in it, joined.

use super::idioms::{Idiom, Shift, Zeros};
use super::reduce::put_off;
use super::unit::{Builder, ENABLE, Logic, Path, Sink, Slot, Source, Unit};
use netlist::{BinaryOp, NodeId, Op};
use std::collections::BTreeMap;

/// Makes the logic of a unit whose memory is known.
pub struct LogicBuilder<'b> {
    builder: &'b Builder<'b>,
    /// Input that is taken to be 1.
    tied: Option<usize>,
    logic: Logic,
    sources: BTreeMap<Source, NodeId>,
    values: BTreeMap<(Path, NodeId), NodeId>,
}

impl<'b> LogicBuilder<'b> {
    pub fn new(builder: &'b Builder<'b>, tied: Option<usize>) -> Self {
        Self { builder, tied, logic: Logic::default(), sources: BTreeMap::new(), values: BTreeMap::new() }
    }

    pub fn finish(mut self, units: &[Unit]) -> Logic {
        let builder = self.builder;
        for (path, position) in &builder.own {
            let register = &builder.module(path).registers[*position as usize];
            let slot = builder.registers[&(path.clone(), *position)];
            let mut value = self.value(path, register.data);
            if let Some(enable) = register.enable {
                let (enable, held) = (self.value(path, enable), self.memory(slot));
                value = self.logic.graph.mux(enable, value, held);
            }
            self.logic.sinks.push(Sink { slot, value });
        }
        for (child, path) in builder.unit.children.iter().zip(&builder.children) {
            let (&position, parent) = path.split_last().expect("a unit inside has an instance");
            let module = builder.module(path);
            let inputs = &builder.module(parent).instances[position as usize].inputs;
            for ((slot, &node), port) in units[child.unit].inputs.iter().zip(inputs).zip(&module.inputs) {
                let value = self.value(parent, node);
                if self.tied.is_some() && port.name == ENABLE {
                    // The unit inside steps by its version that does not look at the enable.
                    assert_eq!(self.logic.graph.constant_value(value), Some(1), "one clock enable for all");
                } else {
                    self.logic.sinks.push(Sink { slot: slot.inside(child.place), value });
                }
            }
        }
        if builder.root == builder.design.top_id() {
            let outputs = builder.design.top().outputs.iter();
            self.logic.outputs = outputs.map(|(_, node)| self.value(&[], *node)).collect();
        }
        let (graph, map) = put_off(&self.logic.graph);
        self.logic.graph = graph;
        for source in &mut self.logic.sources {
            if let Source::LeadingZeros { of, .. } = source {
                *of = map[of.index()];
            }
        }
        self.logic.sinks.iter_mut().for_each(|sink| sink.value = map[sink.value.index()]);
        self.logic.outputs.iter_mut().for_each(|output| *output = map[output.index()]);
        self.logic
    }

    fn memory(&mut self, slot: Slot) -> NodeId {
        self.source(Source::Memory(slot), slot.width)
    }

    fn source(&mut self, source: Source, width: u32) -> NodeId {
        *self.sources.entry(source).or_insert_with(|| {
            self.logic.sources.push(source);
            self.logic.graph.build(Op::Input(self.logic.sources.len() as u32 - 1), width)
        })
    }

    /// The value of a node of `width` bits that ends a recognised shape.
    fn idiom(&mut self, path: &[u32], idiom: Idiom, width: u32) -> NodeId {
        match idiom {
            Idiom::ShiftRight(shift) => {
                let (value, amount) = self.shift_operands(path, shift);
                self.logic.graph.binary(BinaryOp::Shr, value, amount)
            }
            Idiom::Lost(shift) => {
                let (value, amount) = self.shift_operands(path, shift);
                let graph = &mut self.logic.graph;
                let shifted = graph.binary(BinaryOp::Shr, value, amount);
                let back = graph.binary(BinaryOp::Shl, shifted, amount);
                graph.binary(BinaryOp::Ne, back, value)
            }
            Idiom::LeadingZeros(Zeros { value, most }) => {
                let of = self.value(path, value);
                let zeros = self.source(Source::LeadingZeros { of, most }, most.ilog2() + 1);
                self.logic.graph.resize(zeros, width, false)
            }
        }
    }

    fn shift_operands(&mut self, path: &[u32], shift: Shift) -> (NodeId, NodeId) {
        let (value, amount) = (self.value(path, shift.value), self.value(path, shift.amount));
        (value, self.logic.graph.slice(amount, 0, shift.bits))
    }

    /// The node of the unit's graph with the value of `node` of the module at `path`.
    fn value(&mut self, path: &[u32], node: NodeId) -> NodeId {
        let key = (path.to_vec(), node);
        if let Some(&known) = self.values.get(&key) {
            return known;
        }
        let builder = self.builder;
        let module = builder.module(path);
        let found = module.graph.node(node);
        if let Some(&idiom) = builder.idioms[builder.module_id(path).index()].get(&node) {
            let value = self.idiom(path, idiom, found.width);
            self.values.insert(key, value);
            return value;
        }
        let value = match found.op {
            Op::Instance { instance, output } => {
                let inside = module.instances[instance as usize].module;
                let (_, driver) = builder.design.module(inside).outputs[output as usize];
                let path: Path = path.iter().copied().chain([instance]).collect();
                self.value(&path, driver)
            }
            Op::Input(input) => match path.split_last() {
                None if self.tied == Some(input as usize) => self.logic.graph.constant(1, 1),
                None => self.memory(builder.unit.inputs[input as usize]),
                Some((&position, parent)) => {
                    let driver = builder.module(parent).instances[position as usize].inputs[input as usize];
                    self.value(parent, driver)
                }
            },
            Op::Register(position) => self.memory(builder.registers[&(path.to_vec(), position)]),
            op => {
                let operands: Vec<NodeId> = op.operands().map(|operand| self.value(path, operand)).collect();
                let mut operands = operands.into_iter();
                let bound = op.map_operands(|operand| operands.next().unwrap_or(operand));
                self.logic.graph.build(bound, found.width)
            }
        };
        self.values.insert(key, value);
        value
    }
}
