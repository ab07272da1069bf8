//! The timing core: cycles of a chip of multiprocessors, whose threads are clients of the [`memory`].
//!
//! Time advances in the memory's quanta. At the start of a quantum, the memory announces the lines whose time of arrival is known.
//! Then every multiprocessor runs through the quantum (`tm`, `thread`) and asks its port, and the chip takes what the ports cannot
//! answer to the counter and the memory, cycle by cycle (`chip::serve`). The threads that it has answered run through the rest of the
//! quantum, and so on until nothing is asked. Quanta in which nothing can happen are skipped. The model in `tests/slow.rs` tells the
//! same without tables and short cuts.

mod ahead;
mod chip;
mod plan;
mod prefetch;
mod request;
mod slots;
mod stats;
mod thread;
mod tm;
mod work;

pub use chip::{Counts, SimulationError, simulate, simulate_plan};
pub(crate) use chip::{MAX_CYCLES, MOST_WORDS};
pub use memory::{CacheCounts, DramCounts};
pub use plan::{Noted, Plan, accesses};
pub use stats::ThreadCycles;
pub use work::{Tape, Work};

#[cfg(test)]
pub(crate) mod tests;
