//! The paper's figures beside ours at 65 nm, part by part, with error bars.

use super::report::{Section, section};
use super::{Estimates, PipelineRow};
use crate::table::fixed;
use estimate::{Breakdown, PAPER_CLOCK_FO4, Scaling, TARGET_NODE_NM};
use serde::Serialize;

/// An area and an energy at 65 nm. Those of the paper are exact.
#[derive(Clone, Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct BesideRow {
    pub pipeline: &'static str,
    pub of: &'static str,
    pub part: &'static str,
    pub area: Bar,
    pub energy: Bar,
}

/// A number with its error bar: area in um2 or energy of an operation in pJ.
#[derive(Clone, Copy, Debug, Default, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Bar {
    pub value: f64,
    pub least: f64,
    pub most: f64,
}

impl Bar {
    fn exact(value: f64) -> Self {
        Self { value, least: value, most: value }
    }

    fn scaled(value: f64, [factor, least, most]: [f64; 3]) -> Self {
        Self { value: factor * value, least: least * value, most: most * value }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            least: self.least + other.least,
            most: self.most + other.most,
        }
    }
}

/// The name of a part, and how much of a breakdown it is.
type Part = (&'static str, fn(&Breakdown) -> f64);

/// The parts of both pipelines, where the library can be scaled.
pub(super) fn rows(pipelines: &[PipelineRow], scaling: Option<&Scaling>) -> Vec<BesideRow> {
    let Some(scaling) = scaling else { return Vec::new() };
    let mut rows = Vec::new();
    for pipeline in pipelines {
        let paper = &pipeline.published;
        let mut add = |of, part, area, energy| {
            rows.push(BesideRow { pipeline: pipeline.name, of, part, area, energy });
        };
        let beyond = [paper.glue_area_um2, paper.glue_energy_pj];
        let units = [paper.area_um2 - beyond[0], paper.energy_pj - beyond[1]];
        add("paper", "units", Bar::exact(units[0]), Bar::exact(units[1]));
        add("paper", "beyond units", Bar::exact(beyond[0]), Bar::exact(beyond[1]));
        let parts: [Part; 5] = [
            ("units", Breakdown::all_units),
            ("glue", |breakdown| breakdown.glue),
            ("registers", |breakdown| breakdown.registers),
            ("clock", |breakdown| breakdown.clock),
            ("all", |breakdown| breakdown.total() - breakdown.inputs),
        ];
        for (part, of) in parts {
            let area = Bar::scaled(of(&pipeline.area), scaling.area_bar());
            let energy = Bar::scaled(of(&pipeline.energy) / 1e3, scaling.energy_bar());
            add("ours", part, area, energy);
        }
    }
    rows
}

/// What the paper's figures beyond its units are too small for.
fn left_out(rows: &[BesideRow], pipeline: &str) -> String {
    let find = |of: &str, part: &str| {
        rows.iter()
            .find(|row| (row.pipeline, row.of, row.part) == (pipeline, of, part))
            .expect("all parts are rows")
    };
    let room = find("paper", "beyond units");
    let quantity = |name: &str, of: fn(&BesideRow) -> Bar, unit: &str, digits: usize| {
        let mut sum = Bar::default();
        for part in ["glue", "registers", "clock"] {
            sum = sum.plus(of(find("ours", part)));
            if sum.least > of(room).value {
                return format!(
                    "its {name} beyond the units, {} {unit}, is too small for the {part}: up to these, ours is at least {} {unit}",
                    fixed(of(room).value, digits),
                    fixed(sum.least, digits)
                );
            }
        }
        format!(
            "its {name} beyond the units, {} {unit}, has room for all parts",
            fixed(of(room).value, digits)
        )
    };
    format!(
        "{pipeline} of the paper: {}; {}.",
        quantity("area", |row| row.area, "um2", 0),
        quantity("energy", |row| row.energy, "pJ", 3)
    )
}

/// The table, and what the paper must have left out.
pub(super) fn report(document: &Estimates) -> Section {
    let rows = document.beside_paper.iter().map(|row| {
        let bar =
            |bar: Bar, digits: usize| [bar.value, bar.least, bar.most].map(|value| fixed(value, digits));
        let ([area, low_area, high_area], [energy, low, high]) = (bar(row.area, 0), bar(row.energy, 3));
        [
            row.pipeline.to_owned(),
            row.of.to_owned(),
            row.part.to_owned(),
            area,
            low_area,
            high_area,
            energy,
            low,
            high,
        ]
    });
    let mut notes = Vec::new();
    for pipeline in &document.pipelines {
        notes.push(left_out(&document.beside_paper, pipeline.name));
    }
    let clocks = document
        .pipelines
        .iter()
        .map(|pipeline| format!("{} at {} FO4", pipeline.name, fixed(pipeline.clock.period_fo4, 1)));
    notes.push(format!(
        "What has no room was left out, or is in the published unit costs. The paper's clock of 1 GHz is {} to {} FO4 at \
         {TARGET_NODE_NM} nm; ours are {}. Our clock is the flip-flops' pins and the clock gates: a tree of buffers and its wires \
         are in no row.",
        PAPER_CLOCK_FO4.start(),
        PAPER_CLOCK_FO4.end(),
        clocks.collect::<Vec<_>>().join(", ")
    ));
    let header = ["pipeline", "of", "part", "um2", "least", "most", "pJ", "least", "most"];
    section(format!("Beside the paper, scaled to {TARGET_NODE_NM} nm"), header, rows.collect(), notes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_room_even_at_its_least_was_left_out() {
        let scaled = |value: f64| Bar::scaled(value, [1.0, 0.7, 1.3]);
        let row = |of, part, area, energy| BesideRow { pipeline: "p", of, part, area, energy };
        let mut rows = vec![
            row("paper", "beyond units", Bar::exact(100.0), Bar::exact(5.0)),
            row("ours", "glue", scaled(80.0), scaled(1.0)),
            row("ours", "registers", scaled(60.0), scaled(2.0)),
            row("ours", "clock", scaled(6.0), scaled(4.0)),
        ];
        // At least 98 um2 of glue and registers and 4.2 of the clock; at least 4.9 pJ of all.
        let text = left_out(&rows, "p");
        assert!(
            text.contains("beyond the units, 100 um2, is too small for the clock")
                && text.contains("102 um2"),
            "{text}"
        );
        assert!(text.contains("5.000 pJ, has room for all parts"), "{text}");
        rows[2].area = scaled(70.0);
        assert!(left_out(&rows, "p").contains("too small for the registers"));
        rows[0].area = Bar::exact(200.0);
        assert!(left_out(&rows, "p").contains("200 um2, has room for all parts"));
    }
}
