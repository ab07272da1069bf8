//! `dualsplit check --exhaustive`: all pairs of operands, to be interrupted and continued.

use crate::console::{Report, progress, table};
use anyhow::{Context, bail};
use logic::check::exhaustive::{Exhaustive, Operation, Progress};
use pipelines::catalogue::StandardFormat;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Blocks between two writings of the state.
const BLOCKS_AT_ONCE: u64 = 4096;

#[derive(Serialize)]
struct Document {
    units: [Row; 1],
}

#[derive(Serialize)]
struct Row {
    name: String,
    /// Pairs of operands compared, each mode of the unit counted.
    vectors: u64,
    mismatches: u64,
    /// Of this run.
    vectors_per_second: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    first_mismatch: Option<String>,
}

pub fn run(arguments: &[String], state: Option<&Path>) -> anyhow::Result<Report> {
    let [format, operation] = arguments else { bail!("--exhaustive takes a format and an operation") };
    let format: StandardFormat = format.parse()?;
    let operation: Operation = operation.parse().map_err(anyhow::Error::msg)?;
    let check = Exhaustive::new(format, operation)?;
    let path =
        state.map_or_else(|| PathBuf::from(format!("check-{format}-{operation}.json")), Path::to_owned);
    let mut done = resume(&path, &check)?;
    let (before, start) = (done.vectors, Instant::now());
    let bar = progress(check.blocks(), format!("{format} {operation}"));
    bar.println(format!("progress is kept in {}; the same command continues from there", path.display()));
    while done.blocks < check.blocks() {
        bar.set_position(done.blocks);
        check.advance(&mut done, BLOCKS_AT_ONCE);
        if done.blocks < check.blocks() {
            save(&path, &done)?;
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    bar.finish_and_clear();
    if path.exists() {
        std::fs::remove_file(&path).with_context(|| format!("{}: cannot be removed", path.display()))?;
    }
    let row = Row {
        name: format!("{format} {operation}"),
        vectors: done.vectors,
        mismatches: done.mismatches,
        vectors_per_second: (done.vectors - before) as f64 / seconds,
        first_mismatch: done.first,
    };
    let mut text = table(
        ["check", "vectors", "mismatches", "vectors/s"],
        [[
            row.name.clone(),
            row.vectors.to_string(),
            row.mismatches.to_string(),
            format!("{:.0}", row.vectors_per_second),
        ]],
    );
    if let Some(first) = &row.first_mismatch {
        text += &format!("first mismatch: {first}\n");
    }
    let difference = row.mismatches > 0;
    let mut report = Report::new(&Document { units: [row] }, text);
    report.difference = difference;
    Ok(report)
}

/// What an interrupted run has left, or nothing done yet.
fn resume(path: &Path, check: &Exhaustive) -> anyhow::Result<Progress> {
    let fresh = check.start();
    let text = match std::fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(fresh),
        Err(error) => return Err(error).with_context(|| format!("{}: cannot be read", path.display())),
    };
    let remedy = || {
        format!("{}: not the state of this check; remove it, or name another with --state", path.display())
    };
    let found: Progress = serde_json::from_str(&text).with_context(remedy)?;
    if found.format != fresh.format || found.operation != fresh.operation || found.blocks > check.blocks() {
        bail!(remedy());
    }
    Ok(found)
}

fn save(path: &Path, progress: &Progress) -> anyhow::Result<()> {
    base::output::write_file(path, true, |out| Ok(serde_json::to_writer(out, progress)?))?;
    Ok(())
}
