//! The interpreter, which takes any flattened netlist at run time.
//!
//! Nodes become instructions in order of level and, within a level, of operation, so that the same code runs many
//! times in a row. Each instruction works on columns, the values of all lanes; a column holds 32, 64 or 128 bits for
//! each lane, as its node's width needs. A node that only renames bits (a zero extension within a column's size)
//! takes no instruction.

mod columns;
mod compile;
mod instruction;

use columns::Columns;
use compile::compile;
use instruction::{Instruction, Place};
use netlist::Engine;
use netlist::{Flat, NodeId, mask};

/// Copies of the netlist that an interpreter simulates at once.
pub const LANES: usize = 64;

/// A simulation of [`LANES`] copies of a netlist.
#[derive(Clone, Debug)]
pub struct Interpreter {
    code: Vec<Instruction>,
    columns: Columns,
    /// Column and width of each input.
    inputs: Vec<(Place, u32)>,
    outputs: Vec<Place>,
    registers: Vec<Register>,
    /// Column of each node.
    nodes: Vec<Place>,
}

#[derive(Clone, Copy, Debug)]
struct Register {
    present: Place,
    data: Place,
    enable: Option<Place>,
    /// Where the next value waits until all registers have theirs.
    next: Place,
    initial: u128,
}

impl Interpreter {
    /// The netlist at power-up, inputs zero.
    #[must_use]
    pub fn new(netlist: &Flat) -> Self {
        let mut interpreter = compile(netlist);
        interpreter.reset();
        interpreter
    }

    /// Value of any node in one lane at the last [`settle`](Engine::settle).
    ///
    /// # Panics
    /// If there is no such node or lane.
    #[must_use]
    pub fn value(&self, node: NodeId, lane: usize) -> u128 {
        self.columns.get(self.nodes[node.index()], lane)
    }

    #[inline(always)]
    fn run(&mut self) {
        for instruction in &self.code {
            self.columns.execute(instruction);
        }
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl")]
    fn run_avx512(&mut self) {
        self.run();
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn run_avx2(&mut self) {
        self.run();
    }
}

impl Engine for Interpreter {
    fn lanes(&self) -> usize {
        LANES
    }

    fn reset(&mut self) {
        for register in &self.registers {
            (0..LANES).for_each(|lane| self.columns.set(register.present, lane, register.initial));
        }
    }

    fn set_input(&mut self, input: usize, lane: usize, value: u128) {
        let (place, width) = self.inputs[input];
        self.columns.set(place, lane, value & mask(width));
    }

    fn drive(&mut self, input: usize, values: &[u32]) {
        let (place, _) = self.inputs[input];
        self.columns.drive(place, values.try_into().expect("a value for each lane"));
    }

    fn read(&self, output: usize, values: &mut [u32]) {
        self.columns.read(self.outputs[output], values.try_into().expect("room for each lane"));
    }

    fn settle(&mut self) {
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx512bw")
                && is_x86_feature_detected!("avx512dq")
                && is_x86_feature_detected!("avx512vl")
            {
                // SAFETY: the processor has the features.
                return unsafe { self.run_avx512() };
            }
            if is_x86_feature_detected!("avx2") {
                // SAFETY: the processor has the feature.
                return unsafe { self.run_avx2() };
            }
        }
        self.run();
    }

    fn output(&self, output: usize, lane: usize) -> u128 {
        self.columns.get(self.outputs[output], lane)
    }

    fn clock(&mut self) {
        for register in &self.registers {
            self.columns.choose(register.next, register.enable, register.data, register.present);
        }
        for register in &self.registers {
            self.columns.copy(register.present, register.next);
        }
    }
}
