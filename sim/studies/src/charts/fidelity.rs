//! A frame at every level on samples of every size, compared with the most detailed simulation of the whole frame.

use crate::fidelity::{Estimate, FidelityError, Level, Sample, Subject};
use serde::Serialize;
use view::plot::{Axis, Chart, Point, Series, Style};

/// A level on a sample, with means over the draws of that sample.
#[derive(Clone, Debug, Serialize)]
pub struct FidelityPoint {
    /// The level.
    pub level: &'static str,
    /// What puts the caches in the frame's state: `functional` for a lead and the lines of pixels left out, `lead` for a lead
    /// alone, `none` for neither; empty where no pixel is left out.
    pub warming: &'static str,
    /// Batches that were measured.
    pub batches: u32,
    /// Number of samples drawn, each with its own seed.
    pub draws: u32,
    /// Share of the pixels that were timed.
    pub pixels_timed_share: f64,
    /// Seconds of the host for one draw.
    pub seconds: f64,
    /// Milliseconds of the frame.
    pub frame_ms: f64,
    /// Millijoules of the frame.
    pub energy_mj: f64,
    /// Mean error of the frame time in percent. Over many draws, this is the bias.
    pub time_error_pct: f64,
    /// Standard deviation of that error over draws; absent for one draw.
    pub time_spread_pct: Option<f64>,
    /// Half of the 95 % interval, mean of the draws.
    pub time_interval_pct: f64,
    /// Mean error of the frame time in percent, if all timed pixels, cold start and end included, stood for the rest.
    pub plain_time_error_pct: f64,
    /// Mean error of the energy in percent.
    pub energy_error_pct: f64,
    /// Mean error of the energy in percent, if all timed pixels, cold start and end included, stood for the rest.
    pub plain_energy_error_pct: f64,
    /// Standard deviation of `energy_error_pct` over draws; absent for one draw.
    pub energy_spread_pct: Option<f64>,
    /// Half of the 95 % interval, mean of the draws.
    pub energy_interval_pct: f64,
}

/// The setting of a point: the level, the strata of the sample (`None` for the whole frame), and what warms the caches.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Setting {
    level: Level,
    pairs: Option<u32>,
    lead: bool,
    warms: bool,
}

/// All points of a chart, the most detailed simulation of the whole frame last. `done` is called after each run.
///
/// # Errors
/// [`FidelityError`].
pub fn points(
    subject: &Subject<'_>,
    rtl: bool,
    repeats: u32,
    seed: u64,
    mut done: impl FnMut(),
) -> Result<Vec<FidelityPoint>, FidelityError> {
    let settings = settings(subject, rtl);
    let mut runs = vec![];
    for setting in &settings {
        let draws = if setting.pairs.is_some() { repeats } else { 1 };
        let mut estimates = vec![];
        for draw in 0..draws {
            let sample = Sample {
                lead_fills: if setting.lead { Sample::ALL.lead_fills } else { 0.0 },
                warms: setting.warms,
                ..setting.pairs.map_or(Sample::ALL, |pairs| Sample::of(pairs, seed + u64::from(draw)))
            };
            estimates.push(subject.estimate(setting.level, &sample, |_| {})?);
            done();
        }
        runs.push(estimates);
    }
    let reference = &runs.last().expect("the whole frame is always run")[0];
    let reference = (reference.frame_ms.value, reference.energy_mj.value);
    Ok(settings.iter().zip(&runs).map(|(setting, runs)| point(setting, runs, reference)).collect())
}

/// Number of runs of [`points`].
#[must_use]
pub fn runs(subject: &Subject<'_>, rtl: bool, repeats: u32) -> u64 {
    let draws = |setting: &Setting| u64::from(if setting.pairs.is_some() { repeats } else { 1 });
    settings(subject, rtl).iter().map(draws).sum()
}

fn settings(subject: &Subject<'_>, rtl: bool) -> Vec<Setting> {
    let drawable = subject.batches(Sample::ALL.batch_fills).drawable();
    // Powers of two of pairs, as long as a sample is smaller than the frame.
    let pairs: Vec<u32> = (1..12).map(|k| 1 << k).take_while(|pairs| 3 * pairs <= drawable).collect();
    let all = |level| Setting { level, pairs: None, lead: true, warms: true };
    let rtl = rtl && subject.machine.pipeline.is_some();
    let mut settings = vec![];
    for &pairs in &pairs {
        settings.push(Setting { pairs: Some(pairs), ..all(Level::Analytic) });
    }
    settings.push(all(Level::Analytic));
    settings.push(all(Level::Queueing));
    for (lead, warms) in [(false, false), (true, false), (true, true)] {
        for &pairs in &pairs {
            settings.push(Setting { level: Level::Transaction, pairs: Some(pairs), lead, warms });
        }
    }
    if rtl {
        for &pairs in pairs.first().into_iter() {
            settings.push(Setting { pairs: Some(pairs), ..all(Level::Rtl) });
        }
    }
    settings.push(all(Level::Transaction));
    if rtl {
        settings.push(all(Level::Rtl));
    }
    settings
}

