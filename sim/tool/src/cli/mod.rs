//! The arguments of all commands.

mod hardware;
mod shared;
mod studies;
mod trees;
mod values;

pub use hardware::*;
pub use shared::*;
pub use studies::*;
pub use trees::*;

use clap::{Parser, Subcommand};

/// Dual-split trees against bounding volume hierarchies: build, trace, render, compare.
///
/// Without a command, runs `reproduce --preset quick`. Results go to stdout, progress to stderr. Exit codes: 0 done, 1 a
/// check found a difference, 2 bad input or usage.
#[derive(Debug, Parser)]
#[command(name = "dualsplit", version, max_term_width = 100)]
pub struct Cli {
    #[command(flatten)]
    pub global: Global,
    #[command(subcommand)]
    pub command: Option<Command>,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// List the built-in scenes, or write one to a file.
    Scenes(ScenesArgs),
    /// Build all structures over a scene and print their sizes, costs and histograms; save one to a file.
    Tree(TreeArgs),
    /// Trace a file of rays for their closest hits and write the hits.
    Trace(TraceArgs),
    /// Render a picture of a scene, or a heat map of the work that rendering takes.
    Render(RenderArgs),
    /// Compare two pictures; exit code 1 if any pixel differs.
    Compare(CompareArgs),
    /// Print the traversal of one pixel's primary ray step by step, in the dual-split tree and in the BVH2.
    Explain(ExplainArgs),
    /// Compare the hardware's netlist with the specification, cycle by cycle; exit code 1 if anything differs.
    Check(CheckArgs),
    /// Write Verilog with testbenches, vectors and scripts.
    Export(ExportArgs),
    /// Write a waveform of the hardware that processes rays of a scene.
    Wave(WaveArgs),
    /// Chart cost against error, over formats of the hardware or levels of the simulation.
    Chart(ChartArgs),
    /// Judge every structure and arithmetic by exact answers, on inputs made to break them; exit code 1 if a method that must
    /// lose no hit loses one.
    Stress(StressArgs),
    /// Find the least hardware that a scene needs at an error budget, and write it as TOML with a chart of each knee.
    Needs(NeedsArgs),
    /// Estimate area, energy and clock of the pipelines, beside the published figures.
    Estimate(EstimateArgs),
    /// Time a frame on a many-core machine, or the public simulator's reference runs.
    Simulate(SimulateArgs),
    /// Do the paper's study: simulate all built-in scenes, eight structures and both tests on the many-core machine.
    Study(StudyArgs),
    /// Build, render and measure all built-in scenes, and write a folder of pictures, CSV and JSON.
    Reproduce(ReproduceArgs),
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }
}
