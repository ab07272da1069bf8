//! Area and energy of data caches that the published table does not have.
//!
//! Both numbers are sums of two terms, one for the bits and one for the banks. Energy is that of wires as long as the side of an area,
//! the square root, as Cacti finds it (Wilton, Jouppi, "CACTI: An Enhanced Cache Access and Cycle Time Model", IEEE JSSC 31(5), 1996):
//!
//! ```text
//! area mm2    =       PER_MIB * MiB of bits          + BANK * GROWTH ^ log2(banks)
//! energy nJ   = sqrt( PER_MIB * MiB of bits * ways   + BANK * GROWTH ^ log2(banks) )
//! bits        = 8 * size + lines * (42 - log2(size / ways) + 2)
//! ```
//!
//! The three coefficients of each are fitted to the published table. What that table does not vary is assumed:
//!
//! | term | assumption | source |
//! |---|---|---|
//! | bits of a tag | addresses of 42 bits, and two bits of state | Cacti's default |
//! | energy by ways | all ways of a set are read side by side, each as a cache of its size: `ways * sqrt(bits / ways)` | Cacti's normal access, JSSC 1996 |
//! | comparators | one unit of integer comparison for each way beyond the first, in each bank and for each port | published unit table, [`Unit::IntAdd`] |
//! | area by ports | a cell of 10 by 14.6 F grows by two wires of 2.5 F in each direction for each port beyond the first | Cacti 6.5: `cell.h`, `cell.w`, SRAM cell of 146 F2 and aspect 1.46 |
//! | energy by ports | wires grow as the side of the area, its square root | geometry |

use super::{KIB, MemoryCost};
use costs::Unit;

/// The source of the numbers that this model gives.
pub const SOURCE: &str = "modelled: fitted to the published Cacti results of SimTRaX (65 nm)";
/// The source of the numbers that a published one and this model give together.
pub const SCALED: &str =
    "modelled: published Cacti results of SimTRaX (65 nm), scaled from a direct-mapped cache of one port";

/// The smallest cache in bytes.
pub const LEAST_BYTES: u64 = KIB;
/// The largest cache in bytes, twice the largest of the published table.
pub const MOST_BYTES: u64 = 16 << 20;

/// A fitted sum of two terms.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Fit {
    /// For each MiB of bits, those of tags included.
    per_mib: f64,
    /// For one bank.
    bank: f64,
    /// By what the term of the banks grows when their number doubles.
    growth: f64,
}

/// In mm2.
const AREA: Fit = Fit { per_mib: 8.4509, bank: 0.028_231, growth: 2.455 };
/// In nJ squared.
const ENERGY: Fit = Fit { per_mib: 0.624_17, bank: 0.002_115_4, growth: 2.2967 };

impl Fit {
    /// The value for so many MiB of bits and banks.
    fn at(&self, mib: f64, banks: u32) -> f64 {
        // Multiplied out, as the platform's power function differs from machine to machine.
        let banks = (0..banks.ilog2()).fold(self.bank, |value, _| value * self.growth);
        self.per_mib * mib + banks
    }
}

/// A data cache. Sizes are powers of two, in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    pub bytes: u64,
    pub line: u64,
    pub banks: u32,
    pub ways: u32,
    /// Accesses of each bank in a cycle.
    pub ports: u32,
}

impl Shape {
    /// The same cache, direct-mapped and with one port, as the published table has it.
    pub fn direct(self) -> Self {
        Self { ways: 1, ports: 1, ..self }
    }

    /// MiB of bits, those of tags included.
    fn mib(self) -> f64 {
        let tag_bits = 42 - (self.bytes / u64::from(self.ways)).ilog2() + 2;
        let bits = 8 * self.bytes + self.bytes / self.line * u64::from(tag_bits);
        bits as f64 / f64::from(8 << 20)
    }

