//! `dualsplit tree`: sizes, costs and histograms of all structures, one of which can be saved.

use crate::cli::{Global, TreeArgs};
use crate::console::{Bars, Report, fixed, table};
use std::fmt::Write;
use studies::trees::{self, Options, StructureRow, TreeKind, Trees};

pub fn run(args: &TreeArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        scene: args.scene.source(global),
        quality: args.quality.quality,
        save: args.save.clone().map(|file| (args.structure, file)),
        force: global.force,
    };
    let trees = trees::run(&options, &Bars::default())?;
    Ok(Report::new(&trees, text(&trees)))
}

fn text(trees: &Trees) -> String {
    let Trees { scene, triangles, bounds, degenerate, duplicates, quality, structures, saved } = trees;
    let corner = |p: [f32; 3]| p.map(|x| format!("{x:?}")).join(" ");
    let mut text = format!(
        "{scene}: {triangles} triangles, quality {quality}\n\
         from {} to {}; {degenerate} triangles of no area, {duplicates} repeated\n\n",
        corner(bounds.min),
        corner(bounds.max)
    );
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

/// Columns of a histogram: one for its label, and one for each structure.
const COLUMNS: usize = TreeKind::ALL.len() + 1;

/// The histograms of all structures side by side. Rows of zeros at either end are left out.
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
