//! `dualsplit study`: the paper's study of all scenes, structures and tests on the machine.

use crate::cli::{Global, StudyArgs};
use crate::console::{Bars, Report, fixed, table};
use studies::study::row::Row;
use studies::study::sensitivity::{self, Sample, Sensitivity};
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
        seed: global.seed(),
        force: global.force,
    };
    if args.sensitivity {
        let size = Sample { machines: args.machines as usize, confirmed: args.confirm as usize };
        let found = sensitivity::run(&options, size, &Bars::new(global.quiet))?;
        let text = regions(&found);
        let artifacts = found.artifacts.clone();
        return Ok(Report::new(&found, text, artifacts).in_folder(args.out.join("sensitivity")));
    }
    let study = study::run(&options, &Bars::new(global.quiet))?;
    Ok(Report::new(&study, tables(&study), study.artifacts.clone()).in_folder(args.out.clone()))
}

/// The claims with the machines for which they hold.
fn regions(found: &Sensitivity) -> String {
    let percent = |share: f64| fixed(100.0 * share, 0);
    let rows = found.claims.iter().map(|claim| {
        let keys = claim.region.keys.iter().take(2).map(|key| {
            let scores = key.scores.iter().map(|(value, score)| format!("{value}: {}", fixed(*score, 2)));
            format!("{} ({})", key.key, scores.collect::<Vec<_>>().join(", "))
        });
        [
            claim.claim.clone(),
            claim.published.clone(),
            format!("{} ({})", claim.unchanged, claim.unchanged_holds),
            percent(claim.region.holds),
            percent(claim.region.partly),
            claim.region.verdict.clone(),
            keys.collect::<Vec<_>>().join("; "),
        ]
    });
    let header =
        ["claim", "published", "unchanged machine", "holds %", "partly %", "verdict", "mean score by key"];
    let mut text = table(header, rows);
    text += &format!(
        "\n{} machines; a score is 1 where the claim holds, 0.5 where it holds in some scenes, and 0 where it does not.\n",
        found.machines
    );
    if !found.confirmations.is_empty() {
        text += "\nSimulated as well\n\n";
        let rows = found.confirmations.iter().map(|of| {
            [
                of.machine.to_string(),
                of.frames.to_string(),
                fixed(of.mean_time_error_pct, 1),
                fixed(of.worst_time_error_pct, 1),
                fixed(of.worst_energy_error_pct, 1),
                format!("{} of {}", of.claims - of.judged_otherwise.len(), of.claims),
                of.judged_otherwise.join("; "),
            ]
        });
        let header = [
            "machine",
            "frames",
            "mean time error %",
            "worst time error %",
            "worst energy error %",
            "claims judged alike",
            "judged otherwise",
        ];
        text += &table(header, rows);
    }
    text
}

/// All results of a study as tables.
fn tables(study: &Study) -> String {
    let header = [
        "scene",
        "test",
        "structure",
        "alignment",
        "tree MB",
        "rays",
        "frame ms",
        "energy mJ",
        "DRAM mJ",
        "cache mJ",
        "compute mJ",
        "on-chip mJ",
        "execution mJ",
        "issue %",
        "data %",
    ];
    let rows = study.layout.iter().map(|row| {
        [
            row.scene.clone(),
            row.test.clone(),
            row.structure.clone(),
            row.alignment.clone(),
            fixed(row.node_bytes as f64 / 1e6, 2),
            row.rays.to_string(),
            fixed(row.frame_ms, 4),
            fixed(row.energy_mj, 3),
            fixed(row.dram_mj, 3),
            fixed(row.cache_mj, 3),
            fixed(row.compute_mj, 3),
            fixed(row.on_chip_mj, 3),
            fixed(row.execution_mj, 3),
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
