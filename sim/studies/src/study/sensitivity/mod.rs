//! Which of the paper's claims depend on the machine.
//!
//! The study's main series is estimated at the queueing level on a sample of machines ([`machines`]), every claim is judged on each
//! of them, and [`regions`] says for which it holds. Some of the machines are simulated as well ([`confirmation`]).

pub mod confirmation;
pub mod machines;
pub mod regions;

use super::comparison::{Claim, compare};
use super::jobs::{Preset, Series, chip_settings};
use super::row::{Row, Run};
use super::{Options, scenes_of};
use crate::artifacts::Artifacts;
use crate::fidelity::{Subject, queueing};
use crate::input::{Built, display};
use crate::progress::{Part, Progress};
use anyhow::ensure;
use confirmation::{Confirmation, confirm};
use costs::Pipeline;
use golden::structure::Structure;
use machine::description::MachineDescription;
use machine::frame::{FrameMachine, MachineStructure, node_bytes};
use machine::program::Program;
use machine::results::Results;
use machines::{CHIP, RANGES, Values};
use rayon::prelude::*;
use regions::{Region, region};
use render::{RenderOptions, Test};
use scenes::Scene;
use serde::Serialize;
use view::plot::Bars;

/// All claims with the machines for which they hold.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Sensitivity {
    pub preset: String,
    pub machine: String,
    pub ranges: Vec<RangeRow>,
    pub machines: usize,
    pub claims: Vec<ClaimRegion>,
    pub confirmations: Vec<Confirmation>,
    #[serde(skip)]
    pub artifacts: Vec<String>,
}

/// A key of the machine and the values that it was given.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct RangeRow {
    pub key: &'static str,
    pub values: &'static [&'static str],
}

/// A claim, and where it holds.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct ClaimRegion {
    pub claim: String,
    pub published: String,
    /// The result on the machine that is varied, and whether the claim holds there.
    pub unchanged: String,
    pub unchanged_holds: &'static str,
    #[serde(flatten)]
    pub region: Region,
}

/// How many machines are estimated, and how many of these are simulated.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Machines that are estimated, beside the one that is varied.
    pub machines: usize,
    /// Machines of these that are simulated as well.
    pub confirmed: usize,
}

/// Estimates the study's main series on the machine that `args` name and on variations of it, and judges all claims.
///
/// # Errors
/// There is no such preset, scene or machine, a frame cannot be estimated or simulated, or a file cannot be written.
pub fn run(args: &Options, size: Sample, progress: &dyn Progress) -> anyhow::Result<Sensitivity> {
    let preset = Preset { chip: CHIP, ..*Preset::find(&args.preset)? };
    for setting in &args.settings {
        let key = setting.split('=').next().unwrap_or_default().trim();
        let is_varied = key.starts_with("chip.") || RANGES.iter().any(|range| range.key == key);
        ensure!(!is_varied, "--set {setting}: --sensitivity gives this key values of its own; leave it out");
    }
    let sample = machines::sample(size.machines, args.seed);
    let settings = std::iter::once(vec![]).chain(sample.iter().map(machines::settings));
    let descriptions = settings.map(|settings| {
        let settings = [&args.settings[..], &chip_settings(CHIP), &settings].concat();
        MachineDescription::load(&args.machine, &settings)
    });
    let frames = Frames {
        args,
        preset,
        descriptions: descriptions.collect::<Result<_, _>>()?,
        structures: &MachineStructure::ALL,
        pipeline: Box::new(estimate::by_name(args.pipeline_cost)),
    };
    scenes_of(args)?;
    let mut artifacts = Artifacts::create(&args.out.join("sensitivity"), args.force)?;
    let rows = estimates(&frames, progress)?;
    let chosen = confirmation::chosen(&rows, size.confirmed);
    let confirmations = confirm(&frames, &chosen, &rows, &sample, progress)?;
    let claims: Vec<Vec<Claim>> = rows.par_iter().map(|rows| compare(rows, &[])).collect();
    let [unchanged, varied @ ..] = &claims[..] else { unreachable!("the machine itself comes first") };
    let claims: Vec<ClaimRegion> = unchanged.iter().map(|claim| judged(claim, &sample, varied)).collect();
    artifacts.write("machines.csv", machines_csv(&sample, varied)?.as_bytes())?;
    artifacts.write("holds.svg", chart(&claims).svg().as_bytes())?;
    let mut document = Sensitivity {
        preset: args.preset.clone(),
        machine: frames.descriptions[0].name.clone(),
        ranges: RANGES.iter().map(|range| RangeRow { key: range.key, values: range.values }).collect(),
        machines: size.machines,
        claims,
        confirmations,
        artifacts: vec![],
    };
    artifacts.write("sensitivity.json", serde_json::to_string_pretty(&document)?.as_bytes())?;
    document.artifacts = artifacts.finish()?.iter().map(|path| display(path)).collect();
    Ok(document)
}

