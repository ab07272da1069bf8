//! The sections about frame time and energy of the eight structures.

use super::super::stages::Outcome;
use super::{Results, cell, rows};
use machine::frame::MachineStructure;
use serde_json::Value;
use std::collections::BTreeSet;
use view::plot::Bars;
use view::report::{Figure, Item, Section, Table};

const CSV: &str = "../study/study.csv";

/// The sections that show the study; none if the job has no study.
pub fn sections(results: &Results<'_>) -> anyhow::Result<Vec<Section>> {
    // Where the study has several parts, the last has the rows of all.
    let Some((_, study)) = results.outcomes.iter().rfind(|(name, _)| name.starts_with("study")) else {
        return Ok(vec![]);
    };
    let study = &Outcome { command: of_all_scenes(&study.command), ..study.clone() };
    let all = rows(&study.report["rows"]);
    Ok(vec![times(study, all), split(study, all), scaling(results, study)?])
}

/// The command for all scenes that stands for the commands for single scenes.
fn of_all_scenes(command: &str) -> String {
    let mut words: Vec<&str> = command.split(' ').collect();
    if let Some(at) = words.iter().position(|word| *word == "--scene") {
        words.drain(at..at + 2);
    }
    words.join(" ")
}

fn scenes(all: &[Value]) -> Vec<&str> {
    let names: BTreeSet<&str> = all.iter().filter_map(|row| row["scene"].as_str()).collect();
    names.into_iter().collect()
}

fn find<'a>(all: &'a [Value], scene: &str, test: &str, structure: &str) -> Option<&'a Value> {
    all.iter().find(|row| row["scene"] == scene && row["test"] == test && row["structure"] == structure)
}

/// A bar chart of one quantity over all structures and scenes. The charts of both tests have the same scale.
fn bars(study: &Outcome, all: &[Value], test: &str, (title, unit, key): (&str, &str, &str)) -> Item {
    let scenes = scenes(all);
    let value =
        |scene: &&str, structure: MachineStructure| find(all, scene, test, structure.name())?[key].as_f64();
    let series = MachineStructure::ALL.map(|structure| {
        (structure.name().to_owned(), scenes.iter().map(|scene| value(scene, structure)).collect())
    });
    let bars = Bars {
        title: format!("{title}, {test}"),
        unit: unit.to_owned(),
        categories: scenes.iter().map(|scene| (*scene).to_owned()).collect(),
        series: series.to_vec(),
        stacked: false,
        max: all.iter().filter_map(|row| row[key].as_f64()).reduce(f64::max),
    };
    Item::Figure(Figure {
        svg: bars.svg(),
        caption: "Both tests on one scale.".into(),
        csv: CSV.into(),
        command: study.command.clone(),
    })
}

fn times(study: &Outcome, all: &[Value]) -> Section {
    let sample = all.first().map_or(String::new(), |row| {
        let rays: u64 = all.iter().filter_map(|row| row["rays"].as_u64()).sum();
        format!(
            "Sample: {} x {} pixels, {} multiprocessors of 32 threads, {} to {} triangles, {rays} rays in all.",
            cell(&row["width"]),
            cell(&row["height"]),
            cell(&row["tms"]),
            all.iter().filter_map(|row| row["triangles"].as_u64()).min().unwrap_or(0),
            all.iter().filter_map(|row| row["triangles"].as_u64()).max().unwrap_or(0)
        )
    });
    let mut items = vec![];
    for quantity in [("Frame time", "ms", "frame_ms"), ("Energy", "mJ", "energy_mj")] {
        for test in ["raycast", "path"] {
            items.push(bars(study, all, test, quantity));
        }
    }
    let claims = rows(&study.report["comparison"]);
    let header = ["claim", "published", "here", "holds"];
    let keys = ["claim", "published", "ours", "holds"];
    let table = Table::new(header, claims.iter().map(|claim| keys.map(|key| cell(&claim[key]))));
    items.push(Item::Table(table.from("../study/comparison.csv", &study.command)));
    Section {
        title: "Frame time and energy".into(),
        text: vec![
            "dst has the dual-split pipeline, dst-sw decodes its nodes in software; bvh2, bvh4 and bvh8 share one ray-box \
             pipeline a multiprocessor, those with + have one for each child."
                .into(),
            format!("{sample} The table compares with the published results, which are of full size."),
        ],
        items,
    }
}

/// Energy of some structures by memory, caches and computation, on one scale.
fn split(study: &Outcome, all: &[Value]) -> Section {
    const SHOWN: [&str; 4] = ["dst", "dst-sw", "bvh2", "bvh8"];
    const PARTS: [(&str, &str); 3] = [("DRAM", "dram_mj"), ("cache", "cache_mj"), ("compute", "compute_mj")];
    let chosen: Vec<&Value> = scenes(all)
        .into_iter()
        .flat_map(|scene| SHOWN.iter().filter_map(move |structure| find(all, scene, "path", structure)))
        .collect();
    let bars = Bars {
        title: "Energy by component, path".into(),
        unit: "mJ".into(),
        categories: chosen
            .iter()
            .map(|row| format!("{} {}", cell(&row["scene"]), cell(&row["structure"])))
            .collect(),
        series: PARTS
            .map(|(name, key)| (name.to_owned(), chosen.iter().map(|row| row[key].as_f64()).collect()))
            .to_vec(),
        stacked: true,
        max: None,
    };
    let header = [
        "scene",
        "structure",
        "DRAM mJ",
        "cache mJ",
        "compute mJ",
        "on-chip storage mJ",
        "execution mJ",
        "total mJ",
    ];
    let keys = [
        "scene",
        "structure",
        "dram_mj",
        "cache_mj",
        "compute_mj",
        "on_chip_mj",
        "execution_mj",
        "energy_mj",
    ];
    let table = Table::new(header, chosen.iter().map(|row| keys.map(|key| cell(&row[key]))));
    Section {
        title: "Where the energy goes".into(),
        text: vec![
            "Memory with its background; first- and second-level and instruction caches; registers, local stores, units and \
             pipelines. On-chip storage is caches, registers and local stores together, as the talk words it; execution is the \
             rest."
                .into(),
        ],
        items: vec![
            Item::Figure(Figure {
                svg: bars.svg(),
                caption: "One scale for all.".into(),
                csv: CSV.into(),
                command: study.command.clone(),
            }),
            Item::Table(table.from(CSV, &study.command)),
        ],
    }
}

fn scaling(results: &Results<'_>, study: &Outcome) -> anyhow::Result<Section> {
    Ok(Section {
        title: "Scaling".into(),
        text: vec![
            "Speed-up over the fewest multiprocessors. A small frame is soon shared out; full-size scaling is that of the \
             preset paper."
                .into(),
        ],
        items: vec![results.figure(study, "study", ("scaling.svg", "study.csv"), "Path tracing.")?],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_of_one_scene_becomes_that_of_all() {
        let one = "dualsplit study --preset paper --scene hairball --out study";
        assert_eq!(of_all_scenes(one), "dualsplit study --preset paper --out study");
        assert_eq!(of_all_scenes("dualsplit study --out study"), "dualsplit study --out study");
    }
}
