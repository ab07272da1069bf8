//! The quantum in which time advances.

use crate::description;
use crate::dram::Dram;

/// Most cycles of a quantum.
pub const LONGEST_QUANTUM: usize = 8;

/// Cycles of a quantum: not more than a read of the DRAM takes, so that nothing arrives within the quantum in which it was asked
/// for.
#[must_use]
pub fn quantum(dram: &description::Dram) -> u32 {
    Dram::least_latency(dram).clamp(1, LONGEST_QUANTUM as u32)
}
