//! `dualsplit tree`: sizes, costs and histograms of all structures, one of which can be saved.

use crate::cli::{Drawn, Global, TreeArgs};
use crate::console::{Bars, Report, fixed, table};
use std::fmt::Write;
use studies::input::display_all;
use studies::trees::{self, Options, StructureRow, Trees};

pub fn run(args: &TreeArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        scene: args.scene.source(Drawn::Scenes, global)?,
        quality: args.quality.quality,
        scratch: args.scratch,
        save: args.save.clone().map(|file| (args.structure, file)),
        force: global.force,
    };
    let trees = trees::run(&options, &Bars::new(global.quiet))?;
    Ok(Report::new(&trees, text(&trees), display_all(args.save.as_deref())))
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

/// The histograms of all structures side by side. Rows of zeros at either end are left out.
fn histogram(structures: &[StructureRow], label: &str, of: impl Fn(&StructureRow) -> &Vec<u64>) -> String {
    let count = |s, at: usize| of(s).get(at).copied().unwrap_or(0);
    let length = structures.iter().map(|s| of(s).len()).max().unwrap_or(0);
    let first = (0..length).find(|&at| structures.iter().any(|s| count(s, at) > 0)).unwrap_or(0);
    let header: Vec<&str> = [label].into_iter().chain(structures.iter().map(|s| &*s.name)).collect();
    let row = |at: usize| {
        [at.to_string()].into_iter().chain(structures.iter().map(move |s| count(s, at).to_string())).collect()
    };
    table(header, (first..length).map(row).collect::<Vec<Vec<String>>>())
}
