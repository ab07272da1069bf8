//! Records the inputs and outputs of one lane of an engine, and writes a waveform of them.

use super::agreement::Difference;
use netlist::Engine;
use netlist::{Evaluator, Flat};
use std::io::{self, Write};

/// An engine that remembers every cycle of one of its lanes since power-up.
#[derive(Clone, Debug)]
pub struct Recorder<E> {
    engine: E,
    lane: usize,
    outputs: usize,
    driven: Vec<u128>,
    cycles: Vec<Cycle>,
}

#[derive(Clone, Debug)]
struct Cycle {
    inputs: Vec<u128>,
    outputs: Vec<u128>,
}

/// Why there is no waveform.
#[derive(Debug, thiserror::Error)]
pub enum WaveError {
    /// The outputs of the lane differ from those of the netlist's reference simulation, so there are two waveforms,
    /// not one.
    #[error("the engine and the reference simulation differ: {0}")]
    Differs(Difference),
    /// The file cannot be written.
    #[error(transparent)]
    Io(#[from] io::Error),
}

impl<E: Engine> Recorder<E> {
    /// Records `lane` of an engine of `netlist`, which is put back to power-up with inputs zero.
    ///
    /// # Panics
    /// If there is no such lane.
    pub fn new(mut engine: E, netlist: &Flat, lane: usize) -> Self {
        assert!(lane < engine.lanes(), "lane {lane} of {}", engine.lanes());
        engine.reset();
        let driven = vec![0; netlist.inputs.len()];
        for input in 0..driven.len() {
            engine.set_input(input, lane, 0);
        }
        Self { engine, lane, outputs: netlist.outputs.len(), driven, cycles: Vec::new() }
    }

    /// Writes the lane's cycles as a value change dump, with every named signal of the hierarchy.
    ///
    /// Engines do not keep the values between registers. The function therefore runs the inputs through the reference
    /// simulation. Its outputs must equal the recorded ones in every cycle.
    ///
    /// # Errors
    /// When they differ, or `out` cannot be written.
    pub fn write_wave(&self, netlist: &Flat, out: &mut dyn Write) -> Result<(), WaveError> {
        let mut reference = Evaluator::new(netlist);
        for (cycle, Cycle { inputs, outputs }) in (0..).zip(&self.cycles) {
            let expected = reference.cycle(inputs);
            if let Some(output) = (0..outputs.len()).find(|&output| expected[output] != outputs[output]) {
                return Err(WaveError::Differs(Difference {
                    cycle,
                    lane: self.lane,
                    output: netlist.outputs[output].0.name.clone(),
                    expected: expected[output],
                    found: outputs[output],
                }));
            }
        }
        Ok(netlist::wave::write(
            netlist,
            self.cycles.iter().map(|cycle| cycle.inputs.clone()),
            pipelines::words::decoder,
            out,
        )?)
    }
}

impl<E: Engine> Engine for Recorder<E> {
    fn lanes(&self) -> usize {
        self.engine.lanes()
    }

    fn reset(&mut self) {
        self.cycles.clear();
        self.engine.reset();
    }

    fn set_input(&mut self, input: usize, lane: usize, value: u128) {
        if lane == self.lane {
            self.driven[input] = value;
        }
        self.engine.set_input(input, lane, value);
    }

    fn settle(&mut self) {
        self.engine.settle();
    }

    fn output(&self, output: usize, lane: usize) -> u128 {
        self.engine.output(output, lane)
    }

    fn clock(&mut self) {
        let outputs = (0..self.outputs).map(|output| self.engine.output(output, self.lane)).collect();
        self.cycles.push(Cycle { inputs: self.driven.clone(), outputs });
        self.engine.clock();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use equivalence::Stimulus;
    use lanes::Compiled;
    use netlist::{Change, Mutation, flatten, mutate};
    use pipelines::catalogue::{StandardFormat, Top};

    /// The waveform of a lane is that of its inputs, and the recorder refuses an engine of another netlist.
    #[test]
    fn the_waveform_of_a_lane() {
        const LANE: usize = 5;
        let (top, format) = (Top::FpAdd, StandardFormat::Binary32);
        let design = top.design(format).unwrap();
        let netlist = flatten(&design).unwrap();
        let compiled = Compiled::new(compiled::program(top, format).unwrap());
        let mut recorder = Recorder::new(compiled, &netlist, LANE);
        let mut streams: Vec<_> =
            (0..recorder.lanes() as u64).map(|lane| Stimulus::new(top, format, &netlist, lane)).collect();
        for _ in 0..30 {
            for (lane, stream) in streams.iter_mut().enumerate() {
                for (input, value) in stream.next().unwrap().into_iter().enumerate() {
                    recorder.set_input(input, lane, value);
                }
            }
            recorder.settle();
            recorder.clock();
        }
        let (mut found, mut expected) = (Vec::new(), Vec::new());
        recorder.write_wave(&netlist, &mut found).unwrap();
        let cycles = Stimulus::new(top, format, &netlist, LANE as u64).take(30);
        netlist::wave::write(&netlist, cycles, pipelines::words::decoder, &mut expected).unwrap();
        assert_eq!(found, expected);

        let mutation = Mutation { module: "rounder".into(), value: "word_2".into(), change: Change::Invert };
        let other = flatten(&mutate(&design, &mutation).unwrap()).unwrap();
        let refused = recorder.write_wave(&other, &mut Vec::new());
        assert!(matches!(refused, Err(WaveError::Differs(ref d)) if d.output == "result_o"), "{refused:?}");
    }
}
