//! Who makes cells of a pipeline's gates: our mapper, or ABC where it is installed.

use super::Options;
use anyhow::{Context, ensure};
use base::output::Unfinished;
use estimate::{EstimateError, Implementation, Mappings, Workload};
use gates::abc::installed;
use gates::liberty::Library;
use gates::words::Structures;
use pipelines::catalogue::Top;
use serde::Serialize;
use std::str::FromStr;

/// Who makes cells of a pipeline's gates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mapper {
    /// Ours, which needs no other program.
    #[default]
    Own,
    /// ABC, by the best of the fixed scripts.
    Abc,
}

impl FromStr for Mapper {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "own" => Ok(Self::Own),
            "abc" => Ok(Self::Abc),
            _ => Err("name a mapper: own or abc".to_owned()),
        }
    }
}

/// The pipeline by our own mapper, beside the one by ABC that all tables are about.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct OwnRow {
    pub mapping: String,
    pub critical_path_ns: f64,
    pub logic_area_um2: f64,
    /// Energy of one operation, without glitches.
    pub energy_pj: f64,
}

impl OwnRow {
    pub(super) fn new(own: &Implementation, workload: &Workload) -> Result<Self, EstimateError> {
        Ok(Self {
            mapping: own.recipe.to_string(),
            critical_path_ns: own.timing.critical_path_ns,
            logic_area_um2: own.logic_um2(),
            energy_pj: own.zero_delay_energy(&workload.streams(own)?).0.total() / 1e3,
        })
    }
}

/// What has to be there for the mapper that is asked for.
pub(super) fn check(args: &Options) -> anyhow::Result<()> {
    if args.mapper == Mapper::Abc {
        ensure!(args.clock.is_some(), "--mapper abc maps for a clock: add one, such as --clock 40fo4");
        ensure!(!args.liberty.is_empty(), "--mapper abc reads the cells from a file: add --liberty FILE");
        ensure!(
            installed().is_some(),
            "--mapper abc: ABC is not installed: install yosys or berkeley-abc, or leave out --mapper abc"
        );
    }
    Ok(())
}

/// The pipeline, mapped for the clock, or as without one. If ABC maps it, also as our own mapper does for the same clock.
pub(super) fn implementation<'l>(
    args: &Options,
    top: Top,
    library: &'l Library,
) -> anyhow::Result<(Implementation<'l>, Option<Implementation<'l>>)> {
    let Some(clock) = args.clock else {
        return Ok((Implementation::new(top, library, Structures::default())?, None));
    };
    let mappings = Mappings::new(top, library)?;
    let period_ns = clock.period_ns(library);
    let own = mappings.within(period_ns)?;
    Ok(match args.mapper {
        Mapper::Own => (own, None),
        Mapper::Abc => {
            let found = by_abc(args, &mappings, &[period_ns])?.pop();
            (found.expect("one for each clock"), Some(own))
        }
    })
}

/// The pipeline by ABC for each of some clocks in nanoseconds.
pub(super) fn by_abc<'l>(
    args: &Options,
    mappings: &Mappings<'l>,
    clocks_ns: &[f64],
) -> anyhow::Result<Vec<Implementation<'l>>> {
    let folder = tempfile::tempdir().context("a temporary folder cannot be made")?;
    let _unfinished = Unfinished::new(folder.path());
    Ok(mappings.by_abc(clocks_ns, &args.liberty, folder.path())?)
}