/// The frames of the study's main series on many machines.
struct Frames<'a> {
    args: &'a Options,
    preset: Preset,
    descriptions: Vec<MachineDescription>,
    structures: &'static [MachineStructure],
    pipeline: Box<dyn Fn(&str) -> Pipeline + Sync + 'a>,
}

/// One of the frames.
struct Place<'a> {
    scene: &'a Scene,
    structure: MachineStructure,
    converted: &'a Structure,
    options: RenderOptions,
}

impl Frames<'_> {
    /// How many there are on each machine.
    fn count(&self) -> anyhow::Result<usize> {
        Ok(scenes_of(self.args)?.len() * self.structures.len() * Test::ALL.len())
    }

    /// Calls `visit` with each frame.
    fn each(
        &self,
        progress: &dyn Progress,
        mut visit: impl FnMut(&Place<'_>) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        for scene in scenes_of(self.args)? {
            let scene = Scene::load(scene, self.preset.detail, self.args.seed)?;
            let built = Built::new(&scene, self.args.quality, progress)?;
            for &structure in self.structures {
                let (converted, _) = built.convert(structure.kind())?;
                for test in Test::ALL {
                    let options = RenderOptions::new(test, self.preset.width, self.preset.height);
                    let options = RenderOptions { seed: self.args.seed, ..options };
                    visit(&Place { scene: &scene, structure, converted: &converted, options })?;
                }
            }
        }
        Ok(())
    }

    /// The line of the study's tables for a frame on machine `number`.
    fn row(&self, place: &Place<'_>, number: usize, rays: u64, results: &Results) -> anyhow::Result<Row> {
        let machine = &self.descriptions[number];
        let run = Run {
            preset: &self.args.preset,
            size: &self.preset,
            scene: &place.scene.name,
            triangles: place.scene.mesh.triangles.len() as u64,
            structure: place.structure,
            test: place.options.test,
            machine,
            series: Series::Main,
            load_words: &machine.load_words().to_string(),
            node_bytes: node_bytes(place.converted, machine.layout)?.0,
            rays,
            fingerprint: "",
        };
        Ok(Row::new(&run, results))
    }
}

/// For each machine, its lines of the study's tables, from one execution of each frame.
fn estimates(frames: &Frames<'_>, progress: &dyn Progress) -> anyhow::Result<Vec<Vec<Row>>> {
    let part = Part::begin(progress, frames.count()? as u64, "estimating on all machines");
    let mut rows = vec![vec![]; frames.descriptions.len()];
    frames.each(progress, |place| {
        let set_up = frames.descriptions.par_iter().map(|machine| {
            let machine = FrameMachine::new(machine, place.structure, &frames.pipeline)?;
            let program = machine.program()?;
            Ok((machine, program))
        });
        let set_up: Vec<(FrameMachine, Program)> = set_up.collect::<anyhow::Result<_>>()?;
        let subject = Subject {
            machine: &set_up[0].0,
            scene: place.scene,
            structure: place.converted,
            options: &place.options,
        };
        let estimates = queueing::estimates(&subject, &set_up, |_| ())?;
        for (number, (rows, estimate)) in rows.iter_mut().zip(&estimates).enumerate() {
            rows.push(frames.row(place, number, estimate.totals.rays, &estimate.results)?);
        }
        part.advance(1);
        Ok(())
    })?;
    Ok(rows)
}

/// The score of a claim: 1 where it holds, a half where it holds in some scenes, 0 where it does not or is undecided.
fn score(claim: &Claim) -> Option<f64> {
    match claim.holds {
        "yes" => Some(1.0),
        "partly" => Some(0.5),
        "no" | "undecided" => Some(0.0),
        _ => None,
    }
}

fn judged(claim: &Claim, sample: &[Values], varied: &[Vec<Claim>]) -> ClaimRegion {
    let of = |claims: &Vec<Claim>| claims.iter().find(|other| other.name == claim.name).and_then(score);
    let scores: Vec<Option<f64>> = varied.iter().map(of).collect();
    ClaimRegion {
        claim: claim.claim.clone(),
        published: claim.published.clone(),
        unchanged: claim.ours.clone(),
        unchanged_holds: claim.holds,
        region: region(sample, &scores, score(claim)),
    }
}

