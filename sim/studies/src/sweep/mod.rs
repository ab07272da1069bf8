//! Sweeps: the product of lists of scenes, structures, machines, seeds and values of the machine's keys.
//!
//! Each run has a key, a hash of everything that its result depends on (`plan`), and a file of that name in the folder of the
//! sweep (`record`). So runs are independent of each other: shards of a sweep run anywhere and at any time, an interrupted sweep
//! continues where it stopped, and folders are merged by copying. `table` makes the tables from the files, and `workflow`
//! leaves the spreading to Snakemake.

pub mod file;
pub mod plan;
pub mod record;
mod simulate;
mod table;
mod workflow;

use crate::artifacts::Artifacts;
use crate::input::display;
use crate::progress::Progress;
use anyhow::{Context, bail, ensure};
use file::SweepFile;
use plan::{Plan, Run};
use record::Record;
use render::Test;
use serde::Serialize;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The file of the workflow in the folder of a sweep.
const SNAKEFILE: &str = "Snakefile";

/// The folder of the tables in that of a sweep.
const RESULTS: &str = "results";

/// What is done with a sweep.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Task {
    /// Simulate the runs that are missing, and write the tables.
    All,
    /// Of every so many runs (the second number) simulate the one of this number, counted from 1.
    Shard(u32, u32),
    /// Simulate the run of this key.
    Only(String),
    /// Take runs from the folders of other sweeps, and write the tables if none is missing.
    Merge(Vec<PathBuf>),
    /// Count the runs.
    Count,
    /// Write a workflow of Snakemake.
    Workflow,
}

/// The sweep, and what is done with it.
#[derive(Clone, Debug)]
pub struct Options {
    /// The file of the sweep.
    pub file: PathBuf,
    /// The folder of the runs and tables; if absent, `sweep-` and the name of the file.
    pub out: Option<PathBuf>,
    /// What is done.
    pub task: Task,
    /// Writes into the folder of the tables even if it holds files that the tool did not make.
    pub force: bool,
}

/// What was done with a sweep.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Sweep {
    pub folder: String,
    /// Lines of the table.
    pub runs: usize,
    /// Runs that differ in anything that a result depends on.
    pub distinct: usize,
    pub simulated: usize,
    /// Distinct runs without a record.
    pub missing: usize,
    /// About how long the missing ones take on this host.
    pub seconds_left: f64,
    /// The folder of the tables, if they were written.
    #[serde(skip)]
    pub results: Option<PathBuf>,
    #[serde(skip)]
    pub artifacts: Vec<String>,
}

/// Does the task of `options`.
///
/// # Errors
/// The file is no sweep, a scene or a machine cannot be loaded, a run fails, or a file cannot be written.
pub fn run(options: &Options, progress: &dyn Progress) -> anyhow::Result<Sweep> {
    let file = SweepFile::read(&options.file)?;
    let beside =
        options.file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let plan = Plan::new(file, beside, progress).with_context(|| display(&options.file))?;
    let stem = || options.file.file_stem().unwrap_or_default().to_string_lossy();
    let folder = options.out.clone().unwrap_or_else(|| format!("sweep-{}", stem()).into());
    let keys = plan.keys();
    let distinct = keys.len();
    if let Task::Merge(others) = &options.task {
        take(&folder, others, &keys)?;
    }
    let mut open = missing(&plan, &folder);
    let chosen: Vec<&Run> = match &options.task {
        Task::All => open.clone(),
        Task::Shard(number, count) => {
            let own: BTreeSet<&str> =
                keys.iter().copied().skip(*number as usize - 1).step_by(*count as usize).collect();
            open.iter().copied().filter(|run| own.contains(run.key.as_str())).collect()
        }
        Task::Only(key) => {
            let known = keys.contains(&key.as_str());
            ensure!(known, "--only {key}: the sweep has no run of this key; write the workflow anew");
            open.iter().copied().filter(|run| run.key == *key).collect()
        }
        Task::Merge(_) | Task::Count | Task::Workflow => vec![],
    };
    if !chosen.is_empty() {
        progress.note(&format!(
            "finished runs are kept in {}; after an interruption the same command continues there",
            display(&folder)
        ));
        simulate::simulate(&plan, &chosen, &folder, progress)?;
    }
    let simulated = chosen.len();
    let done: BTreeSet<String> = chosen.iter().map(|run| run.key.clone()).collect();
    open.retain(|run| !done.contains(&run.key));
    let artifacts = match &options.task {
        Task::All | Task::Merge(_) => tables(&plan, &open, &folder, options.force)?,
        Task::Workflow => workflow(&options.file, &folder, &keys, options.force)?,
        _ => vec![],
    };
    let results = matches!(options.task, Task::All | Task::Merge(_)).then(|| folder.join(RESULTS));
    Ok(Sweep {
        results,
        folder: display(&folder),
        runs: plan.runs.len(),
        distinct,
        simulated,
        missing: open.len(),
        seconds_left: seconds(&plan, &open, &folder),
        artifacts,
    })
}

