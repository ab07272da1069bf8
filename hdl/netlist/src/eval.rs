//! Evaluation: of a bare graph, and of a flattened netlist cycle by cycle.
//!
//! The plain interpreter that everything faster is measured against: one word at a time, no tricks.

use super::flatten::Flat;
use super::graph::{Graph, NodeId, Op, apply, mask, operand_width};

/// The value of every node of a graph, in node order; `source` gives the value of each node without operands.
pub fn evaluate(graph: &Graph, mut source: impl FnMut(Op, u32) -> u128) -> Vec<u128> {
    let mut values: Vec<u128> = Vec::with_capacity(graph.nodes().len());
    for node in graph.nodes() {
        let value = match node.op {
            Op::Constant(value) => value,
            op if op.is_source() => source(op, node.width) & mask(node.width),
            op => {
                let mut operands = [0; 3];
                for (slot, id) in operands.iter_mut().zip(op.operands()) {
                    *slot = values[id.index()];
                }
                apply(op, node.width, operand_width(op, |id| graph.width(id)), operands)
            }
        };
        values.push(value);
    }
    values
}

/// A cycle-accurate simulation of a flattened netlist.
///
/// ```
/// # use netlist::{Evaluator, Flat};
/// # fn run(flat: &Flat) {
/// let mut simulation = Evaluator::new(flat);
/// simulation.set_input(0, 7);
/// simulation.settle();
/// let now = simulation.output(0);
/// simulation.clock();
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Evaluator<'a> {
    flat: &'a Flat,
    inputs: Vec<u128>,
    values: Vec<u128>,
}

impl<'a> Evaluator<'a> {
    /// The netlist at power-up: registers at their initial value, inputs zero, not yet settled.
    #[must_use]
    pub fn new(flat: &'a Flat) -> Self {
        let mut evaluator =
            Self { flat, inputs: vec![0; flat.inputs.len()], values: vec![0; flat.nodes.len()] };
        evaluator.reset();
        evaluator
    }

    /// Back to power-up; inputs stay.
    pub fn reset(&mut self) {
        for (node, value) in self.flat.nodes.iter().zip(&mut self.values) {
            match node.op {
                Op::Register(register) => *value = self.flat.registers[register as usize].initial,
                Op::Constant(constant) => *value = constant,
                _ => {}
            }
        }
    }

    /// Drives an input, by its position, with a value reduced modulo 2^width.
    ///
    /// # Panics
    /// When there is no such input.
    pub fn set_input(&mut self, input: usize, value: u128) {
        self.inputs[input] = value & mask(self.flat.inputs[input].width);
    }

    /// Computes every node from inputs and registers.
    pub fn settle(&mut self) {
        for (position, node) in self.flat.nodes.iter().enumerate() {
            let value = match node.op {
                Op::Constant(_) | Op::Register(_) => continue,
                Op::Input(input) => self.inputs[input as usize],
                op => {
                    let mut operands = [0; 3];
                    for (slot, id) in operands.iter_mut().zip(op.operands()) {
                        *slot = self.values[id.index()];
                    }
                    let operand_width = operand_width(op, |id| self.flat.nodes[id.index()].width);
                    apply(op, node.width, operand_width, operands)
                }
            };
            self.values[position] = value;
        }
    }

    /// A rising clock edge: registers take the values of the last [`Evaluator::settle`].
    pub fn clock(&mut self) {
        let next: Vec<u128> = self
            .flat
            .registers
            .iter()
            .map(|register| {
                let enabled = register.enable.is_none_or(|enable| self.values[enable.index()] == 1);
                self.values[if enabled { register.data } else { register.output }.index()]
            })
            .collect();
        for (register, value) in self.flat.registers.iter().zip(next) {
            self.values[register.output.index()] = value;
        }
    }

    /// Value of an output, by its position, at the last [`Evaluator::settle`].
    ///
    /// # Panics
    /// When there is no such output.
    #[must_use]
    pub fn output(&self, output: usize) -> u128 {
        self.values[self.flat.outputs[output].1.index()]
    }

    /// Value of any node at the last [`Evaluator::settle`].
    #[must_use]
    pub fn value(&self, node: NodeId) -> u128 {
        self.values[node.index()]
    }

    /// One cycle: drives the inputs, settles, reads the outputs, then clocks.
    pub fn cycle(&mut self, inputs: &[u128]) -> Vec<u128> {
        for (position, &value) in inputs.iter().enumerate() {
            self.set_input(position, value);
        }
        self.settle();
        let outputs = (0..self.flat.outputs.len()).map(|output| self.output(output)).collect();
        self.clock();
        outputs
    }
}
