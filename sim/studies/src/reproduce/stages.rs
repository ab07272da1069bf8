//! The parts of the main job: each is a command of the tool with the options that the report shows beside its results.
//!
//! The result of each part stands under `stages/`. As long as the job is not complete, the same job, started again by the
//! same program, takes them from there.

use crate::artifacts::Artifacts;
use crate::input::display;
use crate::progress::Progress;
use anyhow::Context;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::time::{Instant, UNIX_EPOCH};

/// A part of the job.
pub struct Stage {
    /// Name of its result file.
    pub name: String,
    /// The folder that it fills, if it fills one.
    pub folder: String,
    /// Words of the command; [`FOLDER`] stands for the folder.
    pub words: Vec<String>,
    /// About how many seconds it takes on two cores, to tell how long the rest takes.
    pub seconds: f64,
}

/// The folder of a stage, in its command.
pub const FOLDER: &str = "OUT";

/// What a command has found.
pub struct Finding {
    /// Its JSON document.
    pub report: Value,
    /// Whether a check has found a difference.
    pub difference: bool,
}

/// Runs a command of the tool: the words that are typed, the name of the program first.
pub type Command<'a> = &'a dyn Fn(&[String]) -> anyhow::Result<Finding>;

/// What a part has found.
#[derive(Clone, Serialize, Deserialize)]
pub struct Outcome {
    /// The command that was run, as typed.
    pub command: String,
    /// Its JSON document.
    pub report: Value,
    /// Whether a check has found a difference.
    pub difference: bool,
    /// Of the host.
    pub seconds: f64,
}

impl Stage {
    /// The stage `name`, which runs the command `line`.
    pub fn new(name: &str, seconds: f64, line: &str) -> Self {
        let words = line.split_whitespace().map(str::to_owned).collect();
        Self { name: name.to_owned(), folder: name.to_owned(), words, seconds }
    }
}

/// A job in a folder, with what an interrupted run of it has left there.
pub struct Job<'a> {
    folder: &'a Path,
    seed: u64,
    command: Command<'a>,
    progress: &'a dyn Progress,
    resumed: bool,
    /// For each part done in this run, the seconds that it took over those that it was expected to take.
    paces: Vec<f64>,
    /// Seconds that those ahead are expected to take.
    ahead: f64,
    left: usize,
}

/// Says which job has not been completed.
const UNFINISHED: &str = "stages/unfinished.json";

impl<'a> Job<'a> {
    /// Begins `job`, or goes on with it; `seconds` are those of `parts` parts together.
    pub fn begin(
        folder: &'a Path,
        job: &str,
        (seed, command, progress): (u64, Command<'a>, &'a dyn Progress),
        artifacts: &mut Artifacts,
        (parts, seconds): (usize, f64),
        folders: &BTreeSet<&str>,
    ) -> anyhow::Result<Self> {
        let identity = format!("{job}, seed {}, {}\n", seed, program()?);
        let resumed = fs::read_to_string(folder.join(UNFINISHED)).is_ok_and(|text| text == identity);
        if !resumed {
            // What an earlier job has left must not be mistaken for results of this program.
            for folder in folders.iter().map(|name| folder.join(name)).filter(|folder| folder.is_dir()) {
                Artifacts::create(&folder, false)?.finish()?;
            }
        }
        artifacts.write(UNFINISHED, identity.as_bytes())?;
        Ok(Self { folder, seed, command, progress, resumed, paces: vec![], ahead: seconds, left: parts })
    }

    /// The result of part `name`, from an interrupted run or from `make`, which is expected to take so many seconds.
    pub fn part<T: Serialize + serde::de::DeserializeOwned>(
        &mut self,
        name: &str,
        seconds: f64,
        artifacts: &mut Artifacts,
        make: impl FnOnce(&mut Artifacts) -> anyhow::Result<T>,
    ) -> anyhow::Result<T> {
        let file = format!("stages/{name}.json");
        self.left -= 1;
        self.ahead -= seconds;
        let kept = self.resumed.then(|| fs::read_to_string(self.folder.join(&file)).ok()).flatten();
        if let Some(result) = kept.and_then(|text| serde_json::from_str(&text).ok()) {
            artifacts.keep(&file);
            self.progress.note(&format!("{name}: taken from the interrupted run"));
            return Ok(result);
        }
        self.progress.note(&format!("{name}: {}", self.time_left(seconds)));
        let start = Instant::now();
        let result = make(artifacts)?;
        artifacts.write(&file, serde_json::to_string_pretty(&result)?.as_bytes())?;
        self.paces.push(start.elapsed().as_secs_f64() / seconds);
        Ok(result)
    }

    /// What is still to be done, by the expected times and how they compared so far. The median is taken: a part that finds most of
    /// its runs done takes no time, and says nothing about the others.
    fn time_left(&self, seconds: f64) -> String {
        let mut paces = self.paces.clone();
        paces.sort_by(f64::total_cmp);
        let pace = paces.get(paces.len() / 2).copied();
        let left = (self.ahead + seconds) * pace.unwrap_or(1.0);
        let time = if left < 120.0 { format!("{left:.0} s") } else { format!("{:.0} min", left / 60.0) };
        let basis = if pace.is_some() { "at the pace so far" } else { "as on two cores" };
        format!("{} parts and about {time} left, {basis}", self.left + 1)
    }

    /// Runs `stage`, or takes its result from an interrupted run.
    pub fn run(&mut self, stage: &Stage, artifacts: &mut Artifacts) -> anyhow::Result<Outcome> {
        let folder = self.folder.join(&stage.folder);
        let (seed, run) = (self.seed, self.command);
        self.part(&stage.name, stage.seconds, artifacts, |_| {
            let seed = (seed != 0).then(|| format!("--seed {seed}"));
            let mut words = vec!["dualsplit".to_owned()];
            words.extend(
                stage.words.iter().map(|word| if word == FOLDER { display(&folder) } else { word.clone() }),
            );
            words.extend(seed.iter().flat_map(|seed| seed.split(' ')).map(str::to_owned));
            let command = words.join(" ");
            let start = Instant::now();
            let Finding { report, difference } = run(&words).with_context(|| command.clone())?;
            Ok(Outcome { report, difference, command, seconds: start.elapsed().as_secs_f64() })
        })
    }

    /// The job is complete: nothing is left to go on with.
    pub fn finish(self, artifacts: &mut Artifacts) {
        artifacts.drop(UNFINISHED);
    }
}

/// The running program: results of another build are not taken over.
fn program() -> anyhow::Result<String> {
    let path = std::env::current_exe()?;
    let file = fs::metadata(&path).with_context(|| display(&path))?;
    let modified = file.modified()?.duration_since(UNIX_EPOCH).map(|time| time.as_nanos()).unwrap_or(0);
    Ok(format!("program of {} bytes made at {modified} ns", file.len()))
}
