//! Logarithmic scales, with ticks at 1, 2 and 5 of each decade. There are fewer ticks over many decades, and more
//! within one.

use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use std::ops::Range;

/// A logarithmic scale.
#[derive(Clone, Debug)]
pub struct LogScale {
    low: f64,
    high: f64,
}

/// The fewest ticks by which values can be read off.
const LEAST: usize = 3;

impl LogScale {
    /// A scale from `low` to `high`.
    ///
    /// # Panics
    /// If `low` and `high` are not positive and finite, or `low` is not less than `high`.
    pub fn new(low: f64, high: f64) -> Self {
        assert!(0.0 < low && low < high && high.is_finite(), "a logarithmic scale from {low} to {high}");
        Self { low, high }
    }

    /// At most `most` ticks.
    fn ticks(&self, most: usize) -> Vec<f64> {
        let fits = |ticks: &Vec<f64>| ticks.len() <= most;
        let all = std::iter::once(self.at_digits([1, 2, 5], 1));
        // No two numbers are more than 700 decades apart.
        let sparser = (1..=700).map(|decades| self.at_digits([1], decades));
        let found = all.chain(sparser).find(fits).unwrap_or_default();
        if found.len() >= LEAST {
            return found;
        }
        let denser = [self.at_digits(1..=9, 1), self.at_steps(most)];
        denser.into_iter().find(|ticks| fits(ticks) && ticks.len() >= LEAST).unwrap_or(found)
    }

    /// Ticks at `digits` times a power of ten, in every `decades`th decade.
    fn at_digits(&self, digits: impl IntoIterator<Item = u32> + Clone, decades: i32) -> Vec<f64> {
        let exponent = |value: f64| value.log10().floor() as i32;
        let all = exponent(self.low)..=exponent(self.high) + 1;
        let powers = all.filter(|exponent| exponent.rem_euclid(decades) == 0);
        let ticks = powers
            .flat_map(|exponent| digits.clone().into_iter().map(move |digit| in_decimal(digit, exponent)));
        ticks.filter(|tick| (self.low..=self.high).contains(tick)).collect()
    }

    /// Ticks at equal distances of 1, 2 or 5 times a power of ten.
    fn at_steps(&self, most: usize) -> Vec<f64> {
        let exponent = (self.high - self.low).log10().floor() as i32;
        let steps = (exponent - 2..=exponent).flat_map(|e| [1, 2, 5].map(|digit| (digit, e)));
        let ticks = |(digit, exponent): (u32, i32)| {
            let step = in_decimal(digit, exponent);
            let (first, last) = ((self.low / step).ceil(), (self.high / step).floor());
            // The steps are counted, so that rounding does not add up. There are a thousand at most.
            (0..=(last - first) as usize).map(|n| (first + n as f64) * step).collect::<Vec<_>>()
        };
        steps.map(ticks).find(|ticks| ticks.len() <= most).unwrap_or_default()
    }
}

/// `digit` times ten to the power `exponent`, correctly rounded.
fn in_decimal(digit: u32, exponent: i32) -> f64 {
    format!("{digit}e{exponent}").parse().expect("a number")
}

impl Ranged for LogScale {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        // Differences of logarithms, as the ratio of numbers may be infinite.
        let part = (value.ln() - self.low.ln()) / (self.high.ln() - self.low.ln());
        from + (f64::from(to - from) * part).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        self.ticks(hint.bold_points())
    }

    fn range(&self) -> Range<f64> {
        self.low..self.high
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ticks(low: f64, high: f64) -> Vec<f64> {
        LogScale::new(low, high).ticks(11)
    }

    #[test]
    fn every_decade_has_ticks_from_the_first_on() {
        assert_eq!(ticks(130.0, 2300.0), [200.0, 500.0, 1000.0, 2000.0]);
        assert_eq!(ticks(0.03, 1.0), [0.05, 0.1, 0.2, 0.5, 1.0]);
        assert_eq!(ticks(0.02, 20.0), [0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0]);
    }

    #[test]
    fn over_many_decades_there_are_powers_of_ten_only_and_then_not_all_of_them() {
        assert_eq!(ticks(0.5, 2e5), [1.0, 10.0, 100.0, 1e3, 1e4, 1e5]);
        assert_eq!(ticks(1e-10, 1e10).len(), 11);
        for (low, high) in [(1e-3, 1e30), (1e-3, 1e300), (f64::MIN_POSITIVE, f64::MAX)] {
            let ticks = ticks(low, high);
            assert!((3..=11).contains(&ticks.len()), "{ticks:?}");
        }
    }

    #[test]
    fn within_a_decade_there_are_enough_all_the_same() {
        assert_eq!(ticks(2.1, 4.9), [2.5, 3.0, 3.5, 4.0, 4.5]);
        assert_eq!(ticks(2.1, 6.5), [3.0, 4.0, 5.0, 6.0]);
        assert_eq!(ticks(101.0, 104.0), [101.0, 101.5, 102.0, 102.5, 103.0, 103.5, 104.0]);
    }

    #[test]
    fn equal_ratios_are_equally_long() {
        let scale = LogScale::new(0.1, 1000.0);
        assert_eq!([0.1, 1.0, 10.0, 1000.0].map(|value| scale.map(&value, (0, 400))), [0, 100, 200, 400]);
        assert_eq!([0.1, 1.0, 1000.0].map(|value| scale.map(&value, (400, 0))), [400, 300, 0]);
        let widest = LogScale::new(f64::MIN_POSITIVE, f64::MAX);
        assert_eq!([f64::MIN_POSITIVE, f64::MAX].map(|value| widest.map(&value, (0, 400))), [0, 400]);
    }
}
