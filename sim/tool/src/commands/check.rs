//! `dualsplit check`: the comparison of the hardware's netlists with the specification.

use crate::cli::{CheckArgs, Global};
use crate::console::{Bars, Report, table};
use anyhow::bail;
use serde::Serialize;
use std::fmt::Write;
use studies::check::exhaustive::{self, Pairs};
use studies::check::{self, Checks, Options};

pub fn run(args: &CheckArgs, global: &Global) -> anyhow::Result<Report> {
    if let Some(words) = &args.exhaustive {
        global.without_seed("a check of all pairs")?;
        return pairs(words, args, global);
    }
    let options = Options { unit: args.unit, vectors: args.vectors, fault: args.mutate, seed: global.seed() };
    let checks = check::run(&options, &Bars::new(global.quiet))?;
    let mut report = Report::new(&checks, text(&checks), vec![]);
    report.difference = checks.units.iter().any(|unit| unit.mismatches > 0);
    Ok(report)
}

fn text(checks: &Checks) -> String {
    let rows = checks.units.iter().map(|unit| {
        [
            unit.name.to_owned(),
            unit.vectors.to_string(),
            unit.classes.len().to_string(),
            unit.mismatches.to_string(),
            format!("{:.0}", unit.vectors_per_second),
        ]
    });
    let mut text = table(["unit", "vectors", "classes", "mismatches", "vectors/s"], rows);
    if let Some(fault) = &checks.fault {
        let _ = write!(text, "\nfault put in: {fault}\n");
    }
    for unit in &checks.units {
        let classes: Vec<String> =
            unit.classes.iter().map(|(class, count)| format!("{class} {count}")).collect();
        let _ = write!(text, "\n{}: {}\n", unit.name, classes.join(", "));
        if let Some(first) = &unit.first_mismatch {
            let _ = writeln!(text, "first mismatch with --seed {}: {first}", checks.seed);
        }
    }
    text
}

#[derive(Serialize)]
struct Document {
    units: [Pairs; 1],
}

/// The check of all pairs of operands of a format.
fn pairs(words: &[String], args: &CheckArgs, global: &Global) -> anyhow::Result<Report> {
    let [format, operation] = words else { bail!("--exhaustive takes a format and an operation") };
    let operation = operation.parse().map_err(anyhow::Error::msg)?;
    let pairs = exhaustive::run(format.parse()?, operation, args.state.as_deref(), &Bars::new(global.quiet))?;
    let mut text = table(
        ["check", "vectors", "mismatches", "vectors/s"],
        [[
            pairs.name.clone(),
            pairs.vectors.to_string(),
            pairs.mismatches.to_string(),
            format!("{:.0}", pairs.vectors_per_second),
        ]],
    );
    if let Some(first) = &pairs.first_mismatch {
        text += &format!("first mismatch: {first}\n");
    }
    let difference = pairs.mismatches > 0;
    let mut report = Report::new(&Document { units: [pairs] }, text, vec![]);
    report.difference = difference;
    Ok(report)
}
