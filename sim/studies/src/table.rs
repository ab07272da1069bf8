//! Tables as text.

use comfy_table::{CellAlignment, Table, presets};

/// A Markdown table of rows that are as long as the header. Columns whose cells are all numbers or empty are aligned to the right.
pub fn table<'h, R: AsRef<[String]>>(
    header: impl AsRef<[&'h str]>,
    rows: impl IntoIterator<Item = R>,
) -> String {
    let header = header.as_ref();
    let rows: Vec<R> = rows.into_iter().collect();
    let is_number = |column: usize| {
        rows.iter()
            .map(|row| &row.as_ref()[column])
            .all(|cell| cell.is_empty() || cell.parse::<f64>().is_ok())
    };
    let numbers: Vec<bool> = (0..header.len()).map(is_number).collect();
    let mut table = Table::new();
    table
        .load_style(presets::ASCII_MARKDOWN)
        .set_header(header)
        .add_rows(rows.iter().map(|row| row.as_ref()));
    for (column, _) in table.column_iter_mut().zip(numbers).filter(|(_, number)| *number) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    format!("{table}\n")
}

/// A number for a table of quantities of any size: a count without decimals, anything else with five digits or four decimals.
pub fn number(x: f64) -> String {
    let decimals = if x.fract() == 0.0 {
        0
    } else if x.abs() < 1.0 && x.is_finite() {
        (4.0 - x.abs().log10().floor()).clamp(4.0, 30.0) as usize
    } else {
        4
    };
    format!("{x:.decimals$}")
}

/// A number with `decimals` decimals.
pub fn fixed(x: impl Into<f64>, decimals: usize) -> String {
    format!("{:.decimals$}", x.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_value() {
        let texts = [45_191.0, 0.0, 1.25, 0.000_012_345_6, 0.5].map(number);
        assert_eq!(texts, ["45191", "0", "1.2500", "0.000012346", "0.50000"]);
    }
}
