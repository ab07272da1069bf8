//! Theorems about units and pipelines, and the circuits that they are proved against.
//!
//! A [`Theorem`] puts the gates of a top beside those of its [`reference`](mod@reference). [`Sums`] does so for the adder of any format, one case for
//! each distance between the exponents. `dualsplit check --prove` proves them all.
//!
//! ```
//! use gates::prove::{Limits, Verdict};
//! use pipelines::catalogue::{StandardFormat, Top};
//! use proofs::Theorem;
//!
//! // Minimum and maximum in eight bits, for all pairs of operands.
//! let theorem = Theorem::of(Top::FpMinMax, StandardFormat::E4m3, |_| ())?;
//! assert_eq!(theorem.prove(Limits::default(), || ()).verdict, Verdict::Equal);
//! # Ok::<(), proofs::TheoremError>(())
//! ```

pub mod reference;
mod sums;
mod theorems;

pub use sums::{SumCase, Sums};
pub use theorems::{Theorem, TheoremError};
