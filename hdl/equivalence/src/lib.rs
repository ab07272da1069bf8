//! Equivalence of a top's elaborated netlist and the specification, `golden`, cycle by cycle and bit for bit.
//!
//! ```text
//!  seed --Stimulus--> inputs of each cycle --+--> netlist (Evaluator) --> outputs --+
//!                                            +--> Model (golden) ------> claims ----+--> Outcome
//! ```
//!
//! A [`Model`] turns each operation into a list of claims, *output p shows the value v*. The claims fall due after the unit's latency
//! in enabled cycles. The model claims nothing about outputs that mean nothing: those of an invalid operation, of a miss, or of a
//! slot that is not returned. Stalls, bubbles and tags are part of every stream. Equal seeds give equal streams, so the seed finds a
//! mismatch again.
//!
//! ```
//! use netlist::{flatten, mutate, mutations};
//! use pipelines::catalogue::{StandardFormat::Binary32, Top};
//!
//! let design = Top::FpCmp.design(Binary32)?;
//! let outcome = equivalence::check(&flatten(&design)?, Top::FpCmp, Binary32, 500, 1);
//! assert_eq!(outcome.mismatches, 0);
//!
//! // The check notices a fault in the netlist.
//! let faults = mutations(&design);
//! let faulty = mutate(&design, &faults[0])?;
//! let outcome = equivalence::check(&flatten(&faulty)?, Top::FpCmp, Binary32, 500, 1);
//! assert!(outcome.mismatches > 0, "{:?}", faults[0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod cases;
mod classes;
mod directed;
mod model;
mod ports;
mod stimulus;

use std::collections::BTreeMap;
use std::fmt;

pub use directed::directed;
pub use model::Model;
pub use ports::Ports;
pub use stimulus::{Stimulus, testbench};

use netlist::{Evaluator, Flat};
use pipelines::catalogue::{StandardFormat, Top};

/// The result of a comparison.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// Cycles simulated, stalls and bubbles included.
    pub cycles: u64,
    /// Operations that went in.
    pub vectors: u64,
    /// Number of cycles by class of stimulus; an operation may be in several classes.
    pub classes: BTreeMap<&'static str, u64>,
    /// Claims that did not hold.
    pub mismatches: u64,
    /// The first of them.
    pub first: Option<Mismatch>,
}

/// A claim that did not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Mismatch {
    /// Cycle in which the output was read, from 0.
    pub cycle: u64,
    /// Name of the output.
    pub output: String,
    /// What the specification says.
    pub expected: u128,
    /// What the netlist gives.
    pub found: u128,
    /// All inputs in the cycle in which the operation went in; none for a claim about the empty pipeline.
    pub inputs: Option<Vec<u128>>,
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { cycle, output, expected, found, inputs } = self;
        write!(f, "cycle {cycle}: {output} is {found:#x}, and should be {expected:#x}")?;
        match inputs {
            Some(inputs) => write!(f, ", for inputs {inputs:x?}"),
            None => write!(f, ", before any operation has come through"),
        }
    }
}

/// Runs `cycles`, each the values of all inputs, through `netlist` and compares its outputs with `model`'s claims.
/// `observe` sees inputs and outputs of each cycle.
pub fn compare(
    netlist: &Flat,
    mut model: Model,
    cycles: impl IntoIterator<Item = Vec<u128>>,
    mut observe: impl FnMut(&[u128], &[u128]),
) -> Outcome {
    let mut evaluator = Evaluator::new(netlist);
    let mut outcome = Outcome::default();
    for inputs in cycles {
        let outputs = evaluator.cycle(&inputs);
        for (claim, origin) in model.due() {
            let found = outputs[claim.output];
            if found != claim.value {
                outcome.mismatches += 1;
                outcome.first.get_or_insert_with(|| Mismatch {
                    cycle: outcome.cycles,
                    output: netlist.outputs[claim.output].0.name.clone(),
                    expected: claim.value,
                    found,
                    inputs: origin.map(<[u128]>::to_vec),
                });
            }
        }
        outcome.vectors +=
            u64::from(model.clock(&inputs, |class| *outcome.classes.entry(class).or_default() += 1));
        outcome.cycles += 1;
        observe(&inputs, &outputs);
    }
    outcome
}

/// [`compare`] on `vectors` cycles of the stream of `seed`.
pub fn check(netlist: &Flat, top: Top, format: StandardFormat, vectors: u64, seed: u64) -> Outcome {
    let stimulus = Stimulus::new(top, format, netlist, seed);
    let count = usize::try_from(vectors).unwrap_or(usize::MAX);
    compare(netlist, Model::new(top, format, netlist), stimulus.take(count), |_, _| ())
}
