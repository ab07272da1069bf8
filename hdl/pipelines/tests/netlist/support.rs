//! Drives a rust-hdl module and its elaborated netlist with the same stimulus.

use base::split_mix::hash;
use netlist::{Evaluator, elaborate, flatten, mask};
use rust_hdl_core::prelude::*;

/// A port value as an integer.
pub trait Value: Synth {
    fn from_integer(value: u128) -> Self;
    fn to_integer(self) -> u128;
}

impl Value for Bit {
    fn from_integer(value: u128) -> Self {
        value != 0
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

impl<const N: usize> Value for Signed<N> {
    fn from_integer(value: u128) -> Self {
        signed_cast(value.to_bits())
    }
    fn to_integer(self) -> u128 {
        unsigned_cast(self).to_u128()
    }
}

/// A module whose ports can be driven by position, in order of declaration, the clock left out.
pub trait Driven: Block + Default {
    fn drive(&mut self, inputs: &[u128]);
    fn sample(&self) -> Vec<u128>;
    fn set_clock(&mut self, level: bool);
}

/// Implements [`Driven`] for the listed ports.
macro_rules! driven {
    ($module:ty, ($($($clock:ident).+)?), [$($($input:ident).+),* $(,)?], [$($($output:ident).+),* $(,)?]) => {
        impl crate::support::Driven for $module {
            fn drive(&mut self, inputs: &[u128]) {
                let mut values = inputs.iter().copied();
                $(self.$($input).+.next = crate::support::Value::from_integer(values.next().unwrap());)*
                assert_eq!(values.next(), None);
            }
            fn sample(&self) -> Vec<u128> {
                vec![$(crate::support::Value::to_integer(self.$($output).+.val())),*]
            }
            fn set_clock(&mut self, _level: bool) {
                $(self.$($clock).+.next = Clock { clk: _level };)?
            }
        }
    };
}
pub(crate) use driven;

/// Value of an input of `width` bits in cycle `cycle`: corners in a quarter of the cycles.
pub fn stimulus(cycle: u64, input: usize, width: u32) -> u128 {
    let random = hash(cycle ^ hash(input as u64 + 1));
    let wide = u128::from(hash(random)) << 64 | u128::from(hash(!random));
    let value = match random % 16 {
        0 => 0,
        1 => mask(width),
        2 => 1,
        3 => 1 << (width - 1),
        _ => wide,
    };
    value & mask(width)
}

/// Simulates with rust-hdl and with the netlist for `cycles` cycles; panics at the first output that differs.
pub fn assert_same<M: Driven>(name: &str, cycles: u64) {
    assert_same_after::<M>(name, cycles, |_| ());
}

/// [`assert_same`] with the inputs of each cycle adjusted first.
pub fn assert_same_after<M: Driven>(name: &str, cycles: u64, adjust: impl Fn(&mut [u128])) {
    let mut module = M::default();
    module.connect_all();
    check_all(&module).unwrap_or_else(|error| panic!("{name}: {error:?}"));
    let design = elaborate(&module, name).unwrap_or_else(|error| panic!("{name}: {error}"));
    let flat = flatten(&design).unwrap();
    let mut evaluator = Evaluator::new(&flat);
    for cycle in 0..cycles {
        let mut inputs: Vec<u128> =
            flat.inputs.iter().enumerate().map(|(i, port)| stimulus(cycle, i, port.width)).collect();
        adjust(&mut inputs);
        module.drive(&inputs);
        module.set_clock(false);
        assert!(simulate(&mut module, 100), "{name} does not settle");
        let expected = module.sample();
        let found = evaluator.cycle(&inputs);
        assert_eq!(found, expected, "{name}, cycle {cycle}, inputs {inputs:x?}");
        module.set_clock(true);
        assert!(simulate(&mut module, 100), "{name} does not settle");
    }
}
