//! The machines that claims are tried on: each key is varied over a stated range.

use base::split_mix;

/// A key of the machine with the values that it is given.
#[derive(Clone, Copy, Debug)]
pub struct Range {
    /// The key.
    pub key: &'static str,
    /// Its values, in their order.
    pub values: &'static [&'static str],
}

const fn range(key: &'static str, values: &'static [&'static str]) -> Range {
    Range { key, values }
}

/// Multiprocessors of all these machines, in one partition. Sizes behind the first-level caches are chosen for so many.
pub const CHIP: [u32; 2] = [1, 8];

/// All ranges. They span what public machines of this class have; a constraint that is not here is that of the preset.
pub const RANGES: [Range; 18] = [
    range("tm.threads", &["16", "32"]),
    range("tm.load_words", &["1", "4", "line"]),
    range("layout.alignment", &["0B", "64B"]),
    range("units.fp_add.count", &["8", "16"]),
    range("units.fp_mul.count", &["8", "16"]),
    range("units.fp_mul.latency_cycles", &["2", "4"]),
    range("l1.size", &["16KiB", "32KiB", "64KiB"]),
    range("l1.banks", &["4", "8", "16", "32"]),
    range("l1.bank_by", &["word", "line"]),
    range("l1.associativity", &["1", "4"]),
    range("l1.latency_cycles", &["1", "2", "4"]),
    range("network.latency_cycles", &["0", "4", "16"]),
    range("l2.size", &["128KiB", "256KiB", "512KiB", "1MiB"]),
    range("l2.banks", &["8", "16", "32", "64"]),
    range("l2.bank_by", &["word", "line"]),
    range("l2.latency_cycles", &["3", "10", "30"]),
    range("dram.channels", &["1", "2", "4", "8"]),
    range("dram.mapping", &["column-channel-bank-row", "channel-column-bank-row", "channel-bank-column-row"]),
];

/// Index of each key's value, for one machine.
pub type Values = [usize; RANGES.len()];

/// `count` machines as a Latin hypercube (M. D. McKay, R. J. Beckman, W. J. Conover, "A Comparison of Three Methods for Selecting
/// Values of Input Variables", Technometrics 21, 1979): every value of a key is taken by equally many machines, but for one.
#[must_use]
pub fn sample(count: usize, seed: u64) -> Vec<Values> {
    let mut state = split_mix::hash(seed);
    let mut machines = vec![Values::default(); count];
    for (at, range) in RANGES.iter().enumerate() {
        let mut values: Vec<usize> = (0..count).map(|machine| machine * range.values.len() / count).collect();
        shuffle(&mut values, &mut state);
        machines.iter_mut().zip(values).for_each(|(machine, value)| machine[at] = value);
    }
    machines
}

/// Puts `items` into an order drawn from `state` (Fisher and Yates).
pub(super) fn shuffle<T>(items: &mut [T], state: &mut u64) {
    for at in (1..items.len()).rev() {
        items.swap(at, (split_mix::next(state) % (at as u64 + 1)) as usize);
    }
}

/// `values` as settings of the form `key=value`.
#[must_use]
pub fn settings(values: &Values) -> Vec<String> {
    RANGES
        .iter()
        .zip(values)
        .map(|(range, value)| format!("{}={}", range.key, range.values[*value]))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::jobs::chip_settings;
    use estimate::Method;
    use machine::description::MachineDescription;
    use machine::frame::{FrameMachine, MachineStructure};

    #[test]
    fn every_value_is_taken_as_often_and_every_machine_can_be_built() {
        let machines = sample(24, 3);
        for (at, range) in RANGES.iter().enumerate() {
            for value in 0..range.values.len() {
                let taken = machines.iter().filter(|machine| machine[at] == value).count();
                assert_eq!(taken, 24 / range.values.len(), "{}", range.key);
            }
        }
        assert_ne!(machines, sample(24, 4));
        let pipeline = estimate::by_name(Method::Published);
        for machine in &machines {
            let settings = [chip_settings(CHIP).to_vec(), settings(machine)].concat();
            let machine = MachineDescription::load("trax", &settings).unwrap();
            for structure in [MachineStructure::Dst, MachineStructure::Bvh8Plus] {
                FrameMachine::new(&machine, structure, &pipeline).unwrap();
            }
        }
    }
}
