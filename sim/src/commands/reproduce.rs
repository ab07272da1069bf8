//! `dualsplit reproduce`: the main job, all results in one folder.

use super::tree::{self, StructureRow};
use super::work::ClassRow;
use crate::artifacts::Artifacts;
use crate::cli::{Global, ReproduceArgs, quality_name};
use crate::console::{Report, fixed, progress, table};
use crate::input::{Built, display};
use anyhow::ensure;
use golden::build::Quality;
use golden::render::{RenderOptions, Rendering, Test, render};
use golden::structure::StructureKind;
use scenes::Scene;
use scenes::procedural::{self, CATALOGUE};
use serde::Serialize;
use sim::picture::heatmap::{self, Quantity};
use sim::picture::png;
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

#[derive(Serialize)]
struct Document {
    preset: &'static str,
    version: &'static str,
    mode: &'static str,
    seed: u64,
    quality: &'static str,
    width: u32,
    height: u32,
    spp: u32,
    scenes: Vec<SceneResult>,
}

#[derive(Serialize)]
struct SceneResult {
    scene: String,
    stands_for: &'static str,
    detail: f64,
    triangles: usize,
    structures: Vec<StructureRow>,
    renders: Vec<RenderResult>,
}

#[derive(Serialize)]
struct RenderResult {
    structure: &'static str,
    test: &'static str,
    rays: u64,
    hits: u64,
    node_visits_per_ray: f64,
    plane_tests_per_ray: f64,
    triangle_tests_per_ray: f64,
    bytes_per_ray: f64,
    stack_depth: u32,
    classes: Vec<ClassRow>,
}

impl RenderResult {
    fn new(kind: StructureKind, test: Test, rendering: &Rendering) -> Self {
        let total = rendering.total();
        let per_ray = |x: u64| x as f64 / total.rays.max(1) as f64;
        Self {
            structure: kind.name(),
            test: test.name(),
            rays: total.rays,
            hits: total.hits,
            node_visits_per_ray: per_ray(total.counters.node_visits),
            plane_tests_per_ray: per_ray(total.counters.plane_tests),
            triangle_tests_per_ray: per_ray(total.counters.triangle_tests),
            bytes_per_ray: per_ray(total.counters.bytes),
            stack_depth: total.counters.stack_depth,
            classes: rendering.classes().map(|(class, totals)| ClassRow::new(class, totals, true)).collect(),
        }
    }
}

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
    let bar = progress(steps as u64, "scenes, trees, pictures");
    for entry in CATALOGUE {
        let full = procedural::count_triangles(entry.name, 1.0, global.seed)?;
        let detail = (preset.triangles / full as f64).min(1.0);
        bar.set_message(entry.name);
        let scene = procedural::build(entry.name, detail, global.seed)?;
        let built = Built::new(&scene, preset.quality)?;
        let structures = tree::rows(&built)?;
        bar.inc(1);
        let renders = renders(&scene, &built, preset, &options, &mut artifacts, || bar.inc(1))?;
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
    artifacts.write("trees.csv", &trees_csv(&document)?)?;
    artifacts.write("work.csv", &work_csv(&document)?)?;
    artifacts.write("results.json", format!("{}\n", serde_json::to_string_pretty(&document)?).as_bytes())?;
    let artifacts: Vec<String> = artifacts.finish()?.iter().map(|path| display(path)).collect();
    let seconds = start.elapsed().as_secs_f64();
    let mut text = text(&document);
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
            artifacts.write(&format!("heatmaps/{}-{test}-{kind}.png", scene.name), &png::encode(&map))?;
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

#[derive(Serialize)]
struct TreeLine<'a> {
    scene: &'a str,
    triangles: usize,
    structure: &'a str,
    nodes: u64,
    leaves: u64,
    bytes: u64,
    bytes_per_triangle: f64,
    sah_cost: f64,
    expected_node_visits: f64,
    max_depth: u32,
    build_ms: f64,
    convert_ms: f64,
    carve_nodes_per_split: Option<f64>,
}

