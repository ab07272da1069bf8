//! Standard output and progress.

use anyhow::Context;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard};
use std::time::{Duration, Instant};
use studies::progress::Progress;

pub use studies::table::{fixed, number, table};

/// The result of a command, as JSON and as text.
pub struct Report {
    /// The document without what all documents have in common.
    json: String,
    /// The files that were written.
    artifacts: Vec<String>,
    text: String,
    /// Whether a check found a difference.
    pub difference: bool,
    /// The folder of the results, if they fill one.
    pub folder: Option<PathBuf>,
    /// The command that made it, if that is not the one that runs.
    pub command: Option<String>,
}

impl Report {
    /// A report with the JSON document `json`, the equivalent `text`, and the files that were written.
    ///
    /// # Panics
    /// If `json` has no JSON form or is no object, which is a mistake of the caller.
    pub fn new(json: &impl Serialize, text: String, artifacts: Vec<String>) -> Self {
        let json = serde_json::to_string_pretty(json).expect("results have string keys");
        assert!(json.starts_with("{\n"), "results are objects with keys");
        Self { json, artifacts, text, difference: false, folder: None, command: None }
    }

    /// The report of results that fill `folder`, if any.
    pub fn in_folder(self, folder: impl Into<Option<PathBuf>>) -> Self {
        Self { folder: folder.into(), ..self }
    }

    /// Adds the file `path` to those that were written.
    pub fn add_artifact(&mut self, path: String) {
        self.artifacts.push(path);
    }

    /// The document if `json` is set, else the text. Either ends in a line break.
    ///
    /// Every document begins with the version of the tool, the `command` that made it, and the paths of the files that it wrote.
    pub fn render(&self, json: bool, command: &str) -> String {
        let mut out = self.text.clone();
        if json {
            let text = |value: &str| serde_json::to_string(value).expect("a text has a JSON form");
            let paths: Vec<String> =
                self.artifacts.iter().map(|path| format!("\n    {}", text(path))).collect();
            let end = if paths.is_empty() { "" } else { "\n  " };
            out = format!(
                "{{\n  \"version\": {},\n  \"command\": {},\n  \"artifacts\": [{}{end}],{}",
                text(env!("CARGO_PKG_VERSION")),
                text(self.command.as_deref().unwrap_or(command)),
                paths.join(","),
                &self.json[1..]
            );
        }
        if !out.ends_with('\n') {
            out.push('\n');
        }
        out
    }
}

/// The words of a command line without the options that no result depends on.
pub fn kept(words: impl IntoIterator<Item = OsString>) -> Vec<OsString> {
    let mut kept = vec![];
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        match word.to_string_lossy().as_ref() {
            "--threads" => _ = words.next(),
            "--json" | "--force" | "--quiet" | "-q" => {}
            text if text.starts_with("--threads=") => {}
            _ => kept.push(word),
        }
    }
    kept
}

/// The command line `words` as documents record it.
pub fn command(words: impl IntoIterator<Item = OsString>) -> String {
    let words: Vec<String> = kept(words).iter().map(|word| word.to_string_lossy().into_owned()).collect();
    words.join(" ")
}

/// Writes `text` to stdout. A closed pipe is no error.
pub fn print(text: &str) -> anyhow::Result<()> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result.context("standard output: cannot write"),
    }
}

/// The message of `error` with its causes, without those that it already quotes.
pub fn message(error: &anyhow::Error) -> String {
    let mut message = String::new();
    for cause in error.chain().map(ToString::to_string) {
        if message.is_empty() {
            message = cause;
        } else if !message.contains(&cause) {
            message = format!("{message}: {cause}");
        }
    }
    message
}

/// Lets a signal that ends the program first remove temporary files, and makes a file that becomes too long an error.
pub fn end_at_signals() {
    // The system ends a program that writes beyond the limit of a file's length, unless it ignores the signal.
    // SAFETY: no other thread runs yet, and nothing runs at an ignored signal.
    #[cfg(unix)]
    unsafe {
        libc::signal(libc::SIGXFSZ, libc::SIG_IGN);
    }
    // Without a handler, a signal ends the program as well.
    let _ = ctrlc::set_handler(|| {
        base::output::remove_unfinished();
        std::process::exit(130)
    });
}

/// How often progress is printed where stderr is no terminal.
const SPEAKS_EVERY: Duration = Duration::from_secs(30);

