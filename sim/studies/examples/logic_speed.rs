//! Vectors that each simulation of the two pipelines takes per second of processor time, on the same vectors.
//!
//! `cargo run --release -p dualsplit-studies --example logic_speed` builds Verilator's model of the exported Verilog with
//! `-O3 -march=native` and no threads, and runs rust-hdl's `simulate` loop, Verilator, the interpreter and the compiled
//! simulation in turns. The vectors are operations back to back. The example compares results by the sums of all outputs.
//! With two threads, each thread simulates its own copy; the throughput is the sum of the rates of both threads, each over the
//! processor time of its own thread.

use cpu_time::ThreadTime;
use equivalence::Stimulus;
use lanes::{Compiled, InstructionSet, LANES, Program, Slot};
use logic::interpreter::Interpreter;
use logic::rust_hdl::{Ports, RustHdl};
use logic::verilated::Verilated;
use netlist::Engine;
use netlist::{Flat, flatten, latency_cycles};
use pipelines::catalogue::{StandardFormat, Top};
use pipelines::formats::binary32;

/// Vectors in memory, run over and over.
const VECTORS: usize = 4096;
/// Turns of all simulations. The result is each simulation's best turn.
const TURNS: usize = 5;

/// The stream of a pipeline, without stalls and bubbles.
fn vectors(top: Top, netlist: &Flat) -> Vec<Vec<u64>> {
    let mut stream: Vec<Vec<u64>> = Stimulus::new(top, StandardFormat::Binary32, netlist, 1)
        .take(VECTORS)
        .map(|inputs| inputs.into_iter().map(|value| value as u64).collect())
        .collect();
    for name in ["en_i", "valid_i"] {
        let input = netlist.input(name).expect("a pipeline's port");
        stream.iter_mut().for_each(|inputs| inputs[input] = 1);
    }
    stream
}

/// Sums of the outputs over `passes` passes of the vectors, and the seconds that these took. Each lane runs a part of the stream.
fn compiled_pass(
    engine: &mut Compiled,
    frames: &[Vec<[u32; LANES]>],
    passes: u32,
    latency: usize,
) -> (Vec<u64>, f64) {
    let program = engine.program();
    let cycles = frames.len();
    let mut sums = vec![[0u32; LANES]; program.outputs.len()];
    let mut bits = vec![0u64; program.outputs.len()];
    let start = ThreadTime::now();
    for _ in 0..passes {
        for cycle in 0..cycles + latency {
            // The last frame is repeated while the last results come out.
            for (port, lanes) in program.inputs.iter().zip(&frames[cycle.min(cycles - 1)]) {
                match port.slot {
                    Slot::Word(..) => *engine.words_mut(port.slot) = *lanes,
                    // The first word of a one-bit port holds the bits of all lanes.
                    _ => *engine.bits_mut(port.slot) = lanes[0] as u16,
                }
            }
            engine.settle();
            if cycle >= latency {
                for (position, port) in program.outputs.iter().enumerate() {
                    match port.slot {
                        Slot::Word(..) => {
                            let shown = engine.words(port.slot);
                            sums[position]
                                .iter_mut()
                                .zip(shown)
                                .for_each(|(sum, x)| *sum = sum.wrapping_add(*x));
                        }
                        _ => bits[position] += u64::from(engine.bits(port.slot).count_ones()),
                    }
                }
            }
            engine.clock();
        }
    }
    let seconds = start.elapsed().as_secs_f64();
    let sum = |(lanes, bits): (&[u32; LANES], &u64)| {
        lanes.iter().fold(*bits, |sum, &x| sum.wrapping_add(x.into())) & u64::from(u32::MAX)
    };
    (sums.iter().zip(&bits).map(sum).collect(), seconds)
}

/// The inputs of each cycle, with the stream cut into as many parts as there are lanes, one part a lane.
fn frames(program: &Program, vectors: &[Vec<u64>]) -> Vec<Vec<[u32; LANES]>> {
    let cycles = vectors.len() / LANES;
    let frame = |cycle: usize| {
        let port = |position: usize| {
            let lane = |lane: usize| vectors[lane * cycles + cycle][position] as u32;
            match program.inputs[position].slot {
                Slot::Word(..) => std::array::from_fn(lane),
                _ => [(0..LANES).fold(0, |bits, at| bits | (lane(at) & 1) << at); LANES],
            }
        };
        (0..program.inputs.len()).map(port).collect()
    };
    (0..cycles).map(frame).collect()
}

