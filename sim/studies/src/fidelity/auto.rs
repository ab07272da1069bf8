//! The choice of level and sample by a tolerance: from the cheapest ones upwards, until the result is within it.

use super::{BIAS, Estimate, FidelityError, Level, Sample, Subject};

/// Strata of the first sample, by which the variance is judged.
const FIRST_PAIRS: u32 = 6;
/// Batches that a frame needs to have so many strata.
pub const FEWEST_BATCHES: u32 = 2 * FIRST_PAIRS;
/// Factor by which a sample exceeds its predicted size, because the prediction uses an estimated variance.
const MARGIN: f64 = 1.3;
/// The share of pixels timed from which on a sample costs nearly as much as the whole frame, which is then simulated instead.
const WHOLE_FROM: f64 = 0.7;

/// One estimate on the way to the result, with the reason to stop or to go on.
#[derive(Clone, Debug)]
pub struct Step {
    /// The estimate.
    pub estimate: Estimate,
    /// Why the estimate is sufficient or not.
    pub verdict: String,
}

/// Estimates the frame of `subject` on growing samples, until the 95 % intervals of time and energy reach no farther than
/// `tolerance`, a fraction of the value, to either side. The last step is the result.
///
/// # Errors
/// [`FidelityError`].
pub fn auto(
    subject: &Subject<'_>,
    tolerance: f64,
    seed: u64,
    mut pixels_done: impl FnMut(u32) + Send,
) -> Result<Vec<Step>, FidelityError> {
    let mut steps = vec![];
    let estimate = subject.estimate(Level::Analytic, &Sample::of(FIRST_PAIRS, seed), &mut pixels_done)?;
    let verdict = format!(
        "a lower bound by {}: it says nothing about waiting",
        estimate.bound_by.as_deref().unwrap_or("nothing")
    );
    steps.push(Step { estimate, verdict });
    let mut pairs = FIRST_PAIRS;
    loop {
        let sample = next_sample(subject, tolerance, pairs, seed)?;
        let estimate = subject.estimate(Level::Transaction, &sample, &mut pixels_done)?;
        let worst = estimate.frame_ms.relative().max(estimate.energy_mj.relative());
        if estimate.is_whole() {
            steps.push(Step { estimate, verdict: "the frame itself; no interval is left".to_owned() });
            return Ok(steps);
        }
        let percent = |x: f64| format!("{:.2} %", 100.0 * x);
        if estimate.is_within(tolerance) {
            let verdict = format!("{} is within {}", percent(worst), percent(tolerance));
            steps.push(Step { estimate, verdict });
            return Ok(steps);
        }
        pairs = next_pairs(subject, pairs, worst, tolerance);
        let verdict = format!("{} is not within {}", percent(worst), percent(tolerance));
        steps.push(Step { estimate, verdict });
    }
}

/// The sample of `pairs` strata, or the whole frame if it costs hardly more or if no sample can be within the tolerance.
fn next_sample(
    subject: &Subject<'_>,
    tolerance: f64,
    pairs: u32,
    seed: u64,
) -> Result<Sample, FidelityError> {
    let sample = Sample::of(pairs, seed);
    let (batches, _, plan) = subject.plan(&sample)?;
    let skipped: usize = plan.skipped.iter().map(ExactSizeIterator::len).sum();
    let timed = 1.0 - skipped as f64 / f64::from(batches.items);
    Ok(if timed >= WHOLE_FROM || tolerance <= BIAS { Sample::ALL } else { sample })
}

/// The number of strata that brings an interval within `tolerance`, if `pairs` strata gave it the half width `relative`.
///
/// The square of the half width is proportional to `1/n - 1/N` for `n` of `N` batches.
fn next_pairs(subject: &Subject<'_>, pairs: u32, relative: f64, tolerance: f64) -> u32 {
    let all = f64::from(subject.batches(1.0).drawable().max(1));
    let now = 1.0 / f64::from(2 * pairs) - 1.0 / all;
    let wanted = ((tolerance - BIAS) / (relative - BIAS).max(1e-9)).powi(2) * now.max(0.0);
    let batches = MARGIN / (wanted + 1.0 / all);
    ((batches / 2.0).ceil() as u32).max(pairs + pairs.div_ceil(2))
}
