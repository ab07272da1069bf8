//! One file for each command.

mod chart;
mod check;
mod classes;
mod compare;
mod estimate;
mod explain;
mod export;
mod manual;
mod needs;
mod prove;
mod render;
mod reproduce;
mod rerun;
mod scenes;
mod simulate;
mod stress;
mod study;
mod sweep;
mod trace;
mod tree;
mod validate;
mod wave;

use crate::cli::{Cli, Command, Global, ReproduceArgs};
use crate::console::Report;
use anyhow::{Context, bail};

/// Runs the command of `cli`.
pub fn run(cli: &Cli) -> anyhow::Result<Report> {
    let global = &cli.global;
    if let Some(threads) = global.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
        pool.build_global().with_context(|| {
            format!("--threads {threads}: the system cannot start them; give a smaller number")
        })?;
    }
    match &cli.command {
        Some(Command::Rerun(args)) => rerun::run(args, global, dispatch),
        Some(command) => dispatch(command, global),
        None => dispatch(&Command::Reproduce(ReproduceArgs::default()), global),
    }
}

/// Runs `command` on the threads of the global pool, and records it in the folder of its results.
fn dispatch(command: &Command, global: &Global) -> anyhow::Result<Report> {
    let mut report = perform(command, global)?;
    rerun::record(&mut report, &global.words)?;
    Ok(report)
}

fn perform(command: &Command, global: &Global) -> anyhow::Result<Report> {
    match command {
        Command::Scenes(args) => scenes::run(args, global),
        Command::Tree(args) => tree::run(args, global),
        Command::Trace(args) => trace::run(args, global),
        Command::Render(args) => render::run(args, global),
        Command::Compare(args) => compare::run(args, global),
        Command::Explain(args) => explain::run(args, global),
        Command::Check(args) if args.prove => prove::run(args, global),
        Command::Check(args) => check::run(args, global),
        Command::Export(args) => export::run(args, global),
        Command::Wave(args) => wave::run(args, global),
        Command::Chart(args) => chart::run(args, global),
        Command::Stress(args) => stress::run(args, global),
        Command::Needs(args) => needs::run(args, global),
        Command::Estimate(args) => estimate::run(args, global),
        Command::Simulate(args) => simulate::run(args, global),
        Command::Study(args) => study::run(args, global),
        Command::Sweep(args) => sweep::run(args, global),
        Command::Reproduce(args) => reproduce::run(args, global, dispatch),
        Command::Rerun(_) => bail!("a rerun of a rerun: name the folder of other results"),
        Command::Manual(args) => manual::run(args, global),
    }
}
