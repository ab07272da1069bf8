//! `cargo xtask COMMAND`: tasks for those who change this workspace.
//!
//! The crate has few dependencies, so that a cold build of it takes seconds.

mod behaviour;
mod docs;
mod kernels;
mod quick;
mod times;
mod usage;
mod workspace;

use lexopt::prelude::*;
use std::process::ExitCode;

const HELP: &str = "\
Tasks for those who change this workspace.

cargo xtask behaviour [--tool PATH] [--threads N] [--only NAME]... [--bless]
    Runs a fixed list of commands of the tool and compares the hashes of all that they print and write with
    tests/xtask/behaviour.txt. Exit code 1 if anything differs.
    --tool PATH     this tool [default: builds the release tool]
    --threads N     threads of the tool, which its results do not depend on [default: 2]
    --only NAME     only this command of the list, or those whose names begin with NAME-; may be repeated
    --bless         rewrites the hashes instead

cargo xtask docs [--check] [--tool PATH] [--only FILE]...
    Makes the tables and figures of README.md and docs/ that commands print, runs the commands of the guide, and repeats the small
    runs whose digests stand beside long tables.
    --check         compares them with those that are there; exit code 1 if one differs
    --tool PATH     this tool [default: builds that of the tests]
    --only FILE     only this file, by its path from the root; may be repeated

cargo xtask kernels [--check]
    Compiles the machine's programs from sim/machine/kernels/*.c with Debian's clang 14 (the variable CLANG names another) and writes
    their listings.
    --check         compares them with those that are there; exit code 1 if one differs

cargo xtask quick
    Formats, lints and runs the tests that need neither external tools nor volume. Exit code 1 if one fails.

cargo xtask times [--only STEP]...
    Measures processor time and wall time of builds, tests and the tool's start, as a Markdown table.
    --only STEP     only this step: build, touch-command, touch-chart, touch-machine, test, quick or run
";

fn main() -> ExitCode {
    match run() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

/// Whether nothing differed and nothing failed.
fn run() -> anyhow::Result<bool> {
    let mut arguments = lexopt::Parser::from_env();
    match arguments.next()? {
        Some(Value(command)) => match command.string()?.as_str() {
            "behaviour" => behaviour::run(&behaviour::Options::parse(arguments)?),
            "docs" => docs::run(&docs::Options::parse(arguments)?),
            "kernels" => kernels::run(kernels::parse(arguments)?),
            "quick" => match arguments.next()? {
                None => quick::run(),
                Some(argument) => Err(argument.unexpected().into()),
            },
            "times" => times::run(&times::parse(arguments)?),
            other => anyhow::bail!("{other}: the commands are behaviour, docs, kernels, quick and times"),
        },
        None | Some(Short('h') | Long("help")) => {
            print!("{HELP}");
            Ok(true)
        }
        Some(argument) => Err(argument.unexpected().into()),
    }
}
