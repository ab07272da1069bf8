//! `dualsplit simulate`: frames and reference runs on the many-core machine.

use crate::cli::{Global, SimulateArgs};
use crate::console::{Report, fixed, progress, table};
use rayon::prelude::*;
use serde::Serialize;
use sim::machine::description::MachineDescription;
use sim::machine::reference::{ReferenceRuns, ValidatedRun};
use std::path::Path;

pub fn run(args: &SimulateArgs, _global: &Global) -> anyhow::Result<Report> {
    if let Some(folder) = &args.validate {
        return validate(folder);
    }
    let machine = MachineDescription::load(&args.machine.machine, &args.machine.settings)?;
    Ok(Report::new(&machine, machine.to_toml()))
}

#[derive(Serialize)]
struct Validation {
    runs: Vec<ValidatedRun>,
}

/// Makes the reference runs, each on one thread.
fn validate(folder: &Path) -> anyhow::Result<Report> {
    let reference = ReferenceRuns::read(folder)?;
    let bar = progress(reference.runs.len() as u64, "validating");
    let one = |run| {
        let validated = reference.validate(run);
        bar.inc(1);
        validated
    };
    let runs: Vec<ValidatedRun> = reference.runs.par_iter().map(one).collect::<Result<_, _>>()?;
    bar.finish_and_clear();
    let header = [
        "set",
        "variant",
        "TMs",
        "cycles",
        "reference",
        "error %",
        "instructions %",
        "L1 hit % (ref)",
        "L2 hit % (ref)",
        "units uJ (ref)",
        "rays/s",
        "speed ratio",
        "within",
    ];
    let rows = runs.iter().map(|run| {
        let pair = |c: sim::machine::reference::Compared| format!("{:.2} ({:.2})", c.ours, c.reference);
        [
            run.set.clone(),
            run.variant.clone(),
            run.tms.to_string(),
            run.cycles.to_string(),
            run.reference_cycles.to_string(),
            fixed(run.error_pct, 2),
            fixed(run.instructions_error_pct, 2),
            pair(run.l1_hit_pct),
            pair(run.l2_hit_pct),
            pair(run.units_uj),
            fixed(run.rays_per_second, 0),
            fixed(run.speed_ratio, 0),
            if run.within { "yes" } else { "NO" }.to_owned(),
        ]
    });
    let text = table(header, rows);
    let difference = runs.iter().any(|run| !run.within);
    let mut report = Report::new(&Validation { runs }, text);
    report.difference = difference;
    Ok(report)
}
