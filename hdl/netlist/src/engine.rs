//! What every simulation of a netlist does, whatever it is made of.

use crate::Evaluator;

/// A simulation of equal copies of a netlist, one in each lane. Ports are counted as in
/// [`Flat`](crate::Flat).
///
/// A cycle is: drive the inputs, [`settle`](Engine::settle), read the outputs, [`clock`](Engine::clock).
pub trait Engine {
    /// Number of copies.
    fn lanes(&self) -> usize;

    /// Back to power-up; inputs stay.
    fn reset(&mut self);

    /// Drives an input of one lane with a value reduced modulo 2^width.
    ///
    /// # Panics
    /// If there is no such input or lane.
    fn set_input(&mut self, input: usize, lane: usize, value: u128);

    /// Drives an input of all lanes, in order, with values below 2^width.
    ///
    /// # Panics
    /// If there is no such input, it is wider than 32 bits, or there are not as many values as lanes.
    fn drive(&mut self, input: usize, values: &[u32]) {
        assert_eq!(values.len(), self.lanes());
        for (lane, &value) in values.iter().enumerate() {
            self.set_input(input, lane, value.into());
        }
    }

    /// Computes the outputs from inputs and registers.
    fn settle(&mut self);

    /// Value of an output of one lane at the last [`settle`](Engine::settle).
    ///
    /// # Panics
    /// If there is no such output or lane.
    fn output(&self, output: usize, lane: usize) -> u128;

    /// The low 32 bits of an output of all lanes, as [`output`](Engine::output).
    ///
    /// # Panics
    /// If there is no such output, or room for more or fewer values than lanes.
    fn read(&self, output: usize, values: &mut [u32]) {
        assert_eq!(values.len(), self.lanes());
        for (lane, value) in values.iter_mut().enumerate() {
            *value = self.output(output, lane) as u32;
        }
    }

    /// Applies a rising clock edge with the present inputs. A [`settle`](Engine::settle) must come before it; the
    /// outputs stay as they are until the next one.
    fn clock(&mut self);
}

impl Engine for Evaluator<'_> {
    fn lanes(&self) -> usize {
        1
    }

    fn reset(&mut self) {
        Evaluator::reset(self);
    }

    fn set_input(&mut self, input: usize, lane: usize, value: u128) {
        assert_eq!(lane, 0, "the evaluator has one lane");
        Evaluator::set_input(self, input, value);
    }

    fn settle(&mut self) {
        Evaluator::settle(self);
    }

    fn output(&self, output: usize, lane: usize) -> u128 {
        assert_eq!(lane, 0, "the evaluator has one lane");
        Evaluator::output(self, output)
    }

    fn clock(&mut self) {
        Evaluator::clock(self);
    }
}
