//! `dualsplit rerun`: results made again, by the command that is recorded beside them.

use crate::cli::{COMMIT, Cli, Command, Global, RerunArgs};
use crate::console::{self, Bars, Report};
use anyhow::{Context, bail, ensure};
use base::input::read_own;
use clap::Parser;
use serde::{Deserialize, Serialize};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use studies::artifacts;
use studies::input::display;
use studies::progress::Progress;

/// The file in a folder of results that says how they were made.
const FILE: &str = "rerun.json";

/// Most bytes of that file.
const MOST_BYTES: u64 = 1 << 20;

/// How results were made.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Made {
    version: String,
    /// Of the program's sources; empty if it was not known.
    commit: String,
    /// The folder, as the command named it.
    folder: String,
    /// Words of the command line but the options that no result depends on.
    arguments: Vec<String>,
}

/// Writes into the folder of `report`, if it has one, that the command of `words` made it. Words that are not Unicode have no form
/// in the file, which then is not written.
pub fn record(report: &mut Report, words: &[OsString]) -> anyhow::Result<()> {
    let Some(folder) = report.folder.clone() else { return Ok(()) };
    let arguments = console::kept(words.iter().cloned()).into_iter().map(OsString::into_string);
    let (Ok(arguments), Some(named)) = (arguments.collect::<Result<Vec<String>, _>>(), folder.to_str())
    else {
        return Ok(());
    };
    let (version, commit) = (env!("CARGO_PKG_VERSION").to_owned(), COMMIT.to_owned());
    let made = Made { version, commit, folder: named.to_owned(), arguments };
    let text = format!("{}\n", serde_json::to_string_pretty(&made)?);
    report.add_artifact(display(&artifacts::add(&folder, FILE, text.as_bytes())?));
    Ok(())
}

/// Makes the results of a folder again; `dispatch` runs the command.
pub fn run(
    args: &RerunArgs,
    global: &Global,
    dispatch: fn(&Command, &Global) -> anyhow::Result<Report>,
) -> anyhow::Result<Report> {
    ensure!(global.seed.is_none(), "--seed: results are made again with their own seed; leave it away");
    let file = if args.folder.is_dir() { args.folder.join(FILE) } else { args.folder.clone() };
    let text = read_own(&file, MOST_BYTES).with_context(|| {
        format!("{}: cannot read how the results were made; name their folder", file.display())
    })?;
    let made: Made = serde_json::from_str(&text).with_context(|| {
        format!("{}: this is not how results were made; name their folder", file.display())
    })?;
    let line = made.arguments.join(" ");
    let cli =
        Cli::try_parse_from(std::iter::once("dualsplit").chain(made.arguments.iter().map(String::as_str)))
            .map_err(|error| {
                let first = error.to_string().lines().next().unwrap_or_default().to_owned();
                anyhow::anyhow!("{}: this version does not take `dualsplit {line}` ({first})", file.display())
            })?;
    let folder = file.canonicalize()?.parent().context("a file lies in a folder")?.to_owned();
    let Some(base) = base(&folder, Path::new(&made.folder)) else {
        bail!(
            "{}: the results were written as {}; give the folder that name, or run `dualsplit {line}`",
            folder.display(),
            made.folder
        );
    };
    std::env::set_current_dir(&base).with_context(|| display(&base))?;
    let bars = Bars::new(global.quiet);
    bars.note(&format!("in {}: dualsplit {line}", base.display()));
    if made.commit != COMMIT || made.version != env!("CARGO_PKG_VERSION") {
        bars.note("the results were made by a program of another version, and may differ");
    }
    let words = made.arguments.iter().map(OsString::from).collect();
    let own = Global { seed: cli.global.seed, words, ..global.clone() };
    let command = cli.command.unwrap_or_else(|| Command::Reproduce(crate::cli::ReproduceArgs::default()));
    let mut report = dispatch(&command, &own)?;
    report.command = Some(line);
    Ok(report)
}

/// The folder from which `named` leads to `folder`: this one, or one above `folder`.
fn base(folder: &Path, named: &Path) -> Option<PathBuf> {
    let here = std::env::current_dir().ok();
    let above = folder.ancestors().skip(1).map(Path::to_owned);
    let leads = |base: &PathBuf| base.join(named).canonicalize().is_ok_and(|found| found == folder);
    here.into_iter().chain(above).find(leads)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_found_from_above() {
        let parent = tempfile::tempdir().unwrap();
        let root = parent.path().canonicalize().unwrap();
        let folder = root.join("a/b");
        std::fs::create_dir_all(&folder).unwrap();
        assert_eq!(base(&folder, Path::new("a/b")), Some(root.clone()));
        assert_eq!(base(&folder, Path::new("./b")), Some(root.join("a")));
        assert_eq!(base(&folder, &folder), std::env::current_dir().ok(), "from anywhere");
        assert_eq!(base(&folder, Path::new("a/c")), None);
    }
}
