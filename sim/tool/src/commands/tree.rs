//! `dualsplit tree`: sizes, costs and histograms of all structures; one can be saved.

use crate::cli::{Global, TreeArgs, TreeRow, quality_name};
use crate::console::{self, Report, fixed, table};
use crate::input::{self, Built, check_writable, display};
use golden::build::BuildOptions;
use golden::dst::build_for_dst;
use golden::stats::TreeStatistics;
use golden::structure::{Structure, StructureKind};
use golden::tree_file;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::fmt::Write;

#[derive(Serialize)]
struct Document {
    scene: String,
    triangles: usize,
    quality: &'static str,
    structures: Vec<StructureRow>,
    #[serde(skip_serializing_if = "Option::is_none")]
    saved: Option<String>,
}

/// One structure over one scene.
#[derive(Clone, Serialize, Deserialize)]
pub struct StructureRow {
    pub name: Cow<'static, str>,
    pub nodes: u64,
    pub leaves: u64,
    pub bytes: u64,
    pub bytes_per_triangle: f64,
    pub sah_cost: f64,
    pub expected_node_visits: f64,
    pub expected_triangle_tests: f64,
    /// The sum of the two.
    pub own_cost: f64,
    pub max_depth: u32,
    pub build_ms: f64,
    pub convert_ms: f64,
    /// Absent for structures without carve nodes, as are the histogram and counts of carves.
    pub carve_nodes_per_split: Option<f64>,
    pub single_carves: Option<u64>,
    pub dual_carves: Option<u64>,
    pub children_by_carves: Option<Vec<u64>>,
    pub leaves_by_depth: Vec<u64>,
    pub leaves_by_size: Vec<u64>,
}

impl StructureRow {
    fn new(row: TreeRow, structure: &Structure, build_ms: f64, convert_ms: f64) -> Self {
        let stats = TreeStatistics::of(structure);
        let carves = stats.carves;
        Self {
            name: row.name().into(),
            nodes: stats.nodes,
            leaves: stats.leaves,
            bytes: stats.bytes,
            bytes_per_triangle: stats.bytes as f64 / structure.triangles().len() as f64,
            sah_cost: stats.sah_cost,
            expected_node_visits: stats.expected_node_visits,
            expected_triangle_tests: stats.expected_triangle_tests,
            own_cost: stats.own_cost(),
            max_depth: stats.max_depth,
            build_ms,
            convert_ms,
            carve_nodes_per_split: carves.map(|c| c.per_split),
            single_carves: carves.map(|c| c.single),
            dual_carves: carves.map(|c| c.dual),
            children_by_carves: carves.map(|c| c.children_by_carves.to_vec()),
            leaves_by_depth: stats.leaves_by_depth,
            leaves_by_size: stats.leaves_by_size,
        }
    }
}

/// Converts `built` to every structure and describes it.
pub fn rows(built: &Built) -> anyhow::Result<Vec<StructureRow>> {
    let row = |kind| Ok(converted(built, kind)?.1);
    StructureKind::ALL.into_iter().map(row).collect()
}

fn converted(built: &Built, kind: StructureKind) -> anyhow::Result<(Structure, StructureRow)> {
    let (structure, convert_ms) = built.convert(kind)?;
    let row = StructureRow::new(TreeRow::Converted(kind), &structure, built.build_ms, convert_ms);
    Ok((structure, row))
}

pub fn run(args: &TreeArgs, global: &Global) -> anyhow::Result<Report> {
    if let Some(save) = &args.save {
        check_writable("--save", save, global.force)?;
    }
    let scene = input::scene(&args.scene, global)?;
    let quality = args.quality.quality;
    let partition = Built::new(&scene, quality)?;
    let mut structures = vec![];
    for row in TreeRow::ALL {
        let (structure, described) = match row {
            TreeRow::Converted(kind) => converted(&partition, kind)?,
            TreeRow::DstScratch => {
                let progress =
                    console::spinner(format!("building over {} for the dual-split tree", scene.name));
                let built = Built::with(&scene, || build_for_dst(&scene.mesh, &BuildOptions::new(quality)))?;
                let (structure, convert_ms) = built.convert(StructureKind::Dst)?;
                progress.finish_and_clear();
                let described = StructureRow::new(row, &structure, built.build_ms, convert_ms);
                (structure, described)
            }
        };
        if let (Some(save), true) = (&args.save, row == args.structure) {
            tree_file::save(&structure, save, global.force)?;
        }
        structures.push(described);
    }
    let document = Document {
        scene: scene.name,
        triangles: scene.mesh.triangles.len(),
        quality: quality_name(quality),
        structures,
        saved: args.save.as_deref().map(display),
    };
    let text = text(&document);
    Ok(Report::new(&document, text))
}

fn text(document: &Document) -> String {
    let Document { scene, triangles, quality, structures, saved } = document;
    let mut text = format!("{scene}: {triangles} triangles, quality {quality}\n\n");
    let header = [
        "structure",
        "nodes",
        "leaves",
        "bytes",
        "bytes/triangle",
        "SAH",
        "expected visits",
        "own cost",
        "max depth",
        "build ms",
        "convert ms",
        "carves/split",
    ];
    text += &table(
        header,
        structures.iter().map(|s| {
            [
                s.name.to_string(),
                s.nodes.to_string(),
                s.leaves.to_string(),
                s.bytes.to_string(),
                fixed(s.bytes_per_triangle, 2),
                fixed(s.sah_cost, 3),
                fixed(s.expected_node_visits, 2),
                fixed(s.own_cost, 2),
                s.max_depth.to_string(),
                fixed(s.build_ms, 1),
                fixed(s.convert_ms, 1),
                s.carve_nodes_per_split.map(|x| fixed(x, 3)).unwrap_or_default(),
            ]
        }),
    );
    text += "\nLeaves by depth (steps from the root)\n\n";
    text += &histogram(structures, "depth", |s| &s.leaves_by_depth);
    text += "\nLeaves by number of triangles\n\n";
    text += &histogram(structures, "triangles", |s| &s.leaves_by_size);
    for s in structures {
        if let (Some(by_carves), Some(single), Some(dual)) =
            (&s.children_by_carves, s.single_carves, s.dual_carves)
        {
            let _ = writeln!(
                text,
                "\nChildren by number of carve nodes ({}: {single} single, {dual} dual)\n",
                s.name
            );
            let rows = by_carves.iter().enumerate().map(|(n, count)| [n.to_string(), count.to_string()]);
            text += &table(["carves", "children"], rows);
        }
    }
    if let Some(saved) = saved {
        let _ = writeln!(text, "\nSaved to {saved}");
    }
    text
}

/// A histogram's label, and a column for each structure.
const COLUMNS: usize = TreeRow::ALL.len() + 1;

/// The histograms of all structures side by side; rows where all are zero at either end are left out.
fn histogram(structures: &[StructureRow], label: &str, of: impl Fn(&StructureRow) -> &Vec<u64>) -> String {
    let count = |s, at: usize| of(s).get(at).copied().unwrap_or(0);
    let length = structures.iter().map(|s| of(s).len()).max().unwrap_or(0);
    let first = (0..length).find(|&at| structures.iter().any(|s| count(s, at) > 0)).unwrap_or(0);
    let mut header = [""; COLUMNS];
    header[0] = label;
    for (cell, s) in header[1..].iter_mut().zip(structures) {
        *cell = &s.name;
    }
    let rows = (first..length).map(|at| {
        std::array::from_fn(|column| match column {
            0 => at.to_string(),
            _ => count(&structures[column - 1], at).to_string(),
        })
    });
    table::<{ COLUMNS }>(header, rows)
}
