//! Runs one command of the list, and takes what it prints and writes.

use super::commands::Command;
use super::filter;
use super::hashes::Entry;
use anyhow::Context;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process;
use std::time::{Instant, SystemTime};

/// Lines of stderr that are shown of a command that failed.
const LINES_SHOWN: usize = 5;

/// What a command did.
pub struct Outcome {
    /// Of what it printed and of each file that it wrote.
    pub hashes: Vec<Entry>,
    /// Why it counts as failed.
    pub failure: Option<String>,
}

/// Runs `command` in `folder`.
pub fn run(tool: &Path, command: &Command, threads: u16, folder: &Path) -> anyhow::Result<Outcome> {
    for (name, content) in command.reads {
        let path = folder.join(name);
        fs::write(&path, content).with_context(|| path.display().to_string())?;
    }
    let before = files(folder)?;
    let start = Instant::now();
    let mut process = process::Command::new(tool);
    process.args(command.line.split_whitespace()).args(["--threads", &threads.to_string()]);
    if command.json {
        process.arg("--json");
    }
    let output = process
        .current_dir(folder)
        .stdin(process::Stdio::null())
        .output()
        .with_context(|| format!("{}: does not start", tool.display()))?;
    eprintln!("{:8.2} s  {}", start.elapsed().as_secs_f64(), command.name);

    let printed = if command.json { filter::filtered("stdout.json", output.stdout) } else { output.stdout };
    let mut hashes = vec![Entry::new(&command.name, "stdout", &printed)];
    for (name, stamp) in files(folder)? {
        if before.get(&name) != Some(&stamp) && !command.drops.iter().any(|part| name.contains(part)) {
            let path = folder.join(&name);
            let bytes = fs::read(&path).with_context(|| path.display().to_string())?;
            hashes.push(Entry::new(&command.name, &name, &filter::filtered(&name, bytes)));
        }
    }
    let failure = (output.status.code() != Some(command.code)).then(|| {
        let stderr = String::from_utf8_lossy(&output.stderr);
        let lines: Vec<&str> = stderr.lines().collect();
        let last = lines[lines.len().saturating_sub(LINES_SHOWN)..].join("\n");
        format!("{} in the place of exit code {}\n{last}", output.status, command.code)
    });
    Ok(Outcome { hashes, failure })
}

/// What tells whether a file was written: time and length.
type Stamp = (SystemTime, u64);

/// The files below `folder`, by their paths relative to it with `/`.
fn files(folder: &Path) -> anyhow::Result<BTreeMap<String, Stamp>> {
    let mut found = BTreeMap::new();
    let mut open = vec![String::new()];
    while let Some(prefix) = open.pop() {
        let path = folder.join(&prefix);
        for entry in fs::read_dir(&path).with_context(|| path.display().to_string())? {
            let entry = entry?;
            let name = format!("{prefix}{}", entry.file_name().to_string_lossy());
            let metadata = entry.metadata()?;
            if metadata.is_dir() {
                open.push(name + "/");
            } else {
                found.insert(name, (metadata.modified()?, metadata.len()));
            }
        }
    }
    Ok(found)
}
