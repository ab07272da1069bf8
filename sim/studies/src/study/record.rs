//! What the study keeps of a run: what it counted, by kind, without any price.

use super::jobs::{Job, Preset};
use super::row::{Row, Run};
use golden::build::Quality;
use golden::structure::Structure;
use machine::frame::{FrameMachine, frame, node_bytes};
use machine::results::{Results, Tally};
use render::RenderOptions;
use scenes::Scene;
use serde::{Deserialize, Serialize};

/// A kept run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Record {
    pub triangles: u64,
    pub node_bytes: u64,
    pub rays: u64,
    pub tally: Tally,
    /// A hash of everything that the counts depend on except scene and test.
    pub fingerprint: String,
}

/// A simulation with the machine that it is made on.
pub(super) struct Planned {
    pub scene: String,
    pub job: Job,
    pub machine: FrameMachine,
    /// The file of its record.
    pub file: String,
    pub fingerprint: String,
}

impl Planned {
    /// Simulates the frame.
    pub fn simulate(
        &self,
        preset: &Preset,
        seed: u64,
        scene: &Scene,
        structures: &[Structure],
    ) -> anyhow::Result<Record> {
        let kind = self.job.structure.kind();
        let structure = structures.iter().find(|s| s.kind() == kind).expect("all kinds");
        let mut options = RenderOptions::new(self.job.test, preset.width, preset.height);
        options.seed = seed;
        let frame = frame(&self.machine, scene, structure, &options, |_| {})?;
        Ok(Record {
            triangles: scene.mesh.triangles.len() as u64,
            node_bytes: node_bytes(structure, self.machine.description.layout)?.0,
            rays: frame.rays,
            tally: Tally::new(&frame.program, &frame.counts),
            fingerprint: self.fingerprint.clone(),
        })
    }

    /// The line of the study's tables for `record`, at the prices of the machine.
    pub fn row(&self, name: &str, preset: &Preset, record: &Record) -> anyhow::Result<Row> {
        let FrameMachine { description, pipeline, .. } = &self.machine;
        let results = Results::new(description, pipeline.as_ref(), &record.tally)?;
        let run = Run {
            preset: name,
            size: preset,
            scene: &self.scene,
            triangles: record.triangles,
            structure: self.job.structure,
            test: self.job.test,
            machine: description,
            series: self.job.series,
            load_words: self.job.load_words,
            node_bytes: record.node_bytes,
            rays: record.rays,
            fingerprint: &record.fingerprint,
        };
        Ok(Row::new(&run, &results))
    }
}

/// Most bytes of the file of a run.
pub(super) const MOST_BYTES: u64 = 1 << 20;

/// A hash of everything that a run's counts depend on except its scene and test: the sources of this program, scene size, tree
/// quality, the machine but for what only has a price, the pipeline, the program.
pub(super) fn fingerprint(machine: &FrameMachine, quality: Quality, seed: u64, preset: &Preset) -> String {
    let version = env!("DUALSPLIT_SOURCES");
    let Preset { detail, width, height, .. } = preset;
    let everything = format!(
        "{version} {seed} {detail} {width}x{height} {quality:?}\n{}\n{:?}\n{}",
        machine.description.timing().to_toml(),
        machine.pipeline.as_ref().map(|pipeline| (&pipeline.name, &pipeline.units, pipeline.latency_cycles)),
        machine.structure.listing(machine.description.layout)
    );
    // FNV-1a, 64 bits.
    let hash = everything
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    format!("{hash:016x}")
}

#[cfg(test)]
mod tests {
    use super::super::jobs::Series;
    use super::*;
    use crate::input::Built;
    use crate::progress::Silent;
    use estimate::Method;
    use machine::description::MachineDescription;
    use machine::frame::MachineStructure;
    use render::Test;

    const PRESET: Preset = Preset { detail: 0.001, width: 8, height: 8, chip: [1, 1], scaling_tms: &[] };

    fn planned(settings: &[&str]) -> Planned {
        let settings: Vec<String> = settings.iter().map(|setting| (*setting).to_owned()).collect();
        let job = Job {
            structure: MachineStructure::Dst,
            test: Test::Path,
            series: Series::Main,
            chip: PRESET.chip,
            load_words: "1",
        };
        let machine = job.machine("trax".as_ref(), &settings).unwrap();
        let mut machine =
            FrameMachine::new(&machine, job.structure, estimate::by_name(Method::Published)).unwrap();
        if settings.iter().any(|setting| setting.starts_with("l1.energy")) {
            machine.pipeline.as_mut().unwrap().cost.energy_pj *= 1.5;
        }
        let fingerprint = fingerprint(&machine, Quality::Fast, 1, &PRESET);
        Planned { scene: "atrium".to_owned(), job, machine, file: String::new(), fingerprint }
    }

    #[test]
    fn a_kept_run_at_other_prices_is_what_a_new_simulation_gives() {
        let scene = Scene::load("atrium", PRESET.detail, 1).unwrap();
        let built = Built::new(&scene, Quality::Fast, &Silent).unwrap();
        let structures = [built.convert(MachineStructure::Dst.kind()).unwrap().0];
        let run = |planned: &Planned| planned.simulate(&PRESET, 1, &scene, &structures).unwrap();
        let first = planned(&[]);
        let kept = serde_json::to_string(&run(&first)).unwrap();
        let kept: Record = serde_json::from_str(&kept).unwrap();
        let prices = ["l1.energy_nj=0.3", "l2.area_mm2=7.5", "dram.power.idd0_ma=99.5", "clock_ghz=0.7"];
        let other = planned(&prices);
        assert_eq!(other.fingerprint, first.fingerprint);
        let repriced = other.row("tiny", &PRESET, &kept).unwrap();
        assert_eq!(repriced, other.row("tiny", &PRESET, &run(&other)).unwrap());
        let before = first.row("tiny", &PRESET, &kept).unwrap();
        let energies = |row: &Row| [row.l1_mj, row.dram_mj, row.pipeline_mj, row.area_mm2, row.frame_ms];
        assert!(energies(&before).iter().zip(energies(&repriced)).all(|(a, b)| *a != b));
        assert_eq!((before.l2_mj, before.units_mj), (repriced.l2_mj, repriced.units_mj));
        let sum = |row: &Row| row.dram_mj + row.on_chip_mj + row.execution_mj;
        assert!((sum(&before) / before.energy_mj - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_run_is_known_by_what_its_counts_depend_on() {
        let fingerprint = |setting: &str| planned(&[setting]).fingerprint;
        let trax = fingerprint("name=trax");
        for price in ["name=other", "l2.energy_nj=1", "dram.power.vdd_v=1.2", "clock_ghz=2"] {
            assert_eq!(fingerprint(price), trax, "{price}");
        }
        for timing in
            ["l1.size=64KiB", "l1.ports=2", "dram.timing.refresh=221", "units.fp_add.latency_cycles=3"]
        {
            assert_ne!(fingerprint(timing), trax, "{timing}");
        }
        assert!(MachineDescription::load("trax", &[]).unwrap().timing().needs.is_none());
    }
}
