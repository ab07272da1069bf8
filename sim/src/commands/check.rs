//! `dualsplit check`: the netlists of the hardware against the specification.

use crate::cli::{CheckArgs, Global};
use crate::console::{Report, progress, table};
use hdl::catalogue::{StandardFormat, Top};
use hdl::equivalence::{Model, Outcome, Stimulus, compare};
use hdl::netlist::flatten;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::time::Instant;

#[derive(Serialize)]
struct Document {
    seed: u64,
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
    let units = tops.into_iter().map(|top| row(top, args.vectors, global.seed));
    let document = Document { seed: global.seed, units: units.collect::<anyhow::Result<_>>()? };
    let text = text(&document);
    let mut report = Report::new(&document, text);
    report.difference = document.units.iter().any(|unit| unit.mismatches > 0);
    Ok(report)
}

fn row(top: Top, cycles: u64, seed: u64) -> anyhow::Result<UnitRow> {
    let format = StandardFormat::Binary32;
    let netlist = flatten(&top.design(format)?)?;
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
