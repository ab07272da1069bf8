//! Standard output, tables and progress.

use comfy_table::{CellAlignment, Table, presets};
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::fmt::Display;
use std::io::{self, Write};

/// What a command has to say.
pub struct Report {
    json: String,
    text: String,
    /// Whether a check found a difference.
    pub difference: bool,
}

impl Report {
    /// A report with the JSON document `json`, or else `text`.
    ///
    /// # Panics
    /// If `json` has no JSON form, which is a mistake of the caller.
    pub fn new(json: &impl Serialize, text: String) -> Self {
        let json = serde_json::to_string_pretty(json).expect("results have string keys");
        Self { json, text, difference: false }
    }

    /// The document or the text, ending in a line break.
    pub fn render(&self, json: bool) -> String {
        let mut out = if json { self.json.clone() } else { self.text.clone() };
        if !out.ends_with('\n') {
            out.push('\n');
        }
        out
    }
}

/// Writes `text` to stdout. A reader that has left is no error.
pub fn print(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

/// A Markdown table. Columns that hold numbers only, or nothing, are aligned to the right.
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

/// A bar on stderr, hidden where that is no terminal.
pub fn progress(length: u64, label: impl Display) -> ProgressBar {
    let style =
        ProgressStyle::with_template("{msg:28} {bar:30} {pos}/{len} {elapsed}").expect("a valid template");
    ProgressBar::new(length).with_style(style).with_message(label.to_string())
}

/// A turning wheel on stderr, hidden where that is no terminal.
pub fn spinner(label: impl Display) -> ProgressBar {
    let bar = ProgressBar::new_spinner().with_message(label.to_string());
    bar.enable_steady_tick(std::time::Duration::from_millis(120));
    bar
}