fn trees_csv(document: &Document) -> anyhow::Result<Vec<u8>> {
    let mut csv = csv::Writer::from_writer(vec![]);
    for result in &document.scenes {
        for s in &result.structures {
            csv.serialize(TreeLine {
                scene: &result.scene,
                triangles: result.triangles,
                structure: s.name,
                nodes: s.nodes,
                leaves: s.leaves,
                bytes: s.bytes,
                bytes_per_triangle: s.bytes_per_triangle,
                sah_cost: s.sah_cost,
                expected_node_visits: s.expected_node_visits,
                max_depth: s.max_depth,
                build_ms: s.build_ms,
                convert_ms: s.convert_ms,
                carve_nodes_per_split: s.carve_nodes_per_split,
            })?;
        }
    }
    Ok(csv.into_inner()?)
}

#[derive(Serialize)]
struct WorkLine<'a> {
    scene: &'a str,
    test: &'a str,
    structure: &'a str,
    mode: &'a str,
    class: &'a str,
    rays: u64,
    hits: u64,
    node_visits: u64,
    plane_tests: u64,
    box_tests: u64,
    triangle_tests: u64,
    bytes: u64,
    stack_depth: u32,
}

fn work_csv(document: &Document) -> anyhow::Result<Vec<u8>> {
    let mut csv = csv::Writer::from_writer(vec![]);
    for result in &document.scenes {
        for render in &result.renders {
            for (c, counters) in render.classes.iter().filter_map(|c| Some((c, c.counters?))) {
                csv.serialize(WorkLine {
                    scene: &result.scene,
                    test: render.test,
                    structure: render.structure,
                    mode: document.mode,
                    class: &c.class,
                    rays: c.rays,
                    hits: c.hits,
                    node_visits: counters.node_visits,
                    plane_tests: counters.plane_tests,
                    box_tests: counters.box_tests,
                    triangle_tests: counters.triangle_tests,
                    bytes: counters.bytes,
                    stack_depth: counters.stack_depth,
                })?;
            }
        }
    }
    Ok(csv.into_inner()?)
}

fn text(document: &Document) -> String {
    let d = document;
    let mut text = format!("Trees: {} quality, seed {}\n\n", d.quality, d.seed);
    let header =
        ["scene", "triangles", "structure", "nodes", "bytes/triangle", "of bvh2", "SAH", "expected visits"];
    let rows = d.scenes.iter().flat_map(|result| {
        let reference = result.structures[0].bytes.max(1) as f64;
        result.structures.iter().map(move |s| {
            [
                result.scene.clone(),
                result.triangles.to_string(),
                s.name.to_owned(),
                s.nodes.to_string(),
                fixed(s.bytes_per_triangle, 2),
                fixed(s.bytes as f64 / reference, 3),
                fixed(s.sah_cost, 2),
                fixed(s.expected_node_visits, 2),
            ]
        })
    });
    text += &table(header, rows);
    text += &format!(
        "\nTraversal work per ray: {}x{}, {} sample(s) per pixel, {} mode; all structures gave the same pictures\n\n",
        d.width, d.height, d.spp, d.mode
    );
    let header = [
        "scene",
        "test",
        "structure",
        "rays",
        "node visits",
        "plane tests",
        "triangle tests",
        "bytes",
        "stack depth",
    ];
    let rows = d.scenes.iter().flat_map(|result| {
        result.renders.iter().map(|r| {
            [
                result.scene.clone(),
                r.test.to_owned(),
                r.structure.to_owned(),
                r.rays.to_string(),
                fixed(r.node_visits_per_ray, 2),
                fixed(r.plane_tests_per_ray, 2),
                fixed(r.triangle_tests_per_ray, 2),
                fixed(r.bytes_per_ray, 1),
                r.stack_depth.to_string(),
            ]
        })
    });
    text += &table(header, rows);
    text
}
