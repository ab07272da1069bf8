//! Sums over a frame from sampled batches: the combined ratio estimator over strata.

/// A sampled batch: the quantity to be estimated, and a known quantity that it is about proportional to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    /// The quantity whose sum over all batches is estimated.
    pub y: f64,
    /// The quantity whose sum over all batches is known.
    pub x: f64,
}

/// Number of batches in a stratum, and the batches sampled from it.
pub type Stratum = (u32, Vec<Pair>);

/// An estimated sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sum {
    /// The sum.
    pub value: f64,
    /// The standard error of the sum.
    pub error: f64,
    /// Degrees of freedom of the error.
    pub freedom: u32,
}

/// The sum of `y` over all batches of `strata`, whose sum of `x` is `known` (Cochran 1977, section 6.11).
///
/// The residuals `y - R x` have a mean of their own in each stratum, so their variance is taken within strata. Where the strata
/// differ in spread, the sum has fewer degrees of freedom than all strata together. Their number, rounded down, is that of
/// B. L. Welch, "The generalization of `Student's' problem when several different population variances are involved",
/// Biometrika 34 (1947).
#[must_use]
pub fn estimate(strata: &[Stratum], known: f64) -> Sum {
    let weighted = |of: fn(&Pair) -> f64| -> f64 {
        let stratum = |(count, pairs): &Stratum| {
            f64::from(*count) * pairs.iter().map(of).sum::<f64>() / pairs.len() as f64
        };
        strata.iter().map(stratum).sum()
    };
    let x = weighted(|pair| pair.x);
    if x <= 0.0 {
        return Sum { value: 0.0, error: 0.0, freedom: 1 };
    }
    let ratio = weighted(|pair| pair.y) / x;
    let (mut variance, mut fourth) = (0.0, 0.0);
    let mut most_freedom = 0;
    for (count, pairs) in strata {
        let (size, drawn) = (f64::from(*count), pairs.len() as f64);
        if pairs.len() < 2 {
            continue;
        }
        most_freedom += pairs.len() as u32 - 1;
        let residual = |pair: &Pair| pair.y - ratio * pair.x;
        let mean = pairs.iter().map(residual).sum::<f64>() / drawn;
        let squares: f64 = pairs.iter().map(|pair| (residual(pair) - mean).powi(2)).sum();
        let of_stratum = size * size * (1.0 - drawn / size) * squares / (drawn - 1.0) / drawn;
        variance += of_stratum;
        fourth += of_stratum * of_stratum / (drawn + 1.0);
    }
    let freedom = if fourth > 0.0 { (variance * variance / fourth - 2.0) as u32 } else { most_freedom };
    Sum {
        value: ratio * known,
        error: variance.sqrt() * known / x,
        freedom: freedom.clamp(1, most_freedom.max(1)),
    }
}

/// The 97.5 % point of Student's distribution.
///
/// Points of up to 12 degrees of freedom come from a table. Beyond, the expansion of Cornish and Fisher to the third order
/// (Abramowitz, Stegun 26.7.5) is within 1e-4 of the exact point.
#[must_use]
pub fn student(freedom: u32) -> f64 {
    const TABLE: [f64; 12] =
        [12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060, 2.2622, 2.2281, 2.2010, 2.1788];
    let freedom = freedom.max(1);
    if let Some(point) = TABLE.get(freedom as usize - 1) {
        return *point;
    }
    let (z, n) = (1.959_963_985_f64, f64::from(freedom));
    let powers = [z.powi(3), z.powi(5), z.powi(7)];
    z + (powers[0] + z) / (4.0 * n)
        + (5.0 * powers[1] + 16.0 * powers[0] + 3.0 * z) / (96.0 * n * n)
        + (3.0 * powers[2] + 19.0 * powers[1] + 17.0 * powers[0] - 15.0 * z) / (384.0 * n * n * n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn students_points_are_those_of_the_tables() {
        for (freedom, point) in
            [(1, 12.706), (5, 2.571), (13, 2.160), (20, 2.086), (60, 2.000), (100_000, 1.960)]
        {
            assert!((student(freedom) - point).abs() < 6e-4, "{freedom}: {}", student(freedom));
        }
    }

    #[test]
    fn a_quantity_in_proportion_is_known_exactly() {
        let strata: Vec<Stratum> = (1..6)
            .map(|s| (9, vec![Pair { y: 3.0 * f64::from(s), x: f64::from(s) }, Pair { y: 6.0, x: 2.0 }]))
            .collect();
        let sum = estimate(&strata, 100.0);
        assert!((sum.value - 300.0).abs() < 1e-9 && sum.error < 1e-9 && sum.freedom == 5);
    }

    /// For a synthetic population, 95 % intervals cover the sum in about 95 % of samples, and the estimate has no bias.
    #[test]
    fn intervals_cover_as_often_as_they_say() {
        let mut state = 7;
        let mut uniform = || (base::split_mix::next(&mut state) >> 11) as f64 / (1u64 << 53) as f64;
        let population: Vec<Pair> = (0..240)
            .map(|i| {
                let x = 50.0 + 40.0 * (f64::from(i) / 40.0).sin() + 10.0 * uniform();
                Pair { y: x * (2.0 + 0.5 * (f64::from(i) / 60.0).cos() + 0.6 * uniform()), x }
            })
            .collect();
        let total = |of: fn(&Pair) -> f64| population.iter().map(of).sum::<f64>();
        let (x, y) = (total(|p| p.x), total(|p| p.y));
        let (mut covered, mut mean) = (0, 0.0);
        const TIMES: u32 = 2000;
        for _ in 0..TIMES {
            let strata: Vec<Stratum> = (0..10)
                .map(|s| {
                    let a = (uniform() * 24.0) as usize;
                    let b = (a + 1 + (uniform() * 23.0) as usize) % 24;
                    (24, vec![population[24 * s + a], population[24 * s + b]])
                })
                .collect();
            let sum = estimate(&strata, x);
            covered += u32::from((sum.value - y).abs() <= student(sum.freedom) * sum.error);
            mean += sum.value / f64::from(TIMES);
        }
        let share = f64::from(covered) / f64::from(TIMES);
        assert!((0.935..0.975).contains(&share), "{share}");
        assert!((mean / y - 1.0).abs() < 2e-3, "{}", mean / y);
    }
}
