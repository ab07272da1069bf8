//! What the runs of a study have in common, so that a folder holds runs of one study only.

use super::{Options, record};
use crate::input::quality_name;
use anyhow::bail;
use base::input::read_own;
use machine::description::MachineDescription;
use serde::{Deserialize, Serialize};

/// The file of the settings in the folder of a study.
pub(super) const FILE: &str = "settings.json";

/// What all runs in a folder have in common, whichever preset and scene they are of.
#[derive(PartialEq, Serialize, Deserialize)]
pub(super) struct Settings {
    quality: String,
    seed: u64,
    /// The machine as TOML, before the study varies it, without what only has a price.
    machine: String,
}

impl Settings {
    /// The settings of a study.
    ///
    /// # Errors
    /// There is no such machine.
    pub(super) fn of(args: &Options) -> anyhow::Result<Self> {
        Ok(Self {
            quality: quality_name(args.quality).to_owned(),
            seed: args.seed,
            machine: MachineDescription::load(&args.machine, &args.settings)?.timing().to_toml(),
        })
    }

    /// Checks that the folder holds no runs with other settings, unless `--force` lets them be replaced.
    ///
    /// # Errors
    /// The first setting that differs.
    pub(super) fn compare(&self, args: &Options) -> anyhow::Result<()> {
        let found = read_own(&args.out.join(FILE), record::MOST_BYTES).ok();
        let found = found.and_then(|text| serde_json::from_str::<Self>(&text).ok());
        let Some(found) = found.filter(|found| found != self && !args.force) else { return Ok(()) };
        let differs = if found.quality != self.quality {
            format!("--quality {}", found.quality)
        } else if found.seed != self.seed {
            format!("--seed {}", found.seed)
        } else {
            format!("another machine (see {FILE})")
        };
        bail!(
            "{}: the folder holds a study with {differs}; name another folder with --out, or use --force to replace its runs",
            args.out.display()
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use estimate::Method;
    use golden::build::Quality;

    #[test]
    fn another_study_in_the_folder_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let options = Options {
            preset: "small".to_owned(),
            scene: None,
            quality: Quality::Fast,
            machine: "trax".into(),
            settings: vec![],
            pipeline_cost: Method::Published,
            out: folder.path().to_owned(),
            seed: 3,
            force: false,
        };
        let settings = |options: &Options| Settings::of(options).unwrap();
        let kept = serde_json::to_string(&settings(&options)).unwrap();
        std::fs::write(folder.path().join(FILE), kept).unwrap();
        let refused = |options: Options| settings(&options).compare(&options).unwrap_err().to_string();
        assert!(settings(&options).compare(&options).is_ok());
        let same = || options.clone();
        assert!(refused(Options { seed: 4, ..same() }).contains("--seed 3"));
        assert!(refused(Options { quality: Quality::High, ..same() }).contains("--quality fast"));
        assert!(
            refused(Options { settings: vec!["l1.banks=4".to_owned()], ..same() })
                .contains("another machine")
        );
        let other_price = Options { settings: vec!["l1.energy_nj=1".to_owned()], ..same() };
        assert!(settings(&other_price).compare(&other_price).is_ok());
        let forced = Options { seed: 4, force: true, ..same() };
        assert!(settings(&forced).compare(&forced).is_ok());
    }
}
