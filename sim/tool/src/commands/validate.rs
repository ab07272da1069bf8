//! `dualsplit simulate --validate`: the comparison of the many-core machine with the reference runs.

use crate::cli::Global;
use crate::console::{Bars, Report, fixed, table};
use machine::reference::Compared;
use std::path::Path;
use studies::simulate;

pub fn run(folder: &Path, rows: &[String], global: &Global) -> anyhow::Result<Report> {
    let validation = simulate::validate(folder, rows, &Bars::new(global.quiet))?;
    let header = [
        "set",
        "settings",
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
    let rows = validation.runs.iter().map(|run| {
        let pair = |c: Compared| format!("{:.2} ({:.2})", c.ours, c.reference);
        [
            run.set.clone(),
            run.settings.join(" "),
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
    let mut text = table(header, rows);
    for absent in &validation.absent {
        let row = format!("{}/{}/{}", absent.set, absent.variant, absent.tms);
        text += &format!("absent: {row}: {}\n", absent.reason);
    }
    let difference = validation.runs.iter().any(|run| !run.within);
    let mut report = Report::new(&validation, text, vec![]);
    report.difference = difference;
    Ok(report)
}
