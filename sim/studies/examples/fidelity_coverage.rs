//! How often the intervals of `--fidelity auto` cover the frame's own time and energy: the table of `docs/fidelity.md`.
//!
//! `cargo run --release -p dualsplit-studies --example fidelity_coverage -- [SEEDS [WIDTHxHEIGHT [MULTIPROCESSORS [TOLERANCE [DETAIL]]]]]`

use estimate::Method;
use golden::build::{BuildOptions, Quality, build};
use golden::structure::{Structure, pack_triangles};
use machine::description::MachineDescription;
use machine::frame::{FrameMachine, MachineStructure};
use render::{RenderOptions, Test};
use scenes::Scene;
use scenes::procedural::CATALOGUE;
use std::error::Error;
use studies::fidelity::auto::auto;
use studies::fidelity::{Level, Sample, Subject};

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let arg = |at: usize, default: &str| args.get(at).map_or(default, String::as_str).to_owned();
    let seeds: u32 = arg(0, "20").parse()?;
    let size = arg(1, "96x96");
    let (width, height) = size.split_once('x').ok_or("write WIDTHxHEIGHT")?;
    let (width, height): (u32, u32) = (width.parse()?, height.parse()?);
    let tms: u32 = arg(2, "2").parse()?;
    let tolerance: f64 = arg(3, "0.02").parse()?;
    let detail: f64 = arg(4, "0.02").parse()?;
    let settings = ["chip.l2_partitions=1".to_owned(), format!("chip.tms_per_partition={tms}")];
    let machine = MachineDescription::load("trax", &settings)?;
    println!(
        "{size} pixels, {tms} multiprocessors, detail {detail}, tolerance {} %, {seeds} seeds",
        100.0 * tolerance
    );
    println!();
    println!(
        "| scene | frame ms | mJ | covered | time only | energy only | mean error, time % | energy % | mean interval, time % \
         | energy % | worst error % | pixels timed % | whole frames | runs |"
    );
    println!("|{}", "---|".repeat(14));
    for entry in CATALOGUE {
        let scene = Scene::load(entry.name, detail, 0)?;
        let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast))?;
        let kind = MachineStructure::Dst;
        let structure = Structure::convert(kind.kind(), &tree, &pack_triangles(&scene.mesh, &tree))?;
        let set_up = FrameMachine::new(&machine, kind, estimate::by_name(Method::Published))?;
        let options = RenderOptions::new(Test::Path, width, height);
        let subject = Subject { machine: &set_up, scene: &scene, structure: &structure, options: &options };
        let frame = subject.estimate(Level::Transaction, &Sample::ALL, |_| {})?;
        let (ms, mj) = (frame.frame_ms.value, frame.energy_mj.value);
        let (mut covered, mut whole, mut runs) = ([0u32; 3], 0u32, 0);
        let (mut error, mut half, mut worst, mut share) = ([0.0; 2], [0.0; 2], 0.0f64, 0.0);
        for seed in 0..seeds {
            let steps = auto(&subject, tolerance, seed.into(), |_| {})?;
            let result = &steps.last().ok_or("a result")?.estimate;
            let (time, energy) = (result.frame_ms.covers(ms), result.energy_mj.covers(mj));
            covered[0] += u32::from(time && energy);
            covered[1] += u32::from(time);
            covered[2] += u32::from(energy);
            for (i, (interval, value)) in
                [(result.frame_ms, ms), (result.energy_mj, mj)].into_iter().enumerate()
            {
                let relative = 100.0 * (interval.value / value - 1.0);
                error[i] += relative / f64::from(seeds);
                half[i] += 100.0 * interval.relative() / f64::from(seeds);
                worst = worst.max(relative.abs());
            }
            share += 100.0 * result.timed_share / f64::from(seeds);
            whole += u32::from(result.is_whole());
            runs += steps.len() - 1;
        }
        println!(
            "| {} | {ms:.4} | {mj:.3} | {} of {seeds} | {} | {} | {:+.2} | {:+.2} | {:.2} | {:.2} | {worst:.2} | {share:.0} | {whole} | {:.1} |",
            entry.name,
            covered[0],
            covered[1],
            covered[2],
            error[0],
            error[1],
            half[0],
            half[1],
            runs as f64 / f64::from(seeds)
        );
    }
    Ok(())
}
