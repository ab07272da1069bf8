//! The exported Verilog in Icarus and Verilator, on the streams that the netlist and golden agree on.
//!
//! A tool that is missing skips its test, or fails it where `CI` is set.

use hdl::catalogue::{StandardFormat, Top};
use hdl::equivalence::{Model, Stimulus, compare};
use hdl::netlist::flatten;
use hdl::verilog::testbench::{hex_line, testbench};
use hdl::verilog::text;
use std::path::Path;
use tests::tools::{available, run};

const ICARUS_VECTORS: u64 = 10_000;
const VERILATOR_VECTORS: u64 = 1_000_000;
/// Vectors in one file: a testbench holds them all in memory.
const CHUNK: u64 = 50_000;

/// Tops that a simulator gets through in seconds.
const SMALL: [Top; 7] =
    [Top::IntAdd, Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp, Top::DualSplit, Top::DualSplitLean];
const LARGE: [Top; 6] =
    [Top::RayBox, Top::RayBoxLean, Top::RayBoxX2, Top::RayBoxX4, Top::RayBoxX8, Top::SharedUnits];

/// Writes source and testbench of `top`.
fn write_sources(folder: &Path, top: Top, capacity: u64) {
    let design = top.design(StandardFormat::Binary32).unwrap();
    std::fs::write(folder.join(format!("{top}.v")), text(&design)).unwrap();
    std::fs::write(folder.join(format!("{top}_tb.v")), testbench(&design, capacity)).unwrap();
}

/// Writes `count` vectors of `seed` to `<top>_vectors.hex`: golden's outputs where they mean something, the netlist's
/// elsewhere.
fn write_vectors(folder: &Path, top: Top, count: u64, seed: u64) {
    let format = StandardFormat::Binary32;
    let netlist = flatten(&top.design(format).unwrap()).unwrap();
    let widths: Vec<u32> = netlist
        .inputs
        .iter()
        .chain(netlist.outputs.iter().map(|(port, _)| port))
        .map(|port| port.width)
        .collect();
    let mut lines = String::new();
    let stimulus = Stimulus::new(top, format, &netlist, seed).take(count as usize);
    let outcome = compare(&netlist, Model::new(top, format, &netlist), stimulus, |inputs, outputs| {
        let words: Vec<(u128, u32)> =
            inputs.iter().chain(outputs).zip(&widths).map(|(&value, &width)| (value, width)).collect();
        lines.push_str(&hex_line(&words));
    });
    assert_eq!(outcome.mismatches, 0, "{top}: {:?}", outcome.first);
    std::fs::write(folder.join(format!("{top}_vectors.hex")), lines).unwrap();
}

fn icarus(tops: &[Top]) {
    if !available("iverilog") {
        return;
    }
    for &top in tops {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        write_sources(folder, top, ICARUS_VECTORS);
        write_vectors(folder, top, ICARUS_VECTORS, 1);
        let sources = [format!("{top}_tb.v"), format!("{top}.v")];
        run(folder, "iverilog", &["-g2005", "-Wall", "-o", "simulation", &sources[0], &sources[1]]).unwrap();
        let printed = run(folder, "vvp", &["-n", "simulation"]).unwrap();
        assert!(printed.contains(&format!("PASS: {top}, {ICARUS_VECTORS} vectors")), "{printed}");
        println!("{}", printed.trim());
    }
}

fn verilator(tops: &[Top]) {
    if !available("verilator") {
        return;
    }
    for &top in tops {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        write_sources(folder, top, CHUNK);
        let (bench, sources) = (format!("{top}_tb"), [format!("{top}_tb.v"), format!("{top}.v")]);
        let options = ["--binary", "--timing", "-O3", "-Wno-fatal", "-Wno-lint", "-o", "simulation"];
        let arguments: Vec<&str> =
            options.into_iter().chain(["--top-module", &bench, &sources[0], &sources[1]]).collect();
        run(folder, "verilator", &arguments).unwrap();
        for seed in 0..VERILATOR_VECTORS / CHUNK {
            write_vectors(folder, top, CHUNK, seed);
            let printed = run(folder, "obj_dir/simulation", &[]).unwrap();
            assert!(printed.contains(&format!("PASS: {top}, {CHUNK} vectors")), "{printed}");
        }
        println!("PASS: {top}, {VERILATOR_VECTORS} vectors in Verilator");
    }
}

#[test]
fn icarus_gives_goldens_outputs() {
    icarus(&SMALL);
}

#[test]
#[ignore = "minutes of Icarus; run by name"]
fn icarus_gives_goldens_outputs_for_large_tops() {
    icarus(&LARGE);
}

#[test]
#[ignore = "minutes of Verilator; run by name"]
fn verilator_gives_goldens_outputs() {
    verilator(&SMALL);
}

#[test]
#[ignore = "an hour of Verilator; run by name"]
fn verilator_gives_goldens_outputs_for_large_tops() {
    verilator(&LARGE);
}

/// The testbench notices one wrong bit of one vector.
#[test]
fn a_wrong_vector_fails() {
    if !available("iverilog") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_sources(folder, Top::IntAdd, 100);
    write_vectors(folder, Top::IntAdd, 100, 1);
    let path = folder.join("int_add_vectors.hex");
    let mut lines: Vec<String> = std::fs::read_to_string(&path).unwrap().lines().map(str::to_owned).collect();
    let last = lines[70].pop().unwrap().to_digit(16).unwrap();
    lines[70].push(char::from_digit(last ^ 1, 16).unwrap());
    std::fs::write(&path, lines.join("\n")).unwrap();
    run(folder, "iverilog", &["-g2005", "-o", "simulation", "int_add_tb.v", "int_add.v"]).unwrap();
    let printed = run(folder, "vvp", &["-n", "simulation"]).unwrap();
    assert!(printed.contains("FAIL: int_add, 1 of 100 vectors differ"), "{printed}");
}
