//! `dualsplit check --prove`: what holds for all inputs and states, by proof.

use crate::cli::{CheckArgs, Global};
use crate::console::{Report, fixed, progress, spinner, table};
use anyhow::Context;
use gates::prove::{Limits, Proof, Verdict, verilog};
use pipelines::catalogue::{StandardFormat, Top};
use proofs::{Sums, Theorem};
use serde::Serialize;
use std::path::Path;
use std::time::Instant;

#[derive(Serialize)]
struct Document {
    proofs: Vec<Row>,
    /// Why some are missing.
    #[serde(skip_serializing_if = "Option::is_none")]
    skipped: Option<String>,
}

#[derive(Serialize)]
struct Row {
    unit: &'static str,
    format: &'static str,
    /// What the unit is proved equal to.
    reference: &'static str,
    /// `equal`, `differs` or `unknown`.
    verdict: &'static str,
    cases: usize,
    /// Gates of both circuits, in all cases.
    gates: usize,
    conflicts: u64,
    seconds: f64,
}

/// What there are references for.
fn theorems() -> Vec<(Top, StandardFormat)> {
    let mut list = Vec::new();
    for top in [Top::DualSplit, Top::DualSplitLean, Top::RayBox, Top::RayBoxLean] {
        list.push((top, StandardFormat::Binary32));
    }
    for &format in StandardFormat::ALL {
        list.extend([(Top::FpMinMax, format), (Top::FpCmp, format)]);
    }
    for format in [StandardFormat::E4m3, StandardFormat::E5m2] {
        list.extend([(Top::FpAdd, format), (Top::FpMul, format)]);
    }
    list
}

pub fn run(args: &CheckArgs, _: &Global) -> anyhow::Result<Report> {
    let wanted = |top: Top| args.unit.is_none_or(|unit| unit == top);
    let mut proofs = Vec::new();
    for (top, format) in theorems().into_iter().filter(|(top, _)| wanted(*top)) {
        let start = Instant::now();
        let theorem = Theorem::of(top, format, |_| ())?;
        let bar = progress(theorem.cases.len() as u64, format!("proving {top} {format}"));
        let proof = theorem.prove(Limits::default(), || bar.inc(1));
        bar.finish_and_clear();
        let reference = match top {
            Top::FpAdd | Top::FpMul => "exact integers, rounded once",
            Top::FpMinMax | Top::FpCmp => "order of ranks",
            _ => "control by node type, adders and multipliers free",
        };
        proofs.push(row(top, format, reference, theorem.cases.len().max(1), &proof, start));
    }
    for &format in StandardFormat::ALL.iter().filter(|_| wanted(Top::FpAdd)) {
        let start = Instant::now();
        let sums = Sums::new(format, |_| ())?;
        let bar = progress(sums.cases.len() as u64, format!("proving fp_add {format}"));
        let proof = sums.prove(Limits::default(), || bar.inc(1));
        bar.finish_and_clear();
        let reference = "exact integers, by distance of exponents";
        proofs.push(row(Top::FpAdd, format, reference, sums.cases.len(), &proof, start));
    }
    let mut skipped = None;
    for &top in Top::ALL.iter().filter(|top| wanted(**top)) {
        match exported(top) {
            Ok(row) => proofs.push(row),
            Err(Exported::Missing(reason)) => {
                skipped = Some(reason);
                break;
            }
            Err(Exported::Failed(error)) => return Err(error),
        }
    }
    let text = table(
        ["unit", "format", "equal to", "verdict", "cases", "gates", "conflicts", "seconds"],
        proofs.iter().map(|row| {
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
    let difference = proofs.iter().any(|row| row.verdict != "equal");
    let document = Document { proofs, skipped };
    let note = document.skipped.as_ref().map_or_else(String::new, |reason| format!("\nskipped: {reason}\n"));
    let mut report = Report::new(&document, text + &note);
    report.difference = difference;
    Ok(report)
}

enum Exported {
    /// The tool is not there.
    Missing(String),
    Failed(anyhow::Error),
}

/// The exported Verilog of a top, as another elaborator reads it, against our gates.
fn exported(top: Top) -> Result<Row, Exported> {
    let failed = |error: anyhow::Error| Exported::Failed(error);
    let format = StandardFormat::Binary32;
    let start = Instant::now();
    let folder = std::env::temp_dir().join(format!("dualsplit-proof-{}-{top}", std::process::id()));
    std::fs::create_dir_all(&folder)
        .with_context(|| format!("{}: cannot make the folder", folder.display()))
        .map_err(failed)?;
    let wheel = spinner(format!("reading the Verilog of {top}"));
    let result = compare(top, format, &folder);
    wheel.finish_and_clear();
    // What is left there is of no use to anybody.
    let _ = std::fs::remove_dir_all(&folder);
    let proof = result?;
    Ok(row(top, format, "exported Verilog read by yosys, arrays free", 1, &proof, start))
}

fn compare(top: Top, format: StandardFormat, folder: &Path) -> Result<Proof, Exported> {
    let design = top.design(format).map_err(|error| Exported::Failed(error.into()))?;
    match verilog::exported(&design, folder) {
        Ok(miter) => Ok(miter.prove(Limits::default())),
        Err(error @ verilog::VerilogError::Missing(_)) => Err(Exported::Missing(error.to_string())),
        Err(error) => Err(Exported::Failed(error.into())),
    }
}

fn row(
    top: Top,
    format: StandardFormat,
    reference: &'static str,
    cases: usize,
    proof: &Proof,
    start: Instant,
) -> Row {
    let verdict = match proof.verdict {
        Verdict::Equal => "equal",
        Verdict::Differs { .. } => "differs",
        Verdict::Unknown { .. } => "unknown",
    };
    Row {
        unit: top.name(),
        format: format.name(),
        reference,
        verdict,
        cases,
        gates: proof.nodes,
        conflicts: proof.conflicts,
        seconds: start.elapsed().as_secs_f64(),
    }
}
