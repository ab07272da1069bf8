//! Area and energy of both pipelines against the clock, by our mapper and by ABC's best script where ABC is installed.
//!
//! ABC knows no clock gates, so that on both sides a multiplexer before each register keeps its value.

use super::Options;
use crate::artifacts::Artifacts;
use crate::progress::{Part, Progress};
use anyhow::Context;
use base::output::Unfinished;
use estimate::{EstimateError, Implementation, Mappings, Workload};
use gates::abc::{SCRIPTS, installed};
use gates::liberty::Library;
use gates::timing::fo4_ns;
use pipelines::catalogue::Top;
use serde::Serialize;
use view::plot::{Axis, Chart, Point, Series, Style};

/// The clocks, in multiples of the shortest period that our mapper reaches.
const CLOCKS: [f64; 5] = [1.0, 1.1, 1.25, 1.5, 2.0];
/// Further delays that ABC is asked for, in the same multiples: it may meet a clock with less area if asked for another.
const FURTHER: [f64; 2] = [0.8, 0.9];

/// A pipeline at a clock.
#[derive(Clone, Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct CurveRow {
    pub pipeline: &'static str,
    pub flow: &'static str,
    pub clock_ns: f64,
    pub clock_fo4: f64,
    /// Empty where the flow misses the clock, as are the numbers that follow.
    pub mapping: String,
    pub critical_path_ns: Option<f64>,
    pub logic_area_um2: Option<f64>,
    pub register_area_um2: Option<f64>,
    /// Energy of one operation, without glitches.
    pub energy_pj: Option<f64>,
}

/// The curves of both pipelines.
pub(super) fn run(
    args: &Options,
    library: &Library,
    workload: &Workload,
    progress: &dyn Progress,
) -> anyhow::Result<Vec<CurveRow>> {
    let library = Library { clock_gate: None, ..library.clone() };
    let folder = tempfile::tempdir().context("a temporary folder cannot be made")?;
    let _unfinished = Unfinished::new(folder.path());
    let mut rows = Vec::new();
    for top in [Top::DualSplit, Top::RayBox] {
        let part = Part::endless(progress, &format!("mapping {top} for {} clocks", CLOCKS.len()));
        let mappings = Mappings::new(top, &library)?;
        let fastest = mappings.within(0.0)?;
        let shortest_ns = fastest.timing.critical_path_ns;
        let row = |clock_ns: f64, flow: &'static str, found: Option<(&Implementation, String)>| {
            let energy = |found: &Implementation| -> Result<f64, EstimateError> {
                Ok(found.zero_delay_energy(&workload.streams(found)?).0.total() / 1e3)
            };
            let (implementation, mapping) = found.unzip();
            anyhow::Ok(CurveRow {
                pipeline: top.name(),
                flow,
                clock_ns,
                clock_fo4: clock_ns / fo4_ns(&library),
                mapping: mapping.unwrap_or_default(),
                critical_path_ns: implementation.map(|found| found.timing.critical_path_ns),
                logic_area_um2: implementation.map(Implementation::logic_um2),
                register_area_um2: implementation.map(|found| found.area().registers),
                energy_pj: implementation.map(energy).transpose()?,
            })
        };
        for factor in CLOCKS {
            let found = mappings.within(factor * shortest_ns)?;
            rows.push(row(factor * shortest_ns, "ours", Some((&found, found.recipe.to_string())))?);
        }
        drop(part);
        if installed().is_none() || args.liberty.is_empty() {
            continue;
        }
        let part = Part::endless(progress, &format!("ABC on {top}"));
        let asked: Vec<f64> = FURTHER.iter().chain(&CLOCKS).map(|factor| factor * shortest_ns).collect();
        let mut found = Vec::new();
        for script in &SCRIPTS {
            let all = mappings.by_abc(script, &asked, &args.liberty, folder.path())?;
            found.extend(all.into_iter().map(|implementation| (implementation, script.name)));
        }
        for factor in CLOCKS {
            let clock_ns = factor * shortest_ns;
            let met = found.iter().filter(|(found, _)| found.timing.critical_path_ns <= clock_ns);
            let best = met.min_by(|a, b| a.0.logic_um2().total_cmp(&b.0.logic_um2()));
            let best = best.map(|(found, script)| (found, format!("script `{script}`")));
            rows.push(row(clock_ns, "ABC", best)?);
        }
        let fastest =
            found.iter().min_by(|a, b| a.0.timing.critical_path_ns.total_cmp(&b.0.timing.critical_path_ns));
        if let Some((fastest, script)) = fastest {
            let clock_ns = fastest.timing.critical_path_ns;
            rows.push(row(clock_ns, "ABC", Some((fastest, format!("script `{script}`, fastest"))))?);
        }
        drop(part);
    }
    Ok(rows)
}

/// Writes the rows as CSV and as charts.
pub(super) fn write(rows: &[CurveRow], artifacts: &mut Artifacts) -> anyhow::Result<()> {
    let area = svg(rows, "Area against the clock", "area of logic, um2", |row| row.logic_area_um2);
    let energy = svg(rows, "Energy against the clock", "energy of an operation, pJ", |row| row.energy_pj);
    artifacts.write("curve.csv", &csv(rows)?)?;
    artifacts.write("curve-area.svg", area.as_bytes())?;
    artifacts.write("curve-energy.svg", energy.as_bytes())
}

fn csv(rows: &[CurveRow]) -> anyhow::Result<Vec<u8>> {
    let mut csv = ::csv::Writer::from_writer(vec![]);
    for row in rows {
        csv.serialize(row)?;
    }
    csv.into_inner().context("curve.csv")
}

/// A quantity of the rows against the clock, as SVG.
fn svg(rows: &[CurveRow], title: &str, label: &str, y: impl Fn(&CurveRow) -> Option<f64>) -> String {
    let mut series: Vec<Series> = Vec::new();
    for row in rows {
        let name = format!("{}, {}", row.pipeline, row.flow);
        let Some(y) = y(row) else { continue };
        let point = Point { x: row.clock_ns, y, ..Point::default() };
        match series.iter_mut().find(|series| series.name == name) {
            Some(series) => series.points.push(point),
            None => series.push(Series { name, style: Style::Line, points: vec![point] }),
        }
    }
    series.iter_mut().for_each(|series| series.points.sort_by(|a, b| a.x.total_cmp(&b.x)));
    let (x, y) = (Axis::linear("clock period, ns"), Axis::linear(label));
    Chart { title: title.to_owned(), x, y, series }.svg()
}

impl CurveRow {
    /// Area over that of ABC's row at the same clock.
    pub(super) fn over_abc(&self, rows: &[Self]) -> Option<f64> {
        let same =
            |row: &&Self| row.flow == "ABC" && row.pipeline == self.pipeline && row.clock_ns == self.clock_ns;
        Some(self.logic_area_um2? / rows.iter().find(same)?.logic_area_um2?)
    }
}