/// The runs of `plan` without a record in `folder`, one for each key.
fn missing<'a>(plan: &'a Plan, folder: &Path) -> Vec<&'a Run> {
    let mut seen = BTreeSet::new();
    let distinct = plan.runs.iter().filter(|run| seen.insert(run.key.as_str()));
    distinct.filter(|run| Record::read(folder, &run.key).is_none()).collect()
}

/// Copies the records of `keys` that `folder` has not from `others`.
fn take(folder: &Path, others: &[PathBuf], keys: &[&str]) -> anyhow::Result<()> {
    for other in others {
        ensure!(other.is_dir(), "--merge {}: there is no such folder", display(other));
        for key in keys {
            if Record::read(folder, key).is_none()
                && let Some(record) = Record::read(other, key)
            {
                record.write(folder)?;
            }
        }
    }
    Ok(())
}

/// Writes the tables and charts of a complete sweep, and returns their paths.
fn tables(plan: &Plan, open: &[&Run], folder: &Path, force: bool) -> anyhow::Result<Vec<String>> {
    if let Some(first) = open.first() {
        bail!(
            "{}: {} runs are missing, the first: {}; simulate them without --merge, or with --shard",
            display(folder),
            open.len(),
            plan.words(first)
        );
    }
    let read = |run: &Run| {
        let record = Record::read(folder, &run.key);
        record.with_context(|| {
            format!("{}: the record is gone; run the command again", display(&Record::path(folder, &run.key)))
        })
    };
    let records = plan.runs.iter().map(read).collect::<anyhow::Result<Vec<Record>>>()?;
    let mut artifacts = Artifacts::create(&folder.join(RESULTS), force)?;
    artifacts.write("sweep.csv", &table::csv(plan, &records)?)?;
    for (name, svg) in table::charts(plan, &records) {
        artifacts.write(&name, svg.as_bytes())?;
    }
    Ok(artifacts.finish()?.iter().map(|path| display(path)).collect())
}

fn workflow(file: &Path, folder: &Path, keys: &[&str], force: bool) -> anyhow::Result<Vec<String>> {
    let path = folder.join(SNAKEFILE);
    std::fs::create_dir_all(folder)
        .with_context(|| format!("{}: cannot make the folder", display(folder)))?;
    let text = workflow::snakefile(file, folder, keys);
    base::output::write_file(&path, force, |out| out.write_all(text.as_bytes()))?;
    Ok(vec![display(&path)])
}

/// Path-traced pixels a second that are simulated on a thread, for a first estimate. Between 150 and 1,160 were measured on a thread of
/// a busy Xeon, for dst, bvh2 and bvh8 in the hairball and the atrium at a tenth of their triangles.
const PIXELS_PER_SECOND: f64 = 400.0;

/// About how many seconds the runs `open` take on this host, at the pace of the records in `folder`.
fn seconds(plan: &Plan, open: &[&Run], folder: &Path) -> f64 {
    if open.is_empty() {
        return 0.0;
    }
    let pixels =
        |run: &Run| f64::from(run.size[0]) * f64::from(run.size[1]) * (1 + run.test.bounces()) as f64;
    let kept =
        plan.runs.iter().filter_map(|run| Some((pixels(run), Record::read(folder, &run.key)?.seconds)));
    let (done, seconds) = kept.fold((0.0, 0.0), |sum, run| (sum.0 + run.0, sum.1 + run.1));
    let waves = (1 + Test::Path.bounces()) as f64;
    let pace = if done > 0.0 { seconds / done } else { 1.0 / (waves * PIXELS_PER_SECOND) };
    open.iter().fold(0.0, |sum, run| sum + pixels(run)) * pace / rayon::current_num_threads() as f64
}
