//! The paper's study: all scenes, structures and tests on the machine. The study keeps its runs in files and repeats none. A file
//! holds what its run counted, so that the tables are always at the prices of the machine that is asked for.

pub mod comparison;
mod correlation;
mod jobs;
mod plots;
mod record;
pub mod row;
pub mod sensitivity;
mod settings;

use crate::artifacts::Artifacts;
use crate::input::{Built, display};
use crate::progress::{Part, Progress};
use anyhow::bail;
use base::input::read_own;
use comparison::{Claim, compare};
use estimate::Method;
use golden::build::Quality;
use golden::structure::{Structure, StructureKind};
use jobs::{Job, Preset};
use machine::costs::CacheCosts;
use machine::frame::FrameMachine;
use rayon::prelude::*;
use record::{Planned, Record};
use row::Row;
use scenes::Scene;
use serde::Serialize;
use settings::Settings;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

pub use jobs::Series;

/// The size of the study, the machine, and the folder of the runs.
#[derive(Clone, Debug)]
pub struct Options {
    /// `small`, `quick`, `medium` or `paper`.
    pub preset: String,
    /// The only scene to simulate; all scenes if absent.
    pub scene: Option<String>,
    /// How the trees are built.
    pub quality: Quality,
    /// A preset machine or a TOML file.
    pub machine: PathBuf,
    /// Changed keys of the machine.
    pub settings: Vec<String>,
    /// How area and energy of the pipelines are found.
    pub pipeline_cost: Method<'static>,
    /// The folder that holds the runs.
    pub out: PathBuf,
    /// Seed of scenes and samples.
    pub seed: u64,
    /// Writes into the folder even if it holds files that the tool did not make.
    pub force: bool,
}

/// All runs of a study, and their comparison with the paper.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Study {
    pub preset: String,
    pub rows: Vec<Row>,
    pub scaling: Vec<Row>,
    pub load_width: Vec<Row>,
    pub layout: Vec<Row>,
    pub comparison: Vec<Claim>,
    #[serde(skip)]
    pub artifacts: Vec<String>,
}

/// Simulates the runs that the folder does not hold yet, and writes all tables and charts.
///
/// # Errors
/// There is no such preset, scene or machine, a run fails, or a file cannot be read or written.
pub fn run(args: &Options, progress: &dyn Progress) -> anyhow::Result<Study> {
    let preset = Preset::find(&args.preset)?;
    let chosen = scenes_of(args)?;
    let planned = planned(preset, args)?;
    let mut artifacts = Artifacts::create(&args.out, args.force)?;
    let settings = Settings::of(args)?;
    settings.compare(args)?;
    artifacts.write(settings::FILE, serde_json::to_string_pretty(&settings)?.as_bytes())?;
    progress.note(&format!(
        "finished runs are kept in {}; after an interruption the same command continues there",
        args.out.display()
    ));
    let mut runs = finished(&args.out);
    for scene in chosen {
        let of_scene: Vec<&Planned> = planned.iter().filter(|planned| planned.scene == scene).collect();
        simulate_scene(scene, &of_scene, preset, args, progress, &mut runs, &mut artifacts)?;
    }
    for (name, record) in &runs {
        artifacts.write(name, serde_json::to_string_pretty(record)?.as_bytes())?;
    }
    let mut all: Vec<Row> = vec![];
    let mut others = 0;
    for planned in &planned {
        match runs.get(&planned.file) {
            Some(record) if record.fingerprint == planned.fingerprint => {
                all.push(planned.row(&args.preset, preset, record)?);
            }
            Some(_) => others += 1,
            None => {}
        }
    }
    if others > 0 {
        progress.note(&format!(
            "{}: {others} kept runs of scenes that are not simulated now are of another machine, tree or version, and in no table",
            display(&args.out)
        ));
    }
    let of = |series| row::of_series(&all, series);
    let (rows, scaling, load_width) = (of(Series::Main), of(Series::Scaling), of(Series::LoadWidth));
    let layout = of(Series::Layout);
    let comparison = compare(&rows, &scaling);
    artifacts.write("study.csv", row::csv(all.iter())?.as_bytes())?;
    artifacts.write("comparison.csv", comparison::csv(&comparison)?.as_bytes())?;
    for (name, svg) in plots::all(&rows, &scaling, &load_width) {
        artifacts.write(&name, svg.as_bytes())?;
    }
    let mut study = Study {
        preset: args.preset.clone(),
        rows,
        scaling,
        load_width,
        layout,
        comparison,
        artifacts: vec![],
    };
    let json = serde_json::to_string_pretty(&study)?;
    artifacts.write("study.json", json.as_bytes())?;
    study.artifacts = artifacts.finish()?.iter().map(|path| display(path)).collect();
    Ok(study)
}

