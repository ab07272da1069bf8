//! `dualsplit check --prove`: proofs that the hardware equals its references for all inputs and states.

use crate::cli::{CheckArgs, Global};
use crate::console::{Bars, Report, fixed, table};
use studies::prove::{self, Proofs};

pub fn run(args: &CheckArgs, global: &Global) -> anyhow::Result<Report> {
    global.without_seed("a proof")?;
    let proofs = prove::run(args.unit, &Bars::new(global.quiet))?;
    let mut report = Report::new(&proofs, text(&proofs), vec![]);
    report.difference = proofs.proofs.iter().any(|row| row.verdict != "equal");
    Ok(report)
}

fn text(proofs: &Proofs) -> String {
    let text = table(
        ["unit", "format", "equal to", "verdict", "cases", "gates", "conflicts", "seconds"],
        proofs.proofs.iter().map(|row| {
            [
                row.unit.to_owned(),
                row.format.to_owned(),
                row.reference.to_owned(),
                row.verdict.to_owned(),
                row.cases.to_string(),
                row.gates.to_string(),
                row.conflicts.to_string(),
                fixed(row.seconds, 2),
            ]
        }),
    );
    let note = proofs.skipped.as_ref().map_or_else(String::new, |reason| format!("\nskipped: {reason}\n"));
    text + &note
}
