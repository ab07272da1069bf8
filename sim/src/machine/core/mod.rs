//! The timing core: cycles of a chip of multiprocessors, second-level caches and memory.
//!
//! In each cycle, lines that have arrived are delivered; then every multiprocessor issues, independently of the
//! others; then what they ask of the chip is served in a fixed order. A multiprocessor whose threads all wait costs
//! nothing, and cycles in which nothing can happen are skipped.

mod chip;
mod dram;
mod l2;
mod outstanding;
mod stats;
mod tags;
mod tm;
mod work;

pub use chip::{Counts, SimulationError, simulate};
pub use stats::{CacheCounts, DramCounts, ThreadCycles};
pub use work::{Tape, Work};
