//! The sections about the sizes of the trees and the work of traversing them.

use super::super::results::{Document, RenderResult, SceneResult};
use super::command;
use golden::structure::StructureKind;
use render::Test;
use view::plot::{Bars, number};
use view::report::{Figure, Item, Section, Table};

/// The structure that all others are compared with.
const REFERENCE: StructureKind = StructureKind::Dst;

/// A chart with the value of each structure in each scene, in multiples of the dual-split tree's.
fn ratios<'a>(
    document: &'a Document,
    (title, unit): (&str, &str),
    value: impl Fn(&'a SceneResult, StructureKind) -> Option<f64>,
) -> Bars {
    let values = |kind: StructureKind| -> Vec<Option<f64>> {
        document.scenes.iter().map(|scene| value(scene, kind)).collect()
    };
    let series = StructureKind::ALL.into_iter().map(|kind| (kind.name().to_owned(), values(kind)));
    let bars = Bars {
        title: title.to_owned(),
        unit: unit.to_owned(),
        categories: document.scenes.iter().map(|scene| scene.scene.clone()).collect(),
        series: series.collect(),
        ..Bars::default()
    };
    bars.in_multiples_of(REFERENCE.name(), &values(REFERENCE))
}

pub fn trees(document: &Document) -> Section {
    let structure = |scene: &SceneResult, kind: StructureKind| {
        scene.structures.iter().position(|s| s.name == kind.name()).map(|at| scene.structures[at].clone())
    };
    let bars = ratios(document, ("Size of the tree", "bytes per triangle"), |scene, kind| {
        Some(structure(scene, kind)?.bytes_per_triangle)
    });
    let rows = document.scenes.iter().filter_map(|scene| {
        let (bvh2, dst) = (structure(scene, StructureKind::Bvh2)?, structure(scene, StructureKind::Dst)?);
        Some([
            scene.scene.clone(),
            scene.stands_for.to_string(),
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
                caption: "Size of the tree: nodes without their triangles.".into(),
                csv: "../trees.csv".into(),
                command: command(document),
            }),
            Item::Table(Table::new("Scenes and their trees", header, rows).from("../trees.csv", &command(document))),
        ],
    }
}

pub fn work(document: &Document) -> Section {
    let figure = |test: Test, title: &str, unit: &str, value: fn(&RenderResult) -> f64| {
        let of = |scene: &SceneResult, test: &str, kind: StructureKind| {
            scene.renders.iter().find(|r| r.test == test && r.structure == kind.name()).map(value)
        };
        let heading = format!("{title}, {}", test.name());
        let bars = ratios(document, (&heading, unit), |scene, kind| of(scene, test.name(), kind));
        Item::Figure(Figure {
            svg: bars.svg(),
            caption: format!("{heading}: mean of all rays of the test."),
            csv: "../work.csv".into(),
            command: command(document),
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
