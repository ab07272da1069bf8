//! Standard output and progress.

use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::io::{self, Write};
use std::sync::Mutex;
use studies::progress::Progress;

pub use studies::table::{fixed, table};

/// The result of a command, as JSON and as text.
pub struct Report {
    json: String,
    text: String,
    /// Whether a check found a difference.
    pub difference: bool,
}

impl Report {
    /// A report with the JSON document `json` and the equivalent `text`.
    ///
    /// # Panics
    /// If `json` has no JSON form, which is a mistake of the caller.
    pub fn new(json: &impl Serialize, text: String) -> Self {
        let json = serde_json::to_string_pretty(json).expect("results have string keys");
        Self { json, text, difference: false }
    }

    /// The document if `json` is set, else the text. Either ends in a line break.
    pub fn render(&self, json: bool) -> String {
        let mut out = if json { self.json.clone() } else { self.text.clone() };
        if !out.ends_with('\n') {
            out.push('\n');
        }
        out
    }
}

/// Writes `text` to stdout. A closed pipe is no error.
pub fn print(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

/// Progress bars and spinners on stderr, hidden if that is not a terminal. Reports move the last of them.
#[derive(Default)]
pub struct Bars(Mutex<Vec<ProgressBar>>);

impl Bars {
    fn last(&self, act: impl FnOnce(&ProgressBar)) {
        if let Some(bar) = self.0.lock().expect("no bar panics").last() {
            act(bar);
        }
    }
}

impl Progress for Bars {
    fn begin(&self, total: u64, what: &str) {
        let bar = if total == 0 { spinner(what) } else { bar(total, what) };
        self.0.lock().expect("no bar panics").push(bar);
    }

    fn advance(&self, steps: u64) {
        self.last(|bar| bar.inc(steps));
    }

    fn at(&self, steps: u64) {
        self.last(|bar| bar.set_position(steps));
    }

    fn next(&self, what: &str) {
        self.last(|bar| bar.set_message(what.to_owned()));
    }

    fn note(&self, line: &str) {
        match self.0.lock().expect("no bar panics").last() {
            // A hidden bar prints nothing.
            Some(bar) if !bar.is_hidden() => bar.println(line),
            _ => eprintln!("{line}"),
        }
    }

    fn end(&self) {
        if let Some(bar) = self.0.lock().expect("no bar panics").pop() {
            bar.finish_and_clear();
        }
    }
}

fn bar(length: u64, label: &str) -> ProgressBar {
    let style =
        ProgressStyle::with_template("{msg:28} {bar:30} {pos}/{len} {elapsed}").expect("a valid template");
    ProgressBar::new(length).with_style(style).with_message(label.to_owned())
}

fn spinner(label: &str) -> ProgressBar {
    let bar = ProgressBar::new_spinner().with_message(label.to_owned());
    bar.enable_steady_tick(std::time::Duration::from_millis(120));
    bar
}
