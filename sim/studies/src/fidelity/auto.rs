//! No more than the tolerance asks for: from the cheapest level and sample upwards.

use super::{BIAS, Estimate, FidelityError, Level, Sample, Subject};

/// Strata of the first sample: what the variance is judged by.
const FIRST_PAIRS: u32 = 6;
/// More than a sample is predicted to need, as its variance is itself estimated.
const MARGIN: f64 = 1.3;
/// From this share of the pixels on, the frame itself is the cheapest way to be sure.
const WHOLE_FROM: f64 = 0.7;

/// A step on the way, with the reason for the next one.
#[derive(Clone, Debug)]
pub struct Step {
    /// What was found.
    pub estimate: Estimate,
    /// Why it was enough, or not.
    pub verdict: String,
}

/// Estimates the frame of `subject` until the 95 % intervals of time and energy are within `tolerance` of their values to
/// either side. The last step is the result.
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

/// The sample of `pairs` strata, or the whole frame if that costs hardly more or nothing else can be within the tolerance.
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

/// Strata that bring an interval of `relative` half width within `tolerance`: its square goes with `1/n - 1/N` for `n`
/// batches of `N`.
fn next_pairs(subject: &Subject<'_>, pairs: u32, relative: f64, tolerance: f64) -> u32 {
    let all = f64::from(subject.batches(1.0).drawable().max(1));
    let now = 1.0 / f64::from(2 * pairs) - 1.0 / all;
    let wanted = ((tolerance - BIAS) / (relative - BIAS).max(1e-9)).powi(2) * now.max(0.0);
    let batches = MARGIN / (wanted + 1.0 / all);
    ((batches / 2.0).ceil() as u32).max(pairs + pairs.div_ceil(2))
}
