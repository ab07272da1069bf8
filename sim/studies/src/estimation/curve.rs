//! Area and energy of both pipelines against the clock, by our mapper and by ABC's best script where ABC is installed.

use super::Options;
use super::mapper::by_abc;
use crate::artifacts::Artifacts;
use crate::progress::{Part, Progress};
use anyhow::Context;
use estimate::{EstimateError, Implementation, Mappings, Workload};
use gates::abc::installed;
use gates::liberty::Library;
use gates::timing::fo4_ns;
use pipelines::catalogue::Top;
use serde::Serialize;
use view::plot::{Axis, Chart, Point, Series, Style};

/// The clocks, in multiples of the shortest period that our mapper reaches.
const CLOCKS: [f64; 5] = [1.0, 1.1, 1.25, 1.5, 2.0];

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
    let with_abc = installed().is_some() && !args.liberty.is_empty();
    let tops = [Top::DualSplit, Top::RayBox];
    let steps = 1 + CLOCKS.len() + usize::from(with_abc);
    let part = Part::begin(progress, (steps * tops.len()) as u64, "mapping for several clocks");
    let mut rows = Vec::new();
    for top in tops {
        progress.next(&format!("covers of {top}"));
        let mappings = Mappings::new(top, library)?;
        part.advance(1);
        let row = |flow: &'static str, clock_ns: f64, found: &Implementation| -> Result<_, EstimateError> {
            let is_met = found.timing.critical_path_ns <= clock_ns;
            let met = |value: f64| is_met.then_some(value);
            let energy = found.zero_delay_energy(&workload.streams(found)?).0.total() / 1e3;
            Ok(CurveRow {
                pipeline: top.name(),
                flow,
                clock_ns,
                clock_fo4: clock_ns / fo4_ns(library),
                mapping: if is_met { found.recipe.to_string() } else { String::new() },
                critical_path_ns: met(found.timing.critical_path_ns),
                logic_area_um2: met(found.logic_um2()),
                register_area_um2: met(found.area().registers),
                energy_pj: met(energy),
            })
        };
        progress.next(&format!("{top} as fast as it gets"));
        let fastest = mappings.within(0.0)?;
        let clocks_ns = CLOCKS.map(|factor| factor * fastest.timing.critical_path_ns);
        rows.push(row("ours", clocks_ns[0], &fastest)?);
        part.advance(1);
        for &clock_ns in &clocks_ns[1..] {
            progress.next(&format!("{top} at {clock_ns:.3} ns"));
            rows.push(row("ours", clock_ns, &mappings.within(clock_ns)?)?);
            part.advance(1);
        }
        if !with_abc {
            continue;
        }
        progress.next(&format!("{top} by ABC"));
        let found = by_abc(args, &mappings, &[&[0.0], &clocks_ns[..]].concat())?;
        let path_ns = found[0].timing.critical_path_ns;
        for (&clock_ns, found) in [path_ns].iter().chain(&clocks_ns).zip(&found) {
            rows.push(row("ABC", clock_ns, found)?);
        }
        part.advance(1);
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
