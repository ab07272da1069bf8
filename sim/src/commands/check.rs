//! `dualsplit check`: the netlists of the hardware against the specification.

use crate::cli::{CheckArgs, Global};
use crate::console::{Report, progress, table};
use anyhow::Context;
use hdl::catalogue::{StandardFormat, Top};
use hdl::equivalence::{Model, Outcome, Stimulus, compare};
use hdl::netlist::{Design, flatten, mutate, mutations};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::time::Instant;

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
    /// Clock cycles, with stalls and bubbles.
    cycles: u64,
    mismatches: u64,
    vectors_per_second: f64,
    /// Cycles by class of stimulus; an operation may be in several.
    classes: BTreeMap<&'static str, u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    first_mismatch: Option<String>,
}

pub fn run(args: &CheckArgs, global: &Global) -> anyhow::Result<Report> {
    let tops = args.unit.map_or_else(|| Top::ALL.to_vec(), |top| vec![top]);
    let mut document = Document { seed: global.seed, fault: None, units: Vec::new() };
    for top in tops {
        let mut design = top.design(StandardFormat::Binary32)?;
        if let Some(number) = args.mutate {
            let (mutant, fault) = mutant(&design, number)?;
            design = mutant;
            document.fault = Some(fault);
        }
        document.units.push(row(top, &design, args.vectors, global.seed)?);
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

fn row(top: Top, design: &Design, cycles: u64, seed: u64) -> anyhow::Result<UnitRow> {
    let format = StandardFormat::Binary32;
    let netlist = flatten(design)?;
    let bar = progress(cycles, format!("checking {top}"));
    let stimulus = Stimulus::new(top, format, &netlist, seed);
    let start = Instant::now();
    let stream = (0..cycles).zip(stimulus).map(|(_, inputs)| inputs);
    let Outcome { cycles, vectors, classes, mismatches, first } =
        compare(&netlist, Model::new(top, format, &netlist), stream, |_, _| bar.inc(1));
    let seconds = start.elapsed().as_secs_f64();
    bar.finish_and_clear();
    Ok(UnitRow {
        name: top.name(),
        vectors,
        cycles,
        mismatches,
        vectors_per_second: vectors as f64 / seconds,
        classes,
        first_mismatch: first.map(|first| first.to_string()),
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
