//! `dualsplit study`: the paper's study, all scenes, structures and tests on the machine.

mod comparison;
mod plots;
mod row;

use crate::artifacts::Artifacts;
use crate::cli::{Global, StudyArgs};
use crate::console::{Report, fixed, progress, table};
use crate::input::{Built, display};
use anyhow::{Context, bail};
use comparison::{Claim, compare};
use golden::render::{RenderOptions, Test};
use golden::structure::{Structure, StructureKind};
use rayon::prelude::*;
use row::Row;
use scenes::Scene;
use serde::Serialize;
use sim::estimate::Method;
use sim::machine::description::MachineDescription;
use sim::machine::frame::{FrameMachine, MachineStructure, frame};
use sim::machine::results::Results;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The size of a study.
struct Preset {
    /// Fraction of the scenes' triangles.
    detail: f64,
    width: u32,
    height: u32,
    /// Partitions and multiprocessors per partition.
    chip: [u32; 2],
    /// Multiprocessors of the scaling runs, in one partition each four.
    scaling_tms: &'static [u32],
}

fn preset(name: &str) -> Preset {
    match name {
        "paper" => Preset {
            detail: 1.0,
            width: 256,
            height: 256,
            chip: [4, 8],
            scaling_tms: &[1, 2, 4, 8, 16, 32, 64],
        },
        _ => Preset { detail: 0.02, width: 64, height: 64, chip: [1, 4], scaling_tms: &[1, 2, 4, 8] },
    }
}

/// The scene, test and structures of the scaling runs.
const SCALING_SCENE: &str = "atrium";
const SCALING_TEST: Test = Test::Path;
const SCALING_STRUCTURES: [MachineStructure; 4] =
    [MachineStructure::Dst, MachineStructure::Bvh2, MachineStructure::Bvh4, MachineStructure::Bvh8];

#[derive(Serialize)]
struct Document {
    preset: String,
    rows: Vec<Row>,
    scaling: Vec<Row>,
    comparison: Vec<Claim>,
    artifacts: Vec<String>,
}

/// One simulation.
#[derive(Clone, Copy)]
struct Job {
    structure: MachineStructure,
    test: Test,
    /// Partitions and multiprocessors per partition.
    chip: [u32; 2],
    scaling: bool,
}

pub fn run(args: &StudyArgs, global: &Global) -> anyhow::Result<Report> {
    let preset = preset(&args.preset);
    let names: Vec<&str> = scenes::procedural::CATALOGUE.iter().map(|entry| entry.name).collect();
    let chosen: Vec<&str> = match &args.scene {
        Some(scene) => match names.iter().find(|name| **name == scene.as_str()) {
            Some(name) => vec![*name],
            None => bail!("--scene {scene}: the study's scenes are {}", names.join(", ")),
        },
        None => names,
    };
    let mut artifacts = Artifacts::create(&args.out, global.force)?;
    let mut runs = finished(&args.out)?;
    for scene in chosen {
        simulate_scene(scene, &preset, args, global, &mut runs, &mut artifacts)?;
    }
    for (name, row) in &runs {
        artifacts.write(name, serde_json::to_string_pretty(row)?.as_bytes())?;
    }
    let of_preset = runs.into_values().filter(|row| row.preset == args.preset);
    let (scaling, rows): (Vec<Row>, Vec<Row>) = of_preset.partition(|row| row.scaling);
    let comparison = compare(&rows, &scaling);
    artifacts.write("study.csv", row::csv(rows.iter().chain(&scaling))?.as_bytes())?;
    artifacts.write("comparison.csv", comparison::csv(&comparison)?.as_bytes())?;
    for (name, svg) in plots::all(&rows, &scaling) {
        artifacts.write(&name, svg.as_bytes())?;
    }
    let mut document = Document { preset: args.preset.clone(), rows, scaling, comparison, artifacts: vec![] };
    let json = serde_json::to_string_pretty(&document)?;
    artifacts.write("study.json", json.as_bytes())?;
    document.artifacts = artifacts.finish()?.iter().map(|path| display(path)).collect();
    let text = text(&document);
    Ok(Report::new(&document, text))
}

/// The runs that an earlier study left in `folder`.
fn finished(folder: &Path) -> anyhow::Result<BTreeMap<String, Row>> {
    let mut runs = BTreeMap::new();
    let Ok(entries) = fs::read_dir(folder.join("runs")) else {
        return Ok(runs);
    };
    for entry in entries {
        let entry = entry?;
        let name = format!("runs/{}", entry.file_name().to_string_lossy());
        let text = fs::read_to_string(entry.path()).with_context(|| display(&entry.path()))?;
        // A file of an older version is made anew.
        if let Ok(row) = serde_json::from_str(&text) {
            runs.insert(name, row);
        }
    }
    Ok(runs)
}

