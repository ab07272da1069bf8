//! Estimates of a frame's time and energy: the level of detail, the sample of pixels, and the confidence interval.
//!
//! | level | what is done |
//! |---|---|
//! | [`Level::Analytic`] | the work of the rays is counted; time is the largest of work over peak rate: a lower bound |
//! | [`Level::Queueing`] | the rays' instructions go through a model of caches and queues ([`machine::queueing`]) |
//! | [`Level::Transaction`] | the machine is simulated |
//! | [`Level::Rtl`] | the same, and the pipelines' netlists execute every operation beside golden and are compared bit for bit |
//!
//! # The sample
//! Thousands of threads take pixels from a shared counter at the same time, so the time of a frame is no sum of the times of
//! pixels or tiles. It is a sum over the *counter*. The frame is cut into batches of consecutive pixels ("wavefronts", at least as
//! many pixels as the machine has threads). A batch's cycles are those between the counter's arrival at the first pixel of the
//! batch and its arrival at the first pixel of the next batch; those of the last batch extend to the end of the frame. The cycles
//! of all batches add up to the frame's time.
//!
//! One simulation runs through the whole frame and times three parts of it:
//! * the first batch, from cold caches as in the frame;
//! * the sampled batches. Each follows a lead of pixels that are timed but not measured, so that threads and first-level caches
//!   are in the state that they have in the frame;
//! * the end of the frame. It begins with the first pixel that may still be in flight when the counter runs out, because single
//!   long pixels decide when the frame ends.
//!
//! The pixels between these parts are recorded, and their lines are put into the caches without taking time. So start and end are
//! measured, not estimated, and the cold start is counted once, as in the frame.
//!
//! # The estimate
//! The instructions that threads execute are known for all pixels, because recording a pixel costs little compared with timing
//! it. Two quantities are estimated: the time that the instructions take, and the accesses that reach second-level caches and
//! memory. Both are estimated per instruction, by the ratio of sums over sampled batches ([`ratio`]), so that batches of
//! different work differ little. The frame is cut into strata of equal length, and two batches are drawn at random from each.
//! Neighbouring parts of the picture then stand for each other, and the variance follows from the pairs (W. G. Cochran, "Sampling
//! Techniques", 1977, sections 5A.12 and 6.11). The interval is Student's, with the degrees of freedom that the pairs show. It is
//! widened by the error that warming was measured to leave ([`BIAS`]).
//!
//! [`auto`] starts at the cheapest level, and enlarges the sample until the result is within a tolerance.

pub mod analytic;
pub mod auto;
pub mod batches;
pub mod queueing;
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

/// The level of detail of a simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// The largest of work over peak rate: a lower bound.
    Analytic,
    /// Caches are simulated; units, banks and memory by how long one waits for them on the average.
    Queueing,
    /// The machine is simulated.
    Transaction,
    /// The machine is simulated, and the netlists execute every pipeline operation.
    Rtl,
}

impl Level {
    /// All levels, the cheapest first.
    pub const ALL: [Self; 4] = [Self::Analytic, Self::Queueing, Self::Transaction, Self::Rtl];

    /// The name on the command line and in result files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Analytic => "analytic",
            Self::Queueing => "queueing",
            Self::Transaction => "transaction",
            Self::Rtl => "rtl",
        }
    }
}

impl Level {
    /// Whether the machine is simulated cycle by cycle.
    #[must_use]
    pub fn simulates(self) -> bool {
        matches!(self, Self::Transaction | Self::Rtl)
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A quantity with its interval of 95 % confidence; at the queueing level, with the error that was measured.
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
    /// The interval of a value without uncertainty.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        Self { value, low: value, high: value }
    }

    /// The interval from `value - half` to `value + half`.
    #[must_use]
    pub fn around(value: f64, half: f64) -> Self {
        Self { value, low: value - half, high: value + half }
    }

    /// Half of the interval's width as a fraction of the value.
    #[must_use]
    pub fn relative(&self) -> f64 {
        if self.high > self.low { (self.high - self.low) / 2.0 / self.value.abs() } else { 0.0 }
    }

    /// Whether `x` lies in the interval.
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
