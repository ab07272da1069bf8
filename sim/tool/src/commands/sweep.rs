//! `dualsplit sweep`: many runs, on one host or on many.

use crate::cli::{Engine, Global, SweepArgs};
use crate::console::{Bars, Report};
use anyhow::ensure;
use studies::sweep::{self, Options, Sweep, Task};

pub fn run(args: &SweepArgs, global: &Global) -> anyhow::Result<Report> {
    ensure!(global.seed.is_none(), "--seed: the file of the sweep has the seeds; leave it away");
    let task = match (args.shard, &args.only, args.workflow) {
        (Some([number, count]), _, _) => Task::Shard(number, count),
        (_, Some(key), _) => Task::Only(key.clone()),
        (_, _, Some(Engine::Snakemake)) => Task::Workflow,
        _ if args.dry_run => Task::Count,
        _ if !args.merge.is_empty() => Task::Merge(args.merge.clone()),
        _ => Task::All,
    };
    let options = Options { file: args.file.clone(), out: args.out.clone(), task, force: global.force };
    let sweep = sweep::run(&options, &Bars::new(global.quiet))?;
    Ok(Report::new(&sweep, text(&sweep), sweep.artifacts.clone()).in_folder(sweep.results.clone()))
}

fn text(d: &Sweep) -> String {
    let Sweep { folder, runs, distinct, simulated, missing, .. } = d;
    let mut text = format!(
        "{folder}: {runs} runs, {distinct} of them distinct, {simulated} simulated, {missing} missing\n"
    );
    if d.missing > 0 {
        let seconds = d.seconds_left;
        let time = match seconds {
            ..120.0 => format!("{seconds:.0} s"),
            ..7200.0 => format!("{:.0} min", seconds / 60.0),
            _ => format!("{:.0} h", seconds / 3600.0),
        };
        text += &format!("the missing ones take about {time} on this host\n");
    }
    for artifact in &d.artifacts {
        text += &format!("{artifact}\n");
    }
    text
}
