//! `dualsplit check`: the netlists of the hardware against the specification.
//!
//! All operations go through the fastest engine. The first of them also go through the reference simulation, where each
//! is counted by its class, which says what a stream has covered.

mod exhaustive;

use crate::cli::{CheckArgs, Global};
use crate::console::{Report, progress, table};
use anyhow::Context;
use equivalence;
use logic::check::volume::volume;
use netlist::{Design, flatten, mutate, mutations};
use pipelines::catalogue::{StandardFormat, Top};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::time::Instant;

/// Cycles of each top in the reference simulation.
const REFERENCE_CYCLES: u64 = 10_000;

#[derive(Serialize)]
struct Document {
    seed: u64,
    /// The fault that was put into the unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    fault: Option<String>,
    units: Vec<UnitRow>,
}

#[derive(Serialize)]
struct UnitRow {
    name: &'static str,
    /// Operations that were compared.
    vectors: u64,
    /// Clock cycles of all lanes, with stalls and bubbles.
    cycles: u64,
    mismatches: u64,
    vectors_per_second: f64,
    /// Cycles of the reference simulation by class of stimulus; an operation may be in several.
    classes: BTreeMap<&'static str, u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    first_mismatch: Option<String>,
}

pub fn run(args: &CheckArgs, global: &Global) -> anyhow::Result<Report> {
    if let Some(exhaustive) = &args.exhaustive {
        return exhaustive::run(exhaustive, args.state.as_deref());
    }
    let tops = args.unit.map_or_else(|| Top::ALL.to_vec(), |top| vec![top]);
    let mut document = Document { seed: global.seed, fault: None, units: Vec::new() };
    for top in tops {
        document.units.push(match args.mutate {
            Some(number) => {
                let (mutant, fault) = mutant(&top.design(StandardFormat::Binary32)?, number)?;
                document.fault = Some(fault);
                mutant_row(top, &mutant, args.vectors, global.seed)?
            }
            None => row(top, args.vectors, global.seed)?,
        });
    }
    let text = text(&document);
    let mut report = Report::new(&document, text);
    report.difference = document.units.iter().any(|unit| unit.mismatches > 0);
    Ok(report)
}

/// The design with its fault `number`, and what the fault is.
fn mutant(design: &Design, number: usize) -> anyhow::Result<(Design, String)> {
    let faults = mutations(design);
    let fault = faults.get(number).with_context(|| {
        let name = &design.top().name;
        format!("--mutate {number}: {name} has {} faults to try, counted from 0", faults.len())
    })?;
    Ok((mutate(design, fault)?, fault.to_string()))
}

/// A netlist that nothing is compiled for: the reference simulation alone.
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

fn row(top: Top, vectors: u64, seed: u64) -> anyhow::Result<UnitRow> {
    let format = StandardFormat::Binary32;
    let netlist = flatten(&top.design(format)?)?;
    let bar = progress(vectors, format!("checking {top}"));
    let reference = equivalence::check(&netlist, top, format, vectors.min(REFERENCE_CYCLES), seed);
    let start = Instant::now();
    let totals = volume(top, format, &netlist, vectors, seed, |done| bar.set_position(done))
        .with_context(|| format!("{top} is not compiled in {format}"))?;
    let seconds = start.elapsed().as_secs_f64();
    bar.finish_and_clear();
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

fn text(document: &Document) -> String {
    let rows = document.units.iter().map(|unit| {
        [
            unit.name.to_owned(),
            unit.vectors.to_string(),
            unit.classes.len().to_string(),
            unit.mismatches.to_string(),
            format!("{:.0}", unit.vectors_per_second),
        ]
    });
    let mut text = table(["unit", "vectors", "classes", "mismatches", "vectors/s"], rows);
    if let Some(fault) = &document.fault {
        let _ = write!(text, "\nfault put in: {fault}\n");
    }
    for unit in &document.units {
        let classes: Vec<String> =
            unit.classes.iter().map(|(class, count)| format!("{class} {count}")).collect();
        let _ = write!(text, "\n{}: {}\n", unit.name, classes.join(", "));
        if let Some(first) = &unit.first_mismatch {
            let _ = writeln!(text, "first mismatch with --seed {}: {first}", document.seed);
        }
    }
    text
}
