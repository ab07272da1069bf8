//! One file for each command.

mod chart;
mod check;
mod classes;
mod compare;
mod estimate;
mod explain;
mod export;
mod needs;
mod prove;
mod render;
mod reproduce;
mod scenes;
mod simulate;
mod stress;
mod study;
mod trace;
mod tree;
mod validate;
mod wave;

use crate::cli::{Cli, Command, Global, ReproduceArgs};
use crate::console::Report;
use anyhow::Context;

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
        Some(command) => dispatch(command, global),
        None => reproduce::run(&ReproduceArgs::default(), global, dispatch),
    }
}

/// Runs `command` on the threads of the global pool.
fn dispatch(command: &Command, global: &Global) -> anyhow::Result<Report> {
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
        Command::Reproduce(args) => reproduce::run(args, global, dispatch),
    }
}
