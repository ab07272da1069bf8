//! Tables as text.

use comfy_table::{CellAlignment, Table, presets};

/// A Markdown table. Columns whose cells are all numbers or empty are aligned to the right.
pub fn table<const N: usize>(header: [&str; N], rows: impl IntoIterator<Item = [String; N]>) -> String {
    let rows: Vec<[String; N]> = rows.into_iter().collect();
    let is_number =
        |column: usize| rows.iter().all(|row| row[column].is_empty() || row[column].parse::<f64>().is_ok());
    let numbers: [bool; N] = std::array::from_fn(is_number);
    let mut table = Table::new();
    table.load_style(presets::ASCII_MARKDOWN).set_header(header).add_rows(rows);
    for (column, _) in table.column_iter_mut().zip(numbers).filter(|(_, number)| *number) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    format!("{table}\n")
}

/// A number with `decimals` decimals.
pub fn fixed(x: impl Into<f64>, decimals: usize) -> String {
    format!("{:.decimals$}", x.into())
}