/// Progress bars and spinners on stderr; lines from time to time if that is no terminal. Reports move the last of them.
pub struct Bars {
    /// Nothing is shown.
    quiet: bool,
    shown: Mutex<Shown>,
}

#[derive(Default)]
struct Shown {
    bars: Vec<ProgressBar>,
    /// When the last line was printed, or the first bar began.
    spoke: Option<Instant>,
}

impl Bars {
    /// Shows nothing if `quiet`.
    pub fn new(quiet: bool) -> Self {
        Self { quiet, shown: Mutex::default() }
    }

    fn shown(&self) -> MutexGuard<'_, Shown> {
        self.shown.lock().expect("no bar panics")
    }

    fn last(&self, act: impl FnOnce(&ProgressBar)) {
        let mut shown = self.shown();
        let Some(bar) = shown.bars.last() else { return };
        act(bar);
        if let Some(line) = bar.is_hidden().then(|| line(bar))
            && shown.spoke.is_some_and(|spoke| spoke.elapsed() >= SPEAKS_EVERY)
        {
            shown.spoke = Some(Instant::now());
            say(&line);
        }
    }
}

/// Writes a line to stderr, which may be closed or on a full disk.
pub fn say(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

/// What a bar shows, as a line.
fn line(bar: &ProgressBar) -> String {
    let (done, length, elapsed) = (bar.position(), bar.length().unwrap_or(0), bar.elapsed());
    let left = elapsed.as_secs_f64() * length.saturating_sub(done) as f64 / done.max(1) as f64;
    format!("{}: {done} of {length} in {} s, about {left:.0} s left", bar.message(), elapsed.as_secs())
}

impl Progress for Bars {
    fn begin(&self, total: u64, what: &str) {
        if self.quiet {
            return;
        }
        let bar = if total == 0 { spinner(what) } else { bar(total, what) };
        let mut shown = self.shown();
        shown.spoke.get_or_insert_with(Instant::now);
        shown.bars.push(bar);
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
        match self.shown().bars.last() {
            _ if self.quiet => {}
            // A hidden bar prints nothing.
            Some(bar) if !bar.is_hidden() => bar.println(line),
            _ => say(line),
        }
    }

    fn end(&self) {
        if let Some(bar) = self.shown().bars.pop() {
            bar.finish_and_clear();
        }
    }
}

fn bar(length: u64, label: &str) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:28} {bar:30} {pos}/{len} {elapsed}, about {eta} left")
        .expect("a valid template");
    ProgressBar::new(length).with_style(style).with_message(label.to_owned())
}

fn spinner(label: &str) -> ProgressBar {
    let bar = ProgressBar::new_spinner().with_message(label.to_owned());
    bar.enable_steady_tick(std::time::Duration::from_millis(120));
    bar
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::anyhow;

    #[test]
    fn a_cause_is_said_once() {
        let error: anyhow::Error =
            Err::<(), _>(anyhow!("no space")).context("a.txt: cannot write (no space)").unwrap_err();
        assert_eq!(message(&error), "a.txt: cannot write (no space)");
        assert_eq!(message(&error.context("--out")), "--out: a.txt: cannot write (no space)");
    }

    #[test]
    fn every_document_says_what_made_it() {
        let body = std::collections::BTreeMap::from([("x", 1)]);
        let report = Report::new(&body, String::new(), vec!["a \"b\"".to_owned(), "c".to_owned()]);
        let document: serde_json::Value = serde_json::from_str(&report.render(true, "tree -")).unwrap();
        assert_eq!(document["artifacts"], serde_json::json!(["a \"b\"", "c"]));
        assert_eq!((&document["command"], &document["x"]), (&"tree -".into(), &1.into()));
    }

    #[test]
    fn commands_are_recorded_without_what_changes_no_result() {
        let words = "tree a.obj --threads 2 --json --threads=3 --force -q --quality fast --quiet"
            .split(' ')
            .map(OsString::from);
        assert_eq!(command(words), "tree a.obj --quality fast");
    }

    #[test]
    fn lines_say_how_long_it_takes() {
        let hidden = ProgressBar::hidden().with_message("runs").with_position(2);
        hidden.set_length(8);
        assert!(line(&hidden).starts_with("runs: 2 of 8 in 0 s, about 0 s left"), "{}", line(&hidden));
    }
}