    /// The modelled cost.
    pub fn cost(self) -> MemoryCost {
        let (ways, ports) = (f64::from(self.ways), f64::from(self.ports));
        let comparator = Unit::IntAdd.published();
        let comparators = (ways - 1.0) * ports * f64::from(self.banks);
        let cell = (10.0 + 5.0 * (ports - 1.0)) * (14.6 + 5.0 * (ports - 1.0)) / (10.0 * 14.6);
        let energy_nj = ENERGY.at(self.mib() * ways, self.banks).sqrt() * cell.sqrt();
        MemoryCost {
            area_mm2: AREA.at(self.mib(), self.banks) * cell + comparators * comparator.area_um2 * 1e-6,
            energy_nj: energy_nj + (ways - 1.0) * comparator.energy_pj * 1e-3,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::published::{CACHES, LINES};
    use super::*;

    /// A cache of the published table that the model is fitted to, with a published value.
    type Sample = (Shape, f64);

    /// What the published table says of the caches that the fit uses: all but those of two banks, which are of another size than
    /// the table says.
    fn samples(of: impl Fn(&MemoryCost) -> f64) -> Vec<Sample> {
        let rows = CACHES.iter().filter(|(_, banks, _)| *banks != 2);
        let cells = rows.flat_map(|(kib, banks, costs)| {
            LINES.iter().zip(costs).filter_map(move |(line, cost)| {
                let shape = Shape { bytes: kib * KIB, line: *line, banks: *banks, ways: 1, ports: 1 };
                Some((shape, (*cost)?))
            })
        });
        cells.map(|(shape, cost)| (shape, of(&cost))).collect()
    }

    /// The sum of two terms of least squared error of the logarithm, by Gauss and Newton.
    fn fitted(samples: &[Sample]) -> Fit {
        let mut fit = Fit { per_mib: 1.0, bank: 0.01, growth: 2.0 };
        for _ in 0..100 {
            // Normal equations for the steps of the three logarithms, with the right side as the fourth column.
            let mut rows = [[0.0; 4]; 3];
            for (shape, value) in samples {
                let all = fit.at(shape.mib(), shape.banks);
                let banks = fit.at(0.0, shape.banks);
                let slopes = [(all - banks) / all, banks / all, banks / all * f64::from(shape.banks.ilog2())];
                for (row, slope) in rows.iter_mut().zip(slopes) {
                    for (sum, other) in row.iter_mut().zip(slopes.into_iter().chain([(value / all).ln()])) {
                        *sum += slope * other;
                    }
                }
            }
            let [per_mib, bank, growth] = solved(rows).map(|step| step.clamp(-1.0, 1.0).exp());
            fit = Fit { per_mib: fit.per_mib * per_mib, bank: fit.bank * bank, growth: fit.growth * growth };
        }
        fit
    }

    /// The solution of three linear equations, of a positive definite matrix.
    fn solved(mut rows: [[f64; 4]; 3]) -> [f64; 3] {
        for i in 0..3 {
            let pivot = rows[i];
            for (_, row) in rows.iter_mut().enumerate().filter(|(j, _)| *j != i) {
                let factor = row[i] / pivot[i];
                for (value, other) in row.iter_mut().zip(pivot) {
                    *value -= factor * other;
                }
            }
        }
        [0, 1, 2].map(|i| rows[i][3] / rows[i][i])
    }

    /// Root mean square of the logarithm, median and greatest error in percent.
    fn errors(samples: &[Sample], of: impl Fn(&MemoryCost) -> f64) -> [f64; 3] {
        let ratios: Vec<f64> = samples.iter().map(|(shape, value)| of(&shape.cost()) / value).collect();
        let squares: f64 = ratios.iter().map(|ratio| ratio.ln().powi(2)).sum();
        let mut off: Vec<f64> = ratios.iter().map(|ratio| 100.0 * (ratio - 1.0).abs()).collect();
        off.sort_by(f64::total_cmp);
        [100.0 * (squares / off.len() as f64).sqrt(), off[off.len() / 2], off[off.len() - 1]]
    }

    fn is_near(fit: Fit, committed: Fit) -> bool {
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-4;
        near(fit.per_mib, committed.per_mib)
            && near(fit.bank, committed.bank)
            && near(fit.growth, committed.growth)
    }

    #[test]
    fn the_coefficients_are_those_of_least_squares() {
        let area = fitted(&samples(|cost| cost.area_mm2));
        assert!(is_near(area, AREA), "{area:?}");
        let energy = fitted(&samples(|cost| cost.energy_nj * cost.energy_nj));
        assert!(is_near(energy, ENERGY), "{energy:?}");
    }

    /// The errors that the documentation of the machine states.
    #[test]
    fn the_fit_is_as_far_off_as_stated() {
        let area = samples(|cost| cost.area_mm2);
        let energy = samples(|cost| cost.energy_nj);
        assert_eq!((area.len(), energy.len()), (191, 191));
        let docs = include_str!("../../../../docs/machine.md");
        for (name, errors) in [
            ("area", errors(&area, |cost| cost.area_mm2)),
            ("energy of an access", errors(&energy, |cost| cost.energy_nj)),
        ] {
            let [square, median, greatest] = errors;
            let row = format!("| {name} | {square:.1} | {median:.1} | {greatest:.1} |");
            assert!(docs.contains(&row), "{row}");
        }
    }

    #[test]
    fn more_of_anything_costs_more() {
        let least = Shape { bytes: 1 << 10, line: 64, banks: 1, ways: 1, ports: 1 };
        let more: [fn(Shape) -> Shape; 4] = [
            |shape| Shape { bytes: 2 * shape.bytes, ..shape },
            |shape| Shape { banks: 2 * shape.banks, ..shape },
            |shape| Shape { ways: 2 * shape.ways, ..shape },
            |shape| Shape { ports: 2 * shape.ports, ..shape },
        ];
        for bytes in (10..24).map(|log2| 1 << log2) {
            for (banks, ways, ports) in [(1, 1, 1), (8, 4, 1), (16, 1, 2), (32, 8, 2)] {
                let shape = Shape { bytes, banks, ways, ports, ..least };
                let cost = shape.cost();
                for more in more.map(|more| more(shape)) {
                    let other = more.cost();
                    assert!(other.area_mm2 > cost.area_mm2 && other.energy_nj > cost.energy_nj, "{more:?}");
                }
                // Longer lines have fewer tags.
                assert!(Shape { line: 128, ..shape }.cost().area_mm2 < cost.area_mm2);
            }
        }
    }
}
