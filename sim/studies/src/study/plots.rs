//! The charts of the study.

use super::row::{Row, scenes};
use machine::frame::MachineStructure;
use view::plot::{Axis, Bars, Chart, Point, Series, Style};

/// All charts as SVG, with their file names.
pub fn all(rows: &[Row], scaling: &[Row], load_width: &[Row]) -> Vec<(String, String)> {
    let mut plots = vec![];
    for test in ["raycast", "path"] {
        plots.push((format!("time-{test}.svg"), bars(rows, test, "Frame time", "ms", |row| row.frame_ms)));
        plots.push((format!("energy-{test}.svg"), bars(rows, test, "Energy", "mJ", |row| row.energy_mj)));
        for scene in scenes(rows) {
            plots.push((format!("energy-split-{scene}-{test}.svg"), split(rows, scene, test)));
        }
    }
    let bytes = |row: &Row| row.node_bytes as f64 / 1e6;
    plots.push(("tree-size.svg".to_owned(), bars(rows, "path", "Size of the tree", "MB", bytes)));
    if !scaling.is_empty() {
        plots.push(("scaling.svg".to_owned(), efficiency(scaling)));
    }
    for scene in scenes(load_width) {
        let rows: Vec<&Row> = load_width.iter().filter(|row| row.scene == scene).collect();
        let name = |what: &str| format!("load-width-{what}-{scene}.svg");
        plots.push((name("time"), widths(&rows, "Frame time", "ms", |row| row.frame_ms)));
        plots.push((name("energy"), widths(&rows, "Energy", "mJ", |row| row.energy_mj)));
    }
    plots
}

/// A chart of one quantity of every structure in every scene, in multiples of the dual-split tree's.
fn bars(rows: &[Row], test: &str, title: &str, unit: &str, of: fn(&Row) -> f64) -> String {
    let scenes = scenes(rows);
    let values = |structure: MachineStructure| -> Vec<Option<f64>> {
        scenes.iter().map(|scene| find(rows, scene, test, structure).map(of)).collect()
    };
    let series = MachineStructure::ALL.map(|structure| (structure.name().to_owned(), values(structure)));
    let bars = Bars {
        title: format!("{title}, {test}"),
        unit: unit.to_owned(),
        categories: scenes.iter().map(|scene| (*scene).to_owned()).collect(),
        series: series.to_vec(),
        ..Bars::default()
    };
    bars.in_multiples_of(REFERENCE.name(), &values(REFERENCE)).svg()
}

/// The structure that all others are compared with.
const REFERENCE: MachineStructure = MachineStructure::Dst;

fn find<'a>(rows: &'a [Row], scene: &str, test: &str, structure: MachineStructure) -> Option<&'a Row> {
    rows.iter().find(|row| row.scene == scene && row.test == test && row.structure == structure.name())
}

/// A chart of the energy of every structure in one scene, by memory, caches and computation.
fn split(rows: &[Row], scene: &str, test: &str) -> String {
    let of = |part: fn(&Row) -> f64| {
        MachineStructure::ALL.map(|structure| find(rows, scene, test, structure).map(part)).to_vec()
    };
    let reference = find(rows, scene, test, REFERENCE).map(|row| row.energy_mj);
    let bars = Bars {
        title: format!("Energy in {scene}, {test}"),
        unit: "mJ".to_owned(),
        categories: MachineStructure::ALL.map(|structure| structure.name().to_owned()).to_vec(),
        series: vec![
            ("DRAM".to_owned(), of(|row| row.dram_mj)),
            ("cache".to_owned(), of(|row| row.cache_mj)),
            ("compute".to_owned(), of(|row| row.compute_mj)),
        ],
        stacked: true,
        ..Bars::default()
    };
    bars.in_multiples_of(REFERENCE.name(), &[reference; MachineStructure::ALL.len()]).svg()
}

/// A chart of one quantity of every structure with loads of each width.
fn widths(rows: &[&Row], title: &str, unit: &str, of: fn(&Row) -> f64) -> String {
    let words = ["1", "2", "4", "line"];
    let series = words.map(|words| {
        let value = |structure: MachineStructure| {
            let same = |row: &&&Row| row.structure == structure.name() && row.load_words == words;
            rows.iter().find(same).map(|row| of(row))
        };
        let name = if words == "1" { "1 word".to_owned() } else { words.to_owned() };
        (name, MachineStructure::ALL.map(value).to_vec())
    });
    let scene = rows.first().map_or("", |row| row.scene.as_str());
    let bars = Bars {
        title: format!("{title} by words of a load, {scene}, path"),
        unit: unit.to_owned(),
        categories: MachineStructure::ALL.map(|structure| structure.name().to_owned()).to_vec(),
        series: series.to_vec(),
        ..Bars::default()
    };
    let reference = rows.iter().find(|row| row.structure == REFERENCE.name() && row.load_words == words[0]);
    let reference = reference.map(|row| of(row));
    let name = format!("{} with 1 word", REFERENCE.name());
    bars.in_multiples_of(&name, &[reference; MachineStructure::ALL.len()]).svg()
}

/// A chart of the speed-up over the fewest multiprocessors, as a share of the ideal one.
fn efficiency(scaling: &[Row]) -> String {
    let fewest = scaling.iter().map(|row| row.tms).min().unwrap_or(1);
    let mut series = vec![];
    for structure in MachineStructure::ALL {
        let mut runs: Vec<&Row> = scaling.iter().filter(|row| row.structure == structure.name()).collect();
        runs.sort_by_key(|row| row.tms);
        let Some(base) = runs.iter().find(|row| row.tms == fewest) else { continue };
        let point = |row: &&Row| Point {
            x: f64::from(row.tms),
            y: base.cycles as f64 / row.cycles as f64 * f64::from(fewest) / f64::from(row.tms),
            ..Point::default()
        };
        series.push(Series {
            name: structure.name().to_owned(),
            points: runs.iter().map(point).collect(),
            style: Style::Line,
        });
    }
    let scene = scaling.first().map_or("", |row| row.scene.as_str());
    Chart {
        title: format!("Speed-up over the ideal speed-up, {scene}, path"),
        x: Axis::log("thread multiprocessors"),
        y: Axis::linear("speed-up / ideal"),
        series,
    }
    .svg()
}
