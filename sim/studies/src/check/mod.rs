//! The netlists of the hardware, compared with the specification.
//!
//! All operations run in the fastest engine. The first of them also run in the reference simulation, which counts each by its
//! classes: the counts show what the stream covers.

pub mod exhaustive;

use crate::progress::{Part, Progress};
use anyhow::Context;
use logic::check::volume::volume;
use netlist::{Design, flatten, mutate, mutations};
use pipelines::catalogue::{StandardFormat, Top};
use serde::Serialize;
use std::collections::BTreeMap;
use std::time::Instant;

/// Cycles of each top in the reference simulation.
const REFERENCE_CYCLES: u64 = 10_000;

/// The units to check, and the number of operations.
#[derive(Clone, Debug)]
pub struct Options {
    /// The unit or pipeline that is checked; all of them if absent.
    pub unit: Option<Top>,
    /// Operations that are compared for each unit.
    pub vectors: u64,
    /// The number of a fault, counted from 0, that is put into the unit's netlist before the check.
    pub fault: Option<usize>,
    /// Seed of the operations.
    pub seed: u64,
}

/// The results of all checks.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Checks {
    pub seed: u64,
    /// The fault that was put into the unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fault: Option<String>,
    pub units: Vec<UnitRow>,
}

/// The result of the check of a unit or pipeline.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct UnitRow {
    pub name: &'static str,
    /// Operations that were compared.
    pub vectors: u64,
    /// Clock cycles of all lanes, with stalls and bubbles.
    pub cycles: u64,
    pub mismatches: u64,
    pub vectors_per_second: f64,
    /// Cycles of the reference simulation by class of stimulus; an operation may be in several.
    pub classes: BTreeMap<&'static str, u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_mismatch: Option<String>,
}

/// Compares the units that `options` name with the specification.
///
/// # Errors
/// There is no such fault, or a unit cannot be elaborated.
pub fn run(options: &Options, progress: &dyn Progress) -> anyhow::Result<Checks> {
    let Options { vectors, seed, .. } = *options;
    let tops = options.unit.map_or_else(|| Top::ALL.to_vec(), |top| vec![top]);
    let mut checks = Checks { seed, fault: None, units: Vec::new() };
    for top in tops {
        checks.units.push(match options.fault {
            Some(number) => {
                let (mutant, fault) = mutant(&top.design(StandardFormat::Binary32)?, number)?;
                checks.fault = Some(fault);
                mutant_row(top, &mutant, vectors, seed)?
            }
            None => row(top, vectors, seed, progress)?,
        });
    }
    Ok(checks)
}

/// The design with fault `number`, and a description of the fault.
fn mutant(design: &Design, number: usize) -> anyhow::Result<(Design, String)> {
    let faults = mutations(design);
    let fault = faults.get(number).with_context(|| {
        let name = &design.top().name;
        format!("--mutate {number}: {name} has {} faults to try, counted from 0", faults.len())
    })?;
    Ok((mutate(design, fault)?, fault.to_string()))
}

/// The result for a faulty netlist. Only the reference simulation runs it, as no compiled program exists for it.
fn mutant_row(top: Top, mutant: &Design, cycles: u64, seed: u64) -> anyhow::Result<UnitRow> {
    let start = Instant::now();
    let outcome = equivalence::check(&flatten(mutant)?, top, StandardFormat::Binary32, cycles, seed);
    Ok(UnitRow {
        name: top.name(),
        vectors: outcome.vectors,
        cycles: outcome.cycles,
        mismatches: outcome.mismatches,
        vectors_per_second: outcome.vectors as f64 / start.elapsed().as_secs_f64(),
        classes: outcome.classes,
        first_mismatch: outcome.first.map(|first| first.to_string()),
    })
}

fn row(top: Top, vectors: u64, seed: u64, progress: &dyn Progress) -> anyhow::Result<UnitRow> {
    let format = StandardFormat::Binary32;
    let netlist = flatten(&top.design(format)?)?;
    let part = Part::begin(progress, vectors, &format!("checking {top}"));
    let reference = equivalence::check(&netlist, top, format, vectors.min(REFERENCE_CYCLES), seed);
    let start = Instant::now();
    let totals = volume(top, format, &netlist, vectors, seed, |done| part.at(done))
        .with_context(|| format!("{top} is not compiled in {format}"))?;
    let seconds = start.elapsed().as_secs_f64();
    drop(part);
    let in_reference = reference.first.map(|first| format!("in the reference simulation, {first}"));
    Ok(UnitRow {
        name: top.name(),
        vectors: totals.vectors,
        cycles: totals.cycles,
        mismatches: totals.mismatches + reference.mismatches,
        vectors_per_second: totals.vectors as f64 / seconds,
        classes: reference.classes,
        first_mismatch: in_reference.or(totals.first),
    })
}
