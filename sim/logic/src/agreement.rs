//! Engines against the reference interpreter, cycle by cycle, every output of every lane.

use base::split_mix::hash;
use netlist::Engine;
use netlist::{Evaluator, Flat, mask};
use std::fmt;

/// The first output in which an engine differs from [`Evaluator`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Cycle, from 0.
    pub cycle: u64,
    /// Lane of the engine.
    pub lane: usize,
    /// Name of the output.
    pub output: String,
    /// What the evaluator shows.
    pub expected: u128,
    /// What the engine shows.
    pub found: u128,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { cycle, lane, output, expected, found } = self;
        write!(f, "cycle {cycle}, lane {lane}: {output} is {found:#x}, and should be {expected:#x}")
    }
}

/// Runs `engine`, from power-up, beside an evaluator of `netlist` for each of its lanes. `stimulus` gives all inputs of
/// a lane in a cycle.
pub fn first_difference(
    netlist: &Flat,
    engine: &mut dyn Engine,
    cycles: u64,
    mut stimulus: impl FnMut(u64, usize) -> Vec<u128>,
) -> Option<Difference> {
    engine.reset();
    let mut references: Vec<Evaluator<'_>> = (0..engine.lanes()).map(|_| Evaluator::new(netlist)).collect();
    for cycle in 0..cycles {
        let mut expected = Vec::with_capacity(references.len());
        for (lane, reference) in references.iter_mut().enumerate() {
            let inputs = stimulus(cycle, lane);
            for (input, &value) in inputs.iter().enumerate() {
                engine.set_input(input, lane, value);
            }
            expected.push(reference.cycle(&inputs));
        }
        engine.settle();
        for (lane, expected) in expected.iter().enumerate() {
            for (output, &expected) in expected.iter().enumerate() {
                let found = engine.output(output, lane);
                if found != expected {
                    let output = netlist.outputs[output].0.name.clone();
                    return Some(Difference { cycle, lane, output, expected, found });
                }
            }
        }
        engine.clock();
    }
    None
}

/// Inputs with random bits, a quarter of them corner values, equal for equal seeds.
#[must_use]
pub fn any_inputs(netlist: &Flat, seed: u64, cycle: u64, lane: usize) -> Vec<u128> {
    let value = |(input, width): (usize, u32)| {
        let random = hash(hash(seed ^ hash(cycle)) ^ ((lane as u64) << 32) ^ input as u64);
        let wide = u128::from(hash(random)) << 64 | u128::from(hash(!random));
        let value = match random % 16 {
            0 => 0,
            1 => u128::MAX,
            2 => 1,
            3 => 1 << (width - 1),
            _ => wide,
        };
        value & mask(width)
    };
    netlist.inputs.iter().map(|port| port.width).enumerate().map(value).collect()
}
