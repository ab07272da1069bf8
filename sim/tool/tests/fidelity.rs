//! Levels and samples of the simulation, compared with the frame itself.

use estimate::Method;
use golden::build::{BuildOptions, Quality, build};
use golden::structure::{Structure, pack_triangles};
use machine::description::MachineDescription;
use machine::frame::{FrameMachine, MachineStructure, frame};
use machine::results::Instructions;
use render::{RenderOptions, Test};
use scenes::Scene;
use studies::fidelity::auto::auto;
use studies::fidelity::{BIAS, Estimate, Level, Sample, Subject};

struct Prepared {
    scene: Scene,
    machine: FrameMachine,
    structure: Structure,
    options: RenderOptions,
}

impl Prepared {
    fn new(name: &str, detail: f64, structure: MachineStructure, test: Test, side: u32) -> Self {
        let settings = ["chip.l2_partitions=1".to_owned(), "chip.tms_per_partition=1".to_owned()];
        let machine = MachineDescription::load("trax", &settings).unwrap();
        let scene = Scene::load(name, detail, 0).unwrap();
        let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
        let triangles = pack_triangles(&scene.mesh, &tree);
        Self {
            machine: FrameMachine::new(&machine, structure, estimate::by_name(Method::Published)).unwrap(),
            structure: Structure::convert(structure.kind(), &tree, &triangles).unwrap(),
            options: RenderOptions::new(test, side, side),
            scene,
        }
    }

    fn subject(&self) -> Subject<'_> {
        let Self { scene, machine, structure, options } = self;
        Subject { machine, scene, structure, options }
    }

    fn estimate(&self, level: Level, sample: &Sample) -> Estimate {
        self.subject().estimate(level, sample, |_| {}).unwrap()
    }
}

#[test]
fn all_pixels_are_the_frame_and_a_sample_knows_its_instructions() {
    let prepared = Prepared::new("atrium", 0.002, MachineStructure::Dst, Test::Path, 28);
    let plain =
        frame(&prepared.machine, &prepared.scene, &prepared.structure, &prepared.options, |_| {}).unwrap();
    let whole = prepared.estimate(Level::Transaction, &Sample::ALL);
    assert!(whole.is_whole());
    assert_eq!(whole.counts.cycles, plain.counts.cycles);
    assert_eq!(whole.counts.thread_cycles, plain.counts.thread_cycles);
    assert_eq!(whole.counts.dram, plain.counts.dram);
    assert_eq!(whole.counts.runs, plain.counts.runs);
    assert_eq!(whole.frame_ms.low, whole.frame_ms.high);

    let sample = prepared.estimate(Level::Transaction, &Sample::of(2, 0));
    assert!(sample.timed_share < 0.75 && !sample.is_whole(), "{}", sample.timed_share);
    // The instructions executed are known, not estimated.
    assert_eq!(sample.counts.runs, plain.counts.runs);
    assert_eq!(sample.totals.rays, plain.rays);
    assert_eq!(sample.results.energy_mj.pipeline, whole.results.energy_mj.pipeline);
    assert_eq!(sample.results.energy_mj.l1, whole.results.energy_mj.l1);
    assert_ne!(sample.counts.cycles, plain.counts.cycles);
    // The same seed draws the same batches.
    assert_eq!(prepared.estimate(Level::Transaction, &Sample::of(2, 0)).frame_ms, sample.frame_ms);
    assert_ne!(prepared.estimate(Level::Transaction, &Sample::of(2, 1)).frame_ms, sample.frame_ms);
}

#[test]
fn the_netlists_execute_every_operation_and_change_nothing() {
    for structure in [MachineStructure::Dst, MachineStructure::Bvh2, MachineStructure::Bvh4Plus] {
        let prepared = Prepared::new("statue", 0.001, structure, Test::Raycast, 12);
        let rtl = prepared.estimate(Level::Rtl, &Sample::ALL);
        let transaction = prepared.estimate(Level::Transaction, &Sample::ALL);
        assert_eq!(rtl.totals.rtl_differences, 0, "{structure}");
        if structure != MachineStructure::Bvh4Plus {
            // Pipelines side by side test several boxes in one operation.
            assert_eq!(rtl.totals.rtl_operations, rtl.results.instructions.pipeline, "{structure}");
        }
        assert!(rtl.totals.rtl_operations > 1000, "{structure}");
        assert_eq!(transaction.totals.rtl_operations, 0);
        assert_eq!(rtl.counts.cycles, transaction.counts.cycles, "{structure}");
        assert_eq!(rtl.results.energy_mj, transaction.results.energy_mj, "{structure}");
    }
    let software = Prepared::new("statue", 0.001, MachineStructure::DstSoftware, Test::Raycast, 12);
    let error = software.subject().estimate(Level::Rtl, &Sample::ALL, |_| {}).unwrap_err();
    assert!(error.to_string().contains("dst-sw"), "{error}");
}

