//! `dualsplit reproduce`: the main job, all results in one folder.

mod page;
mod results;
mod tables;

use super::tree;
use crate::artifacts::Artifacts;
use crate::cli::{Global, ReproduceArgs, quality_name};
use crate::console::{Report, progress};
use crate::input::{Built, display};
use anyhow::ensure;
use golden::build::Quality;
use golden::render::{RenderOptions, Rendering, Test, render};
use golden::structure::StructureKind;
use page::Pictures;
use results::{Document, RenderResult, SceneResult};
use scenes::Scene;
use scenes::procedural::{self, CATALOGUE};
use serde::Serialize;
use sim::picture::heatmap::{self, Quantity};
use sim::picture::png;
use sim::report::Picture;
use std::time::Instant;

/// How large the job is.
struct Preset {
    name: &'static str,
    /// About this many triangles to a scene, but not fewer than its coarsest level has.
    triangles: f64,
    quality: Quality,
    /// Side of the renderings in which work is counted, in pixels, with one sample each.
    measured_side: u32,
    /// Side of the pictures.
    picture_side: u32,
    picture_samples: u32,
}

const PRESETS: [Preset; 2] = [
    // To see in seconds whether everything works.
    Preset {
        name: "smoke",
        triangles: 1.0,
        quality: Quality::Fast,
        measured_side: 24,
        picture_side: 48,
        picture_samples: 1,
    },
    // Two minutes on two cores are plenty for it.
    Preset {
        name: "quick",
        triangles: 60_000.0,
        quality: Quality::High,
        measured_side: 192,
        picture_side: 320,
        picture_samples: 8,
    },
];

/// The structures whose heat maps the report shows.
const SHOWN: [StructureKind; 2] = [StructureKind::Bvh2, StructureKind::Dst];

#[derive(Serialize)]
struct Artifact {
    artifacts: Vec<String>,
    mode: &'static str,
    seconds: f64,
}

pub fn run(args: &ReproduceArgs, global: &Global) -> anyhow::Result<Report> {
    let start = Instant::now();
    let preset = PRESETS.iter().find(|preset| preset.name == args.preset).expect("a possible value");
    let mut artifacts = Artifacts::create(&args.out, global.force)?;
    let options = RenderOptions {
        seed: global.seed,
        mode: args.mode.mode,
        count_work: true,
        ..RenderOptions::new(Test::Raycast, preset.measured_side, preset.measured_side)
    };
    let mut document = Document {
        preset: preset.name,
        version: env!("CARGO_PKG_VERSION"),
        mode: args.mode.mode.name(),
        seed: global.seed,
        quality: quality_name(preset.quality),
        width: options.width,
        height: options.height,
        spp: options.samples,
        scenes: vec![],
    };
    let steps = CATALOGUE.len() * (Test::ALL.len() * (StructureKind::ALL.len() + 1) + 1);
    let mut pictures = Pictures { images: vec![], heat_maps: vec![] };
    let bar = progress(steps as u64, "scenes, trees, pictures");
    for entry in CATALOGUE {
        let full = procedural::count_triangles(entry.name, 1.0, global.seed)?;
        let detail = (preset.triangles / full as f64).min(1.0);
        bar.set_message(entry.name);
        let scene = procedural::build(entry.name, detail, global.seed)?;
        let built = Built::new(&scene, preset.quality)?;
        let structures = tree::rows(&built)?;
        bar.inc(1);
        let renders =
            renders(&scene, &built, preset, &options, &mut artifacts, &mut pictures, || bar.inc(1))?;
        document.scenes.push(SceneResult {
            scene: scene.name,
            stands_for: entry.stands_for,
            detail,
            triangles: scene.mesh.triangles.len(),
            structures,
            renders,
        });
    }
    bar.finish_and_clear();
    artifacts.write("trees.csv", &tables::trees_csv(&document)?)?;
    artifacts.write("work.csv", &tables::work_csv(&document)?)?;
    artifacts.write("results.json", format!("{}\n", serde_json::to_string_pretty(&document)?).as_bytes())?;
    artifacts.write("report/index.html", page::page(&document, pictures)?.html().as_bytes())?;
    let artifacts: Vec<String> = artifacts.finish()?.iter().map(|path| display(path)).collect();
    let seconds = start.elapsed().as_secs_f64();
    let mut text = tables::text(&document);
    text += &format!("\n{} files in {}, {seconds:.1} s\n", artifacts.len(), args.out.display());
    Ok(Report::new(&Artifact { artifacts, mode: document.mode, seconds }, text))
}

/// Measures both tests in every structure, makes sure that all give one picture, and writes heat maps and pictures.
fn renders(
    scene: &Scene,
    built: &Built,
    preset: &Preset,
    options: &RenderOptions,
    artifacts: &mut Artifacts,
    pictures: &mut Pictures,
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
            artifacts.write(&format!("heatmaps/{}-{test}-{kind}.png", scene.name), &map)?;
            if test == Test::Path && SHOWN.contains(kind) {
                let caption = format!("{}: {quantity}, {kind}", scene.name);
                pictures.heat_maps.push(Picture { png: map, caption });
            }
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
        artifacts.write(&format!("images/{}-{test}.png", scene.name), &picture)?;
        if test == Test::Path {
            pictures.images.push(Picture { png: picture, caption: scene.name.clone() });
        }
        done();
    }
    Ok(results)
}

/// Whether two renderings are equal bit for bit in all but the work that they took.
fn same_picture(a: &Rendering, b: &Rendering) -> bool {
    let bits = |r: &Rendering| {
        let pixel = |p: &golden::render::Pixel| {
            (p.rgb.map(f32::to_bits), p.depth.to_bits(), p.normal.map(f32::to_bits), p.triangle)
        };
        r.pixels.iter().map(pixel).collect::<Vec<_>>()
    };
    bits(a) == bits(b)
}
