//! The timing core: cycles of a chip of multiprocessors, second-level caches and memory.
//!
//! Time advances in quanta of some cycles. At the start of a quantum, the chip announces the lines whose time of arrival is known.
//! Then every multiprocessor runs through the quantum (`tm`, `thread`), and the chip serves their requests cycle by cycle
//! (`chip::serve`). The threads that it has answered run through the rest of the quantum, and so on until nothing is asked. Quanta
//! in which nothing can happen are skipped. The model in `tests/slow.rs` tells the same without tables and short cuts.

mod ahead;
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
mod request;
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
