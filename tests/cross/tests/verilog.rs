//! The exported Verilog in Icarus and Verilator, with golden's outputs.
//!
//! Icarus runs the exported testbench. Verilator runs a hundred times as many vectors, streamed to a harness in C++: the
//! model's inputs and golden's claims about its outputs, nothing from the netlist.
//!
//! A test whose tool is missing passes with a message, or fails where `CI` is set.

use equivalence::{Model, Stimulus, compare};
use netlist::verilog::testbench::{Start, hex_line, testbench};
use netlist::verilog::{Namespace, port_names, text};
use netlist::{Change, Design, Flat, Mutation, flatten, mutate};
use pipelines::catalogue::{StandardFormat, Top};
use std::fmt::Write as _;
use std::io::{BufWriter, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};
use testing::tools::{available, in_parallel, run};
use testing::{cases, long};

/// Writes source and testbench of `top`.
fn write_sources(folder: &Path, top: Top, capacity: u64) {
    let design = top.design(StandardFormat::Binary32).unwrap();
    std::fs::write(folder.join(format!("{top}.v")), text(&design)).unwrap();
    std::fs::write(folder.join(format!("{top}_tb.v")), testbench(&design, &Start::default(), None, capacity))
        .unwrap();
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

/// Every top, the largest first.
fn tops() -> impl Iterator<Item = Top> {
    Top::ALL.iter().rev().copied()
}

#[test]
fn icarus_gives_goldens_outputs() {
    if !available("iverilog") {
        return;
    }
    let vectors = cases(10_000, 500);
    in_parallel(tops(), |top| {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        write_sources(folder, top, vectors);
        write_vectors(folder, top, vectors, 1);
        let sources = [format!("{top}_tb.v"), format!("{top}.v")];
        run(folder, "iverilog", &["-g2012", "-Wall", "-o", "simulation", &sources[0], &sources[1]]).unwrap();
        let printed = run(folder, "vvp", &["-n", "simulation"]).unwrap();
        assert!(printed.contains(&format!("PASS: {top}, {vectors} vectors")), "{printed}");
        println!("{}", printed.trim());
    });
}

#[test]
fn verilator_gives_goldens_outputs() {
    if !available("verilator") || !available("g++") {
        return;
    }
    let vectors = cases(1_000_000, 10_000);
    let is_chosen =
        |top: &Top| matches!(top, Top::FpAdd | Top::DualSplit) || long(&format!("{top} in Verilator"));
    let runtime = tempfile::tempdir().unwrap();
    compile_runtime(runtime.path());
    in_parallel(tops().filter(is_chosen), |top| {
        let folder = tempfile::tempdir().unwrap();
        let design = top.design(StandardFormat::Binary32).unwrap();
        compile_model(folder.path(), runtime.path(), &design);
        let differing = differing(folder.path(), top, &flatten(&design).unwrap(), vectors);
        assert_eq!(differing, format!("0 of {vectors} vectors differ"), "{top}");
        println!("{top}: {differing}");
    });
}

#[test]
fn verilator_finds_faults() {
    if !available("verilator") || !available("g++") {
        return;
    }
    let runtime = tempfile::tempdir().unwrap();
    compile_runtime(runtime.path());
    for (value, change) in [("tag", Change::Constant(0)), ("ordered", Change::Constant(1))] {
        let folder = tempfile::tempdir().unwrap();
        let design = Top::FpCmp.design(StandardFormat::Binary32).unwrap();
        let mutation = Mutation { module: "fp_cmp".into(), value: value.into(), change };
        compile_model(folder.path(), runtime.path(), &mutate(&design, &mutation).unwrap());
        let differing = differing(folder.path(), Top::FpCmp, &flatten(&design).unwrap(), 10_000);
        assert!(
            differing.ends_with(" of 10000 vectors differ") && !differing.starts_with("0 "),
            "{differing}"
        );
    }
}

/// Compiles the part of Verilator that all models share. It takes as long as most models.
fn compile_runtime(folder: &Path) {
    let printed = run(folder, "verilator", &["--getenv", "VERILATOR_ROOT"]).unwrap();
    let include = format!("{}/include", printed.trim());
    for part in ["verilated", "verilated_threads"] {
        let options = ["-O1", "-std=gnu++17", "-c", "-I.", "-I", &include, "-I"];
        let vltstd = format!("{include}/vltstd");
        let source = format!("{include}/{part}.cpp");
        run(folder, "g++", &[&options[..], &[&vltstd, &source]].concat()).unwrap();
    }
}

/// Makes `folder/simulation` of the design and the harness.
fn compile_model(folder: &Path, runtime: &Path, design: &Design) {
    let top = &design.top().name;
    std::fs::write(folder.join("unit.v"), text(design)).unwrap();
    std::fs::write(folder.join("ports.h"), ports_header(design)).unwrap();
    let options =
        ["--cc", "-O3", "-Wno-fatal", "-Wno-lint", "--prefix", "Vunit", "--Mdir", ".", "--top-module", top];
    run(folder, "verilator", &[&options[..], &["unit.v"]].concat()).unwrap();
    let include =
        run(folder, "verilator", &["--getenv", "VERILATOR_ROOT"]).unwrap().trim().to_owned() + "/include";
    let vltstd = format!("{include}/vltstd");
    let harness = concat!(env!("CARGO_MANIFEST_DIR"), "/verilator/main.cpp");
    let mut arguments = [
        "-O1",
        "-std=gnu++17",
        "-pthread",
        "-I.",
        "-I",
        &include,
        "-I",
        &vltstd,
        harness,
        "-o",
        "simulation",
    ]
    .map(str::to_owned)
    .to_vec();
    let files =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut sources: Vec<String> = files.filter(|name| name.ends_with(".cpp")).collect();
    sources.sort();
    arguments.extend(sources);
    arguments
        .extend(["verilated.o", "verilated_threads.o"].map(|part| runtime.join(part).display().to_string()));
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    run(folder, "g++", &arguments).unwrap();
}

/// What the harness has to know of the ports.
fn ports_header(design: &Design) -> String {
    let top = design.top();
    let names = port_names(top, &mut Namespace::default());
    let widths = top.inputs.iter().chain(top.outputs.iter().map(|(port, _)| port)).map(|port| port.width);
    assert!(widths.max().unwrap() <= 32, "a port is one word of a vector");
    let (inputs, outputs) = (&names.inputs, &names.outputs);
    let mut text = format!(
        "#include \"Vunit.h\"\n#define MODEL Vunit\n#define INPUTS {}\n#define OUTPUTS {}\n",
        inputs.len(),
        outputs.len()
    );
    text.push_str("static inline void write_inputs(MODEL& model, const uint32_t* in) {\n");
    for (i, name) in inputs.iter().enumerate() {
        let _ = writeln!(text, "    model.{name} = in[{i}];");
    }
    text.push_str("}\nstatic inline void read_outputs(MODEL& model, uint32_t* out) {\n");
    for (i, name) in outputs.iter().enumerate() {
        let _ = writeln!(text, "    out[{i}] = model.{name};");
    }
    text.push_str("}\n");
    text
}

/// Streams vectors to `folder/simulation` and returns the last line that it prints.
fn differing(folder: &Path, top: Top, netlist: &Flat, vectors: u64) -> String {
    let mut child =
        Command::new(folder.join("simulation")).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut pipe = BufWriter::with_capacity(1 << 20, child.stdin.take().unwrap());
    let format = StandardFormat::Binary32;
    let mut model = Model::new(top, format, netlist);
    let outputs = netlist.outputs.len();
    for inputs in Stimulus::new(top, format, netlist, 1).take(vectors as usize) {
        let mut expected = vec![0u32; outputs + outputs.div_ceil(32)];
        for (claim, _) in model.due() {
            expected[claim.output] = claim.value as u32;
            expected[outputs + claim.output / 32] |= 1 << (claim.output % 32);
        }
        for word in inputs.iter().map(|&value| value as u32).chain(expected) {
            pipe.write_all(&word.to_le_bytes()).unwrap();
        }
        model.clock(&inputs, |_| ());
    }
    drop(pipe.into_inner().unwrap());
    let output = child.wait_with_output().unwrap();
    let printed = String::from_utf8(output.stdout).unwrap();
    printed.lines().last().unwrap_or_default().to_owned()
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
    run(folder, "iverilog", &["-g2012", "-o", "simulation", "int_add_tb.v", "int_add.v"]).unwrap();
    let printed = run(folder, "vvp", &["-n", "simulation"]).expect_err("the exit code says it");
    assert!(printed.contains("FAIL: int_add, 1 of 100 vectors differ"), "{printed}");
}
