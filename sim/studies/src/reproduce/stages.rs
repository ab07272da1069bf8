//! The parts of the main job: each is a command of the tool with the options that the report shows beside its results.
//!
//! The result of each part is written to `stages/`. If the job is interrupted, the same job of the same program continues with
//! the results that it finds there.

use crate::artifacts::Artifacts;
use crate::input::display;
use crate::progress::Progress;
use anyhow::Context;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::Path;
use std::time::{Instant, UNIX_EPOCH};

/// A part of the job.
pub struct Stage {
    /// Name of its result file.
    pub name: String,
    /// The folder that the command writes, if it writes one.
    pub folder: String,
    /// Words of the command, in which [`FOLDER`] stands for the folder.
    pub words: Vec<String>,
    /// The approximate seconds that the command takes on two cores. The estimate of the time left uses them.
    pub seconds: f64,
}

/// The placeholder for a stage's folder in its command.
pub const FOLDER: &str = "OUT";

/// The result of a command.
pub struct Finding {
    /// The command's JSON document.
    pub report: Value,
    /// Whether a check found a difference.
    pub difference: bool,
}

/// A function that runs a command of the tool. It takes the words of the command line, beginning with the program's name.
pub type Command<'a> = &'a dyn Fn(&[OsString]) -> anyhow::Result<Finding>;

/// The result of a part, with its command.
#[derive(Clone, Serialize, Deserialize)]
pub struct Outcome {
    /// The command that was run, as typed.
    pub command: String,
    /// The command's JSON document.
    pub report: Value,
    /// Whether a check found a difference.
    pub difference: bool,
    /// Seconds of the host.
    pub seconds: f64,
}

impl Stage {
    /// The stage `name`, which runs the command `line`.
    pub fn new(name: &str, seconds: f64, line: &str) -> Self {
        let words = line.split_whitespace().map(str::to_owned).collect();
        Self { name: name.to_owned(), folder: name.to_owned(), words, seconds }
    }
}

/// A job in a folder. It takes the results that an interrupted run left there.
pub struct Job<'a> {
    folder: &'a Path,
    seed: u64,
    command: Command<'a>,
    progress: &'a dyn Progress,
    resumed: bool,
    /// For each part done in this run, the seconds that it took over the seconds expected.
    paces: Vec<f64>,
    /// The seconds expected for all parts ahead.
    ahead: f64,
    left: usize,
}

/// The file that identifies the job in the folder until it is complete.
const UNFINISHED: &str = "stages/unfinished.json";

impl<'a> Job<'a> {
    /// Begins `job`, or continues it. All of its `parts` parts are expected to take `seconds` together.
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
            // Files of an earlier job must not be mistaken for results of this program.
            for folder in folders.iter().map(|name| folder.join(name)).filter(|folder| folder.is_dir()) {
                Artifacts::create(&folder, false)?.finish()?;
            }
        }
        artifacts.write(UNFINISHED, identity.as_bytes())?;
        Ok(Self { folder, seed, command, progress, resumed, paces: vec![], ahead: seconds, left: parts })
    }

    /// The result of part `name`, from an interrupted run or from `make`, which is expected to take `seconds`.
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

    /// The number of parts left, and the expected time for them, scaled by the median pace of the parts done. A part that finds
    /// most of its runs done takes almost no time, which would distort a mean.
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
            let mut words = vec![OsString::from("dualsplit")];
            words.extend(
                stage
                    .words
                    .iter()
                    .map(|word| if word == FOLDER { folder.clone().into() } else { word.into() }),
            );
            words.extend(seed.iter().flat_map(|seed| seed.split(' ')).map(OsString::from));
            let command = words.join(OsStr::new(" ")).to_string_lossy().into_owned();
            let start = Instant::now();
            let Finding { report, difference } = run(&words).with_context(|| command.clone())?;
            Ok(Outcome { report, difference, command, seconds: start.elapsed().as_secs_f64() })
        })
    }

    /// Completes the job, so that a later run begins anew.
    pub fn finish(self, artifacts: &mut Artifacts) {
        artifacts.drop(UNFINISHED);
    }
}

/// A text that identifies the running program, so that a job never continues with results of another build.
fn program() -> anyhow::Result<String> {
    let path = std::env::current_exe()?;
    let file = fs::metadata(&path).with_context(|| display(&path))?;
    let modified = file.modified()?.duration_since(UNIX_EPOCH).map(|time| time.as_nanos()).unwrap_or(0);
    Ok(format!("program of {} bytes made at {modified} ns", file.len()))
}
