//! The queueing level: many machines from one execution of the frame.

use super::{Estimate, FidelityError, Interval, Level, Subject};
use machine::frame::FrameMachine;
use machine::program::Program;
use machine::queueing;
use std::time::Instant;

/// The greatest error that this level was measured to make in frame time and energy, as a fraction (`docs/fidelity.md`). Intervals
/// reach so far to either side.
pub const ERROR: f64 = 0.1;

/// Estimates the frame of `subject` on each of `machines` with its program, in their order. Machines whose threads execute the same
/// share one execution.
///
/// # Errors
/// [`FidelityError`].
///
/// # Panics
/// If a machine is set up for another kind of structure than the subject's.
pub fn estimates(
    subject: &Subject<'_>,
    machines: &[(FrameMachine, Program)],
    mut pixels_done: impl FnMut(u32),
) -> Result<Vec<Estimate>, FidelityError> {
    let mut open: Vec<usize> = (0..machines.len()).collect();
    let mut estimates: Vec<Option<Estimate>> = vec![None; machines.len()];
    while let Some(first) = open.first() {
        let start = Instant::now();
        let work = Subject { machine: &machines[*first].0, ..*subject }.work(false)?;
        let (alike, others): (Vec<usize>, Vec<usize>) = open.iter().partition(|number| {
            let (machine, program) = &machines[**number];
            work.records_for(machine, program)
        });
        open = others;
        let timed = alike.iter().map(|number| &machines[*number]);
        let timed: Vec<_> = timed.map(|(machine, program)| (&machine.description, program)).collect();
        let counts = queueing::estimate(&timed, &work, &mut pixels_done)?;
        let (_, totals) = work.finish()?;
        let seconds = start.elapsed().as_secs_f64() / alike.len() as f64;
        for (number, counts) in alike.into_iter().zip(counts) {
            let (machine, program) = &machines[number];
            let results = machine.results(program, &counts)?;
            let (ms, mj) = (results.frame_ms, results.energy_mj.total);
            let batches = Subject { machine, ..*subject }.batches(1.0).count;
            estimates[number] = Some(Estimate {
                level: Level::Queueing,
                batches,
                measured: batches,
                timed_share: 1.0,
                counts,
                results,
                frame_ms: Interval::around(ms, ERROR * ms),
                energy_mj: Interval::around(mj, ERROR * mj),
                plain: [ms, mj],
                bound_by: None,
                totals,
                seconds,
            });
        }
    }
    Ok(estimates.into_iter().map(|estimate| estimate.expect("every machine is in a group")).collect())
}
