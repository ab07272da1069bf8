//! `dualsplit study`: the paper's study of all scenes, structures and tests on the machine.

use crate::cli::{Global, StudyArgs};
use crate::console::{Bars, Report, fixed, table};
use studies::study::row::Row;
use studies::study::{self, Options, Study};

pub fn run(args: &StudyArgs, global: &Global) -> anyhow::Result<Report> {
    let options = Options {
        preset: args.preset.clone(),
        scene: args.scene.clone(),
        quality: args.quality.quality,
        machine: args.machine.machine.clone(),
        settings: args.machine.settings.clone(),
        pipeline_cost: args.cost.pipeline_cost.method(),
        out: args.out.clone(),
        seed: global.seed,
        force: global.force,
    };
    let study = study::run(&options, &Bars::default())?;
    Ok(Report::new(&study, tables(&study), study.artifacts.clone()))
}

/// All results of a study as tables.
fn tables(study: &Study) -> String {
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
    let rows = study.rows.iter().map(|row| {
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
    text += "\nFrame time by number of multiprocessors\n\n";
    text += &across(&study.scaling, |row| row.tms.to_string());
    text += "\nFrame time and energy by words of a load\n\n";
    text += &across(&study.load_width, |row| row.load_words.clone());
    text += "\nComparison with the published results\n\n";
    let claims = study.comparison.iter().map(|claim| {
        [claim.claim.clone(), claim.published.clone(), claim.ours.clone(), claim.holds.to_owned()]
    });
    text += &table(["claim", "published", "ours", "holds"], claims);
    text
}

/// A table with one line for each run of a series. `of` returns the quantity that the series varies.
fn across(rows: &[Row], of: fn(&Row) -> String) -> String {
    let header =
        ["scene", "test", "structure", "value", "frame ms", "energy mJ", "issue %", "data %", "halted %"];
    let line = |row: &Row| {
        [
            row.scene.clone(),
            row.test.clone(),
            row.structure.clone(),
            of(row),
            fixed(row.frame_ms, 4),
            fixed(row.energy_mj, 3),
            fixed(row.issue_pct, 1),
            fixed(row.data_pct, 1),
            fixed(row.halted_pct, 1),
        ]
    };
    table(header, rows.iter().map(line))
}
