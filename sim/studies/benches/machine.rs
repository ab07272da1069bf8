//! Speed of the machine model in simulated rays per second: `cargo bench -p dualsplit-studies --bench machine`.
//!
//! One benchmark simulates a frame of a built-in scene in every structure, and another renders the same picture by golden
//! alone: the ratio of the two is the slow-down of the model. If `DUALSPLIT_DATA` names the folder, a third repeats runs of the
//! public simulator's table (`simulate --validate` prints all of them beside that simulator's speed).

use divan::Bencher;
use divan::counter::ItemsCount;
use estimate::Method;
use golden::build::{BinaryTree, BuildOptions, Quality, build};
use golden::structure::{Structure, pack_triangles};
use machine::description::MachineDescription;
use machine::frame::{FrameMachine, MachineStructure, frame};
use machine::reference::ReferenceRuns;
use render::{RenderOptions, Test, render};
use scenes::Scene;
use std::path::PathBuf;
use std::sync::LazyLock;

fn main() {
    divan::main();
}

static PREPARED: LazyLock<(Scene, BinaryTree)> = LazyLock::new(|| {
    let scene = Scene::load("atrium", 0.02, 0).expect("a built-in scene");
    let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).expect("it is not empty");
    (scene, tree)
});

fn options() -> RenderOptions {
    RenderOptions::new(Test::Path, 48, 48)
}

fn structure(of: MachineStructure) -> Structure {
    let (scene, tree) = &*PREPARED;
    Structure::convert(of.kind(), tree, &pack_triangles(&scene.mesh, tree)).expect("it converts")
}

fn rays(structure: &Structure) -> u64 {
    render(structure, &PREPARED.0, &options(), |_| {}).expect("it renders").total().rays
}

/// A frame on four multiprocessors.
#[divan::bench(args = MachineStructure::ALL, sample_count = 5)]
fn simulated_frame(bencher: Bencher, of: MachineStructure) {
    let settings = ["chip.l2_partitions=1", "chip.tms_per_partition=4"].map(str::to_owned);
    let machine = MachineDescription::load("trax", &settings).expect("a preset");
    let set_up =
        FrameMachine::new(&machine, of, estimate::by_name(Method::Published)).expect("it has the units");
    let structure = structure(of);
    bencher
        .counter(ItemsCount::new(rays(&structure)))
        .bench_local(|| frame(&set_up, &PREPARED.0, &structure, &options(), |_| {}).expect("it ends").counts);
}

/// The same picture without a machine.
#[divan::bench(args = [MachineStructure::Dst, MachineStructure::Bvh2], sample_count = 5)]
fn golden_frame(bencher: Bencher, of: MachineStructure) {
    let structure = structure(of);
    let one = || render(&structure, &PREPARED.0, &options(), |_| {}).expect("it renders");
    bencher.counter(ItemsCount::new(rays(&structure))).bench_local(one);
}

/// The set `bunny_primary` of the public simulator's table on `tms` multiprocessors.
#[divan::bench(args = [1, 4, 16], sample_count = 3)]
fn reference_run(bencher: Bencher, tms: u32) {
    let Some(data) = std::env::var_os("DUALSPLIT_DATA").map(PathBuf::from) else {
        return;
    };
    let reference = ReferenceRuns::read(&data.join("simtrax")).expect("the folder holds the runs");
    let is_it = |tms: u32| {
        reference
            .runs
            .iter()
            .find(|run| run.set == "bunny_primary" && run.variant.is_empty() && run.tms == tms)
    };
    let run = is_it(tms).expect("the table has the run");
    bencher.counter(ItemsCount::new(16_384u32)).bench_local(|| reference.validate(run).expect("it ends"));
}
