//! How closely a frame is simulated, on how many of its rays, and how far off the result may be.
//!
//! | level | what is done |
//! |---|---|
//! | [`Level::Analytic`] | the work of the rays is counted; time is the largest of work over peak rate: a lower bound |
//! | [`Level::Transaction`] | the machine is simulated |
//! | [`Level::Rtl`] | the same, and the pipelines' netlists execute every operation beside golden and are compared bit for bit |
//!
//! # The sample
//! Threads take pixels from a shared counter, thousands at a time: the time of a frame is no sum of times of pixels or tiles.
//! It is a sum over the *counter*: the frame is cut into batches of consecutive pixels ("wavefronts", as many pixels as the
//! machine has threads, or more), and a batch's cycles are those between the counter's arrival at its first pixel and at
//! the next batch's first. These do add up to the frame's time, with the last batch's up to the end.
//!
//! The machine is simulated in one go: first batch from cold caches, as in the frame; sampled batches, each behind
//! a lead of pixels that are timed and not measured, so that threads and first-level caches are in the state of the
//! frame; and the end, from the first pixel on that may still be on its way when the counter has run out, as single long
//! pixels decide when the frame is over. What lies between is recorded and its lines put into
//! the caches in no time. So start and end are measured, not estimated, and the cold start is counted once, as in the frame.
//!
//! # The estimate
//! What threads *execute* is known of all pixels, as recording them costs little beside timing them. Only how long it takes,
//! and what reaches second-level caches and memory, is estimated: per instruction, by the ratio of sums over sampled
//! batches ([`ratio`]). Batches of different work then differ little. Batches are drawn at random, two from each of equally
//! long strata of the frame, so that neighbouring parts of the picture stand for each other, and the variance follows from the
//! pairs (W. G. Cochran, "Sampling Techniques", 1977, sections 5A.12 and 6.11). The interval is Student's, with the
//! degrees of freedom that the pairs show, widened by what warming is measured to miss ([`BIAS`]).
//!
//! [`auto`] starts at the cheapest level and adds what the tolerance asks for.

pub mod analytic;
pub mod auto;
pub mod batches;
pub mod ratio;
mod sampled;
mod window;
mod witness;

pub use sampled::{BIAS, Estimate, Sample, Subject};

use machine::core::SimulationError;
use machine::description::DescriptionError;
use machine::execute::Fault;
use machine::frame::FrameError;
use serde::Serialize;
use std::fmt;

/// How closely a frame is simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// Work over peak rates: a lower bound.
    Analytic,
    /// The machine.
    Transaction,
    /// The machine with every pipeline operation executed by its netlist.
    Rtl,
}

impl Level {
    /// All of them, the cheapest first.
    pub const ALL: [Self; 3] = [Self::Analytic, Self::Transaction, Self::Rtl];

    /// The name on the command line and in result files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Analytic => "analytic",
            Self::Transaction => "transaction",
            Self::Rtl => "rtl",
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A quantity with its interval of 95 % confidence.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Interval {
    /// The estimate.
    pub value: f64,
    /// Low end.
    pub low: f64,
    /// High end.
    pub high: f64,
}

impl Interval {
    /// Without uncertainty.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        Self { value, low: value, high: value }
    }

    /// `value` give or take `half`.
    #[must_use]
    pub fn around(value: f64, half: f64) -> Self {
        Self { value, low: value - half, high: value + half }
    }

    /// Half of its width as a fraction of the value.
    #[must_use]
    pub fn relative(&self) -> f64 {
        if self.high > self.low { (self.high - self.low) / 2.0 / self.value.abs() } else { 0.0 }
    }

    /// Whether `x` lies inside.
    #[must_use]
    pub fn covers(&self, x: f64) -> bool {
        (self.low..=self.high).contains(&x)
    }
}

/// Why a frame cannot be estimated.
#[derive(Debug, thiserror::Error)]
pub enum FidelityError {
    /// The frame cannot be simulated.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// The machine has no costs.
    #[error(transparent)]
    Description(#[from] DescriptionError),
    /// The simulation does not end.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    /// The program does something wrong.
    #[error(transparent)]
    Fault(#[from] Box<Fault>),
    /// The structure is decoded in software.
    #[error("{0} has no pipeline whose netlist could be executed; use the level transaction")]
    NoPipeline(&'static str),
}
