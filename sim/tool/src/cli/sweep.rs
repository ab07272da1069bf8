//! Arguments of sweeps.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Args, Debug)]
pub struct SweepArgs {
    /// The file of the sweep, in TOML.
    pub file: PathBuf,
    /// The folder of the runs and results; runs that it already holds are not repeated [default: sweep-FILE].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Simulate only every Nth run, beginning with the Kth, and write no table: shards may run on several hosts.
    #[arg(long, value_name = "K/N", value_parser = shard, conflicts_with_all = ["merge", "dry_run", "workflow"])]
    pub shard: Option<[u32; 2]>,
    /// Simulate no run; take those of this sweep that the folder of another one holds. May be repeated.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["dry_run", "workflow"])]
    pub merge: Vec<PathBuf>,
    /// Say how many runs there are and about how long they take.
    #[arg(long, conflicts_with = "workflow")]
    pub dry_run: bool,
    /// Write a workflow, whose jobs are the runs.
    #[arg(long, value_name = "ENGINE")]
    pub workflow: Option<Engine>,
    /// Simulate only the run of this key, for a job of a workflow.
    #[arg(long, value_name = "KEY", hide = true, conflicts_with_all = ["shard", "merge", "dry_run", "workflow"])]
    pub only: Option<String>,
}

/// A workflow engine.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum Engine {
    /// A Snakefile in the folder of the sweep.
    Snakemake,
}

fn shard(text: &str) -> Result<[u32; 2], String> {
    match super::values::integers(text, '/') {
        Some([number, count]) if (1..=count).contains(&number) => Ok([number, count]),
        _ => Err("write K/N with K from 1 to N, such as 2/8".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards() {
        assert_eq!(shard("2/8"), Ok([2, 8]));
        for bad in ["0/8", "9/8", "2", "2/", "a/b", "-1/2", "1/0"] {
            assert!(shard(bad).is_err(), "{bad}");
        }
    }
}
