//! The table of the reference runs, and the same runs by this machine.

use super::compared::{ValidatedRun, compare};
use super::scene::{RaySet, ReferenceError, ReferenceScene};
use super::{ANY, CLOSEST, ReferenceWork};
use crate::core::{SimulationError, simulate};
use crate::description::{DescriptionError, MachineDescription};
use crate::program::{ListingError, Program};
use crate::results::{Results, Tally};
use cpu_time::ThreadTime;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The preset that the reference runs were made with.
pub const PRESET: &str = "simtrax-reference";

/// The table of the runs in their folder.
pub const TABLE: &str = "reference_runs.csv";

/// What variants of the reference runs set that do not say so themselves.
const VARIANTS: &str = include_str!("../../presets/simtrax-variants.toml");

/// One run of the table `reference_runs.csv`. Columns that are not compared are not read.
#[derive(Clone, Debug, Deserialize)]
pub struct ReferenceRun {
    /// Set of rays.
    pub set: String,
    /// The name of what differs from the main configuration; empty for that.
    #[serde(default)]
    pub variant: String,
    /// What differs, as words `KEY=VALUE`. Where the table has no such column or it is empty, the name says what differs.
    #[serde(default)]
    settings: String,
    /// `closest` or `anyhit`.
    pub kernel: String,
    /// Multiprocessors.
    #[serde(rename = "TMs")]
    pub tms: u32,
    pub(super) cycles: u64,
    pub(super) instr: u64,
    #[serde(rename = "L1_acc")]
    pub(super) l1_accesses: u64,
    #[serde(rename = "L1_hits")]
    pub(super) l1_hits: u64,
    #[serde(rename = "L2_acc")]
    pub(super) l2_accesses: u64,
    #[serde(rename = "L2_hits")]
    pub(super) l2_hits: u64,
    pub(super) dram_reads: u64,
    #[serde(rename = "E_fu")]
    pub(super) units_j: f64,
    #[serde(rename = "E_l1")]
    pub(super) l1_j: f64,
    #[serde(rename = "E_l2")]
    pub(super) l2_j: f64,
    #[serde(rename = "E_ic")]
    pub(super) icache_j: f64,
    #[serde(rename = "E_ls")]
    pub(super) local_store_j: f64,
    #[serde(rename = "E_rf")]
    pub(super) registers_j: f64,
    #[serde(rename = "E_dram")]
    pub(super) dram_j: f64,
    pub(super) wall_s: f64,
}

/// One line of `counts.csv`: where a set lies in memory.
#[derive(Clone, Debug, Deserialize)]
struct Addresses {
    set: String,
    ray_addr: u32,
    out_addr: u32,
}

