//! The simulations that a study consists of.

use anyhow::Context;
use machine::description::MachineDescription;
use machine::frame::MachineStructure;
use render::Test;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The size of a study.
pub struct Preset {
    /// Fraction of the scenes' triangles.
    pub detail: f64,
    pub width: u32,
    pub height: u32,
    /// Partitions and multiprocessors per partition.
    pub chip: [u32; 2],
    /// Multiprocessors of the scaling runs, up to eight in a partition.
    pub scaling_tms: &'static [u32],
}

/// The size for the main job, which has a minute for the study.
const SMALL: Preset = Preset { width: 24, height: 24, ..QUICK };
const QUICK: Preset =
    Preset { detail: 0.02, width: 64, height: 64, chip: [1, 4], scaling_tms: &[1, 2, 4, 8] };
const MEDIUM: Preset =
    Preset { detail: 0.25, width: 128, height: 128, chip: [4, 8], scaling_tms: &[1, 2, 4, 8, 16, 32, 64] };
const PAPER: Preset = Preset { detail: 1.0, width: 256, height: 256, ..MEDIUM };

impl Preset {
    /// The preset `name` of the command line.
    pub fn find(name: &str) -> anyhow::Result<&'static Self> {
        [("small", &SMALL), ("quick", &QUICK), ("medium", &MEDIUM), ("paper", &PAPER)]
            .into_iter()
            .find_map(|(known, preset)| (known == name).then_some(preset))
            .with_context(|| format!("--preset {name}: the presets are small, quick, medium and paper"))
    }
}

/// The series that a simulation belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Series {
    /// All scenes, structures and tests.
    Main,
    /// One scene on more and fewer multiprocessors.
    Scaling,
    /// Some scenes with loads of several words.
    LoadWidth,
    /// The hierarchies of boxes with sibling nodes placed within lines, which costs bytes for gaps.
    Layout,
}

/// The scene and test of the scaling runs.
pub const SCALING_SCENE: &str = "atrium";
pub const SCALING_TEST: Test = Test::Path;
/// The scenes of the runs with wider loads. Runs with loads of one word belong to the main series.
pub const WIDTH_SCENES: [&str; 2] = ["atrium", "hairball"];
pub const WIDTH_TEST: Test = Test::Path;
const WIDER_LOADS: [&str; 3] = ["2", "4", "line"];
/// The structures that are simulated a second time, with their nodes at [`LINE`]. The main series packs nodes, as the paper does.
const PLACED: [MachineStructure; 3] =
    [MachineStructure::Bvh2, MachineStructure::Bvh4, MachineStructure::Bvh8];
/// The alignment at which the fewest loads of a hierarchy reach the L2 (docs/machine.md, "Where nodes lie").
const LINE: &str = "64B";

/// The settings of a machine with so many partitions and multiprocessors per partition.
pub fn chip_settings([partitions, tms]: [u32; 2]) -> [String; 2] {
    [format!("chip.l2_partitions={partitions}"), format!("chip.tms_per_partition={tms}")]
}

/// One simulation.
#[derive(Clone, Copy)]
pub struct Job {
    pub structure: MachineStructure,
    pub test: Test,
    pub series: Series,
    /// Partitions and multiprocessors per partition.
    pub chip: [u32; 2],
    /// The words of a load.
    pub load_words: &'static str,
}

impl Job {
    /// All simulations of a scene, the main series first. Another series leaves out the simulations that the main series has.
    pub fn of_scene(scene: &str, preset: &Preset) -> Vec<Self> {
        let main = |structure| {
            Test::ALL.map(|test| Self {
                structure,
                test,
                series: Series::Main,
                chip: preset.chip,
                load_words: "1",
            })
        };
        let mut jobs: Vec<Self> = MachineStructure::ALL.into_iter().flat_map(main).collect();
        let of_test = |test: Test| jobs.iter().filter(move |job| job.test == test).copied();
        let mut others = vec![];
        if scene == SCALING_SCENE {
            let chips = preset.scaling_tms.iter().map(|tms| [tms.div_ceil(8), (*tms).min(8)]);
            for chip in chips.filter(|chip| *chip != preset.chip) {
                let job = |job| Self { series: Series::Scaling, chip, ..job };
                others.extend(of_test(SCALING_TEST).map(job));
            }
        }
        if WIDTH_SCENES.contains(&scene) {
            for load_words in WIDER_LOADS {
                let job = |job| Self { series: Series::LoadWidth, load_words, ..job };
                others.extend(of_test(WIDTH_TEST).map(job));
            }
        }
        let placed = jobs.iter().filter(|job| PLACED.contains(&job.structure));
        others.extend(placed.map(|job| Self { series: Series::Layout, ..*job }));
        jobs.extend(others);
        jobs
    }

    /// The machine of this simulation: that of the command line, with the settings that the study varies.
    pub fn machine(&self, name: &Path, settings: &[String]) -> anyhow::Result<MachineDescription> {
        let mut settings = settings.to_vec();
        settings.extend(chip_settings(self.chip));
        match self.series {
            Series::Main | Series::Scaling => {}
            Series::LoadWidth => settings.push(format!("tm.load_words={}", self.load_words)),
            Series::Layout => settings.push(format!("layout.alignment={LINE}")),
        }
        Ok(MachineDescription::load(name, &settings)?)
    }

    /// The file that keeps the record of this simulation.
    pub fn file(&self, scene: &str, preset: &str) -> String {
        let part = match self.series {
            Series::Main => String::new(),
            Series::Scaling => format!("-{}tms", self.chip[0] * self.chip[1]),
            Series::LoadWidth => format!("-{}words", self.load_words),
            Series::Layout => format!("-{LINE}"),
        };
        let structure = self.structure.name().replace('+', "p");
        format!("runs/{preset}-{scene}-{}-{structure}{part}.json", self.test)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_simulation_has_a_file_and_placed_nodes_lie_in_lines() {
        for scene in scenes::procedural::CATALOGUE {
            let jobs = Job::of_scene(scene.name, &QUICK);
            let files: BTreeSet<String> = jobs.iter().map(|job| job.file(scene.name, "quick")).collect();
            assert_eq!(files.len(), jobs.len(), "{}", scene.name);
            let placed: Vec<&Job> = jobs.iter().filter(|job| job.series == Series::Layout).collect();
            assert_eq!(placed.len(), PLACED.len() * Test::ALL.len());
            for job in jobs {
                let machine = job.machine("trax".as_ref(), &[]).unwrap();
                let alignment = machine.layout.alignment.to_string();
                assert_eq!(alignment, if job.series == Series::Layout { LINE } else { "0B" });
            }
        }
    }
}
