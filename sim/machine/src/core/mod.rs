//! The timing core: cycles of a chip of multiprocessors, second-level caches and memory.
//!
//! Time advances in quanta of some cycles (see `tm`): lines that arrive are announced, every multiprocessor runs
//! independently of the others, and what they ask of the chip is served in the order of time. Quanta in which nothing
//! can happen are skipped.

mod banks;
mod blocked;
mod chip;
mod dram;
mod l1;
mod l2;
mod lines;
mod outstanding;
mod plan;
mod prefetch;
mod quantum;
mod slots;
mod stats;
mod tags;
mod thread;
mod tm;
mod work;

pub use chip::{Counts, SimulationError, simulate, simulate_plan};
pub use plan::{Noted, Plan, accesses};
pub use stats::{CacheCounts, DramCounts, ThreadCycles};
pub use work::{Tape, Work};

#[cfg(test)]
mod tests;
