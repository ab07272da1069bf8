//! Bit-sliced simulation of an and-inverter graph: every bit of a machine word is a simulation of its own.

use super::aig::{Aig, Lit, Node};

/// Simulations in one machine word.
pub const LANES_PER_WORD: usize = 64;

/// The values of one bit in all lanes.
pub type Slice<const N: usize> = [u64; N];

/// A cycle-accurate simulation of `64 N` independent copies.
#[derive(Clone, Debug)]
pub struct Simulator<'a, const N: usize> {
    aig: &'a Aig,
    /// Operands of each AND, in order, behind the position of its value.
    steps: Vec<(u32, Lit, Lit)>,
    values: Vec<Slice<N>>,
    next: Vec<Slice<N>>,
}

impl<'a, const N: usize> Simulator<'a, N> {
    /// All lanes at power-up; inputs zero, not yet settled.
    #[must_use]
    pub fn new(aig: &'a Aig) -> Self {
        let steps = aig.nodes().iter().zip(0..).filter_map(|(node, position)| match *node {
            Node::And(a, b) => Some((position, a, b)),
            _ => None,
        });
        let mut simulator = Self {
            aig,
            steps: steps.collect(),
            values: vec![[0; N]; aig.nodes().len()],
            next: vec![[0; N]; aig.latches().len()],
        };
        simulator.reset();
        simulator
    }

    /// Back to power-up; inputs stay.
    pub fn reset(&mut self) {
        for latch in self.aig.latches() {
            self.values[latch.lit.node()] = [if latch.initial { !0 } else { 0 }; N];
        }
    }

    /// Drives an input, by its position, in all lanes.
    pub fn set_input(&mut self, input: usize, value: Slice<N>) {
        self.values[self.aig.inputs()[input].lit.node()] = value;
    }

    /// Puts a latch, by its position, into a state.
    pub fn set_latch(&mut self, latch: usize, value: Slice<N>) {
        self.values[self.aig.latches()[latch].lit.node()] = value;
    }

    /// Drives a word's bits with one value for each lane.
    ///
    /// # Panics
    /// When there are more values than lanes, or a bit is no input.
    pub fn set_word(&mut self, bits: &[Lit], lanes: impl IntoIterator<Item = u128>) {
        let mut slices = vec![[0; N]; bits.len()];
        for (lane, value) in lanes.into_iter().enumerate() {
            for (bit, slice) in slices.iter_mut().enumerate() {
                slice[lane / LANES_PER_WORD] |= u64::from(value >> bit & 1 == 1) << (lane % LANES_PER_WORD);
            }
        }
        for (bit, slice) in bits.iter().zip(slices) {
            assert!(matches!(self.aig.nodes()[bit.node()], Node::Input(_)), "only inputs are driven");
            self.values[bit.node()] = slice;
        }
    }

    /// Computes every AND from inputs and latches.
    pub fn settle(&mut self) {
        for &(position, a, b) in &self.steps {
            let (x, y) = (self.value(a), self.value(b));
            self.values[position as usize] = std::array::from_fn(|word| x[word] & y[word]);
        }
    }

    /// A rising clock edge: latches take the values of the last [`Simulator::settle`].
    pub fn clock(&mut self) {
        for (position, latch) in self.aig.latches().iter().enumerate() {
            let (enable, data, held) =
                (self.value(latch.enable), self.value(latch.data), self.value(latch.lit));
            self.next[position] =
                std::array::from_fn(|word| (enable[word] & data[word]) | (!enable[word] & held[word]));
        }
        for (latch, &value) in self.aig.latches().iter().zip(&self.next) {
            self.values[latch.lit.node()] = value;
        }
    }

    /// Value of a literal in all lanes.
    #[must_use]
    pub fn value(&self, lit: Lit) -> Slice<N> {
        let invert = if lit.is_complemented() { !0 } else { 0 };
        self.values[lit.node()].map(|word| word ^ invert)
    }

    /// Values of all nodes in all lanes, in order.
    #[must_use]
    pub fn values(&self) -> &[Slice<N>] {
        &self.values
    }

    /// Value of a word in one lane.
    #[must_use]
    pub fn word(&self, bits: &[Lit], lane: usize) -> u128 {
        let bit =
            |lit: Lit| u128::from(self.value(lit)[lane / LANES_PER_WORD] >> (lane % LANES_PER_WORD) & 1);
        bits.iter().rev().fold(0, |word, &lit| word << 1 | bit(lit))
    }
}
