//! Simulation of some of the estimated machines: how far their estimates are off, and which claims they judge otherwise.

use super::super::comparison::{Claim, compare};
use super::super::row::Row;
use super::{Frames, machines};
use crate::progress::{Part, Progress};
use machine::frame::{FrameMachine, frame};
use machines::Values;
use rayon::prelude::*;
use serde::Serialize;

/// A machine of the sample that was simulated as well.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[allow(missing_docs, reason = "keys of result files, with their units")]
pub struct Confirmation {
    /// Number of the machine in `machines.csv`.
    pub machine: usize,
    pub settings: Vec<String>,
    pub frames: usize,
    /// Mean of the estimates' distances from the simulations.
    pub mean_time_error_pct: f64,
    /// The estimate furthest from its simulation, with its sign.
    pub worst_time_error_pct: f64,
    pub worst_energy_error_pct: f64,
    pub claims: usize,
    /// The claims that the simulation judges otherwise, each with both verdicts.
    pub judged_otherwise: Vec<String>,
}

/// Numbers of `count` machines from the fastest to the slowest by their estimated `rows`, both included, at equal steps between.
/// Machine 0, the unchanged one, is none of them.
pub(super) fn chosen(rows: &[Vec<Row>], count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (1..rows.len()).collect();
    let time = |machine: &usize| rows[*machine].iter().map(|row| row.frame_ms).sum::<f64>();
    order.sort_by(|a, b| time(a).total_cmp(&time(b)));
    let count = count.min(order.len());
    let last = order.len().saturating_sub(1);
    (0..count).map(|step| order[if count == 1 { 0 } else { step * last / (count - 1) }]).collect()
}

/// Simulates the frames of machines `chosen`, whose `estimates` are there, and compares.
///
/// # Errors
/// A frame cannot be simulated.
pub(super) fn confirm(
    frames: &Frames<'_>,
    chosen: &[usize],
    estimates: &[Vec<Row>],
    sample: &[Values],
    progress: &dyn Progress,
) -> anyhow::Result<Vec<Confirmation>> {
    let all = chosen.first().map_or(0, |machine| estimates[*machine].len());
    let part = Part::begin(progress, (all * chosen.len()) as u64, "simulating some of the machines");
    let mut simulated: Vec<Vec<Row>> = vec![vec![]; chosen.len()];
    frames.each(progress, |place| {
        let rows = chosen.par_iter().map(|&machine| {
            let set_up = FrameMachine::new(&frames.descriptions[machine], place.structure, &frames.pipeline)?;
            let run = frame(&set_up, place.scene, place.converted, &place.options, |_| ())?;
            let results = set_up.results(&run.program, &run.counts)?;
            part.advance(1);
            frames.row(place, machine, run.rays, &results)
        });
        let rows: Vec<Row> = rows.collect::<anyhow::Result<_>>()?;
        simulated.iter_mut().zip(rows).for_each(|(rows, row)| rows.push(row));
        Ok(())
    })?;
    let confirmation = |(machine, simulated): (&usize, &Vec<Row>)| {
        compared(*machine, machines::settings(&sample[machine - 1]), &estimates[*machine], simulated)
    };
    Ok(chosen.iter().zip(&simulated).map(confirmation).collect())
}

/// What the rows of one machine say; both have the same frames in the same order.
fn compared(machine: usize, settings: Vec<String>, estimated: &[Row], simulated: &[Row]) -> Confirmation {
    let errors = |of: fn(&Row) -> f64| -> Vec<f64> {
        let pairs = estimated.iter().zip(simulated);
        pairs.map(|(estimate, simulation)| 100.0 * (of(estimate) / of(simulation) - 1.0)).collect()
    };
    let worst = |errors: &[f64]| {
        errors.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or_default()
    };
    let (time, energy) = (errors(|row| row.frame_ms), errors(|row| row.energy_mj));
    let [expected, found] = [compare(estimated, &[]), compare(simulated, &[])];
    let otherwise = |(expected, found): (&Claim, &Claim)| {
        (expected.holds != found.holds)
            .then(|| format!("{}: {} instead of {}", found.claim, found.holds, expected.holds))
    };
    Confirmation {
        machine,
        settings,
        frames: simulated.len(),
        mean_time_error_pct: time.iter().map(|error| error.abs()).sum::<f64>() / time.len() as f64,
        worst_time_error_pct: worst(&time),
        worst_energy_error_pct: worst(&energy),
        claims: found.len(),
        judged_otherwise: expected.iter().zip(&found).filter_map(otherwise).collect(),
    }
}