/// A line for each machine and claim: the values of all keys, the claim, the result, and whether the claim holds.
fn machines_csv(sample: &[Values], varied: &[Vec<Claim>]) -> anyhow::Result<String> {
    let mut writer = csv::Writer::from_writer(vec![]);
    let keys = RANGES.iter().map(|range| range.key);
    writer.write_record(["machine"].into_iter().chain(keys).chain(["claim", "ours", "holds"]))?;
    for (number, (machine, claims)) in sample.iter().zip(varied).enumerate() {
        for claim in claims {
            let mut record = vec![(number + 1).to_string()];
            record.extend(RANGES.iter().zip(machine).map(|(range, value)| range.values[*value].to_owned()));
            record.extend([claim.claim.clone(), claim.ours.clone(), claim.holds.to_owned()]);
            writer.write_record(&record)?;
        }
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// The shares of machines for which each claim holds, in all scenes or in some.
fn chart(claims: &[ClaimRegion]) -> Bars {
    let share = |of: fn(&Region) -> f64| claims.iter().map(|claim| Some(100.0 * of(&claim.region))).collect();
    Bars {
        title: "Claims by the share of machines for which they hold".to_owned(),
        unit: "% of machines".to_owned(),
        categories: claims.iter().map(|claim| claim.claim.clone()).collect(),
        series: vec![
            ("in all scenes".to_owned(), share(|region| region.holds)),
            ("in some scenes".to_owned(), share(|region| region.partly)),
        ],
        stacked: true,
        max: Some(100.0),
        texts: vec![vec![], claims.iter().map(|claim| shares(&claim.region)).collect()],
        ..Bars::default()
    }
}

/// Both shares of a claim in percent, which stand beside its bar.
fn shares(region: &Region) -> String {
    format!("{:.0} + {:.0}", 100.0 * region.holds, 100.0 * region.partly)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Silent;
    use estimate::Method;
    use golden::build::Quality;

    #[test]
    fn each_machine_has_its_own_lines() {
        let args = Options {
            preset: "tiny".to_owned(),
            scene: Some("courtyard".to_owned()),
            quality: Quality::Fast,
            machine: "trax".into(),
            settings: vec![],
            pipeline_cost: Method::Published,
            out: "unused".into(),
            seed: 1,
            force: false,
        };
        let machine = |settings: &[&str]| {
            let settings = settings.iter().map(|setting| (*setting).to_owned());
            let settings: Vec<String> = chip_settings(CHIP).into_iter().chain(settings).collect();
            MachineDescription::load("trax", &settings).unwrap()
        };
        let frames = |descriptions: Vec<MachineDescription>| Frames {
            args: &args,
            preset: Preset { detail: 0.001, width: 16, height: 16, chip: CHIP, scaling_tms: &[] },
            descriptions,
            structures: &[MachineStructure::Bvh2],
            pipeline: Box::new(estimate::by_name(Method::Published)),
        };
        let machines =
            [&[][..], &["layout.alignment=64B"], &["l1.size=16KiB", "dram.channels=1"]].map(machine);
        let rows = |machines: &[MachineDescription]| estimates(&frames(machines.to_vec()), &Silent).unwrap();
        let together = rows(&machines);
        let [packed, aligned, small] = &together[..] else { panic!("{} machines", together.len()) };
        assert_eq!(packed.iter().map(|row| row.test.as_str()).collect::<Vec<_>>(), ["raycast", "path"]);
        assert!(aligned[0].node_bytes > packed[0].node_bytes);
        assert!(small[1].cycles > packed[1].cycles && small[1].l1_hit_pct < packed[1].l1_hit_pct);
        assert_eq!(small[1].instructions, packed[1].instructions);
        for (machine, own) in machines.iter().zip(&together) {
            assert_eq!(rows(std::slice::from_ref(machine))[0], *own, "a machine alone has the same lines");
        }
        let chosen = confirmation::chosen(&together, 2);
        assert_eq!(chosen, [1, 2], "the fastest first");
        let sample = machines::sample(2, 1);
        let confirmed = confirm(&frames(machines.to_vec()), &chosen, &together, &sample, &Silent).unwrap();
        for (machine, confirmation) in chosen.iter().zip(&confirmed) {
            assert_eq!((confirmation.machine, confirmation.frames), (*machine, together[0].len()));
            let error = confirmation.worst_time_error_pct.abs();
            assert!((0.001..20.0).contains(&error), "{confirmation:?}");
        }
        // The estimates of another machine are noticed.
        let others = [packed.clone(), small.clone(), aligned.clone()];
        let confirmed = confirm(&frames(machines.to_vec()), &[1], &others, &sample, &Silent).unwrap();
        assert!(confirmed[0].mean_time_error_pct > 15.0, "{:?}", confirmed[0]);
    }
}
