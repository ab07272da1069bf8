//! A check of all pairs of operands, which can be interrupted and continued.

use crate::progress::{Part, Progress};
use anyhow::{Context, bail};
use logic::check::exhaustive::{Exhaustive, Operation, Progress as State};
use pipelines::catalogue::StandardFormat;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Most bytes of a state.
const MOST_BYTES: u64 = 1 << 20;

/// Blocks between two writings of the state.
const BLOCKS_AT_ONCE: u64 = 4096;

/// The result of a check of all pairs of operands.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Pairs {
    pub name: String,
    /// Pairs of operands compared. A pair counts once for each mode of the unit.
    pub vectors: u64,
    pub mismatches: u64,
    /// The rate of this run, without what an interrupted run had compared.
    pub vectors_per_second: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first_mismatch: Option<String>,
}

/// Compares all pairs, or continues where an earlier run was interrupted.
///
/// `state` names the file that holds the progress of an interrupted run. The file is removed at the end.
///
/// # Errors
/// The unit is not compiled in this format, or the file belongs to another check or cannot be read or written.
pub fn run(
    format: StandardFormat,
    operation: Operation,
    state: Option<&Path>,
    progress: &dyn Progress,
) -> anyhow::Result<Pairs> {
    let check = Exhaustive::new(format, operation)?;
    let path =
        state.map_or_else(|| PathBuf::from(format!("check-{format}-{operation}.json")), Path::to_owned);
    let mut done = resume(&path, &check)?;
    let (before, start) = (done.vectors, Instant::now());
    let part = Part::begin(progress, check.blocks(), &format!("{format} {operation}"));
    progress.note(&format!("progress is kept in {}; the same command continues from there", path.display()));
    while done.blocks < check.blocks() {
        part.at(done.blocks);
        check.advance(&mut done, BLOCKS_AT_ONCE);
        if done.blocks < check.blocks() {
            save(&path, &done)?;
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    drop(part);
    if path.exists() {
        std::fs::remove_file(&path).with_context(|| format!("{}: cannot be removed", path.display()))?;
    }
    Ok(Pairs {
        name: format!("{format} {operation}"),
        vectors: done.vectors,
        mismatches: done.mismatches,
        vectors_per_second: (done.vectors - before) as f64 / seconds,
        first_mismatch: done.first,
    })
}

/// The state that an interrupted run left, or that of a check that begins.
fn resume(path: &Path, check: &Exhaustive) -> anyhow::Result<State> {
    let fresh = check.start();
    let text = match base::input::read_own(path, MOST_BYTES) {
        Ok(text) => text,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(fresh),
        Err(error) => return Err(error).with_context(|| format!("{}: cannot be read", path.display())),
    };
    let remedy = || {
        format!("{}: not the state of this check; remove it, or name another with --state", path.display())
    };
    let found: State = serde_json::from_str(&text).with_context(remedy)?;
    if found.format != fresh.format || found.operation != fresh.operation || found.blocks > check.blocks() {
        bail!(remedy());
    }
    Ok(found)
}

fn save(path: &Path, state: &State) -> anyhow::Result<()> {
    base::output::write_file(path, true, |out| Ok(serde_json::to_writer(out, state)?))?;
    Ok(())
}
