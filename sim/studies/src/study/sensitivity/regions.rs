//! For which machines a claim holds, and on which key that depends.

use super::machines::{RANGES, Values, shuffle};
use base::split_mix;
use serde::Serialize;

/// From this share of the machines on, a claim holds on whatever machine.
const ROBUST: f64 = 0.95;
/// Draws of the permutation test.
const DRAWS: usize = 400;
/// The share of draws that a key has to beat.
const CONFIDENCE: f64 = 0.99;

/// Where a claim holds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Region {
    /// Machines for which the claim could be judged.
    pub machines: usize,
    /// The share of these for which it holds in all scenes that it is about.
    pub holds: f64,
    /// The share for which it holds in some scenes.
    pub partly: f64,
    /// `robust`; `never`; `seldom`, where it holds on the machine that is varied and on none of these; `depends on KEY`; or `no single key`.
    pub verdict: String,
    /// The keys on which it depends, the strongest first.
    pub keys: Vec<Dependence>,
}

/// How a claim depends on a key.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Dependence {
    /// The key.
    pub key: &'static str,
    /// The share of the scores' variance that the key explains.
    pub explained: f64,
    /// For each value of the key, the mean score of its machines: 1 where the claim holds, a half where it holds in some scenes.
    pub scores: Vec<(&'static str, f64)>,
}

/// Judges a claim by its `scores` on `machines` and on the machine that is varied; a claim without a score could not be judged.
#[must_use]
pub fn region(machines: &[Values], scores: &[Option<f64>], unchanged: Option<f64>) -> Region {
    let judged: Vec<(&Values, f64)> =
        machines.iter().zip(scores).filter_map(|(machine, score)| Some((machine, (*score)?))).collect();
    let count = judged.len().max(1) as f64;
    let share = |score: f64| judged.iter().filter(|(_, found)| *found == score).count() as f64 / count;
    let (holds, partly) = (share(1.0), share(0.5));
    let keys = dependences(&judged);
    let verdict = match keys.first() {
        _ if judged.is_empty() => "no data".to_owned(),
        _ if holds >= ROBUST => "robust".to_owned(),
        _ if holds == 0.0 && partly == 0.0 && unchanged > Some(0.0) => "seldom".to_owned(),
        _ if holds == 0.0 && partly == 0.0 => "never".to_owned(),
        Some(first) => format!("depends on {}", first.key),
        None => "no single key".to_owned(),
    };
    Region { machines: judged.len(), holds, partly, verdict, keys }
}

/// The keys that explain more of the scores than chance does, the strongest first.
fn dependences(judged: &[(&Values, f64)]) -> Vec<Dependence> {
    let machines: Vec<&Values> = judged.iter().map(|(machine, _)| *machine).collect();
    let scores: Vec<f64> = judged.iter().map(|(_, score)| *score).collect();
    let of = |at: usize, scores: &[f64]| explained(&machines, scores, at);
    // What the strongest key explains if the scores are dealt out at random.
    let mut state = split_mix::hash(DRAWS as u64);
    let mut dealt = scores.clone();
    let mut chance: Vec<f64> = (0..DRAWS)
        .map(|_| {
            shuffle(&mut dealt, &mut state);
            (0..RANGES.len()).map(|at| of(at, &dealt)).fold(0.0, f64::max)
        })
        .collect();
    chance.sort_by(f64::total_cmp);
    let least = chance[(CONFIDENCE * DRAWS as f64) as usize - 1];
    let dependence = |at: usize| {
        let explained = of(at, &scores);
        (explained > least).then(|| Dependence {
            key: RANGES[at].key,
            explained,
            scores: means(&machines, &scores, at).into_iter().map(|(value, mean, _)| (value, mean)).collect(),
        })
    };
    let mut found: Vec<Dependence> = (0..RANGES.len()).filter_map(dependence).collect();
    found.sort_by(|a, b| b.explained.total_cmp(&a.explained));
    found
}

/// For each value of key `at`: the value, the mean score of its machines, and their number.
fn means(machines: &[&Values], scores: &[f64], at: usize) -> Vec<(&'static str, f64, f64)> {
    let values = RANGES[at].values.iter().enumerate().map(|(value, name)| {
        let own = machines.iter().zip(scores).filter(|(machine, _)| machine[at] == value);
        let (sum, count) = own.fold((0.0, 0.0), |(sum, count), (_, score)| (sum + score, count + 1.0));
        (*name, if count > 0.0 { sum / count } else { 0.0 }, count)
    });
    values.filter(|(_, _, count)| *count > 0.0).collect()
}

/// The share of the variance of `scores` that lies between the values of key `at`.
fn explained(machines: &[&Values], scores: &[f64], at: usize) -> f64 {
    let mean = scores.iter().sum::<f64>() / scores.len().max(1) as f64;
    let all: f64 = scores.iter().map(|score| (score - mean).powi(2)).sum();
    let between: f64 =
        means(machines, scores, at).iter().map(|(_, own, count)| count * (own - mean).powi(2)).sum();
    if all > 0.0 { between / all } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::super::machines::sample;
    use super::*;

    fn judge(score: impl Fn(&Values, usize) -> Option<f64>) -> Region {
        let machines = sample(48, 1);
        let scores: Vec<Option<f64>> =
            machines.iter().enumerate().map(|(at, machine)| score(machine, at)).collect();
        region(&machines, &scores, Some(0.0))
    }

    #[test]
    fn a_claim_holds_everywhere_nowhere_or_by_a_key() {
        assert_eq!(judge(|_, _| Some(1.0)).verdict, "robust");
        assert_eq!(judge(|_, _| Some(0.0)).verdict, "never");
        assert_eq!(judge(|_, _| None).verdict, "no data");
        let key = RANGES.iter().position(|range| range.key == "dram.channels").unwrap();
        let few = judge(|machine, _| Some(f64::from(u8::from(machine[key] < 2))));
        assert_eq!((few.verdict.as_str(), few.holds), ("depends on dram.channels", 0.5));
        assert_eq!(few.keys[0].scores, [("1", 1.0), ("2", 1.0), ("4", 0.0), ("8", 0.0)]);
        assert!((few.keys[0].explained - 1.0).abs() < 1e-12);
    }

    #[test]
    fn what_chance_explains_is_no_dependence() {
        let scattered = judge(|_, at| Some((split_mix::hash(at as u64 + 7) % 2) as f64));
        assert_eq!((scattered.verdict.as_str(), scattered.keys.len()), ("no single key", 0));
    }
}