fn simulate_scene(
    name: &str,
    preset: &Preset,
    args: &StudyArgs,
    global: &Global,
    runs: &mut BTreeMap<String, Row>,
    artifacts: &mut Artifacts,
) -> anyhow::Result<()> {
    let mut jobs = vec![];
    for test in Test::ALL {
        for structure in MachineStructure::ALL {
            jobs.push(Job { structure, test, chip: preset.chip, scaling: false });
        }
    }
    if name == SCALING_SCENE {
        for &tms in preset.scaling_tms {
            for structure in SCALING_STRUCTURES {
                let chip = [tms.div_ceil(8), tms.min(8)];
                jobs.push(Job { structure, test: SCALING_TEST, chip, scaling: true });
            }
        }
    }
    let machine = |job: &Job| {
        let mut settings = args.machine.settings.clone();
        settings.push(format!("chip.l2_partitions={}", job.chip[0]));
        settings.push(format!("chip.tms_per_partition={}", job.chip[1]));
        MachineDescription::load(&args.machine.machine, &settings)
    };
    let mut open = vec![];
    for job in jobs {
        let machine = machine(&job)?;
        let file = file_name(name, &args.preset, &job);
        let fingerprint = row::fingerprint(&machine, global.seed, preset.detail, preset.width, preset.height);
        if runs.get(&file).is_none_or(|row| row.fingerprint != fingerprint) {
            open.push((job, machine, file, fingerprint));
        }
    }
    if open.is_empty() {
        return Ok(());
    }
    let scene = Scene::load(name, preset.detail, global.seed)?;
    let built = Built::new(&scene, args.quality.quality)?;
    let structures = StructureKind::ALL
        .into_par_iter()
        .map(|kind| Ok(built.convert(kind)?.0))
        .collect::<anyhow::Result<Vec<Structure>>>()?;
    let bar = progress(open.len() as u64, name);
    // In batches, so that an interrupted study goes on where it was.
    for batch in open.chunks(rayon::current_num_threads().max(1)) {
        let done = batch
            .par_iter()
            .map(|(job, machine, file, fingerprint)| {
                let row = simulate_one(&scene, &structures, preset, args, global, job, machine, fingerprint)?;
                bar.inc(1);
                Ok((file.clone(), row))
            })
            .collect::<anyhow::Result<Vec<(String, Row)>>>()?;
        for (file, row) in done {
            artifacts.write(&file, serde_json::to_string_pretty(&row)?.as_bytes())?;
            runs.insert(file, row);
        }
    }
    bar.finish_and_clear();
    Ok(())
}

fn file_name(scene: &str, preset: &str, job: &Job) -> String {
    let scaling = if job.scaling { format!("-{}tms", job.chip[0] * job.chip[1]) } else { String::new() };
    let structure = job.structure.name().replace('+', "p");
    format!("runs/{preset}-{scene}-{}-{structure}{scaling}.json", job.test)
}

#[allow(clippy::too_many_arguments, reason = "everything that a run depends on")]
fn simulate_one(
    scene: &Scene,
    structures: &[Structure],
    preset: &Preset,
    args: &StudyArgs,
    global: &Global,
    job: &Job,
    machine: &MachineDescription,
    fingerprint: &str,
) -> anyhow::Result<Row> {
    let set_up = FrameMachine::new(machine, job.structure, Method::Published)?;
    let structure = structures.iter().find(|s| s.kind() == job.structure.kind()).expect("all kinds");
    let mut options = RenderOptions::new(job.test, preset.width, preset.height);
    options.seed = global.seed;
    let frame = frame(&set_up, scene, structure, &options, |_| {})?;
    let results = Results::new(&set_up.description, set_up.pipeline.as_ref(), &frame.program, &frame.counts)?;
    Ok(Row::new(
        row::Run {
            preset: &args.preset,
            scene,
            structure: job.structure.name(),
            test: job.test.name(),
            tms: machine.chip.tms(),
            scaling: job.scaling,
            node_bytes: structure.node_bytes(),
            fingerprint,
        },
        &options,
        &frame,
        &results,
    ))
}

fn text(document: &Document) -> String {
    let header = [
        "scene",
        "test",
        "structure",
        "tree MB",
        "rays",
        "frame ms",
        "energy mJ",
        "DRAM mJ",
        "cache mJ",
        "compute mJ",
        "issue %",
        "data %",
    ];
    let rows = document.rows.iter().map(|row| {
        [
            row.scene.clone(),
            row.test.clone(),
            row.structure.clone(),
            fixed(row.node_bytes as f64 / 1e6, 2),
            row.rays.to_string(),
            fixed(row.frame_ms, 4),
            fixed(row.energy_mj, 3),
            fixed(row.dram_mj, 3),
            fixed(row.cache_mj, 3),
            fixed(row.compute_mj, 3),
            fixed(row.issue_pct, 1),
            fixed(row.data_pct, 1),
        ]
    });
    let mut text = table(header, rows);
    text += "\nComparison with the published results\n\n";
    let claims = document.comparison.iter().map(|claim| {
        [claim.claim.clone(), claim.published.clone(), claim.ours.clone(), claim.holds.to_owned()]
    });
    text += &table(["claim", "published", "ours", "holds"], claims);
    text
}