/// The scenes of the study.
fn scenes_of(args: &Options) -> anyhow::Result<Vec<&str>> {
    let names: Vec<&str> = scenes::procedural::CATALOGUE.iter().map(|entry| entry.name).collect();
    match &args.scene {
        Some(scene) => match names.iter().find(|name| **name == scene.as_str()) {
            Some(name) => Ok(vec![*name]),
            None => bail!("--scene {scene}: the study's scenes are {}", names.join(", ")),
        },
        None => Ok(names),
    }
}

/// All simulations of all scenes, in the order of their files.
fn planned(preset: &Preset, args: &Options) -> anyhow::Result<Vec<Planned>> {
    let pipeline = estimate::by_name(args.pipeline_cost);
    let mut all = vec![];
    for scene in scenes::procedural::CATALOGUE {
        for job in Job::of_scene(scene.name, preset) {
            let machine = job.machine(&args.machine, &args.settings)?;
            // A machine whose parts have no cost shows before anything is simulated or written.
            CacheCosts::new(&machine)?;
            let machine = FrameMachine::new(&machine, job.structure, &pipeline)?;
            let fingerprint = record::fingerprint(&machine, args.quality, args.seed, preset);
            let file = job.file(scene.name, &args.preset);
            all.push(Planned { scene: scene.name.to_owned(), job, machine, file, fingerprint });
        }
    }
    all.sort_by(|a, b| a.file.cmp(&b.file));
    Ok(all)
}

/// The runs that an earlier study left in `folder`. What is no run, or one of an older version, is left out.
fn finished(folder: &Path) -> BTreeMap<String, Record> {
    let entries = fs::read_dir(folder.join("runs")).into_iter().flatten().flatten();
    let run = |entry: fs::DirEntry| {
        let name = format!("runs/{}", entry.file_name().to_str()?);
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        let text = is_file.then(|| read_own(&entry.path(), record::MOST_BYTES).ok()).flatten()?;
        Some((name, serde_json::from_str(&text).ok()?))
    };
    entries.filter_map(run).collect()
}

fn simulate_scene(
    name: &str,
    planned: &[&Planned],
    preset: &Preset,
    args: &Options,
    progress: &dyn Progress,
    runs: &mut BTreeMap<String, Record>,
    artifacts: &mut Artifacts,
) -> anyhow::Result<()> {
    let is_open = |planned: &&&Planned| {
        runs.get(&planned.file).is_none_or(|record| record.fingerprint != planned.fingerprint)
    };
    let open: Vec<&Planned> = planned.iter().filter(is_open).copied().collect();
    if open.is_empty() {
        return Ok(());
    }
    let scene = Scene::load(name, preset.detail, args.seed)?;
    let built = Built::new(&scene, args.quality, progress)?;
    let structures = StructureKind::ALL
        .into_par_iter()
        .filter(|kind| open.iter().any(|planned| planned.job.structure.kind() == *kind))
        .map(|kind| Ok(built.convert(kind)?.0))
        .collect::<anyhow::Result<Vec<Structure>>>()?;
    let part = Part::begin(progress, open.len() as u64, name);
    // The runs of each batch are written before the next batch begins, so that an interrupted study can continue there.
    for batch in open.chunks(rayon::current_num_threads().max(1)) {
        let done = batch
            .par_iter()
            .map(|planned| {
                let record = planned.simulate(preset, args.seed, &scene, &structures)?;
                part.advance(1);
                Ok((planned.file.clone(), record))
            })
            .collect::<anyhow::Result<Vec<(String, Record)>>>()?;
        for (file, record) in done {
            artifacts.write(&file, serde_json::to_string_pretty(&record)?.as_bytes())?;
            runs.insert(file, record);
        }
    }
    Ok(())
}
