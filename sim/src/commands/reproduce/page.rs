//! The main job's report, `report/index.html`.

use super::results::{Document, RenderResult, SceneResult};
use golden::render::Test;
use golden::structure::StructureKind;
use hdl::catalogue::{StandardFormat, Top};
use sim::plot::{Bars, number};
use sim::report::{Figure, Item, Page, Picture, Section, Table};
use sim::unit_costs::{SOURCE, Unit};

/// Pictures that the page shows: its caption and a PNG file's bytes.
pub struct Pictures {
    /// The path-traced picture of each scene.
    pub images: Vec<Picture>,
    /// Heat maps of node visits.
    pub heat_maps: Vec<Picture>,
}

const COMMAND: &str = "dualsplit reproduce";

/// The page, in which files are named relative to its folder.
pub fn page(document: &Document, pictures: Pictures) -> anyhow::Result<Page> {
    let scenes = document.scenes.len();
    let sample = format!(
        "This run: {scenes} built-in scenes of about {} triangles each, {} x {} pixels with {} sample(s) each where work \
         is counted, {} mode, seed {}.",
        document.scenes.iter().map(|s| s.triangles).max().unwrap_or(0),
        document.width,
        document.height,
        document.spp,
        document.mode,
        document.seed
    );
    Ok(Page {
        title: "Dual-split trees against bounding volume hierarchies".into(),
        summary: vec![
            "A dual-split tree holds exactly the space partitioning of a bounding volume hierarchy in 12-byte nodes with \
             two planes each: split nodes cut the parent box in two, carve nodes cut empty space off it. Its nodes are \
             slow to decode in software and cheap in hardware."
                .into(),
            "dualsplit builds both sides: the trees and an exact traversal as the specification, the pipelines as \
             synthesizable modules that equal it bit for bit, and measures what that saves."
                .into(),
            sample,
        ],
        sections: vec![trees(document), work(document), pipelines()?, scene_pictures(pictures)],
    })
}

/// One series for each structure, a value for each scene.
fn by_structure<'a>(
    document: &'a Document,
    value: impl Fn(&'a SceneResult, StructureKind) -> Option<f64>,
) -> Vec<(String, Vec<Option<f64>>)> {
    let series = |kind: StructureKind| {
        (kind.name().to_owned(), document.scenes.iter().map(|scene| value(scene, kind)).collect())
    };
    StructureKind::ALL.into_iter().map(series).collect()
}

fn scene_names(document: &Document) -> Vec<String> {
    document.scenes.iter().map(|scene| scene.scene.clone()).collect()
}

fn trees(document: &Document) -> Section {
    let structure = |scene: &SceneResult, kind: StructureKind| {
        scene.structures.iter().position(|s| s.name == kind.name()).map(|at| scene.structures[at].clone())
    };
    let bars = Bars {
        title: "Size of the tree".into(),
        unit: "bytes per triangle".into(),
        categories: scene_names(document),
        series: by_structure(document, |scene, kind| Some(structure(scene, kind)?.bytes_per_triangle)),
        ..Bars::default()
    };
    let rows = document.scenes.iter().filter_map(|scene| {
        let (bvh2, dst) = (structure(scene, StructureKind::Bvh2)?, structure(scene, StructureKind::Dst)?);
        Some([
            scene.scene.clone(),
            scene.stands_for.to_owned(),
            scene.triangles.to_string(),
            format!("{:.3}", dst.bytes as f64 / bvh2.bytes.max(1) as f64),
            format!("{:.2}", dst.carve_nodes_per_split.unwrap_or_default()),
            number(bvh2.sah_cost),
            dst.max_depth.to_string(),
        ])
    });
    let header = [
        "scene",
        "stands for",
        "triangles",
        "bytes, DST / BVH2",
        "carves per split",
        "SAH",
        "depth of the DST",
    ];
    Section {
        title: "Trees".into(),
        text: vec![
            "All structures partition space alike; only the format differs: 28 bytes for a box, 12 for a dual-split node, 4 \
             for its bare leaf."
                .into(),
        ],
        items: vec![
            Item::Figure(Figure {
                svg: bars.svg(),
                caption: "Nodes without their triangles.".into(),
                csv: "../trees.csv".into(),
                command: COMMAND.into(),
            }),
            Item::Table(Table::new(header, rows).from("../trees.csv", COMMAND)),
        ],
    }
}

