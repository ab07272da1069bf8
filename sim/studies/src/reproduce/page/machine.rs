//! The sections about frame time and energy of the eight structures.

use super::super::stages::Outcome;
use super::{Results, cell, claims, rows};
use machine::frame::MachineStructure;
use scenes::procedural::CATALOGUE;
use serde_json::Value;
use view::plot::Bars;
use view::report::{Figure, Item, Section, Table};

const CSV: &str = "../study/study.csv";

/// The sections that show the study; none if the job has no study.
pub fn sections(results: &Results<'_>) -> anyhow::Result<Vec<Section>> {
    let Some(study) = results.study() else { return Ok(vec![]) };
    let study = &Outcome { command: of_all_scenes(&study.command), ..study.clone() };
    let all = rows(&study.report["rows"]);
    Ok(vec![times(results, study, all)?, split(study, all), scaling(results, study)?])
}

/// The command for all scenes that stands for the commands for single scenes.
fn of_all_scenes(command: &str) -> String {
    let mut words: Vec<&str> = command.split(' ').collect();
    if let Some(at) = words.iter().position(|word| *word == "--scene") {
        words.drain(at..at + 2);
    }
    words.join(" ")
}

fn find<'a>(all: &'a [Value], scene: &str, test: &str, structure: &str) -> Option<&'a Value> {
    all.iter().find(|row| row["scene"] == scene && row["test"] == test && row["structure"] == structure)
}

fn times(results: &Results<'_>, study: &Outcome, all: &[Value]) -> anyhow::Result<Section> {
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
    for (file, quantity) in [("time", "Frame time"), ("energy", "Energy")] {
        for test in ["raycast", "path"] {
            let file = format!("{file}-{test}.svg");
            let caption = format!("{quantity} of each structure in each scene, {test}.");
            items.push(results.figure(study, "study", (&file, "study.csv"), &caption)?);
        }
    }
    items.push(Item::Table(claims::table(study, results.is_full_size())));
    let small = "Frames so small and scenes so coarse say little about how large a gain is, and some claims are judged otherwise at full \
                 size: see [the study at full size](#the-study-at-full-size).";
    let mut text = vec![
        "dst has the dual-split pipeline, dst-sw decodes its nodes in software; bvh2, bvh4 and bvh8 share one ray-box \
         pipeline a multiprocessor, those with + have one for each child."
            .into(),
        sample,
    ];
    text.extend((!results.is_full_size()).then(|| small.to_owned()));
    Ok(Section { title: "Frame time and energy".into(), text, items })
}

/// Energy of some structures by memory, caches and computation, on one scale.
fn split(study: &Outcome, all: &[Value]) -> Section {
    const SHOWN: [&str; 4] = ["dst", "dst-sw", "bvh2", "bvh8"];
    const PARTS: [(&str, &str); 3] = [("DRAM", "dram_mj"), ("cache", "cache_mj"), ("compute", "compute_mj")];
    let shown =
        |scene: &'static str| SHOWN.iter().filter_map(move |structure| find(all, scene, "path", structure));
    let chosen: Vec<&Value> = CATALOGUE.iter().flat_map(|entry| shown(entry.name)).collect();
    let dst = MachineStructure::Dst.name();
    let reference: Vec<Option<f64>> = chosen
        .iter()
        .map(|row| find(all, row["scene"].as_str()?, "path", dst)?["energy_mj"].as_f64())
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
        ..Bars::default()
    };
    let bars = bars.in_multiples_of(dst, &reference);
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
    let table = Table::new(
        "Energy by component, path",
        header,
        chosen.iter().map(|row| keys.map(|key| cell(&row[key]))),
    );
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
                caption: "Energy by component, path tracing.".into(),
                csv: CSV.into(),
                command: study.command.clone(),
            }),
            Item::Table(table.from(CSV, &study.command)),
        ],
    }
}

fn scaling(results: &Results<'_>, study: &Outcome) -> anyhow::Result<Section> {
    let all = rows(&study.report["scaling"]);
    let mut tms: Vec<u64> = all.iter().filter_map(|row| row["tms"].as_u64()).collect();
    tms.sort_unstable();
    tms.dedup();
    let cycles = |structure: &str, tms: u64| {
        all.iter().find(|row| row["structure"] == structure && row["tms"] == tms)?["cycles"].as_f64()
    };
    let line = |structure: MachineStructure| {
        let one = cycles(structure.name(), *tms.first()?)?;
        let speed_up =
            |tms: &u64| cycles(structure.name(), *tms).map_or(String::new(), |n| format!("{:.2}", one / n));
        Some([structure.name().to_owned()].into_iter().chain(tms.iter().map(speed_up)).collect())
    };
    let table = Table {
        caption: "Speed-up by number of multiprocessors".into(),
        header: ["structure".to_owned()].into_iter().chain(tms.iter().map(u64::to_string)).collect(),
        rows: MachineStructure::ALL.into_iter().filter_map(line).collect(),
        ..Table::default()
    };
    Ok(Section {
        title: "Scaling".into(),
        text: vec![
            "Speed-up over the fewest multiprocessors as a share of the ideal one, which is 1. A small frame is soon shared out; \
             full-size scaling is that of the preset paper."
                .into(),
        ],
        items: vec![
            results.figure(study, "study", ("scaling.svg", "study.csv"), "Speed-up over the ideal, path tracing.")?,
            Item::Table(table.from(CSV, &study.command)),
        ],
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
