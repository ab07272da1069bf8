//! Tables of a cell's delay, transition time and energy over input transition time and output load.

/// A table over two axes, or one, or none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Input transition times in nanoseconds.
    slews: Vec<f64>,
    /// Output loads in femtofarads.
    loads: Vec<f64>,
    /// Row by row, one row for each transition time.
    values: Vec<f64>,
}

impl Table {
    /// A table; `values` has an entry for each pair, rows of equal transition time. An axis without positions is a constant.
    #[must_use]
    pub fn new(slews: Vec<f64>, loads: Vec<f64>, values: Vec<f64>) -> Option<Self> {
        let fits = values.len() == slews.len().max(1) * loads.len().max(1);
        let rises = |axis: &[f64]| axis.windows(2).all(|pair| pair[0] < pair[1]);
        (fits && rises(&slews) && rises(&loads)).then_some(Self { slews, loads, values })
    }

    /// A table with one value.
    #[must_use]
    pub fn constant(value: f64) -> Self {
        Self { slews: Vec::new(), loads: Vec::new(), values: vec![value] }
    }

    /// `at_zero + per_load * load`, whatever the transition time.
    #[must_use]
    pub fn linear(at_zero: f64, per_load: f64) -> Self {
        Self { slews: Vec::new(), loads: vec![0.0, 1.0], values: vec![at_zero, at_zero + per_load] }
    }

    /// The value at a point, linear between the table's points and beyond its ends.
    #[must_use]
    pub fn at(&self, slew_ns: f64, load_ff: f64) -> f64 {
        let (row, s) = position(&self.slews, slew_ns);
        let (column, t) = position(&self.loads, load_ff);
        let width = self.loads.len().max(1);
        let value = |row: usize, column: usize| self.values[row * width + column];
        let along = |row: usize| {
            if t == 0.0 {
                value(row, column)
            } else {
                value(row, column) * (1.0 - t) + value(row, column + 1) * t
            }
        };
        if s == 0.0 { along(row) } else { along(row) * (1.0 - s) + along(row + 1) * s }
    }
}

/// The interval for a coordinate, and where in it: 0 at its begin, 1 at its end.
fn position(axis: &[f64], x: f64) -> (usize, f64) {
    if axis.len() < 2 {
        return (0, 0.0);
    }
    let above = axis[1..axis.len() - 1].iter().take_while(|&&point| point <= x).count();
    (above, (x - axis[above]) / (axis[above + 1] - axis[above]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bilinear_inside_and_linear_beyond() {
        let table =
            Table::new(vec![0.0, 1.0], vec![0.0, 10.0, 20.0], vec![0.0, 1.0, 4.0, 2.0, 3.0, 6.0]).unwrap();
        assert_eq!(table.at(0.0, 10.0), 1.0);
        assert_eq!(table.at(0.5, 5.0), 1.5);
        assert_eq!(table.at(0.0, 30.0), 7.0);
        assert_eq!(table.at(2.0, 0.0), 4.0);
        assert_eq!(Table::linear(1.0, 0.5).at(9.0, 4.0), 3.0);
        assert_eq!(Table::constant(7.0).at(1.0, 1.0), 7.0);
        assert!(Table::new(vec![0.0, 1.0], vec![], vec![1.0]).is_none());
        assert!(Table::new(vec![1.0, 1.0], vec![], vec![1.0, 2.0]).is_none());
    }
}