/// Why the reference runs cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum ValidationError {
    /// A file is missing or is not what it should be.
    #[error(transparent)]
    File(#[from] ReferenceError),
    /// A table cannot be read.
    #[error("{}: {error}", .file.display())]
    Table {
        /// The file.
        file: PathBuf,
        /// Line and reason.
        error: csv::Error,
    },
    /// A run that this machine cannot be set up for.
    #[error("{}: {message}", .file.display())]
    Run {
        /// The file.
        file: PathBuf,
        /// Which run, and what is wrong.
        message: String,
    },
    /// A variant that cannot be built.
    #[error(transparent)]
    Description(#[from] DescriptionError),
    /// A mistake in the program.
    #[error(transparent)]
    Listing(#[from] ListingError),
    /// A run that does not end.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
}

fn table<T: for<'de> Deserialize<'de>>(file: &Path) -> Result<Vec<T>, ValidationError> {
    let failed = |error| ValidationError::Table { file: file.to_owned(), error };
    let mut reader = csv::Reader::from_path(file).map_err(failed)?;
    reader.deserialize().collect::<Result<_, _>>().map_err(failed)
}

/// The runs of `folder`, with the addresses of their sets.
pub struct ReferenceRuns {
    folder: PathBuf,
    /// All runs, in the order of the table.
    pub runs: Vec<ReferenceRun>,
    addresses: Vec<Addresses>,
}

impl ReferenceRuns {
    /// Reads `reference_runs.csv` and `counts.csv` in `folder`.
    ///
    /// # Errors
    /// If a table is missing or malformed.
    pub fn read(folder: &Path) -> Result<Self, ValidationError> {
        let runs: Vec<ReferenceRun> = table(&folder.join(TABLE))?;
        if runs.is_empty() {
            let file = folder.join(TABLE);
            return Err(ValidationError::Run { file, message: "the table has no run to repeat".to_owned() });
        }
        let addresses = table(&folder.join("counts.csv"))?;
        Ok(Self { folder: folder.to_owned(), runs, addresses })
    }

    fn fail(&self, run: &ReferenceRun, message: &str) -> ValidationError {
        ValidationError::Run {
            file: self.folder.join(TABLE),
            message: format!("run {} {} with {} TMs: {message}", run.set, run.variant, run.tms),
        }
    }

    /// What differs in a run from the main configuration, but for the number of multiprocessors.
    fn settings(&self, run: &ReferenceRun) -> Result<Vec<String>, ValidationError> {
        if !run.settings.trim().is_empty() {
            return Ok(run.settings.split_whitespace().map(str::to_owned).collect());
        }
        let variants: BTreeMap<String, Vec<String>> = toml::from_str(VARIANTS).expect("a test reads it");
        if run.variant.is_empty() {
            return Ok(vec![]);
        }
        variants.get(&run.variant).cloned().ok_or_else(|| {
            let known: Vec<&str> = variants.keys().map(String::as_str).collect();
            let message = format!(
                "nothing says what the variant sets; give the table a column `settings` with words such as \
                 l1.enabled=false, or take one of the variants {}",
                known.join(", ")
            );
            self.fail(run, &message)
        })
    }

    /// The file that the run needs and the folder does not have, or what else it lacks.
    #[must_use]
    pub fn lacks(&self, run: &ReferenceRun) -> Option<String> {
        if !self.addresses.iter().any(|place| place.set == run.set) {
            return Some(format!("{} does not have the set", self.folder.join("counts.csv").display()));
        }
        let scene = run.set.rsplit_once('_').map_or("", |(scene, _)| scene);
        let files = [(scene, "bvh.json"), (scene, "bvh"), (&run.set, "rays"), (&run.set, "hits")];
        let paths = files.map(|(name, extension)| self.folder.join(format!("{name}.{extension}")));
        let missing = paths.iter().find(|path| !path.exists());
        missing.map(|path| format!("{} is missing", path.display()))
    }

    /// Makes a run and compares it. `seconds` are right only where a single host thread runs it.
    ///
    /// # Errors
    /// If its files are missing or its machine cannot be built.
    pub fn validate(&self, run: &ReferenceRun) -> Result<ValidatedRun, ValidationError> {
        let settings = self.settings(run)?;
        let all = [&[format!("chip.tms_per_partition={}", run.tms)], &settings[..]].concat();
        let machine =
            MachineDescription::load(PRESET, &all).map_err(|error| self.fail(run, &error.to_string()))?;
        let any = match run.kernel.as_str() {
            "closest" => false,
            "anyhit" => true,
            _ => return Err(self.fail(run, "the kernel is neither `closest` nor `anyhit`")),
        };
        let (scene_name, _) =
            run.set.rsplit_once('_').ok_or_else(|| self.fail(run, "the set is not called SCENE_RAYS"))?;
        let place = self.addresses.iter().find(|place| place.set == run.set);
        let place = place.ok_or_else(|| self.fail(run, "counts.csv does not have the set"))?;
        let scene = ReferenceScene::read(&self.folder, scene_name)?;
        let rays = RaySet::read(&self.folder, &run.set, place.ray_addr, place.out_addr)?;
        let program = Program::new("reference", if any { ANY } else { CLOSEST }, &machine, 1)?;
        let program = Arc::new(program);
        // Processor time: other work on the host does not count.
        let start = ThreadTime::now();
        let work = ReferenceWork::new(Arc::clone(&program), &scene, &rays).map_err(SimulationError::from)?;
        let counts = simulate(&machine, &program, &work, |_| {})?;
        let seconds = start.elapsed().as_secs_f64();
        let result_mismatches = work.mismatches();
        let results = Results::new(&machine, None, &Tally::new(&program, &counts))?;
        Ok(compare(run, settings, &results, result_mismatches, rays.rays.len() as u64, seconds))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_variant_can_be_set_and_differs() {
        let main = MachineDescription::load(PRESET, &[]).unwrap();
        let variants: BTreeMap<String, Vec<String>> = toml::from_str(VARIANTS).unwrap();
        assert!(variants.contains_key("l1off"));
        for (name, settings) in variants {
            let machine = MachineDescription::load(PRESET, &settings);
            assert_ne!(machine.unwrap_or_else(|error| panic!("{name}: {error}")), main, "{name}");
        }
    }
}
