//! Proofs that the hardware equals its references for all inputs and states.

use crate::progress::{Part, Progress};
use anyhow::{Context, bail};
use base::output::Unfinished;
use gates::prove::{Limits, Proof, Verdict, verilog};
use pipelines::catalogue::{StandardFormat, Top};
use proofs::{Sums, Theorem};
use serde::Serialize;
use std::path::Path;
use std::time::Instant;

/// The results of all proofs.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Proofs {
    pub proofs: Vec<ProofRow>,
    /// Why some proofs are missing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub skipped: Option<String>,
}

/// The result of one proof.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct ProofRow {
    pub unit: &'static str,
    pub format: &'static str,
    /// The circuit that the unit is compared with.
    pub reference: &'static str,
    /// `equal`, `differs` or `unknown`.
    pub verdict: &'static str,
    pub cases: usize,
    /// Gates of both circuits, in all cases.
    pub gates: usize,
    pub conflicts: u64,
    pub seconds: f64,
}

/// The units and formats that have references.
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

/// Proves all theorems about `unit`, or about all units.
///
/// # Errors
/// A unit cannot be elaborated, or its exported Verilog cannot be read.
pub fn run(unit: Option<Top>, progress: &dyn Progress) -> anyhow::Result<Proofs> {
    let wanted = |top: Top| unit.is_none_or(|unit| unit == top);
    let mut proofs = Vec::new();
    for (top, format) in theorems().into_iter().filter(|(top, _)| wanted(*top)) {
        let start = Instant::now();
        let theorem = Theorem::of(top, format, |_| ())?;
        let part = Part::begin(progress, theorem.cases.len() as u64, &format!("proving {top} {format}"));
        let proof = theorem.prove(Limits::default(), || part.advance(1));
        drop(part);
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
        let part = Part::begin(progress, sums.cases.len() as u64, &format!("proving fp_add {format}"));
        let proof = sums.prove(Limits::default(), || part.advance(1));
        drop(part);
        let reference = "exact integers, by distance of exponents";
        proofs.push(row(Top::FpAdd, format, reference, sums.cases.len(), &proof, start));
    }
    let mut skipped = None;
    for &top in Top::ALL.iter().filter(|top| wanted(**top)) {
        match exported(top, progress) {
            Ok(row) => proofs.push(row),
            Err(Exported::Missing(reason)) => {
                skipped = Some(reason);
                break;
            }
            Err(Exported::Failed(error)) => return Err(error),
        }
    }
    if proofs.is_empty() {
        bail!("--prove: nothing was proved: {}", skipped.as_deref().unwrap_or("there is no theorem"));
    }
    Ok(Proofs { proofs, skipped })
}

enum Exported {
    /// The elaborator is not installed.
    Missing(String),
    Failed(anyhow::Error),
}

/// The proof that the exported Verilog of a top, read by another elaborator, equals our gates.
fn exported(top: Top, progress: &dyn Progress) -> Result<ProofRow, Exported> {
    let failed = |error: anyhow::Error| Exported::Failed(error);
    let format = StandardFormat::Binary32;
    let start = Instant::now();
    let folder = tempfile::tempdir().context("a temporary folder cannot be made").map_err(failed)?;
    let _unfinished = Unfinished::new(folder.path());
    let part = Part::endless(progress, &format!("reading the Verilog of {top}"));
    let result = compare(top, format, folder.path());
    drop(part);
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
) -> ProofRow {
    let verdict = match proof.verdict {
        Verdict::Equal => "equal",
        Verdict::Differs { .. } => "differs",
        Verdict::Unknown { .. } => "unknown",
    };
    ProofRow {
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
