//! The arguments of all commands.

mod examples;
mod hardware;
mod records;
mod shared;
mod studies;
mod sweep;
mod trees;
mod values;

pub use hardware::*;
pub use records::*;
pub use shared::*;
pub use studies::*;
pub use sweep::*;
pub use trees::*;

use clap::{Parser, Subcommand};

/// Dual-split trees against bounding volume hierarchies: build, trace, render, compare.
///
/// Without a command, runs `reproduce --preset quick`. Results go to stdout, progress to stderr.
#[derive(Debug, Parser)]
#[command(name = "dualsplit", version = env!("DUALSPLIT_VERSION"), max_term_width = 100, after_long_help = examples::MANUAL,
    after_help = "`dualsplit --help` is the manual, `dualsplit COMMAND --help` explains a command.")]
pub struct Cli {
    #[command(flatten)]
    pub global: Global,
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// The commit of the sources; empty if it was not known where the tool was built.
pub const COMMIT: &str = env!("DUALSPLIT_COMMIT");

#[derive(Debug, Subcommand)]
pub enum Command {
    /// List the built-in scenes, or write one to a file.
    #[command(after_help = examples::SCENES)]
    Scenes(ScenesArgs),
    /// Build all structures over a scene and print their sizes, costs and histograms; save one to a file.
    #[command(after_help = examples::TREE)]
    Tree(TreeArgs),
    /// Trace a file of rays for their closest hits and write the hits.
    #[command(after_help = examples::TRACE)]
    Trace(TraceArgs),
    /// Render a picture of a scene, or a heat map of the work that rendering takes.
    #[command(after_help = examples::RENDER)]
    Render(RenderArgs),
    /// Compare two pictures; exit code 1 if any pixel differs.
    #[command(after_help = examples::COMPARE)]
    Compare(CompareArgs),
    /// Print the traversal of one pixel's primary ray step by step, in the dual-split tree and in the BVH2.
    #[command(after_help = examples::EXPLAIN)]
    Explain(ExplainArgs),
    /// Compare the hardware's netlist with the specification, cycle by cycle; exit code 1 if anything differs.
    #[command(after_help = examples::CHECK)]
    Check(CheckArgs),
    /// Write Verilog with testbenches, vectors and scripts.
    #[command(after_help = examples::EXPORT)]
    Export(ExportArgs),
    /// Write a waveform of the hardware that processes rays of a scene.
    #[command(after_help = examples::WAVE)]
    Wave(WaveArgs),
    /// Chart cost against error, over formats of the hardware or levels of the simulation.
    #[command(after_help = examples::CHART)]
    Chart(ChartArgs),
    /// Judge every structure and arithmetic by exact answers, on inputs made to break them; exit code 1 if a method that must
    /// lose no hit loses one.
    #[command(after_help = examples::STRESS)]
    Stress(StressArgs),
    /// Find the least hardware that a scene needs at an error budget, and write it as TOML with a chart of each knee.
    #[command(after_help = examples::NEEDS)]
    Needs(NeedsArgs),
    /// Estimate area, energy and clock of the pipelines, beside the published figures.
    #[command(after_help = examples::ESTIMATE)]
    Estimate(EstimateArgs),
    /// Time a frame on a many-core machine, or the public simulator's reference runs.
    #[command(after_help = examples::SIMULATE)]
    Simulate(SimulateArgs),
    /// Do the paper's study: simulate all built-in scenes, eight structures and both tests on the many-core machine.
    #[command(after_help = examples::STUDY)]
    Study(StudyArgs),
    /// Simulate the product of lists of scenes, structures, machines, seeds and values of the machine's keys.
    #[command(after_help = examples::SWEEP)]
    Sweep(SweepArgs),
    /// Build, render and measure all built-in scenes, and write a folder of pictures, CSV and JSON.
    #[command(after_help = examples::REPRODUCE)]
    Reproduce(ReproduceArgs),
    /// Make a folder of results again, by the command that made it.
    #[command(after_help = examples::RERUN)]
    Rerun(RerunArgs),
    /// Write shell completions and man pages to a folder.
    #[command(hide = true, after_help = examples::MANUAL_FILES)]
    Manual(ManualArgs),
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Cli::command().debug_assert();
    }

    /// The examples in the help of `command` and of its commands.
    fn examples(command: &clap::Command, path: &str) -> Vec<String> {
        let help = command.get_after_long_help().or(command.get_after_help());
        let help = help.unwrap_or_else(|| panic!("{path} has no examples")).to_string();
        let lines = help.lines().map(str::trim).filter(|line| line.starts_with("dualsplit"));
        let of_commands = command.get_subcommands().filter(|inner| inner.get_name() != "help");
        let own: Vec<String> =
            lines.map(|line| line.split("   ").next().unwrap_or(line).to_owned()).collect();
        let own_of_path = own.iter().filter(|line| line.starts_with(path)).count();
        assert!(own_of_path > 0, "{path} has no example of itself");
        own.into_iter()
            .chain(of_commands.flat_map(|inner| examples(inner, &format!("{path} {}", inner.get_name()))))
            .collect()
    }

    #[test]
    fn every_command_has_examples_that_parse() {
        let examples = examples(&Cli::command(), "dualsplit");
        assert!(examples.len() > 30, "{examples:?}");
        for example in examples {
            let parsed = Cli::try_parse_from(example.split_whitespace());
            assert!(parsed.is_ok(), "{example}: {}", parsed.unwrap_err());
        }
    }
}
