//! `cargo xtask behaviour`: does the tool still print and write what it did?

mod commands;
mod execute;
pub mod filter;
pub mod hashes;

use crate::workspace::{must_succeed, root, scratch, target};
use anyhow::{Context, ensure};
use commands::{Command, commands};
use hashes::Hashes;
use lexopt::prelude::*;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The hashes of what was found to be right, relative to the root.
const FILE: &str = "tests/xtask/behaviour.txt";

/// What the command line asks for.
#[derive(Debug)]
pub struct Options {
    tool: Option<PathBuf>,
    threads: u16,
    only: Vec<String>,
    bless: bool,
}

impl Options {
    /// Reads what follows the command's name.
    pub fn parse(mut arguments: lexopt::Parser) -> anyhow::Result<Self> {
        let mut options = Self { tool: None, threads: 2, only: vec![], bless: false };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("tool") => options.tool = Some(arguments.value()?.into()),
                Long("threads") => options.threads = arguments.value()?.parse()?,
                Long("only") => options.only.push(arguments.value()?.string()?),
                Long("bless") => options.bless = true,
                other => return Err(other.unexpected().into()),
            }
        }
        Ok(options)
    }
}

/// Runs the commands; whether all did what the file of hashes says.
pub fn run(options: &Options) -> anyhow::Result<bool> {
    let all = commands();
    let chosen = choose(&all, &options.only)?;
    let tool = tool(options.tool.as_deref())?;
    let file = root().join(FILE);
    let expected = if file.exists() { Hashes::read(&file)? } else { Hashes::default() };

    let start = Instant::now();
    let mut scratch = scratch("behaviour-run")?;
    let (mut found, mut failures) = (Hashes::default(), 0);
    for command in &chosen {
        let outcome = execute::run(&tool, command, options.threads, scratch.path())?;
        if let Some(failure) = outcome.failure {
            println!("{}: {failure}", command.name);
            failures += 1;
        }
        found.extend(outcome.hashes);
    }
    eprintln!("{:8.2} s  all {} commands", start.elapsed().as_secs_f64(), chosen.len());

    let run: Vec<&str> = chosen.iter().map(|command| command.name.as_str()).collect();
    if options.bless {
        ensure!(failures == 0, "{FILE} stays as it is: {failures} commands failed");
        let known: Vec<&str> = all.iter().map(|command| command.name.as_str()).collect();
        found.and_others_of(&expected, &run, &known).write(&file)?;
        return Ok(true);
    }
    let is_due = |command: &str| options.only.is_empty() || run.contains(&command);
    let differences = found.differences(&expected, is_due);
    for difference in &differences {
        println!("{difference}");
    }
    let good = differences.is_empty() && failures == 0;
    if !good {
        scratch.disable_cleanup(true);
        println!(
            "{} differences, {failures} failures; the files are in {}",
            differences.len(),
            scratch.path().display()
        );
    }
    Ok(good)
}

/// The commands that are asked for, and those that write what they read, in the order of the list.
fn choose<'a>(all: &'a [Command], only: &[String]) -> anyhow::Result<Vec<&'a Command>> {
    if only.is_empty() {
        return Ok(all.iter().collect());
    }
    let is_meant = |name: &str, asked: &str| {
        name.strip_prefix(asked).is_some_and(|rest| rest.is_empty() || rest.starts_with('-'))
    };
    for asked in only {
        ensure!(
            all.iter().any(|command| is_meant(&command.name, asked)),
            "--only {asked}: no such command; they are {}",
            all.iter().map(|command| command.name.as_str()).collect::<Vec<_>>().join(", ")
        );
    }
    let mut names: Vec<&str> = vec![];
    let mut chosen = vec![];
    // Backwards, as a command reads what earlier ones write.
    for command in all.iter().rev() {
        if names.contains(&command.name.as_str()) || only.iter().any(|asked| is_meant(&command.name, asked)) {
            names.extend(command.after);
            chosen.push(command);
        }
    }
    chosen.reverse();
    Ok(chosen)
}

/// The tool at `path`, or else the release tool, which is built.
fn tool(path: Option<&Path>) -> anyhow::Result<PathBuf> {
    let path = match path {
        Some(path) => path.to_owned(),
        None => {
            must_succeed("build --release --bin dualsplit", |_| {})?;
            target()?.join("release").join(format!("dualsplit{}", std::env::consts::EXE_SUFFIX))
        }
    };
    path.canonicalize().with_context(|| format!("{}: no such tool", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_what_a_command_reads_is_written_before() {
        let all = commands();
        for (i, command) in all.iter().enumerate() {
            let before: Vec<&str> = all[..i].iter().map(|command| command.name.as_str()).collect();
            assert!(!before.contains(&command.name.as_str()), "{} is there twice", command.name);
            for name in command.after {
                assert!(before.contains(name), "{} reads what {name} writes", command.name);
            }
        }
    }

    #[test]
    fn a_choice_brings_what_it_reads() {
        let all = commands();
        let names = |only: &str| -> Vec<String> {
            choose(&all, &[only.to_owned()]).unwrap().iter().map(|command| command.name.clone()).collect()
        };
        assert_eq!(names("trace-dst-fast"), ["render-path", "trace-dst-fast"]);
        assert!(names("simulate").len() > 16);
        assert!(choose(&all, &["simul".to_owned()]).is_err());
    }
}
