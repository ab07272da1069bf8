//! The netlist as gates, 64 lanes in the bits of a machine word.

use gates::blast::Blasted;
use gates::simulate::{LANES_PER_WORD, Simulator};
use netlist::Engine;

/// A simulation of a bit-blasted netlist.
#[derive(Clone, Debug)]
pub struct GateEngine<'b> {
    blasted: &'b Blasted,
    simulator: Simulator<'b, 1>,
    /// Position of each input's first bit among the inputs of the gates.
    first_bit: Vec<usize>,
}

impl<'b> GateEngine<'b> {
    /// The gates at power-up, inputs zero.
    #[must_use]
    pub fn new(blasted: &'b Blasted) -> Self {
        let mut next = 0;
        let first_bit = blasted.inputs.iter().map(|bits| {
            next += bits.len();
            next - bits.len()
        });
        Self { blasted, simulator: Simulator::new(&blasted.aig), first_bit: first_bit.collect() }
    }
}

impl Engine for GateEngine<'_> {
    fn lanes(&self) -> usize {
        LANES_PER_WORD
    }

    fn reset(&mut self) {
        self.simulator.reset();
    }

    fn set_input(&mut self, input: usize, lane: usize, value: u128) {
        assert!(lane < LANES_PER_WORD, "lane {lane} of {LANES_PER_WORD}");
        for (bit, &lit) in self.blasted.inputs[input].iter().enumerate() {
            let [before] = self.simulator.value(lit);
            let now = before & !(1 << lane) | ((value >> bit & 1) as u64) << lane;
            self.simulator.set_input(self.first_bit[input] + bit, [now]);
        }
    }

    fn settle(&mut self) {
        self.simulator.settle();
    }

    fn output(&self, output: usize, lane: usize) -> u128 {
        self.simulator.word(&self.blasted.outputs[output], lane)
    }

    fn clock(&mut self) {
        self.simulator.clock();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::agreement::first_difference;
    use equivalence::Stimulus;
    use gates::blast::{Options, blast};
    use netlist::{Change, Mutation, flatten, mutate};
    use pipelines::catalogue::{StandardFormat, Top};

    #[test]
    fn gates_agree_with_the_evaluator_and_a_faulty_unit_does_not() {
        for top in [Top::FpAdd, Top::FpMul, Top::DualSplit] {
            let format = StandardFormat::Binary32;
            let design = top.design(format).unwrap();
            let netlist = flatten(&design).unwrap();
            let blasted = blast(&design, &netlist, Options::default());
            let fault =
                Mutation { module: "rounder".into(), value: "encoded".into(), change: Change::Increment };
            let faulty = flatten(&mutate(&design, &fault).unwrap()).unwrap();
            for (reference, agrees) in [(&netlist, true), (&faulty, false)] {
                let mut streams: Vec<_> =
                    (0..64).map(|lane| Stimulus::new(top, format, &netlist, lane)).collect();
                let inputs = |_, lane: usize| streams[lane].next().unwrap();
                let difference = first_difference(reference, &mut GateEngine::new(&blasted), 30, inputs);
                assert_eq!(difference.is_none(), agrees, "{top}: {difference:?}");
            }
        }
    }
}
