//! The quantum in which time advances.

use super::dram::Dram;
use crate::description::MachineDescription;

/// Most cycles of a quantum.
pub const LONGEST: usize = 8;

/// Cycles of a machine's quantum: not more than memory takes, so that nothing arrives within the quantum in which it was asked for.
pub fn cycles(machine: &MachineDescription) -> u32 {
    Dram::least_latency(&machine.dram).clamp(1, LONGEST as u32)
}
