//! To which part of the design the cells of a netlist belong that somebody else mapped.

use std::collections::HashMap;

use super::Mapped;
use crate::aig::{Aig, Origin};
use crate::liberty::Library;
use crate::simulate::{Simulator, Slice};

/// Words of random patterns that tell nets apart.
const WORDS: usize = 16;

impl Mapped {
    /// Gives each cell an origin. A cell whose output equals gates of `source`, as they are or complemented, in all of 1024 random
    /// patterns of inputs and states, has the origin of such a gate, in the region of what reads the cell if there is one. Any
    /// other cell has the origin of what reads it, as has one that never changes in these patterns, which says little.
    pub fn attribute(&mut self, source: &Aig, library: &Library) {
        let (function, literals) = self.function(source, library);
        let simulated = simulate(&function);
        let mut origins: HashMap<Slice<WORDS>, Vec<Origin>> = HashMap::new();
        let live = source.live();
        for (node, &values) in simulate(source).iter().enumerate() {
            let values = plain(values);
            if live[node] && source.operands(node).is_some() && values != [0; WORDS] {
                origins.entry(values).or_default().push(source.origin_of(node));
            }
        }
        let mut readers: Vec<Option<Origin>> = vec![None; self.nets];
        for register in &self.registers {
            readers[register.data as usize] = Some(register.origin);
        }
        for gate in self.gates.iter_mut().rev() {
            let values = simulated[literals[gate.output as usize].node()];
            let reader = readers[gate.output as usize].unwrap_or_default();
            let same = origins.get(&plain(values)).map_or(&[][..], Vec::as_slice);
            let near = same.iter().find(|origin| origin.region == reader.region);
            gate.origin = near.or(same.first()).copied().unwrap_or(reader);
            for &net in &gate.inputs {
                readers[net as usize] = Some(gate.origin);
            }
        }
    }
}

/// The values of a node or of its complement, whichever is 0 in the first pattern.
fn plain(values: Slice<WORDS>) -> Slice<WORDS> {
    let invert = (values[0] & 1).wrapping_neg();
    values.map(|word| word ^ invert)
}

/// The values of all nodes, for the same random inputs and states of any graph with the same ports and latches.
fn simulate(aig: &Aig) -> Vec<Slice<WORDS>> {
    let mut counter = 0;
    let mut random = || std::array::from_fn(|_| base::split_mix::next(&mut counter));
    let mut simulator = Simulator::<WORDS>::new(aig);
    (0..aig.inputs().len()).for_each(|input| simulator.set_input(input, random()));
    (0..aig.latches().len()).for_each(|latch| simulator.set_latch(latch, random()));
    simulator.settle();
    simulator.values().to_vec()
}
