//! The paper's study: all scenes, structures and tests on the machine. The study keeps its runs in files and repeats none.

pub mod comparison;
mod jobs;
mod plots;
pub mod row;
mod settings;

use crate::artifacts::Artifacts;
use crate::input::{Built, display};
use crate::progress::{Part, Progress};
use anyhow::bail;
use base::input::read_text;
use comparison::{Claim, compare};
use estimate::Method;
use golden::build::Quality;
use golden::structure::{Structure, StructureKind};
use jobs::{Job, Preset};
use machine::frame::{FrameMachine, frame};
use machine::results::Results;
use rayon::prelude::*;
use render::RenderOptions;
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
    let names: Vec<&str> = scenes::procedural::CATALOGUE.iter().map(|entry| entry.name).collect();
    let chosen: Vec<&str> = match &args.scene {
        Some(scene) => match names.iter().find(|name| **name == scene.as_str()) {
            Some(name) => vec![*name],
            None => bail!("--scene {scene}: the study's scenes are {}", names.join(", ")),
        },
        None => names,
    };
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
        simulate_scene(scene, preset, args, progress, &mut runs, &mut artifacts)?;
    }
    for (name, row) in &runs {
        artifacts.write(name, serde_json::to_string_pretty(row)?.as_bytes())?;
    }
    let all: Vec<Row> = runs.into_values().filter(|row| row.preset == args.preset).collect();
    let of = |series| row::of_series(&all, series);
    let (rows, scaling, load_width) = (of(Series::Main), of(Series::Scaling), of(Series::LoadWidth));
    let comparison = compare(&rows, &scaling);
    artifacts.write("study.csv", row::csv(all.iter())?.as_bytes())?;
    artifacts.write("comparison.csv", comparison::csv(&comparison)?.as_bytes())?;
    for (name, svg) in plots::all(&rows, &scaling, &load_width) {
        artifacts.write(&name, svg.as_bytes())?;
    }
    let mut study =
        Study { preset: args.preset.clone(), rows, scaling, load_width, comparison, artifacts: vec![] };
    let json = serde_json::to_string_pretty(&study)?;
    artifacts.write("study.json", json.as_bytes())?;
    study.artifacts = artifacts.finish()?.iter().map(|path| display(path)).collect();
    Ok(study)
}

/// The runs that an earlier study left in `folder`. What is no run, or one of an older version, is left out.
fn finished(folder: &Path) -> BTreeMap<String, Row> {
    let entries = fs::read_dir(folder.join("runs")).into_iter().flatten().flatten();
    let run = |entry: fs::DirEntry| {
        let name = format!("runs/{}", entry.file_name().to_str()?);
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        let text = is_file.then(|| read_text(&entry.path(), row::MOST_BYTES).ok()).flatten()?;
        Some((name, serde_json::from_str(&text).ok()?))
    };
    entries.filter_map(run).collect()
}

fn simulate_scene(
    name: &str,
    preset: &Preset,
    args: &Options,
    progress: &dyn Progress,
    runs: &mut BTreeMap<String, Row>,
    artifacts: &mut Artifacts,
) -> anyhow::Result<()> {
    let mut open = vec![];
    for job in Job::of_scene(name, preset) {
        let machine = job.machine(&args.machine, &args.settings)?;
        let machine = FrameMachine::new(&machine, job.structure, estimate::by_name(args.pipeline_cost))?;
        let file = job.file(name, &args.preset);
        let fingerprint = row::fingerprint(&machine, args.quality, args.seed, preset);
        if runs.get(&file).is_none_or(|row| row.fingerprint != fingerprint) {
            open.push((job, machine, file, fingerprint));
        }
    }
    if open.is_empty() {
        return Ok(());
    }
    let scene = Scene::load(name, preset.detail, args.seed)?;
    let built = Built::new(&scene, args.quality, progress)?;
    let structures = StructureKind::ALL
        .into_par_iter()
        .filter(|kind| open.iter().any(|(job, ..)| job.structure.kind() == *kind))
        .map(|kind| Ok(built.convert(kind)?.0))
        .collect::<anyhow::Result<Vec<Structure>>>()?;
    let part = Part::begin(progress, open.len() as u64, name);
    // The runs of each batch are written before the next batch begins, so that an interrupted study can continue there.
    for batch in open.chunks(rayon::current_num_threads().max(1)) {
        let done = batch
            .par_iter()
            .map(|(job, machine, file, fingerprint)| {
                let row = simulate_one(&scene, &structures, preset, args, job, machine, fingerprint)?;
                part.advance(1);
                Ok((file.clone(), row))
            })
            .collect::<anyhow::Result<Vec<(String, Row)>>>()?;
        for (file, row) in done {
            artifacts.write(&file, serde_json::to_string_pretty(&row)?.as_bytes())?;
            runs.insert(file, row);
        }
    }
    Ok(())
}

#[allow(clippy::too_many_arguments, reason = "everything that a run depends on")]
fn simulate_one(
    scene: &Scene,
    structures: &[Structure],
    preset: &Preset,
    args: &Options,
    job: &Job,
    set_up: &FrameMachine,
    fingerprint: &str,
) -> anyhow::Result<Row> {
    let structure = structures.iter().find(|s| s.kind() == job.structure.kind()).expect("all kinds");
    let mut options = RenderOptions::new(job.test, preset.width, preset.height);
    options.seed = args.seed;
    let frame = frame(set_up, scene, structure, &options, |_| {})?;
    let results = Results::new(&set_up.description, set_up.pipeline.as_ref(), &frame.program, &frame.counts)?;
    Ok(Row::new(
        row::Run {
            preset: &args.preset,
            scene,
            structure: job.structure.name(),
            test: job.test.name(),
            tms: set_up.description.chip.tms(),
            series: job.series,
            load_words: job.load_words,
            node_bytes: structure.node_bytes(),
            fingerprint,
        },
        &options,
        &frame,
        &results,
    ))
}
