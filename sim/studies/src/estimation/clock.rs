//! The clock that is asked for, and whether a pipeline meets it.

use estimate::{Implementation, StageRow};
use gates::liberty::Library;
use gates::timing::fo4_ns;
use serde::Serialize;
use std::str::FromStr;

/// Shortest and longest period, in nanoseconds.
const PERIODS_NS: std::ops::RangeInclusive<f64> = 1e-3..=1e6;

/// A clock to map for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clock {
    /// As fast as the mapper gets.
    Fastest,
    /// A period in nanoseconds.
    Ns(f64),
    /// A period in delays of an inverter that drives four of its kind.
    Fo4(f64),
}

impl FromStr for Clock {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let lower = text.to_ascii_lowercase();
        if lower == "fastest" {
            return Ok(Self::Fastest);
        }
        let units = ["ghz", "mhz", "fo4", "ps", "ns"];
        let found = units.into_iter().find_map(|unit| Some((lower.strip_suffix(unit)?, unit)));
        let parsed = found.and_then(|(digits, unit)| Some((digits.trim().parse::<f64>().ok()?, unit)));
        let clock = match parsed {
            Some((x, "ghz")) => Self::Ns(1.0 / x),
            Some((x, "mhz")) => Self::Ns(1e3 / x),
            Some((x, "ps")) => Self::Ns(x / 1e3),
            Some((x, "ns")) => Self::Ns(x),
            Some((x, _)) => Self::Fo4(x),
            None => return Err("give a clock such as 1GHz, 500ps, 2ns, 40fo4, or fastest".to_owned()),
        };
        match clock {
            Self::Ns(ns) if !PERIODS_NS.contains(&ns) => {
                Err("the period has to be from 1ps to 1ms".to_owned())
            }
            Self::Fo4(fo4) if !(0.1..=1e6).contains(&fo4) => {
                Err("the period has to be from 0.1fo4 to 1e6fo4".to_owned())
            }
            clock => Ok(clock),
        }
    }
}

impl Clock {
    /// The period in a library; 0 for the fastest.
    #[must_use]
    pub fn period_ns(self, library: &Library) -> f64 {
        match self {
            Self::Fastest => 0.0,
            Self::Ns(ns) => ns,
            Self::Fo4(fo4) => fo4 * fo4_ns(library),
        }
    }
}

/// The clock that a pipeline's numbers hold for.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct ClockRow {
    /// The period: what was asked for, or else the critical path.
    pub period_ns: f64,
    pub period_fo4: f64,
    /// The period less the critical path; absent where no period was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub slack_ns: Option<f64>,
    /// How gates became cells.
    pub mapping: String,
    /// The critical path of each stage.
    pub stages: Vec<StageRow>,
}

impl ClockRow {
    pub(super) fn of(implementation: &Implementation, clock: Option<Clock>) -> Self {
        let library = implementation.library;
        let path_ns = implementation.timing.critical_path_ns;
        let asked = clock.map(|clock| clock.period_ns(library)).filter(|&ns| ns > 0.0);
        let period_ns = asked.unwrap_or(path_ns);
        let sized =
            if clock.is_some() { "proved equal to its gates" } else { "sized until no path gets shorter" };
        Self {
            period_ns,
            period_fo4: period_ns / fo4_ns(library),
            slack_ns: asked.map(|ns| ns - path_ns),
            mapping: format!("{}, {sized}", implementation.recipe),
            stages: implementation.stages(),
        }
    }

    /// Whether the pipeline is too slow for the clock that was asked for.
    #[must_use]
    pub fn is_missed(&self) -> bool {
        self.slack_ns.is_some_and(|slack| slack < 0.0)
    }

    /// The stage with the longest path.
    pub(super) fn longest(&self) -> Option<&StageRow> {
        self.stages.iter().max_by(|a, b| a.path_ns.total_cmp(&b.path_ns))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimation::timing_report::missed;
    use estimate::Mappings;
    use gates::liberty::embedded;
    use pipelines::catalogue::Top;

    #[test]
    fn a_missed_clock_has_its_slack_and_path() {
        let library = embedded();
        let mappings = Mappings::new(Top::FpCmp, &library).unwrap();
        for (text, is_missed) in [("50ps", true), ("200fo4", false)] {
            let clock: Clock = text.parse().unwrap();
            let found = mappings.within(clock.period_ns(&library)).unwrap();
            let row = ClockRow::of(&found, Some(clock));
            assert_eq!(row.is_missed(), is_missed, "{text}");
            let (longest, slack_ns) = (row.longest().unwrap(), row.slack_ns.unwrap());
            assert!((row.period_ns - longest.path_ns - slack_ns).abs() < 1e-12, "{text}");
            assert_eq!(missed("it", &row).is_some(), is_missed, "{text}");
        }
        let found = mappings.within(0.05).unwrap();
        let note = missed("it", &ClockRow::of(&found, Some(Clock::Ns(0.05)))).unwrap();
        assert!(
            note.starts_with("it misses the clock by ") && note.contains(", in stage 1, from "),
            "{note}"
        );
        // Without a clock there is none to miss.
        assert!(missed("it", &ClockRow::of(&found, None)).is_none());
    }

    #[test]
    fn clocks_and_what_is_none() {
        for (text, clock) in [
            ("1GHz", Clock::Ns(1.0)),
            ("250mhz", Clock::Ns(4.0)),
            ("500ps", Clock::Ns(0.5)),
            ("2.5 ns", Clock::Ns(2.5)),
            ("40fo4", Clock::Fo4(40.0)),
            ("fastest", Clock::Fastest),
        ] {
            assert_eq!(text.parse(), Ok(clock), "{text}");
        }
        for text in ["", "1", "GHz", "1 s", "-1ns", "0GHz", "nan ns", "inf fo4", "1e9ns", "0fo4", "slow"] {
            assert!(text.parse::<Clock>().is_err(), "{text}");
        }
    }
}
