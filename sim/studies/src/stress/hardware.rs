//! The dual-split pipeline's netlist in a narrow format as a step function. [`logic::steps`] does the same in binary32, faster.

use equivalence::Ports;
use equivalence::cases::{NodeCase, RayWords};
use fp::{Arithmetic, Rounding};
use golden::dst::{Child, Code, Step};
use golden::precision::NarrowRay;
use netlist::{Evaluator, Flat, latency_cycles};

/// A pipeline that processes one node at a time: the next node enters when the result of the last one has come out.
pub struct Hardware<'n> {
    ports: Ports<'n>,
    inputs: Vec<u128>,
    simulation: Evaluator<'n>,
    latency_cycles: u32,
}

impl<'n> Hardware<'n> {
    /// The pipeline at power-up.
    ///
    /// # Panics
    /// If `netlist` has no fixed latency.
    #[must_use]
    pub fn new(netlist: &'n Flat) -> Self {
        let inputs = vec![0; netlist.inputs.len()];
        let latency_cycles = latency_cycles(netlist).expect("a plain pipeline");
        Self { ports: Ports::new(netlist), inputs, simulation: Evaluator::new(netlist), latency_cycles }
    }

    /// One step in the format of `arithmetic`, which has to be the pipeline's. As in the naive variant, the ray has a single value
    /// for each origin and each reciprocal.
    pub fn narrow_step(
        &mut self,
        arithmetic: Arithmetic,
        words: [u32; 3],
        ray: &NarrowRay,
        t_min: f32,
        t_max: f32,
    ) -> Step {
        self.run(&narrow_case(arithmetic, words, ray, t_min, t_max), |bits| arithmetic.to_f32(bits))
    }

    fn run(&mut self, case: &NodeCase, number: impl Fn(u32) -> f32) -> Step {
        self.inputs[self.ports.input("en_i")] = 1;
        self.inputs[self.ports.input("valid_i")] = 1;
        self.ports.node().drive(&mut self.inputs, case);
        self.simulation.cycle(&self.inputs);
        self.inputs[self.ports.input("valid_i")] = 0;
        for _ in 1..self.latency_cycles {
            self.simulation.cycle(&self.inputs);
        }
        let outputs = self.simulation.cycle(&self.inputs);
        let output = |name: &str| outputs[self.ports.output(name)] as u32;
        let slot = |which: &str| {
            let word = |what: &str| output(&format!("{which}_{what}_o"));
            Child { offset: word("offset"), t_min: number(word("t_min")), t_max: number(word("t_max")) }
        };
        let code = [Code::Miss, Code::One, Code::Two, Code::Leaf][output("code_o") as usize];
        Step { code, near: slot("near"), far: slot("far") }
    }
}

/// The pipeline's inputs for a step in the format of `arithmetic`. As in the naive variant, the ray has a single value for each
/// origin and each reciprocal.
#[must_use]
pub fn narrow_case(
    arithmetic: Arithmetic,
    words: [u32; 3],
    ray: &NarrowRay,
    t_min: f32,
    t_max: f32,
) -> NodeCase {
    // All numbers are numbers of the format already, so the conversion rounds none.
    let bits = |x: f32| arithmetic.from_f32(x, Rounding::NearestEven);
    let ray = RayWords {
        origin: ray.origin_entry.map(bits),
        inv_entry: ray.inv_entry.map(bits),
        inv_exit: ray.inv_exit.map(bits),
        t_min: bits(t_min),
        t_max: bits(t_max),
    };
    let plane = |word: u32| bits(f32::from_bits(word));
    NodeCase { words: [words[0], plane(words[1]), plane(words[2])], ray }
}
