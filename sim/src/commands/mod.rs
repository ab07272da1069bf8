//! One file for each command.

mod chart;
mod check;
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
mod wave;
mod work;

use crate::cli::{Cli, Command, ReproduceArgs};
use crate::console::Report;
use anyhow::Context;

/// Runs the command of `cli`.
pub fn run(cli: &Cli) -> anyhow::Result<Report> {
    let global = &cli.global;
    if let Some(threads) = global.threads {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.into());
        pool.build_global()
            .with_context(|| format!("--threads {threads}: the system does not start them"))?;
    }
    match &cli.command {
        Some(Command::Scenes(args)) => scenes::run(args, global),
        Some(Command::Tree(args)) => tree::run(args, global),
        Some(Command::Trace(args)) => trace::run(args, global),
        Some(Command::Render(args)) => render::run(args, global),
        Some(Command::Compare(args)) => compare::run(args, global),
        Some(Command::Explain(args)) => explain::run(args, global),
        Some(Command::Check(args)) if args.prove => prove::run(args, global),
        Some(Command::Check(args)) => check::run(args, global),
        Some(Command::Export(args)) => export::run(args, global),
        Some(Command::Wave(args)) => wave::run(args, global),
        Some(Command::Chart(args)) => chart::run(args, global),
        Some(Command::Stress(args)) => stress::run(args, global),
        Some(Command::Needs(args)) => needs::run(args, global),
        Some(Command::Estimate(args)) => estimate::run(args, global),
        Some(Command::Simulate(args)) => simulate::run(args, global),
        Some(Command::Study(args)) => study::run(args, global),
        Some(Command::Reproduce(args)) => reproduce::run(args, global),
        None => reproduce::run(&ReproduceArgs::default(), global),
    }
}
