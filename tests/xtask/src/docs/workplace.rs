//! Runs the commands of one file, in a folder of its own.

use super::markdown::Recipe;
use super::{recipes, select};
use crate::behaviour::filter;
use crate::workspace::{must_succeed, root, target};
use anyhow::{Context, ensure};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::Instant;

/// A folder with the tool, and what its commands have printed.
pub struct Workplace<'a> {
    folder: &'a Path,
    /// The search path, which begins with the folder of the tool.
    path: OsString,
    printed: BTreeMap<String, String>,
}

impl<'a> Workplace<'a> {
    /// The folder `folder`; `programs` holds the program `dualsplit`.
    pub fn new(folder: &'a Path, programs: &Path) -> anyhow::Result<Self> {
        let others = std::env::var_os("PATH").unwrap_or_default();
        let all = [programs.to_owned()].into_iter().chain(std::env::split_paths(&others));
        Ok(Self { folder, path: std::env::join_paths(all)?, printed: BTreeMap::new() })
    }

    /// What `recipe` makes, in lines; of JSON, without what depends on the host.
    pub fn make(&mut self, recipe: &Recipe) -> anyhow::Result<String> {
        let mut output = String::new();
        for command in &recipe.commands {
            output = match command.strip_prefix("recipe ") {
                Some(name) => recipes::make(name, self)?,
                None if command.split_whitespace().any(|word| word == "--json") => {
                    filter::json(&self.output(command)?)
                }
                None => self.output(command)?,
            };
        }
        select::select(&output, &recipe.selections).with_context(|| recipe.commands.join("\n"))
    }

    /// What `command` prints. A command runs once.
    pub fn output(&mut self, command: &str) -> anyhow::Result<String> {
        if let Some(printed) = self.printed.get(command) {
            return Ok(printed.clone());
        }
        let output = match command.strip_prefix("cargo run ") {
            Some(rest) => example(rest)?.output().with_context(|| command.to_owned())?,
            None => self.shell(command)?,
        };
        let text = String::from_utf8(output.stdout).with_context(|| format!("{command}: prints no text"))?;
        self.printed.insert(command.to_owned(), text.clone());
        Ok(text)
    }

    /// Runs `script`, all of whose commands have to succeed.
    pub fn shell(&self, script: &str) -> anyhow::Result<Output> {
        let start = Instant::now();
        let output = Command::new("sh")
            .args(["-e", "-c", script])
            .current_dir(self.folder)
            .env("PATH", &self.path)
            // The files are the same with and without data that only some have.
            .env_remove("DUALSPLIT_DATA")
            .stdin(Stdio::null())
            .output()
            .context("sh does not start")?;
        eprintln!("{:8.2} s  {}", start.elapsed().as_secs_f64(), script.lines().next().unwrap_or(""));
        let errors = String::from_utf8_lossy(&output.stderr);
        ensure!(output.status.success(), "{script}\n{}\n{errors}", output.status);
        Ok(output)
    }
}

/// The example that `cargo run REST` would run, in the profile of the tests whatever `rest` says.
fn example(rest: &str) -> anyhow::Result<Command> {
    let (options, arguments) = rest.split_once(" -- ").unwrap_or((rest, ""));
    let name = options.split_once("--example ").and_then(|(_, rest)| rest.split_whitespace().next());
    let name = name.context("cargo run: only examples, by --example NAME")?;
    let program = target()?.join("debug/examples").join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    // `cargo test --workspace` has built it. Built alone, its packages have other features, and all of them are compiled again.
    if !program.exists() {
        must_succeed(&format!("build --quiet --example {name}"), |_| {})?;
    }
    let mut command = Command::new(program);
    command.args(arguments.split_whitespace()).current_dir(root()).stdin(Stdio::null());
    Ok(command)
}
