//! The file of hashes: a line with hash, command and artifact for each.

use anyhow::Context;
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Bytes of a hash that are kept.
const BYTES: usize = 16;

/// The hash of `bytes` in hexadecimal digits.
pub fn digest(bytes: &[u8]) -> String {
    let mut hash = String::new();
    for byte in &Sha256::digest(bytes)[..BYTES] {
        let _ = write!(hash, "{byte:02x}");
    }
    hash
}

/// What one command printed or wrote.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    hash: String,
    command: String,
    artifact: String,
}

impl Entry {
    /// The artifact `artifact` of `command`, which holds `bytes`.
    pub fn new(command: &str, artifact: &str, bytes: &[u8]) -> Self {
        Self { hash: digest(bytes), command: command.to_owned(), artifact: artifact.to_owned() }
    }

    fn is_of(&self, other: &Self) -> bool {
        (&self.command, &self.artifact) == (&other.command, &other.artifact)
    }
}

/// The artifacts of commands, in the commands' order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Hashes(Vec<Entry>);

impl Hashes {
    /// Reads a file that [`Self::write`] wrote.
    pub fn read(path: &Path) -> anyhow::Result<Self> {
        let text = fs::read_to_string(path).with_context(|| path.display().to_string())?;
        let entry = |(i, line): (usize, &str)| {
            let mut words = line.splitn(3, ' ').map(str::to_owned);
            let (Some(hash), Some(command), Some(artifact)) = (words.next(), words.next(), words.next())
            else {
                anyhow::bail!("{}:{}: a line is a hash, a command and an artifact", path.display(), i + 1);
            };
            Ok(Entry { hash, command, artifact })
        };
        Ok(Self(text.lines().enumerate().map(entry).collect::<anyhow::Result<_>>()?))
    }

    /// Writes a line for each.
    pub fn write(&self, path: &Path) -> anyhow::Result<()> {
        let line = |entry: &Entry| format!("{} {} {}\n", entry.hash, entry.command, entry.artifact);
        let text: String = self.0.iter().map(line).collect();
        fs::write(path, text).with_context(|| path.display().to_string())
    }

    /// Adds the artifacts of one more command.
    pub fn extend(&mut self, entries: Vec<Entry>) {
        self.0.extend(entries);
    }

    /// These of the commands `run`, and those in `others` of the other commands, in the order of `known`.
    pub fn and_others_of(&self, others: &Self, run: &[&str], known: &[&str]) -> Self {
        let of = |command: &&str| {
            let from = if run.contains(command) { self } else { others };
            from.0.iter().filter(|entry| entry.command == *command).cloned().collect::<Vec<_>>()
        };
        Self(known.iter().flat_map(of).collect())
    }

    /// A line for each artifact that is not as in `expected`.
    ///
    /// Only artifacts of commands that are due can be missing.
    pub fn differences(&self, expected: &Self, is_due: impl Fn(&str) -> bool) -> Vec<String> {
        let mut lines = vec![];
        for found in &self.0 {
            let what = match expected.0.iter().find(|entry| entry.is_of(found)) {
                Some(entry) if entry.hash == found.hash => continue,
                Some(entry) => format!("was {}, is {}", entry.hash, found.hash),
                None => format!("new, is {}", found.hash),
            };
            lines.push(format!("{}: {}: {what}", found.command, found.artifact));
        }
        for entry in expected.0.iter().filter(|entry| is_due(&entry.command)) {
            if !self.0.iter().any(|found| found.is_of(entry)) {
                lines.push(format!("{}: {}: missing, was {}", entry.command, entry.artifact, entry.hash));
            }
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hashes(entries: &[(&str, &str, &str)]) -> Hashes {
        let entry =
            |&(command, artifact, text): &(&str, &str, &str)| Entry::new(command, artifact, text.as_bytes());
        Hashes(entries.iter().map(entry).collect())
    }

    #[test]
    fn changed_new_and_missing_artifacts_are_told() {
        let expected = hashes(&[("a", "stdout", "1"), ("a", "x", "2"), ("b", "stdout", "3")]);
        assert!(expected.differences(&expected, |_| true).is_empty());
        let found = hashes(&[("a", "stdout", "other"), ("a", "y", "2")]);
        let lines = found.differences(&expected, |command| command == "a");
        assert_eq!(lines.len(), 3, "{lines:?}");
        for (line, what) in lines.iter().zip(["a: stdout: was 6b86b273ff34", "a: y: new", "a: x: missing"]) {
            assert!(line.starts_with(what), "{line}");
        }
        assert_eq!(found.differences(&expected, |_| true).len(), 4);
    }

    #[test]
    fn other_commands_keep_their_hashes() {
        let old = hashes(&[("a", "x", "1"), ("b", "x", "1"), ("gone", "x", "1")]);
        let run = hashes(&[("b", "y", "2")]);
        let blessed = run.and_others_of(&old, &["b"], &["a", "b"]);
        assert_eq!(blessed, hashes(&[("a", "x", "1"), ("b", "y", "2")]));
    }
}
