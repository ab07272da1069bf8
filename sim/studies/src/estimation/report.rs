//! The report as text and as an HTML fragment.

use super::numbers::parts;
use super::timing_report::{clocks, curve, mappers, stages};
use super::{Estimates, PipelineRow, beside_paper};
use crate::table::{fixed, table};
use estimate::{Breakdown, NodeType, TARGET_NODE_NM};
use std::fmt::Write;

/// A table with its title, as text and as HTML.
pub struct Section {
    title: String,
    text: String,
    html: String,
    notes: Vec<String>,
}

pub(super) fn section<const N: usize>(
    title: impl Into<String>,
    header: [&str; N],
    rows: Vec<[String; N]>,
    notes: Vec<String>,
) -> Section {
    let line = |tag: &str, cells: &mut dyn Iterator<Item = &str>| -> String {
        let cells: String = cells.map(|cell| format!("<{tag}>{}</{tag}>", escape(cell))).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let mut html = format!("<table>\n{}", line("th", &mut header.into_iter()));
    for row in &rows {
        html += &line("td", &mut row.iter().map(String::as_str));
    }
    html.push_str("</table>\n");
    Section { title: title.into(), text: table(header, rows), html, notes }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// All sections as one text.
pub fn text(sections: &[Section]) -> String {
    let mut text = String::new();
    for section in sections {
        let _ = writeln!(text, "{}\n\n{}", section.title, section.text);
        for note in &section.notes {
            let _ = writeln!(text, "{note}");
        }
        if !section.notes.is_empty() {
            text.push('\n');
        }
    }
    text
}

/// All sections as an HTML fragment without styles.
pub fn html(sections: &[Section]) -> String {
    let mut html = String::from("<section class=\"estimate\">\n");
    for section in sections {
        let _ = write!(html, "<h3>{}</h3>\n{}", escape(&section.title), section.html);
        for note in &section.notes {
            let _ = writeln!(html, "<p>{}</p>", escape(note));
        }
    }
    html.push_str("</section>\n");
    html
}

/// The sections of the report, in the order in which they are printed.
pub fn sections(document: &Estimates) -> Vec<Section> {
    let mut sections = vec![comparison(document), ratios(document)];
    sections.push(clocks(document));
    if document.pipelines.iter().any(|pipeline| pipeline.own.is_some()) {
        sections.push(mappers(document));
    }
    if !document.beside_paper.is_empty() {
        sections.push(beside_paper::report(document));
    }
    sections.extend(document.pipelines.iter().map(stages));
    sections.push(breakdowns(document));
    sections.push(node_types(document));
    sections.push(scenes(document));
    for pipeline in &document.pipelines {
        sections.push(modules(document, pipeline));
    }
    if !document.synthesis.is_empty() {
        sections.push(synthesis(document));
    }
    if !document.curve.is_empty() {
        sections.push(curve(document));
    }
    sections
}

fn comparison(document: &Estimates) -> Section {
    let mut rows = Vec::new();
    let mut notes = Vec::new();
    for pipeline in document.pipelines.iter().chain(&document.lean_pipelines) {
        let units = &pipeline.units;
        let counts = format!(
            "{}/{}/{}/{}/{}",
            units.int_add, units.fp_add, units.fp_mul, units.fp_min_max, units.fp_cmp
        );
        let latency = pipeline.latency_cycles.map_or_else(String::new, |cycles| cycles.to_string());
        let mut add =
            |method: &str, latency: String, area: f64, glue_area: f64, energy: f64, glue_energy: f64| {
                rows.push([
                    pipeline.name.to_owned(),
                    method.to_owned(),
                    counts.clone(),
                    latency,
                    fixed(area / 1e6, 5),
                    fixed(glue_area / 1e6, 5),
                    fixed(energy / 1e3, 5),
                    fixed(glue_energy / 1e3, 5),
                ]);
            };
        let paper = &pipeline.published;
        if document.pipelines.iter().any(|published| published.name == pipeline.name) {
            let latency = paper.latency_cycles.to_string();
            add("paper", latency, paper.area_um2, paper.glue_area_um2, paper.energy_pj, paper.glue_energy_pj);
        }
        for estimate in &pipeline.estimates {
            add(
                estimate.method,
                latency.clone(),
                estimate.area_um2,
                estimate.glue_area_um2,
                estimate.energy_pj,
                estimate.glue_energy_pj,
            );
        }
        for estimate in &pipeline.estimates {
            notes.push(format!("{}, {}: {}.", pipeline.name, estimate.method, estimate.source));
        }
    }
    if document.library.scaling.is_none() {
        notes.push(format!(
            "No rows at {TARGET_NODE_NM} nm: there are no scaling coefficients for {}.",
            document.library.name
        ));
    }
    notes.push(
        "Paper: Lin, Vasiou, Yuksel, Kopta, Brunvand, HPG 2020; its glue is what its totals hold beyond the published unit \
         costs. All rows are without registers, clock and wires; those of the netlist have their own table."
            .to_owned(),
    );
    let header =
        ["pipeline", "method", "INT/ADD/MUL/MINMAX/CMP", "cycles", "mm2", "of it glue", "nJ", "of it glue"];
    let title = format!("Pipelines, an operation of {} ({})", document.scene, document.library.name);
    section(title, header, rows, notes)
}

fn ratios(document: &Estimates) -> Section {
    let rows =
        document.ratios.iter().map(|row| [row.method.clone(), fixed(row.area, 2), fixed(row.energy, 2)]);
    section("Ray-box over dual-split", ["method", "area", "energy"], rows.collect(), Vec::new())
}

fn breakdowns(document: &Estimates) -> Section {
    let mut rows = Vec::new();
    for pipeline in document.pipelines.iter().chain(&document.lean_pipelines) {
        let columns = [&pipeline.area, &pipeline.energy, &pipeline.energy_with_glitches].map(parts);
        let totals = [&pipeline.area, &pipeline.energy, &pipeline.energy_with_glitches].map(Breakdown::total);
        for (i, (part, _)) in columns[0].iter().enumerate() {
            let value = |column: usize| columns[column].get(i).map_or(0.0, |(_, value)| *value);
            let share = |column: usize| 100.0 * value(column) / totals[column];
            rows.push([
                pipeline.name.to_owned(),
                part.clone(),
                fixed(value(0), 1),
                fixed(share(0), 1),
                fixed(value(1) / 1e3, 3),
                fixed(share(1), 1),
                fixed(value(2) / 1e3, 3),
                fixed(share(2), 1),
            ]);
        }
        rows.push([
            pipeline.name.to_owned(),
            "all".to_owned(),
            fixed(totals[0], 1),
            fixed(100.0, 1),
            fixed(totals[1] / 1e3, 3),
            fixed(100.0, 1),
            fixed(totals[2] / 1e3, 3),
            fixed(100.0, 1),
        ]);
    }
    let mut notes = Vec::new();
    for pipeline in document.pipelines.iter().chain(&document.lean_pipelines) {
        notes.push(format!(
            "{}: {} cells, {} flip-flops, critical path {:.3} ns ({:.0} MHz), leakage {:.3} uW; energy of {} operations, with \
             glitches of {} (standard error {}).",
            pipeline.name,
            pipeline.cells,
            pipeline.registers,
            pipeline.critical_path_ns,
            pipeline.clock_mhz,
            pipeline.leakage_uw,
            pipeline.operations,
            pipeline.glitch_operations,
            percent(pipeline.glitch_error)
        ));
    }
    let header = ["pipeline", "part", "um2", "%", "pJ", "%", "pJ with glitches", "%"];
    let library = &document.library;
    let title = format!(
        "Parts, in {} as it is ({} V, one gate equivalent {} um2)",
        library.source, library.voltage_v, library.gate_equivalent_um2
    );
    section(title, header, rows, notes)
}

fn node_types(document: &Estimates) -> Section {
    let mut rows = Vec::new();
    for pipeline in document.pipelines.iter().chain(&document.lean_pipelines) {
        for row in &pipeline.node_types {
            rows.push([
                pipeline.name.to_owned(),
                row.node_type.name().to_owned(),
                fixed(100.0 * row.share, 1),
                fixed(row.energy.logic() / 1e3, 3),
                fixed(row.energy.glue / 1e3, 3),
                fixed(row.energy.total() / 1e3, 3),
                fixed(row.energy_with_glitches.total() / 1e3, 3),
            ]);
        }
    }
    let header = [
        "pipeline",
        "node",
        "% of operations",
        "pJ units and glue",
        "pJ glue",
        "pJ all",
        "pJ all with glitches",
    ];
    let note = sentence(&document.provenance["node_types"]);
    section("Energy of an operation by type of node, in the library", header, rows, vec![note])
}

fn scenes(document: &Estimates) -> Section {
    let rows = document.scenes.iter().map(|row| {
        let share = |wanted: NodeType| {
            let found = row.node_types.iter().find(|(node_type, _)| *node_type == wanted);
            found.map_or_else(String::new, |(_, share)| fixed(100.0 * share, 1))
        };
        let [split, single, dual, leaf] = NodeType::ALL.map(share);
        [
            row.scene.clone(),
            row.pipeline.to_owned(),
            split,
            single,
            dual,
            leaf,
            fixed(row.energy.zero_delay.logic() / 1e3, 3),
            fixed(row.energy.zero_delay.total() / 1e3, 3),
            fixed(row.energy.with_glitches.total() / 1e3, 3),
            row.energy.glitch_error.map_or_else(String::new, |error| fixed(100.0 * error, 1)),
        ]
    });
    let header = [
        "scene",
        "pipeline",
        "% split",
        "% single carve",
        "% dual carve",
        "% leaf",
        "pJ units and glue",
        "pJ all",
        "pJ all with glitches",
        "standard error %",
    ];
    let note = sentence(&document.provenance["scenes"]);
    section("Energy of an operation by scene, in the library", header, rows.collect(), vec![note])
}

fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(letters).chain(std::iter::once('.')).collect()
}

fn modules(document: &Estimates, pipeline: &PipelineRow) -> Section {
    let rows = pipeline.modules.iter().map(|row| {
        [
            row.module.clone(),
            row.instances.to_string(),
            row.cells.to_string(),
            fixed(row.area_um2, 1),
            row.registers.to_string(),
            fixed(row.register_area_um2, 1),
            row.levels.to_string(),
            fixed(row.latest_ns, 3),
        ]
    });
    let header = ["module", "instances", "cells", "um2", "flip-flops", "um2 of those", "levels", "latest ns"];
    let note = sentence(&document.provenance["modules"]);
    section(format!("Modules of {}", pipeline.name), header, rows.collect(), vec![note])
}

fn synthesis(document: &Estimates) -> Section {
    let rows = document.synthesis.iter().map(|row| {
        [
            row.pipeline.to_owned(),
            row.flow.clone(),
            row.cells.to_string(),
            fixed(row.logic_area_um2, 1),
            fixed(row.register_area_um2, 1),
            row.critical_path_ns.map_or_else(String::new, |ns| fixed(ns, 3)),
        ]
    });
    let header = ["pipeline", "flow", "cells", "um2 logic", "um2 flip-flops", "critical path ns"];
    let note =
        "yosys has no clock gates here: its logic holds a multiplexer for each register's enable.".to_owned();
    section("The exported Verilog in yosys and ABC", header, rows.collect(), vec![note])
}

/// A standard error in percent.
fn percent(error: Option<f64>) -> String {
    error.map_or_else(|| "unknown".to_owned(), |error| format!("{:.1} %", 100.0 * error))
}
