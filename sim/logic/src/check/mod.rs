//! The simulated hardware against the specification, in volume.
//!
//! [`volume`] draws operations of every class from a seed, with stalls, bubbles and tags, and compares the compiled
//! netlist with golden's traversal steps and with the [`oracle`]; [`exhaustive`] goes through all pairs of operands
//! of a small format. Both work in blocks. One thread does a whole block, and the block's number decides what is in
//! it, so results do not depend on the number of threads.

pub mod exhaustive;
mod operations;
pub mod oracle;
pub mod volume;

#[cfg(test)]
mod tests;

/// What a check has found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Totals {
    /// Cycles of all lanes, stalls and bubbles included.
    pub cycles: u64,
    /// Operations whose results were compared.
    pub vectors: u64,
    /// Results that were wrong.
    pub mismatches: u64,
    /// The first of them.
    pub first: Option<String>,
}

impl Totals {
    /// Adds what a later block has found.
    pub fn add(&mut self, later: Self) {
        self.cycles += later.cycles;
        self.vectors += later.vectors;
        self.mismatches += later.mismatches;
        self.first = self.first.take().or(later.first);
    }
}
