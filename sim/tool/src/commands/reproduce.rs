//! `dualsplit reproduce`: the main job, which writes all results to one folder.

use crate::cli::{Cli, Global, ReproduceArgs};
use crate::console::{self, Bars, Report, fixed, table};
use anyhow::bail;
use clap::Parser;
use serde::Serialize;
use std::ffi::OsString;
use studies::reproduce::results::Document;
use studies::reproduce::{self, Finding, Options};

#[derive(Serialize)]
struct Facts {
    mode: &'static str,
    seconds: f64,
}

/// Runs the job; `dispatch` runs each command that it consists of.
pub fn run(
    args: &ReproduceArgs,
    global: &Global,
    dispatch: fn(&crate::cli::Command, &Global) -> anyhow::Result<Report>,
) -> anyhow::Result<Report> {
    let options = Options {
        preset: args.preset.clone(),
        out: args.out.clone(),
        mode: args.mode.mode,
        seed: global.seed(),
        force: global.force,
    };
    let of_parts = Global { json: true, force: false, ..global.clone() };
    let command = |words: &[OsString]| {
        let cli = Cli::try_parse_from(words)?;
        let Some(command) = &cli.command else { bail!("no command") };
        let of_part = Global { seed: cli.global.seed, words: words[1..].to_vec(), ..of_parts.clone() };
        let report = dispatch(command, &of_part)?;
        Ok(Finding {
            report: serde_json::from_str(
                &report.render(true, &console::command(words[1..].iter().cloned())),
            )?,
            difference: report.difference,
        })
    };
    let done = reproduce::run(&options, &command, &Bars::new(global.quiet))?;
    let mut text = text(&done.document);
    for command in &done.differences {
        text += &format!("\nA check found a difference: {command}\n");
    }
    let (files, seconds) = (done.artifacts.len(), done.seconds);
    text += &format!("\n{files} files in {}, {seconds:.1} s\n", args.out.display());
    let facts = Facts { mode: done.document.mode, seconds };
    let mut report = Report::new(&facts, text, done.artifacts).in_folder(args.out.clone());
    report.difference = !done.differences.is_empty();
    Ok(report)
}

/// Trees and work as tables.
fn text(d: &Document) -> String {
    let mut text = format!("Trees: {} quality, seed {}\n\n", d.quality, d.seed);
    let header =
        ["scene", "triangles", "structure", "nodes", "bytes/triangle", "of bvh2", "SAH", "expected visits"];
    let rows = d.scenes.iter().flat_map(|result| {
        let reference = result.structures[0].bytes.max(1) as f64;
        result.structures.iter().map(move |s| {
            [
                result.scene.clone(),
                result.triangles.to_string(),
                s.name.to_string(),
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
                r.test.to_string(),
                r.structure.to_string(),
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
