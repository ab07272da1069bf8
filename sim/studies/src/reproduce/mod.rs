//! The main job: it writes all results to one folder, with a page that shows them.

mod page;
mod presets;
pub mod results;
mod stages;
mod tables;

use crate::artifacts::Artifacts;
use crate::input::{Built, display, quality_name};
use crate::progress::{Part, Progress};
use crate::trees;
use anyhow::{Context, ensure};
use golden::Mode;
use golden::structure::StructureKind;
use page::Pictures;
use presets::{PRESETS, Preset};
use render::{RenderOptions, Rendering, Test, render};
use results::{Document, RenderResult, SceneResult};
use scenes::Scene;
use scenes::procedural::{self, CATALOGUE, CatalogueEntry};
use stages::{Job, Outcome};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;
use view::picture::heatmap::{self, Quantity};
use view::picture::png;
use view::report::Picture;

pub use stages::{Command, Finding};

/// The structures whose heat maps the report shows.
const SHOWN: [StructureKind; 2] = [StructureKind::Bvh2, StructureKind::Dst];

/// The extent of the job, and the folder for its results.
#[derive(Clone, Debug)]
pub struct Options {
    /// `smoke`, `quick` or `paper`.
    pub preset: String,
    /// The folder that is filled.
    pub out: PathBuf,
    /// How plane distances are rounded.
    pub mode: Mode,
    /// Seed of scenes, samples and stimuli.
    pub seed: u64,
    /// Writes into the folder even if it holds files that the tool did not make.
    pub force: bool,
}

/// The results of the job.
#[derive(Debug)]
pub struct Reproduction {
    /// Trees and work of all scenes.
    pub document: Document,
    /// The paths of all files, in order.
    pub artifacts: Vec<String>,
    /// Seconds of the host.
    pub seconds: f64,
    /// The commands in which a check found a difference.
    pub differences: Vec<String>,
}

/// Does the main job, or continues one that was interrupted. `command` runs a command of the tool.
///
/// # Errors
/// There is no such preset, a part of the job fails, or a file cannot be written.
pub fn run(args: &Options, command: Command<'_>, progress: &dyn Progress) -> anyhow::Result<Reproduction> {
    let start = Instant::now();
    let preset = PRESETS.iter().find(|preset| preset.name == args.preset);
    let preset = preset.with_context(|| {
        format!("--preset {}: there is no such preset; name smoke, quick or paper", args.preset)
    })?;
    let mut artifacts = Artifacts::create(&args.out, args.force)?;
    let options = RenderOptions {
        seed: args.seed,
        mode: args.mode,
        count_work: true,
        ..RenderOptions::new(Test::Raycast, preset.measured_side, preset.measured_side)
    };
    let mut document = Document {
        preset: preset.name,
        version: env!("CARGO_PKG_VERSION"),
        mode: args.mode.name(),
        seed: args.seed,
        quality: quality_name(preset.quality),
        width: options.width,
        height: options.height,
        spp: options.samples,
        scenes: vec![],
    };
    let stages = (preset.stages)();
    let seconds: f64 = stages.iter().map(|stage| stage.seconds).sum();
    let parts = (stages.len() + CATALOGUE.len(), seconds + CATALOGUE.len() as f64 * preset.scene_seconds);
    let folders: BTreeSet<&str> = stages.iter().map(|stage| stage.folder.as_str()).collect();
    let name = format!("reproduce {} {}", preset.name, document.mode);
    progress.note(&format!(
        "finished parts are kept in {}; after an interruption the same command continues there",
        args.out.display()
    ));
    let mut job =
        Job::begin(&args.out, &name, (args.seed, command, progress), &mut artifacts, parts, &folders)?;
    for entry in CATALOGUE {
        let part = format!("scene-{}", entry.name);
        let result = job.part(&part, preset.scene_seconds, &mut artifacts, |artifacts| {
            scene_result(entry, preset, &options, progress, artifacts)
        })?;
        for file in files(entry.name) {
            ensure!(
                artifacts.keep(&file),
                "{}: a file of the interrupted run is missing; remove {0}/stages to begin anew",
                args.out.display()
            );
        }
        document.scenes.push(result);
    }
    let mut outcomes: Vec<(String, Outcome)> = vec![];
    for stage in &stages {
        let outcome = job.run(stage, &mut artifacts)?;
        outcomes.push((stage.name.clone(), outcome));
    }
    let pictures = Pictures::read(&args.out)?;
    artifacts.write("trees.csv", &tables::trees_csv(&document)?)?;
    artifacts.write("work.csv", &tables::work_csv(&document)?)?;
    artifacts.write("results.json", format!("{}\n", serde_json::to_string_pretty(&document)?).as_bytes())?;
    let results = page::Results { document: &document, outcomes: &outcomes, folder: &args.out };
    artifacts.write("report/index.html", results.page(pictures)?.html().as_bytes())?;
    job.finish(&mut artifacts);
    let mut paths: Vec<String> = artifacts.finish()?.iter().map(|path| display(path)).collect();
    let of_stages = outcomes.iter().filter_map(|(_, outcome)| outcome.report["artifacts"].as_array());
    paths.extend(of_stages.flatten().filter_map(|path| path.as_str().map(str::to_owned)));
    let seconds = start.elapsed().as_secs_f64();
    let differences = outcomes.into_iter().filter(|(_, outcome)| outcome.difference);
    let differences = differences.map(|(_, outcome)| outcome.command).collect();
    Ok(Reproduction { document, artifacts: paths, seconds, differences })
}

