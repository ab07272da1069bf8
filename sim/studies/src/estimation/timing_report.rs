//! The sections of the report about time: clocks, stages, curves.

use super::report::{Section, section};
use super::{ClockRow, Estimates, OwnRow, PipelineRow};
use crate::table::fixed;
use estimate::StageRow;

/// By how much a pipeline misses its clock, and where; none if it meets it.
pub(super) fn missed(name: &str, clock: &ClockRow) -> Option<String> {
    let (slack_ns, stage) = (clock.slack_ns.filter(|&slack| slack < 0.0)?, clock.longest()?);
    Some(format!(
        "{name} misses the clock by {:.3} ns, in stage {}, from {} to {}: {}.",
        -slack_ns,
        stage.stage,
        stage.from,
        stage.to,
        through(stage)
    ))
}

/// The clock that each pipeline's areas and energies hold for.
pub(super) fn clocks(document: &Estimates) -> Section {
    let mut notes = Vec::new();
    let rows = document.pipelines.iter().chain(&document.lean_pipelines).map(|pipeline| {
        let clock = &pipeline.clock;
        notes.extend(missed(pipeline.name, clock));
        [
            pipeline.name.to_owned(),
            fixed(clock.period_ns, 3),
            fixed(clock.period_fo4, 1),
            fixed(1e3 / clock.period_ns, 0),
            fixed(pipeline.critical_path_ns, 3),
            clock.slack_ns.map_or_else(String::new, |ns| fixed(ns, 3)),
            clock.mapping.clone(),
        ]
    });
    let rows: Vec<[String; 7]> = rows.collect();
    let library = &document.library;
    notes.push(format!(
        "FO4, the delay of an inverter ({}) that drives four of its kind, measured in {}: {:.1} ps.",
        library.fo4_inverter, library.source, library.fo4_ps
    ));
    let header = ["pipeline", "clock ns", "FO4", "MHz", "critical path ns", "slack ns", "mapping"];
    section("The clock that areas and energies hold for", header, rows, notes)
}

/// What ABC gains over our own mapper.
pub(super) fn mappers(document: &Estimates) -> Section {
    let mut rows = Vec::new();
    let mut notes = Vec::new();
    for pipeline in document.pipelines.iter().chain(&document.lean_pipelines) {
        let Some(own) = &pipeline.own else { continue };
        let abc = OwnRow {
            mapping: pipeline.clock.mapping.clone(),
            critical_path_ns: pipeline.critical_path_ns,
            logic_area_um2: pipeline.area.logic(),
            energy_pj: pipeline.energy.total() / 1e3,
        };
        for (mapper, row) in [("ABC", &abc), ("ours", own)] {
            rows.push([
                pipeline.name.to_owned(),
                mapper.to_owned(),
                fixed(row.critical_path_ns, 3),
                fixed(row.logic_area_um2, 0),
                fixed(row.energy_pj, 3),
                row.mapping.clone(),
            ]);
        }
        let over = |of: fn(&OwnRow) -> f64| 100.0 * (of(own) / of(&abc) - 1.0);
        let late =
            if own.critical_path_ns > pipeline.clock.period_ns { ", and misses the clock" } else { "" };
        notes.push(format!(
            "{}: our own mapping has {:+.1} % area of logic, {:+.1} % energy and {:+.1} % longest path{late}.",
            pipeline.name,
            over(|row| row.logic_area_um2),
            over(|row| row.energy_pj),
            over(|row| row.critical_path_ns)
        ));
    }
    notes.push(
        "All tables but this are about ABC's cells. A cell of ABC's belongs to the unit that has a gate of the same value in random \
         patterns, or else to what reads it."
            .to_owned(),
    );
    let header = ["pipeline", "mapper", "critical path ns", "um2 logic", "pJ", "mapping"];
    section("ABC and our own mapper at the same clock", header, rows, notes)
}

/// What a path passes, with the time that it takes there.
fn through(stage: &StageRow) -> String {
    let stretches = stage.through.iter().map(|stretch| format!("{} {:.0}", stretch.part, 1e3 * stretch.ns));
    stretches.collect::<Vec<_>>().join(", ")
}

/// The longest path of each stage.
pub(super) fn stages(pipeline: &PipelineRow) -> Section {
    let rows = pipeline.clock.stages.iter().map(|stage| {
        [
            stage.stage.to_string(),
            fixed(1e3 * stage.path_ns, 0),
            fixed(stage.path_fo4, 1),
            stage.from.clone(),
            stage.to.clone(),
            through(stage),
        ]
    });
    let note = "Paths hold the register's own delay and its setup time. The last stage lies behind the last registers.";
    let header = ["stage", "path ps", "FO4", "from", "to", "through, ps"];
    section(format!("Stages of {}", pipeline.name), header, rows.collect(), vec![note.to_owned()])
}

/// Area and energy at several clocks.
pub(super) fn curve(document: &Estimates) -> Section {
    let optional = |value: Option<f64>, digits| value.map_or_else(String::new, |value| fixed(value, digits));
    let rows = document.curve.iter().map(|row| {
        let over_abc = if row.flow == "ours" { row.over_abc(&document.curve) } else { None };
        [
            row.pipeline.to_owned(),
            row.flow.to_owned(),
            fixed(row.clock_ns, 3),
            fixed(row.clock_fo4, 1),
            optional(row.critical_path_ns, 3),
            optional(row.logic_area_um2, 0),
            optional(over_abc, 3),
            optional(row.register_area_um2, 0),
            optional(row.energy_pj, 3),
            row.mapping.clone(),
        ]
    });
    let header = [
        "pipeline",
        "flow",
        "clock ns",
        "FO4",
        "critical path ns",
        "um2 logic",
        "over ABC's",
        "um2 flip-flops",
        "pJ",
        "mapping",
    ];
    let note = "Every netlist is proved equal to its gates. A multiplexer before each register stands for a clock gate. ABC \
                runs where it is installed and the library is a file: of three scripts the smallest that meets the clock.";
    section("Area and energy against the clock", header, rows.collect(), vec![note.to_owned()])
}