fn work(document: &Document) -> Section {
    let figure = |test: Test, title: &str, unit: &str, value: fn(&RenderResult) -> f64| {
        let of = |scene: &SceneResult, test: &str, kind: StructureKind| {
            scene.renders.iter().find(|r| r.test == test && r.structure == kind.name()).map(value)
        };
        let largest = document.scenes.iter().flat_map(|scene| &scene.renders).map(value).fold(0.0, f64::max);
        let bars = Bars {
            title: format!("{title}, {}", test.name()),
            unit: unit.into(),
            categories: scene_names(document),
            series: by_structure(document, |scene, kind| of(scene, test.name(), kind)),
            max: Some(largest),
            ..Bars::default()
        };
        Item::Figure(Figure {
            svg: bars.svg(),
            caption: "Mean of all rays of the test; both tests on one scale.".into(),
            csv: "../work.csv".into(),
            command: COMMAND.into(),
        })
    };
    let mut items = vec![];
    for test in Test::ALL {
        items.push(figure(test, "Nodes and triangles read", "bytes per ray", |r| r.bytes_per_ray));
    }
    for test in Test::ALL {
        items.push(figure(test, "Planes tested", "per ray", |r| r.plane_tests_per_ray));
    }
    Section {
        title: "Traversal work".into(),
        text: vec![
            "raycast traces primary and shadow rays, path adds five diffuse bounces. Every structure gave the same \
             picture, bit for bit."
                .into(),
        ],
        items,
    }
}

/// What is published of a pipeline as a whole, in mm2 and nJ (HPG 2020, table 1).
fn published(top: Top) -> Option<(f64, f64)> {
    match top {
        Top::DualSplit => Some((0.0498, 0.0610)),
        Top::RayBox => Some((0.1278, 0.1377)),
        _ => None,
    }
}

fn pipelines() -> anyhow::Result<Section> {
    let mut rows = vec![];
    for top in [Top::DualSplit, Top::DualSplitLean, Top::RayBox, Top::RayBoxLean] {
        let inventory = hdl::netlist::inventory(&top.design(StandardFormat::Binary32)?)?;
        let units =
            || inventory.units.iter().filter_map(|(kind, &n)| Some((Unit::of_module(kind)?, f64::from(n))));
        let sum = |cost: fn(Unit) -> f64| units().map(|(unit, n)| n * cost(unit)).sum::<f64>();
        let count = |kind: &str| inventory.units.get(kind).copied().unwrap_or(0).to_string();
        let (area, energy) =
            published(top).map_or((String::new(), String::new()), |(a, e)| (a.to_string(), e.to_string()));
        rows.push([
            top.name().to_owned(),
            count("int_add"),
            count("fp_add"),
            count("fp_mul"),
            count("fp_min_max"),
            count("fp_cmp"),
            inventory.latency_cycles.map(|n| n.to_string()).unwrap_or_default(),
            format!("{:.4}", sum(|unit| unit.published().area_um2) / 1e6),
            format!("{:.4}", sum(|unit| unit.published().energy_pj) / 1e3),
            area,
            energy,
            inventory.register_bits.to_string(),
        ]);
    }
    let header = [
        "pipeline",
        "INTADD",
        "FPADD",
        "FPMUL",
        "FPMIN/MAX",
        "FPCMP",
        "latency (cycles)",
        "units (mm2)",
        "units (nJ)",
        "published (mm2)",
        "published (nJ)",
        "register bits",
    ];
    Ok(Section {
        title: "Units and pipelines".into(),
        text: vec![format!(
            "Counts and latency are read from the elaborated hardware. Area and energy of the units are sums of the {SOURCE}; \
             the published pipelines hold decoding logic besides."
        )],
        items: vec![Item::Table(Table::new(header, rows).from("", "cargo test -p hdl --test netlist"))],
    })
}

fn scene_pictures(pictures: Pictures) -> Section {
    Section {
        title: "Pictures".into(),
        text: vec!["Path-traced through the dual-split tree; then the nodes that each pixel's rays read, on one scale for all \
                    structures of a scene."
            .into()],
        items: vec![Item::Pictures(pictures.images), Item::Pictures(pictures.heat_maps)],
    }
}
