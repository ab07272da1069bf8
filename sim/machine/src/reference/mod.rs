//! The reference runs: a software BVH2 on the public simulator, with its rays, its tree and its results.

mod compared;
mod runs;
mod scene;
mod work;

pub use compared::{Compared, ValidatedRun};
pub use runs::{PRESET, ReferenceRun, ReferenceRuns, TABLE, ValidationError};
pub use scene::{RaySet, ReferenceError, ReferenceScene};
pub use work::ReferenceWork;

/// The program of closest-hit sets.
pub const CLOSEST: &str = include_str!("../../kernels/reference.s");
/// The program of any-hit sets.
pub const ANY: &str = include_str!("../../kernels/reference-any.s");
