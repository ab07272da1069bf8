//! How close the queueing level comes to transactions, and in what time of the host: the table of `docs/fidelity.md`.
//!
//! `cargo run --release -p dualsplit-studies --example queueing_accuracy -- [WIDTHxHEIGHT [MULTIPROCESSORS [DETAIL [KEY=VALUE ...]]]]`

use cpu_time::ProcessTime;
use estimate::Method;
use golden::build::{BuildOptions, Quality, build};
use golden::structure::{Structure, pack_triangles};
use machine::description::MachineDescription;
use machine::frame::{FrameMachine, MachineStructure};
use render::{RenderOptions, Test};
use scenes::Scene;
use scenes::procedural::CATALOGUE;
use std::error::Error;
use studies::fidelity::{Level, Sample, Subject, queueing};

/// Relative errors of many frames.
#[derive(Default)]
struct Errors(Vec<f64>);

impl Errors {
    fn text(&self) -> String {
        let mean = self.0.iter().map(|error| error.abs()).sum::<f64>() / self.0.len() as f64;
        let worst = self.0.iter().copied().fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
        format!("{:.1} % | {:+.1} %", 100.0 * mean, 100.0 * worst)
    }
}

/// Pairs of structures whose frame times differ by more than this fraction are compared in their order.
const DIFFERENT: f64 = 0.05;

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let arg = |at: usize, default: &str| args.get(at).map_or(default, String::as_str).to_owned();
    let size = arg(0, "64x64");
    let (width, height) = size.split_once('x').ok_or("write WIDTHxHEIGHT")?;
    let (width, height): (u32, u32) = (width.parse()?, height.parse()?);
    let (tms, detail): (u32, f64) = (arg(1, "8").parse()?, arg(2, "0.02").parse()?);
    let mut settings = vec!["chip.l2_partitions=1".to_owned(), format!("chip.tms_per_partition={tms}")];
    settings.extend(args.iter().skip(3).cloned());
    let machine = MachineDescription::load("trax", &settings)?;
    rayon::ThreadPoolBuilder::new().num_threads(1).build_global()?;
    println!("{size} pixels, detail {detail}, {}, host times on one thread", settings.join(", "));
    println!(
        "| scene | time, mean | worst | energy, mean | worst | order kept | host, first machine | each further |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let mut all = (Errors::default(), Errors::default());
    for entry in CATALOGUE {
        let scene = Scene::load(entry.name, detail, 0)?;
        let tree = build(&scene.mesh, &BuildOptions::new(Quality::Medium))?;
        let triangles = pack_triangles(&scene.mesh, &tree);
        let (mut time, mut energy) = (Errors::default(), Errors::default());
        let (mut kept, mut pairs) = (0, 0);
        let mut seconds = [0.0; 3];
        for test in Test::ALL {
            let mut frames = vec![];
            for structure in MachineStructure::ALL {
                let set_up = FrameMachine::new(&machine, structure, estimate::by_name(Method::Published))?;
                let structure = Structure::convert(structure.kind(), &tree, &triangles)?;
                let options = RenderOptions::new(test, width, height);
                let subject =
                    Subject { machine: &set_up, scene: &scene, structure: &structure, options: &options };
                let timed = |count: usize| {
                    let start = ProcessTime::now();
                    let machines = vec![(set_up.clone(), set_up.program()?); count];
                    let estimates = queueing::estimates(&subject, &machines, |_| ())?;
                    Ok::<_, Box<dyn Error>>((estimates, start.elapsed().as_secs_f64()))
                };
                let (estimates, one) = timed(1)?;
                let (_, five) = timed(5)?;
                let start = ProcessTime::now();
                let whole = subject.estimate(Level::Transaction, &Sample::ALL, |_| ())?;
                let host = [one, (five - one) / 4.0, start.elapsed().as_secs_f64()];
                seconds.iter_mut().zip(host).for_each(|(sum, seconds)| *sum += seconds);
                time.0.push(estimates[0].frame_ms.value / whole.frame_ms.value - 1.0);
                energy.0.push(estimates[0].energy_mj.value / whole.energy_mj.value - 1.0);
                frames.push((estimates[0].frame_ms.value, whole.frame_ms.value));
            }
            for (at, a) in frames.iter().enumerate() {
                for b in frames[..at].iter().filter(|b| (a.1 / b.1 - 1.0).abs() > DIFFERENT) {
                    pairs += 1;
                    kept += u32::from((a.0 > b.0) == (a.1 > b.1));
                }
            }
        }
        let [first, further, transactions] = seconds;
        println!(
            "| {} | {} | {} | {kept} of {pairs} | {:.2} | {:.2} |",
            scene.name,
            time.text(),
            energy.text(),
            first / transactions,
            further / transactions
        );
        all.0.0.extend(time.0);
        all.1.0.extend(energy.0);
    }
    println!("| all | {} | {} | | | |", all.0.text(), all.1.text());
    Ok(())
}
