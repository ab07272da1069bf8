//! The main job's report, `report/index.html`.

mod claims;
mod hardware;
mod machine;
mod precision;
mod stability;
mod trees;

use super::results::Document;
use super::stages::Outcome;
use crate::input::display;
use anyhow::Context;
use serde_json::Value;
use std::fs;
use std::path::Path;
use view::report::{Figure, Item, Page, Picture, Section};

/// The scene whose picture stands for all.
const SHOWN_SCENE: &str = "courtyard";

/// Pictures that the page shows.
pub struct Pictures {
    /// The path-traced picture of each scene.
    pub images: Vec<Picture>,
    /// Heat maps of node visits.
    pub heat_maps: Vec<Picture>,
}

/// The command that makes the page.
fn command(document: &Document) -> String {
    match document.preset {
        "quick" => "dualsplit reproduce".to_owned(),
        preset => format!("dualsplit reproduce --preset {preset}"),
    }
}

/// The results that the page shows.
pub struct Results<'a> {
    /// Trees and work of all scenes.
    pub document: &'a Document,
    /// The results of the other parts of the job, by name.
    pub outcomes: &'a [(String, Outcome)],
    /// The folder of the job.
    pub folder: &'a Path,
}

impl Results<'_> {
    /// The page. It names files relative to its own folder.
    pub fn page(&self, pictures: Pictures) -> anyhow::Result<Page> {
        let d = self.document;
        let mut sections = vec![self.summary(&pictures)];
        sections.extend(self.outcome("check").map(hardware::equivalence));
        sections.push(hardware::pipelines(self.outcome("estimate"))?);
        sections.extend([trees::trees(d), trees::work(d)]);
        sections.extend(machine::sections(self)?);
        sections.extend((!self.is_full_size()).then(claims::at_full_size));
        sections.extend(precision::sections(self)?);
        sections.push(scene_pictures(pictures));
        Ok(Page {
            title: "Dual-split trees against bounding volume hierarchies".into(),
            summary: vec![
                "A dual-split tree holds exactly the space partitioning of a bounding volume hierarchy in 12-byte nodes with \
                 two planes each: split nodes cut the parent box in two, carve nodes cut empty space off it. Its nodes are \
                 slow to decode in software and cheap in hardware."
                    .into(),
            ],
            sections,
        })
    }

    /// What a reader can understand in a minute.
    fn summary(&self, pictures: &Pictures) -> Section {
        let d = self.document;
        let sample = format!(
            "This run ({}): {} built-in scenes of at most {} triangles, {} x {} pixels with {} sample(s) each where work is \
             counted, {} mode, seed {}. What else was sampled stands with each command.",
            d.preset,
            d.scenes.len(),
            d.scenes.iter().map(|s| s.triangles).max().unwrap_or(0),
            d.width,
            d.height,
            d.spp,
            d.mode,
            d.seed
        );
        let equal = match self.outcome("check") {
            Some(check) => {
                let (operations, mismatches) = hardware::compared(check);
                format!(
                    "Equal: of {operations} operations of the simulated hardware, {mismatches} differ from the exact software in any \
                     bit. All structures gave the same pictures, bit for bit, and so did the programs on the machine."
                )
            }
            None => "Equal: all structures gave the same pictures, bit for bit.".to_owned(),
        };
        let shown = pictures.images.iter().find(|picture| picture.caption == SHOWN_SCENE).cloned();
        let mut items = vec![Item::Table(claims::ratios(self.study()))];
        let all = if self.is_full_size() { "frame-time-and-energy" } else { "the-study-at-full-size" };
        items.push(Item::Text(format!("Where it differs: {} [All claims](#{all}).", claims::differences())));
        items.extend(shown.map(|picture| {
            let caption = format!("{}, path-traced through the dual-split tree", picture.caption);
            Item::Pictures(vec![Picture { caption, ..picture }])
        }));
        Section {
            title: "In a minute".into(),
            text: vec![
                "Built: the trees and an exact traversal as the specification; floating-point units and pipelines as \
                 synthesizable modules that equal it bit for bit, and their Verilog; and a many-core machine, timed by those \
                 pipelines, that says what they save."
                    .into(),
                equal,
                sample,
            ],
            items,
        }
    }

    /// The result of the study. Where it has several parts, the last has the rows of all.
    fn study(&self) -> Option<&Outcome> {
        self.outcomes.iter().rfind(|(name, _)| name.starts_with("study")).map(|(_, outcome)| outcome)
    }

    /// Whether the job's own study is the one at full size.
    fn is_full_size(&self) -> bool {
        self.study().is_some_and(|study| study.report["preset"] == "paper")
    }

    /// The result of the part `name`, if this job has it.
    fn outcome(&self, name: &str) -> Option<&Outcome> {
        self.outcomes.iter().find(|(other, _)| other == name).map(|(_, outcome)| outcome)
    }

    /// The chart `file` in the folder that `outcome` filled.
    fn figure(
        &self,
        outcome: &Outcome,
        folder: &str,
        (file, csv): (&str, &str),
        caption: &str,
    ) -> anyhow::Result<Item> {
        let path = self.folder.join(folder).join(file);
        let svg = fs::read_to_string(&path).with_context(|| display(&path))?;
        Ok(Item::Figure(Figure {
            svg,
            caption: caption.to_owned(),
            csv: format!("../{folder}/{csv}"),
            command: outcome.command.clone(),
        }))
    }
}

/// The elements of `value` if it is an array, else none.
fn rows(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// A value as a table shows it.
fn cell(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Number(n) if n.is_f64() => view::plot::number(n.as_f64().unwrap_or(f64::NAN)),
        other => other.to_string(),
    }
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