#[test]
fn the_analytic_bound_is_below_the_machine_in_every_structure() {
    for structure in MachineStructure::ALL {
        let prepared = Prepared::new("courtyard", 0.002, structure, Test::Path, 20);
        let bound = prepared.estimate(Level::Analytic, &Sample::ALL);
        let machine = prepared.estimate(Level::Transaction, &Sample::ALL);
        assert!(bound.frame_ms.value <= machine.frame_ms.value, "{structure}");
        assert!(bound.energy_mj.value <= machine.energy_mj.value, "{structure}");
        assert!(bound.frame_ms.value > 0.05 * machine.frame_ms.value, "{structure}");
        assert_eq!(bound.counts.runs, machine.counts.runs, "{structure}");
        let instructions =
            |e: &Estimate| Instructions::new(&prepared.machine.program().unwrap(), &e.counts).total;
        assert_eq!(instructions(&bound), instructions(&machine), "{structure}");
        assert!(bound.counts.dram.reads <= machine.counts.dram.reads, "{structure}");
    }
}

/// A small version of the table of `docs/fidelity.md`.
#[test]
fn the_queueing_level_is_as_close_as_it_says_in_every_structure() {
    for structure in MachineStructure::ALL {
        for (scene, test) in [("atrium", Test::Raycast), ("courtyard", Test::Path)] {
            let prepared = Prepared::new(scene, 0.005, structure, test, 32);
            let estimate = prepared.estimate(Level::Queueing, &Sample::ALL);
            let machine = prepared.estimate(Level::Transaction, &Sample::ALL);
            let what = format!("{structure} {scene}");
            assert!(
                estimate.frame_ms.covers(machine.frame_ms.value),
                "{what}: {:?} {:?}",
                estimate.frame_ms,
                machine.frame_ms
            );
            assert!(estimate.energy_mj.covers(machine.energy_mj.value), "{what}");
            assert_eq!(estimate.counts.runs, machine.counts.runs, "{what}");
            assert_eq!(estimate.totals, machine.totals, "{what}");
            assert!(!estimate.is_whole());
            let classes = |e: &Estimate| e.counts.thread_cycles.total() as f64 / f64::from(e.counts.cycles);
            assert!(
                (classes(&estimate) - classes(&machine)).abs() < 1e-3,
                "{what}: each thread-cycle is in a class"
            );
        }
    }
}

/// A small version of the experiment of `docs/fidelity.md`. If the timed pixels, with cold start and end, stand for the rest
/// without correction, the error is several times as large.
#[test]
fn intervals_of_samples_cover_the_frame() {
    const SEEDS: u64 = 6;
    let (mut covered, mut error, mut plain) = (0, 0.0, 0.0);
    for (name, structure) in [("courtyard", MachineStructure::Dst), ("statue", MachineStructure::Bvh2)] {
        let prepared = Prepared::new(name, 0.01, structure, Test::Raycast, 64);
        let frame = prepared.estimate(Level::Transaction, &Sample::ALL);
        let (ms, mj) = (frame.frame_ms.value, frame.energy_mj.value);
        for seed in 0..SEEDS {
            let sample = prepared.estimate(Level::Transaction, &Sample::of(6, seed));
            error += (sample.energy_mj.value / mj - 1.0) / (2 * SEEDS) as f64;
            plain += (sample.plain[1] / mj - 1.0) / (2 * SEEDS) as f64;
            covered += u32::from(sample.frame_ms.covers(ms) && sample.energy_mj.covers(mj));
        }
    }
    assert!(covered >= 10, "{covered} of 12");
    assert!(plain > 0.01, "cold caches have a bias to correct: {plain}");
    assert!(error.abs() < plain / 2.0, "{error} corrected, {plain} not");
}

#[test]
fn auto_takes_no_more_than_the_tolerance_asks_for() {
    let prepared = Prepared::new("courtyard", 0.005, MachineStructure::Dst, Test::Raycast, 64);
    let subject = prepared.subject();
    let loose = auto(&subject, 0.1, 1, |_| {}).unwrap();
    let [first, last] = &loose[..] else { panic!("{} steps", loose.len()) };
    assert_eq!(first.estimate.level, Level::Analytic);
    assert!(last.estimate.is_within(0.1) && last.estimate.timed_share < 0.5, "{}", last.verdict);
    let frame = prepared.estimate(Level::Transaction, &Sample::ALL);
    // Warming leaves an error of BIAS, so a lower tolerance takes the whole frame.
    let tight = auto(&subject, 0.5 * BIAS, 1, |_| {}).unwrap();
    let result = &tight.last().unwrap().estimate;
    assert!(result.is_whole() && result.frame_ms == frame.frame_ms && result.energy_mj == frame.energy_mj);
    // With a tolerance in between, every sample is larger than the one before.
    let steps = auto(&subject, 0.015, 1, |_| {}).unwrap();
    assert!(steps.last().unwrap().estimate.is_within(0.015));
    assert!(steps.windows(2).all(|pair| pair[0].estimate.timed_share < pair[1].estimate.timed_share));
}