fn interpreter_rate(netlist: &Flat, vectors: &[Vec<u64>]) -> f64 {
    let mut engine = Interpreter::new(netlist);
    let lanes = engine.lanes();
    let cycles = vectors.len() / lanes;
    let mut columns = vec![vec![vec![0u32; lanes]; netlist.inputs.len()]; cycles];
    for (position, inputs) in vectors.iter().enumerate() {
        for (input, &value) in inputs.iter().enumerate() {
            columns[position % cycles][input][position / cycles] = value as u32;
        }
    }
    let start = ThreadTime::now();
    for frame in &columns {
        frame.iter().enumerate().for_each(|(input, values)| engine.drive(input, values));
        engine.settle();
        engine.clock();
    }
    (cycles * lanes) as f64 / start.elapsed().as_secs_f64()
}

fn rust_hdl_rate<M: Ports>(vectors: &[Vec<u64>]) -> f64 {
    let mut engine = RustHdl::<M>::new();
    let start = ThreadTime::now();
    for inputs in vectors {
        inputs.iter().enumerate().for_each(|(input, &value)| engine.set_input(input, 0, value.into()));
        engine.settle();
        engine.clock();
    }
    vectors.len() as f64 / start.elapsed().as_secs_f64()
}

fn best(rates: impl Iterator<Item = f64>) -> f64 {
    rates.fold(0.0, f64::max)
}

fn measure(top: Top, rust_hdl: fn(&[Vec<u64>]) -> f64) -> Result<(), Box<dyn std::error::Error>> {
    let format = StandardFormat::Binary32;
    let design = top.design(format)?;
    let netlist = flatten(&design)?;
    let latency = latency_cycles(&netlist).ok_or("a plain pipeline has a latency")? as usize;
    let program = compiled::program(top, format).ok_or("the pipelines are compiled")?;
    let vectors = vectors(top, &netlist);
    let frames = frames(program, &vectors);
    let folder = tempfile::tempdir()?;
    let model = Verilated::build(&design, folder.path())?;
    let mut drained = vectors.clone();
    drained.extend(std::iter::repeat_n(vectors[VECTORS - 1].clone(), latency));

    let (mut verilator, mut one, mut two) = (0.0f64, 0.0f64, 0.0f64);
    const VERILATOR_PASSES: u32 = 100;
    const PASSES: u32 = 1000;
    let rate = |passes: u32, seconds: f64| f64::from(passes) * VECTORS as f64 / seconds;
    for _ in 0..TURNS {
        let run = model.run(&drained, VERILATOR_PASSES + 1, latency)?;
        verilator = verilator.max(rate(VERILATOR_PASSES, run.seconds));
        let (sums, seconds) = compiled_pass(&mut Compiled::new(program), &frames, PASSES, latency);
        one = one.max(rate(PASSES, seconds));
        // Both simulate the same vectors in different orders. Sums do not depend on the order.
        let single = model.run(&drained, 1, latency)?.sums;
        let (once, _) = compiled_pass(&mut Compiled::new(program), &frames, 1, latency);
        let single: Vec<u64> = single.iter().map(|sum| sum & u64::from(u32::MAX)).collect();
        if once != single || sums.len() != once.len() {
            return Err(format!("{top}: the sums of the outputs differ: {once:?} and {single:?}").into());
        }
        let rates: Vec<f64> = std::thread::scope(|scope| {
            let run = || rate(PASSES, compiled_pass(&mut Compiled::new(program), &frames, PASSES, latency).1);
            let threads: Vec<_> = (0..2).map(|_| scope.spawn(run)).collect();
            threads.into_iter().map(|thread| thread.join().expect("no panic")).collect()
        });
        two = two.max(rates.iter().sum());
    }
    let loop_rate = rust_hdl(&vectors[..1000]);
    let interpreter = best((0..TURNS).map(|_| interpreter_rate(&netlist, &vectors)));
    println!(
        "| {top} | {loop_rate:.0} | {:.2} M | {:.2} M | {:.2} M | {:.1} | {:.0} | {:.2} |",
        verilator * 1e-6,
        interpreter * 1e-6,
        one * 1e-6,
        one / verilator,
        one / loop_rate,
        two / one
    );
    for set in InstructionSet::ALL {
        if let Some(mut engine) = Compiled::with_instructions(program, set) {
            let passes = if set == InstructionSet::Scalar { PASSES / 10 } else { PASSES };
            let found = best(
                (0..TURNS).map(|_| rate(passes, compiled_pass(&mut engine, &frames, passes, latency).1)),
            );
            println!("  {set}: {:.2} M/s, {:.1} times Verilator", found * 1e-6, found / verilator);
        }
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!(
        "| pipeline | rust-hdl | Verilator | interpreter | compiled | / Verilator | / rust-hdl | two threads / one |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    measure(Top::DualSplit, rust_hdl_rate::<binary32::DualSplitPipeline>)?;
    measure(Top::RayBox, rust_hdl_rate::<binary32::RayBoxPipeline>)
}
