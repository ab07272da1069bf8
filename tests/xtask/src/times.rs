//! `cargo xtask times`: what builds, tests and the tool's start take.

use crate::quick;
use crate::usage::{Usage, measure};
use crate::workspace::{LONG_TESTS, NO_TOOL_MISSING, must_succeed, root, scratch};
use anyhow::{Context, bail, ensure};
use lexopt::prelude::*;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant, SystemTime};

/// The files that are touched: step, what the file is a part of, and path.
const TOUCHED: [(&str, &str, &str); 3] = [
    ("touch-command", "a command", "sim/tool/src/commands/needs.rs"),
    ("touch-chart", "a chart", "sim/studies/src/charts/precision.rs"),
    ("touch-machine", "the machine", "sim/machine/src/core/tm.rs"),
];

/// All steps, in the order of the table.
const STEPS: [&str; 7] = ["build", TOUCHED[0].0, TOUCHED[1].0, TOUCHED[2].0, "test", "quick", "run"];

const BUILD: &str = "build --release";

/// A row of the table.
struct Row {
    step: String,
    processor: Option<Duration>,
    wall: Duration,
}

impl Row {
    fn new(step: impl Into<String>, usage: Usage) -> Self {
        Self { step: step.into(), processor: Some(usage.processor), wall: usage.wall }
    }
}

/// The steps that the command line asks for.
pub fn parse(mut arguments: lexopt::Parser) -> anyhow::Result<Vec<String>> {
    let mut only = vec![];
    while let Some(argument) = arguments.next()? {
        match argument {
            Long("only") => only.push(arguments.value()?.string()?),
            other => return Err(other.unexpected().into()),
        }
    }
    for step in &only {
        ensure!(STEPS.contains(&step.as_str()), "--only {step}: the steps are {}", STEPS.join(", "));
    }
    Ok(only)
}

/// Measures the steps `only`, or all, and prints the table.
pub fn run(only: &[String]) -> anyhow::Result<bool> {
    // Before hours of work.
    for (_, _, path) in TOUCHED {
        ensure!(
            root().join(path).is_file(),
            "{path}: no such file; correct the paths in tests/xtask/src/times.rs"
        );
    }
    let mut builds = Builds { folder: scratch("times-build")?, built: None };
    let mut rows = vec![];
    for step in STEPS.iter().filter(|step| only.is_empty() || only.iter().any(|only| only == *step)) {
        eprintln!("times: {step}");
        rows.extend(measured(step, &mut builds)?);
    }
    println!("| step | processor time, s | wall time, s |\n|---|---|---|");
    for row in &rows {
        let processor = row.processor.map(|time| format!("{:.1}", time.as_secs_f64())).unwrap_or_default();
        println!("| {} | {processor} | {:.1} |", row.step, row.wall.as_secs_f64());
    }
    Ok(true)
}

fn measured(step: &str, builds: &mut Builds) -> anyhow::Result<Vec<Row>> {
    if let Some((_, part, path)) = TOUCHED.iter().find(|(name, ..)| *name == step) {
        builds.first()?;
        let row = format!("`cargo {BUILD}` after a change of {part} (`{path}`)");
        return Ok(vec![Row::new(row, builds.after_touching(path)?)]);
    }
    Ok(match step {
        "build" => vec![Row::new(format!("`cargo {BUILD}`, from nothing"), builds.first()?)],
        "test" => vec![Row::new("`cargo test --workspace`, from nothing", test()?)],
        "quick" => vec![Row::new("`cargo xtask quick`, again", quick_again()?)],
        "run" => {
            builds.first()?;
            let [first, end] = start_and_end(&builds.tool())?;
            vec![first, end]
        }
        other => bail!("{other}: no such step"),
    })
}

/// Release builds in a folder of their own.
struct Builds {
    folder: tempfile::TempDir,
    /// What the first one took.
    built: Option<Usage>,
}

impl Builds {
    fn build(&self) -> anyhow::Result<Usage> {
        let target = self.folder.path();
        let build = || {
            must_succeed(BUILD, |command| {
                command.env("CARGO_TARGET_DIR", target);
            })
        };
        Ok(measure(build)?.1)
    }

    /// What the build from an empty folder took, which is made once.
    fn first(&mut self) -> anyhow::Result<Usage> {
        let usage = self.built.map_or_else(|| self.build(), Ok)?;
        self.built = Some(usage);
        Ok(usage)
    }

    /// What a build takes after the file at `path` was touched; the file's time is then as before.
    fn after_touching(&self, path: &str) -> anyhow::Result<Usage> {
        let file = File::options().append(true).open(root().join(path)).with_context(|| path.to_owned())?;
        let before = file.metadata()?.modified()?;
        file.set_modified(SystemTime::now())?;
        let usage = self.build();
        file.set_modified(before)?;
        usage
    }

    fn tool(&self) -> PathBuf {
        self.folder.path().join("release").join(format!("dualsplit{}", std::env::consts::EXE_SUFFIX))
    }
}

/// The tests that run without the long ones, from an empty folder.
fn test() -> anyhow::Result<Usage> {
    let folder = scratch("times-test")?;
    let test = || {
        must_succeed("test --workspace", |command| {
            command.env("CARGO_TARGET_DIR", folder.path()).env_remove(LONG_TESTS).env_remove(NO_TOOL_MISSING);
        })
    };
    Ok(measure(test)?.1)
}

/// `quick` when all is built.
fn quick_again() -> anyhow::Result<Usage> {
    ensure!(quick::run()?, "quick: failed");
    let (good, usage) = measure(quick::run)?;
    ensure!(good, "quick: failed the second time");
    Ok(usage)
}

/// The time until `tool` without arguments prints its first line, and the time until it ends.
fn start_and_end(tool: &Path) -> anyhow::Result<[Row; 2]> {
    let folder = scratch("times-run")?;
    let run = || {
        let start = Instant::now();
        let mut child = Command::new(tool)
            .current_dir(folder.path())
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .with_context(|| format!("{}: does not start", tool.display()))?;
        let (sender, receiver) = mpsc::channel();
        let readers = [
            read(child.stdout.take().context("stdout is a pipe")?, sender.clone()),
            read(child.stderr.take().context("stderr is a pipe")?, sender),
        ];
        let first = receiver.recv().context("the tool prints nothing")?.duration_since(start);
        let status = child.wait()?;
        for reader in readers {
            let _ = reader.join();
        }
        ensure!(status.success(), "{}: {status}", tool.display());
        Ok(first)
    };
    let (first, usage) = measure(run)?;
    Ok([
        Row { step: "`dualsplit`, until its first line".to_owned(), processor: None, wall: first },
        Row::new("`dualsplit`, until its end", usage),
    ])
}

/// Reads all of `stream`, and sends when its first line was there.
fn read(stream: impl Read + Send + 'static, sender: mpsc::Sender<Instant>) -> thread::JoinHandle<()> {
    thread::spawn(move || {
        let mut lines = BufReader::new(stream);
        let mut line = vec![];
        while matches!(lines.read_until(b'\n', &mut line), Ok(bytes) if bytes > 0) {
            let _ = sender.send(Instant::now());
            line.clear();
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_files_that_are_touched_exist() {
        for (_, _, path) in TOUCHED {
            assert!(root().join(path).is_file(), "{path}");
        }
    }
}
