//! Runs the tool in a folder of its own.
#![allow(dead_code, reason = "each user needs a part")]

use serde_json::Value;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

/// A folder in which the tool runs, with a small scene, `scene.obj`.
pub struct Workplace {
    folder: tempfile::TempDir,
}

/// A pyramid over a floor.
const SCENE: &str = "\
v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
v 0 1.5 0
v -4 -0.1 -4
v 4 -0.1 -4
v 4 -0.1 4
v -4 -0.1 4
f 1 2 5
f 2 3 5
f 3 4 5
f 4 1 5
f 6 7 8 9
";

impl Workplace {
    pub fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("scene.obj"), SCENE).unwrap();
        Self { folder }
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub fn write(&self, name: &str, content: &[u8]) {
        fs::write(self.path(name), content).unwrap();
    }

    /// Names of all files in the folder.
    pub fn files(&self) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(self.folder.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    /// Runs the tool with the words of `line` as arguments.
    pub fn run(&self, line: &str) -> Output {
        Command::new(env!("CARGO_BIN_EXE_dualsplit"))
            .args(line.split_whitespace())
            .current_dir(self.folder.path())
            .output()
            .unwrap()
    }

    /// Runs the tool, which has to succeed, and returns its JSON document.
    pub fn json(&self, line: &str) -> Value {
        let output = self.run(&format!("{line} --json"));
        assert_eq!(output.status.code(), Some(0), "{line}: {}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{line}: {error}"))
    }

    /// Runs the tool, which has to refuse its input: it ends with exit code 2, prints nothing to stdout and every one of `words`
    /// to stderr, and makes or removes no file.
    pub fn refused(&self, line: &str, words: &[&str]) {
        let before = self.files();
        let output = self.run(line);
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{line}: {stderr}");
        assert!(output.stdout.is_empty(), "{line}");
        for word in words {
            assert!(stderr.contains(word), "{line}: no `{word}` in {stderr}");
        }
        assert!(!stderr.contains("panicked"), "{line}: {stderr}");
        assert_eq!(self.files(), before, "{line}");
    }
}

/// Asserts that `value` has all of `keys`.
pub fn has_keys(value: &Value, keys: &[&str]) {
    for key in keys {
        assert!(value.get(key).is_some(), "no key `{key}` in {value}");
    }
}