/// Trees, work and pictures of one scene.
fn scene_result(
    entry: &CatalogueEntry,
    preset: &Preset,
    options: &RenderOptions,
    progress: &dyn Progress,
    artifacts: &mut Artifacts,
) -> anyhow::Result<SceneResult> {
    let full = procedural::count_triangles(entry.name, 1.0, options.seed)?;
    let detail = (preset.triangles / full as f64).min(1.0);
    let steps = Test::ALL.len() * (StructureKind::ALL.len() + 1) + 1;
    let part = Part::begin(progress, steps as u64, entry.name);
    let scene = procedural::build(entry.name, detail, options.seed)?;
    let built = Built::new(&scene, preset.quality, progress)?;
    let structures = trees::rows(&built)?;
    part.advance(1);
    let renders = renders(&scene, &built, preset, options, artifacts, || part.advance(1))?;
    Ok(SceneResult {
        scene: scene.name,
        stands_for: entry.stands_for.into(),
        detail,
        triangles: scene.mesh.triangles.len(),
        structures,
        renders,
    })
}

/// The pictures and heat maps of a scene.
fn files(scene: &str) -> Vec<String> {
    let of_test = |test: Test| {
        let maps = StructureKind::ALL.map(|kind| heat_map_file(scene, test, kind));
        maps.into_iter().chain([image_file(scene, test)])
    };
    Test::ALL.into_iter().flat_map(of_test).collect()
}

fn heat_map_file(scene: &str, test: Test, kind: StructureKind) -> String {
    format!("heatmaps/{scene}-{test}-{kind}.png")
}

fn image_file(scene: &str, test: Test) -> String {
    format!("images/{scene}-{test}.png")
}

impl Pictures {
    /// Reads the pictures that the page shows.
    fn read(folder: &Path) -> anyhow::Result<Self> {
        let picture = |file: &str, caption: String| -> anyhow::Result<Picture> {
            let path = folder.join(file);
            Ok(Picture { png: fs::read(&path).with_context(|| display(&path))?, caption })
        };
        let mut pictures = Self { images: vec![], heat_maps: vec![] };
        for entry in CATALOGUE {
            let name = entry.name;
            pictures.images.push(picture(&image_file(name, Test::Path), name.to_owned())?);
            for kind in SHOWN {
                let caption = format!("{name}: {}, {kind}", Quantity::NodeVisits);
                pictures.heat_maps.push(picture(&heat_map_file(name, Test::Path, kind), caption)?);
            }
        }
        Ok(pictures)
    }
}

/// Measures both tests in every structure, checks that all structures give the same picture, and writes heat maps and pictures.
fn renders(
    scene: &Scene,
    built: &Built,
    preset: &Preset,
    options: &RenderOptions,
    artifacts: &mut Artifacts,
    done: impl Fn(),
) -> anyhow::Result<Vec<RenderResult>> {
    let mut results = vec![];
    for test in Test::ALL {
        let options = RenderOptions { test, ..*options };
        let mut renderings = vec![];
        for kind in StructureKind::ALL {
            let (structure, _) = built.convert(kind)?;
            let rendering = render(&structure, scene, &options, |_| {})?;
            results.push(RenderResult::new(kind, test, &rendering));
            renderings.push((kind, rendering));
            done();
        }
        let (_, first) = &renderings[0];
        // One scale for all structures, so that the maps can be compared.
        let quantity = Quantity::NodeVisits;
        let scale_max = renderings.iter().map(|(_, rendering)| quantity.max(rendering)).max();
        for (kind, rendering) in &renderings {
            ensure!(
                same_picture(first, rendering),
                "{} {test}: {kind} gives another picture than {}; this is a defect of the program",
                scene.name,
                StructureKind::ALL[0]
            );
            let map = heatmap::of_rendering(rendering, quantity, scale_max);
            let map = png::encode(&map);
            artifacts.write(&heat_map_file(&scene.name, test, *kind), &map)?;
        }
        let (structure, _) = built.convert(StructureKind::Dst)?;
        let options = RenderOptions {
            width: preset.picture_side,
            height: preset.picture_side,
            samples: preset.picture_samples,
            count_work: false,
            ..options
        };
        let rendering = render(&structure, scene, &options, |_| {})?;
        let picture = png::encode(&png::develop(&rendering, 0.0));
        artifacts.write(&image_file(&scene.name, test), &picture)?;
        done();
    }
    Ok(results)
}

/// Whether two renderings are equal bit for bit, except for their counters of work.
fn same_picture(a: &Rendering, b: &Rendering) -> bool {
    let bits = |r: &Rendering| {
        let pixel = |p: &render::Pixel| {
            (p.rgb.map(f32::to_bits), p.depth.to_bits(), p.normal.map(f32::to_bits), p.triangle)
        };
        r.pixels.iter().map(pixel).collect::<Vec<_>>()
    };
    bits(a) == bits(b)
}