fn point(setting: &Setting, runs: &[Estimate], reference: (f64, f64)) -> FidelityPoint {
    let draws = runs.len() as f64;
    let mean = |of: &dyn Fn(&Estimate) -> f64| runs.iter().map(of).sum::<f64>() / draws;
    let time = |e: &Estimate| 100.0 * (e.frame_ms.value / reference.0 - 1.0);
    let energy = |e: &Estimate| 100.0 * (e.energy_mj.value / reference.1 - 1.0);
    let spread = |of: &dyn Fn(&Estimate) -> f64| {
        let centre = mean(of);
        let squares: f64 = runs.iter().map(|run| (of(run) - centre).powi(2)).sum();
        (runs.len() > 1).then(|| (squares / (draws - 1.0)).sqrt())
    };
    FidelityPoint {
        level: setting.level.name(),
        warming: match (setting.pairs, setting.level, setting.lead, setting.warms) {
            (None, ..) | (_, Level::Analytic, ..) => "",
            (_, _, _, true) => "functional",
            (_, _, true, false) => "lead",
            _ => "none",
        },
        batches: runs[0].measured,
        draws: runs.len() as u32,
        pixels_timed_share: mean(&|run| run.timed_share),
        seconds: mean(&|run| run.seconds),
        frame_ms: mean(&|run| run.frame_ms.value),
        energy_mj: mean(&|run| run.energy_mj.value),
        time_error_pct: mean(&time),
        plain_time_error_pct: mean(&|e: &Estimate| 100.0 * (e.plain[0] / reference.0 - 1.0)),
        plain_energy_error_pct: mean(&|e: &Estimate| 100.0 * (e.plain[1] / reference.1 - 1.0)),
        time_spread_pct: spread(&time),
        time_interval_pct: mean(&|run| 100.0 * run.frame_ms.relative()),
        energy_error_pct: mean(&energy),
        energy_spread_pct: spread(&energy),
        energy_interval_pct: mean(&|run| 100.0 * run.energy_mj.relative()),
    }
}

/// Charts of the errors in frame time and in energy against the host's time, with intervals.
#[must_use]
pub fn charts(title: &str, points: &[FidelityPoint]) -> [(&'static str, Chart); 2] {
    let chart = |what: &str, of: fn(&FidelityPoint) -> (f64, f64), plain: fn(&FidelityPoint) -> f64| {
        let series = |name: &str, level: Level, warming: &[&str]| {
            let mine = points.iter().filter(|p| p.level == level.name() && warming.contains(&p.warming));
            let point = |p: &FidelityPoint| {
                let (error, half) = of(p);
                Point {
                    x: p.seconds,
                    y: error,
                    y_range: Some((error - half, error + half)),
                    label: Some(if p.warming.is_empty() && level != Level::Analytic {
                        "all".to_owned()
                    } else {
                        p.batches.to_string()
                    }),
                    ..Point::default()
                }
            };
            Series { name: name.to_owned(), style: Style::Points, points: mine.map(point).collect() }
        };
        let sampled = points.iter().filter(|p| p.warming == "functional" && p.level != Level::Rtl.name());
        let uncorrected = Series {
            name: "transaction, cold start not corrected".to_owned(),
            style: Style::Points,
            points: sampled.map(|p| Point { x: p.seconds, y: plain(p), ..Point::default() }).collect(),
        };
        Chart {
            title: format!("{title}: error in {what}; batches measured beside each point"),
            x: Axis::log("host time per frame (s)"),
            y: Axis::linear("error (%), 95 % interval"),
            series: vec![
                series("queueing", Level::Queueing, &[""]),
                series("transaction", Level::Transaction, &["functional", ""]),
                series("rtl", Level::Rtl, &["functional", ""]),
                uncorrected,
            ],
        }
    };
    [
        (
            "time-error",
            chart("frame time", |p| (p.time_error_pct, p.time_interval_pct), |p| p.plain_time_error_pct),
        ),
        (
            "energy-error",
            chart("energy", |p| (p.energy_error_pct, p.energy_interval_pct), |p| p.plain_energy_error_pct),
        ),
    ]
}
