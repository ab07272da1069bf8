//! `rust-hdl`'s own simulation of a module, which executes the kernels' Rust text: the first witness of what the
//! hardware does.

use netlist::Engine;
use pipelines::formats::binary32;
use rust_hdl_core::prelude::*;

/// Passes over the hierarchy after which a clock edge must have settled.
const SETTLING_PASSES: usize = 100;

/// A port's value as an integer.
trait Value: Synth {
    fn from_integer(value: u128) -> Self;
    fn to_integer(self) -> u128;
}

impl Value for Bit {
    fn from_integer(value: u128) -> Self {
        value & 1 == 1
    }

    fn to_integer(self) -> u128 {
        u128::from(self)
    }
}

impl<const N: usize> Value for Bits<N> {
    fn from_integer(value: u128) -> Self {
        value.to_bits()
    }

    fn to_integer(self) -> u128 {
        self.to_u128()
    }
}

/// A module whose ports are counted as in its netlist.
pub trait Ports: Block + Default {
    /// Drives an input.
    fn drive(&mut self, input: usize, value: u128);
    /// Reads an output.
    fn read(&self, output: usize) -> u128;
    /// Sets the clock.
    fn set_clock(&mut self, level: bool);
}

macro_rules! ports {
    ($($module:ty: [$($($input:ident).+),*] -> [$($($output:ident).+),*];)*) => { $(
        impl Ports for $module {
            fn drive(&mut self, input: usize, value: u128) {
                let mut position = 0;
                $(
                    if input == position {
                        self.$($input).+.next = Value::from_integer(value);
                    }
                    position += 1;
                )*
                assert!(input < position, "no input {input}");
            }

            fn read(&self, output: usize) -> u128 {
                let mut position = 0;
                $(
                    if output == position {
                        return Value::to_integer(self.$($output).+.val());
                    }
                    position += 1;
                )*
                panic!("no output {output} of {position}");
            }

            fn set_clock(&mut self, level: bool) {
                self.clocking.clk_i.next = Clock { clk: level };
            }
        }
    )* };
}

ports! {
    binary32::FpAdd: [clocking.en_i, valid_i, tag_i, a_i, b_i, subtract_i, rounding_i] -> [valid_o, tag_o, result_o];
    binary32::FpMul: [clocking.en_i, valid_i, tag_i, a_i, b_i, rounding_i] -> [valid_o, tag_o, result_o];
    binary32::FpMinMax: [clocking.en_i, valid_i, tag_i, a_i, b_i, maximum_i, propagate_nan_i] -> [valid_o, tag_o, result_o];
    binary32::FpCmp: [clocking.en_i, valid_i, tag_i, a_i, b_i] -> [valid_o, tag_o, lt_o, le_o, eq_o];
    binary32::DualSplitPipeline: [
        clocking.en_i, valid_i, tag_i, node.header_i, node.plane_0_i, node.plane_1_i, ray.origin.origin_x_i, ray.origin.origin_y_i, ray.origin.origin_z_i, ray.reciprocals.inv_entry_x_i, ray.reciprocals.inv_entry_y_i,
        ray.reciprocals.inv_entry_z_i, ray.reciprocals.inv_exit_x_i, ray.reciprocals.inv_exit_y_i, ray.reciprocals.inv_exit_z_i, ray.interval.t_min_i, ray.interval.t_max_i
    ] -> [valid_o, tag_o, step.code_o, step.near_offset_o, step.near_t_min_o, step.near_t_max_o, step.far_offset_o, step.far_t_min_o, step.far_t_max_o];
    binary32::RayBoxPipeline: [
        clocking.en_i, valid_i, tag_i, bounds.box_min_x_i, bounds.box_min_y_i, bounds.box_min_z_i, bounds.box_max_x_i, bounds.box_max_y_i, bounds.box_max_z_i, ray.origin.origin_x_i,
        ray.origin.origin_y_i, ray.origin.origin_z_i, ray.reciprocals.inv_entry_x_i, ray.reciprocals.inv_entry_y_i, ray.reciprocals.inv_entry_z_i, ray.reciprocals.inv_exit_x_i, ray.reciprocals.inv_exit_y_i, ray.reciprocals.inv_exit_z_i,
        ray.interval.t_min_i, ray.interval.t_max_i
    ] -> [valid_o, tag_o, hit_o, t_entry_o];
}

/// The simulation of a module.
#[derive(Debug, Default)]
pub struct RustHdl<M> {
    module: M,
}

impl<M: Ports> RustHdl<M> {
    /// The module at power-up.
    #[must_use]
    pub fn new() -> Self {
        let mut module = M::default();
        module.connect_all();
        Self { module }
    }

    fn level(&mut self, level: bool) {
        self.module.set_clock(level);
        assert!(simulate(&mut self.module, SETTLING_PASSES), "the module does not settle");
    }
}

impl<M: Ports> Engine for RustHdl<M> {
    fn lanes(&self) -> usize {
        1
    }

    fn reset(&mut self) {
        *self = Self::new();
    }

    fn set_input(&mut self, input: usize, lane: usize, value: u128) {
        assert_eq!(lane, 0, "rust-hdl simulates one lane");
        self.module.drive(input, value);
    }

    fn settle(&mut self) {
        self.level(false);
    }

    fn output(&self, output: usize, lane: usize) -> u128 {
        assert_eq!(lane, 0, "rust-hdl simulates one lane");
        self.module.read(output)
    }

    fn clock(&mut self) {
        self.level(true);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use equivalence::Stimulus;
    use lanes::Compiled;
    use netlist::flatten;
    use pipelines::catalogue::{StandardFormat, Top};

    /// Every output of every cycle of one lane.
    fn assert_same<M: Ports>(top: Top, cycles: usize) {
        const LANE: usize = 9;
        let format = StandardFormat::Binary32;
        let netlist = flatten(&top.design(format).unwrap()).unwrap();
        let mut compiled = Compiled::new(compiled::program(top, format).unwrap());
        let mut witness = RustHdl::<M>::new();
        for (cycle, inputs) in Stimulus::new(top, format, &netlist, 77).take(cycles).enumerate() {
            for (input, value) in inputs.into_iter().enumerate() {
                witness.set_input(input, 0, value);
                compiled.set_input(input, LANE, value);
            }
            witness.settle();
            compiled.settle();
            for output in 0..netlist.outputs.len() {
                let (found, expected) = (compiled.output(output, LANE), witness.output(output, 0));
                assert_eq!(found, expected, "{top}, cycle {cycle}: {}", netlist.outputs[output].0.name);
            }
            witness.clock();
            compiled.clock();
        }
    }

    #[test]
    fn compiled_tops_agree_with_rust_hdl() {
        assert_same::<binary32::FpAdd>(Top::FpAdd, 10_000);
        assert_same::<binary32::FpMul>(Top::FpMul, 10_000);
        assert_same::<binary32::FpMinMax>(Top::FpMinMax, 10_000);
        assert_same::<binary32::FpCmp>(Top::FpCmp, 10_000);
        assert_same::<binary32::DualSplitPipeline>(Top::DualSplit, 2_000);
        assert_same::<binary32::RayBoxPipeline>(Top::RayBox, 1_000);
    }
}
