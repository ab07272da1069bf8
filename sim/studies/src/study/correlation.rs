//! Whether one quantity rises or falls with another, by Kendall's rank correlation and an exact test.

use std::fmt;

/// A rank correlation, and how likely chance gives one that is as strong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correlation {
    /// Kendall's tau: the share of pairs that agree less the share of those that do not.
    tau: f64,
    /// The probability of a tau at least as far from 0 on the same side, if all orders are equally likely.
    chance: f64,
}

/// What a claim says of two quantities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The second rises with the first.
    Rises,
    /// The second falls as the first rises.
    Falls,
}

/// A result that chance gives with at most this probability is one.
const SIGNIFICANT: f64 = 0.05;
/// The fewest pairs of quantities that have a correlation.
const LEAST: usize = 3;

impl Correlation {
    /// The correlation of `pairs`; none of fewer than three. A pair of equal quantities counts as one that does not agree.
    pub fn of(pairs: &[(f64, f64)]) -> Option<Self> {
        if pairs.len() < LEAST {
            return None;
        }
        let couples = pairs.iter().enumerate().flat_map(|(i, a)| pairs[..i].iter().map(move |b| (a, b)));
        let apart = couples.filter(|(a, b)| (a.0 > b.0) != (a.1 > b.1)).count();
        let all = pairs.len() * (pairs.len() - 1) / 2;
        // The number of couples that disagree is that of inversions of an order.
        let orders = inversions(pairs.len());
        let as_far = if 2 * apart > all { &orders[apart..] } else { &orders[..=apart] };
        let tau = 1.0 - 2.0 * apart as f64 / all as f64;
        Some(Self { tau, chance: as_far.iter().sum() })
    }

    /// Whether a claim of this direction holds: `undecided` if chance gives such a result too often.
    pub fn holds(self, direction: Direction) -> &'static str {
        let as_claimed = match direction {
            Direction::Rises => self.tau > 0.0,
            Direction::Falls => self.tau < 0.0,
        };
        match as_claimed {
            _ if self.chance > SIGNIFICANT => "undecided",
            true => "yes",
            false => "no",
        }
    }
}

impl fmt::Display for Correlation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let chance =
            if self.chance < 0.001 { "p < 0.001".to_owned() } else { format!("p = {:.3}", self.chance) };
        write!(f, "{:+.2}, {chance}", self.tau)
    }
}

/// The share of the orders of `n` things that have 0, 1, 2 and more inversions.
fn inversions(n: usize) -> Vec<f64> {
    let mut shares = vec![1.0];
    for length in 2..=n {
        // The last thing goes to each of `length` places, which makes 0 to `length - 1` inversions.
        let mut next = vec![0.0; shares.len() + length - 1];
        for (at, share) in shares.iter().enumerate() {
            next[at..at + length].iter_mut().for_each(|sum| *sum += share / length as f64);
        }
        shares = next;
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(second: &[f64]) -> Correlation {
        let pairs: Vec<(f64, f64)> = second.iter().enumerate().map(|(n, value)| (n as f64, *value)).collect();
        Correlation::of(&pairs).unwrap()
    }

    #[test]
    fn orders_by_inversions_are_those_of_the_mahonian_numbers() {
        let counts: Vec<f64> = inversions(4).iter().map(|share| (24.0 * share).round()).collect();
        assert_eq!(counts, [1.0, 3.0, 5.0, 6.0, 5.0, 3.0, 1.0]);
    }

    #[test]
    fn an_order_is_significant_from_four_on() {
        let rising = of(&[1.0, 2.0, 3.0, 4.0]);
        assert_eq!((rising.tau, rising.chance), (1.0, 1.0 / 24.0));
        assert_eq!((rising.holds(Direction::Rises), rising.holds(Direction::Falls)), ("yes", "no"));
        assert_eq!(of(&[1.0, 2.0, 3.0]).holds(Direction::Rises), "undecided");
        assert_eq!(Correlation::of(&[(0.0, 0.0), (1.0, 1.0)]), None);
    }

    #[test]
    fn a_weak_correlation_decides_nothing() {
        // 36 of 66 couples fall, as in a study with a tau of -0.09.
        let weak = of(&[5.0, 9.0, 3.0, 11.0, 1.0, 12.0, 6.0, 2.0, 8.0, 10.0, 4.0, 7.0]);
        assert!(weak.tau.abs() < 0.2 && weak.chance > 0.2, "{weak:?}");
        assert_eq!(weak.holds(Direction::Falls), "undecided");
        assert!(weak.to_string().contains("p = 0."), "{weak}");
    }
}
