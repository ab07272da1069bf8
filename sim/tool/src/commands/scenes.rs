//! `dualsplit scenes`: the list of built-in scenes, and their export.

use crate::cli::{Global, ScenesArgs};
use crate::console::{Bars, Report, table};
use anyhow::{Context, ensure};
use scenes::procedural::{self, CATALOGUE};
use serde::Serialize;
use studies::input::{check_outputs, display};
use studies::progress::Part;

#[derive(Serialize)]
struct Document {
    scenes: Vec<Entry>,
    #[serde(skip_serializing_if = "Option::is_none")]
    exported: Option<Exported>,
}

#[derive(Serialize)]
struct Entry {
    name: &'static str,
    /// Number of triangles at full detail.
    triangles: usize,
    stands_for: &'static str,
    description: &'static str,
}

#[derive(Serialize)]
struct Exported {
    name: String,
    triangles: usize,
    detail: f64,
    seed: u64,
}

pub fn run(args: &ScenesArgs, global: &Global) -> anyhow::Result<Report> {
    let mut document = Document { scenes: CATALOGUE.iter().map(Entry::new).collect(), exported: None };
    let (Some(name), Some(path)) = (&args.name, &args.export) else {
        ensure!(
            args.detail.detail.is_none(),
            "--detail scales the scene that --export writes; name a scene and a file"
        );
        global.without_seed("the list of scenes")?;
        let rows = document.scenes.iter().map(|entry| {
            [entry.name, &entry.triangles.to_string(), entry.stands_for, entry.description].map(str::to_owned)
        });
        let text = table(["name", "triangles", "stands for", "what it is"], rows);
        return Ok(Report::new(&document, text, vec![]));
    };
    check_outputs(&[("--export", Some(path))], global.force)?;
    scenes::formats::written_format(path).context("--export")?;
    let bars = Bars::new(global.quiet);
    let part = Part::endless(&bars, &format!("making {name}"));
    let detail = args.detail.value();
    let scene = procedural::build(name, detail, global.seed())?;
    scenes::formats::save(path, name, &scene.mesh, global.force)?;
    drop(part);
    let triangles = scene.mesh.triangles.len();
    document.scenes.retain(|entry| entry.name == name);
    document.exported = Some(Exported { name: name.clone(), triangles, detail, seed: global.seed() });
    Ok(Report::new(&document, format!("{}: {triangles} triangles", path.display()), vec![display(path)]))
}

impl Entry {
    fn new(entry: &procedural::CatalogueEntry) -> Self {
        let procedural::CatalogueEntry { name, stands_for, triangles, description, .. } = *entry;
        Self { name, triangles, stands_for, description }
    }
}
