//! Sizes, costs and histograms of all structures over a scene. One of the structures can be saved.

use crate::input::{Built, SceneSource, check_outputs, display, quality_name};
use crate::progress::{Part, Progress};
use anyhow::Context;
use golden::build::{BuildOptions, Quality};
use golden::dst::build_for_dst;
use golden::stats::TreeStatistics;
use golden::structure::{Structure, StructureKind};
use golden::tree_file;
use scenes::{Bounds, MeshReport};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::path::PathBuf;

/// The kind of a tree, by how it is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TreeKind {
    /// A structure converted from the binary hierarchy, which all such trees have in common.
    Converted(StructureKind),
    /// The dual-split tree of a partition that is optimized for dual-split trees.
    DstScratch,
}

impl TreeKind {
    /// All kinds, in the order in which tables have them.
    pub const ALL: [Self; StructureKind::ALL.len() + 1] = {
        let mut all = [Self::DstScratch; StructureKind::ALL.len() + 1];
        let mut i = 0;
        while i < StructureKind::ALL.len() {
            all[i] = Self::Converted(StructureKind::ALL[i]);
            i += 1;
        }
        all
    };

    /// The name on the command line and in result files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converted(kind) => kind.name(),
            Self::DstScratch => "dst_scratch",
        }
    }
}

/// The scene, how its trees are built, and which tree is saved.
#[derive(Clone, Debug)]
pub struct Options {
    /// The scene.
    pub scene: SceneSource,
    /// How the trees are built.
    pub quality: Quality,
    /// Builds the dual-split tree of a partition of its own, which takes several times as long as the others, although it is not
    /// saved.
    pub scratch: bool,
    /// The kind of a tree, and the file that it is saved to.
    pub save: Option<(TreeKind, PathBuf)>,
    /// Replaces a file that exists.
    pub force: bool,
}

/// All structures over a scene.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Trees {
    pub scene: String,
    pub triangles: usize,
    pub bounds: Extent,
    /// Triangles of zero area.
    pub degenerate: usize,
    /// Triangles that have the same corners as an earlier one.
    pub duplicates: usize,
    pub quality: &'static str,
    pub structures: Vec<StructureRow>,
    #[serde(skip)]
    pub saved: Option<String>,
}

/// The box around all triangles.
#[derive(Clone, Copy, Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Extent {
    pub min: [f32; 3],
    pub max: [f32; 3],
}

/// One structure over one scene.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[allow(missing_docs, reason = "keys of result files, explained in golden's statistics")]
pub struct StructureRow {
    pub name: Cow<'static, str>,
    pub nodes: u64,
    pub leaves: u64,
    pub bytes: u64,
    pub bytes_per_triangle: f64,
    pub sah_cost: f64,
    pub expected_node_visits: f64,
    pub expected_triangle_tests: f64,
    /// The sum of `expected_node_visits` and `expected_triangle_tests`.
    pub own_cost: f64,
    pub max_depth: u32,
    pub build_ms: f64,
    pub convert_ms: f64,
    /// Absent for structures without carve nodes, as are the histogram and the counts of carve nodes.
    pub carve_nodes_per_split: Option<f64>,
    pub single_carves: Option<u64>,
    pub dual_carves: Option<u64>,
    pub children_by_carves: Option<Vec<u64>>,
    pub leaves_by_depth: Vec<u64>,
    pub leaves_by_size: Vec<u64>,
}

impl StructureRow {
    fn new(row: TreeKind, structure: &Structure, build_ms: f64, convert_ms: f64) -> Self {
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

/// Converts `built` to every structure, and returns a description of each.
///
/// # Errors
/// A structure cannot hold so many nodes or triangles.
pub fn rows(built: &Built) -> anyhow::Result<Vec<StructureRow>> {
    let row = |kind| Ok(converted(built, kind)?.1);
    StructureKind::ALL.into_iter().map(row).collect()
}

fn converted(built: &Built, kind: StructureKind) -> anyhow::Result<(Structure, StructureRow)> {
    let (structure, convert_ms) = built.convert(kind)?;
    let row = StructureRow::new(TreeKind::Converted(kind), &structure, built.build_ms, convert_ms);
    Ok((structure, row))
}

/// Builds and describes all trees.
///
/// # Errors
/// The scene cannot be loaded, a tree cannot be built, or the file cannot be written.
pub fn run(options: &Options, progress: &dyn Progress) -> anyhow::Result<Trees> {
    let save = options.save.as_ref().map(|(_, file)| file.as_path());
    check_outputs(&[("--save", save)], options.force)?;
    let scene = options.scene.load(progress)?;
    let MeshReport { bounds, degenerate, duplicates, .. } = MeshReport::new(&scene.mesh);
    let Bounds { min, max } = bounds.context("the scene has no triangle")?;
    let quality = options.quality;
    let partition = Built::new(&scene, quality, progress)?;
    let mut structures = vec![];
    let saved = options.save.as_ref().map(|(kind, _)| *kind);
    let wanted = |kind: &TreeKind| *kind != TreeKind::DstScratch || options.scratch || saved == Some(*kind);
    for kind in TreeKind::ALL.into_iter().filter(wanted) {
        let (structure, described) = match kind {
            TreeKind::Converted(kind) => converted(&partition, kind)?,
            TreeKind::DstScratch => {
                let what = format!("building over {} for the dual-split tree", scene.name);
                let _part = Part::endless(progress, &what);
                let built = Built::with(&scene, || build_for_dst(&scene.mesh, &BuildOptions::new(quality)))?;
                let (structure, convert_ms) = built.convert(StructureKind::Dst)?;
                let described = StructureRow::new(kind, &structure, built.build_ms, convert_ms);
                (structure, described)
            }
        };
        if let Some((_, file)) = options.save.as_ref().filter(|(saved, _)| *saved == kind) {
            tree_file::save(&structure, file, options.force)?;
        }
        structures.push(described);
    }
    Ok(Trees {
        scene: scene.name,
        triangles: scene.mesh.triangles.len(),
        bounds: Extent { min, max },
        degenerate,
        duplicates,
        quality: quality_name(quality),
        structures,
        saved: options.save.as_ref().map(|(_, file)| display(file)),
    })
}
