//! The Verilog means what the netlist means: linted, simulated, synthesised, proved equal to rust-hdl's.

use crate::modules::*;
use crate::support::{Driven, stimulus};
use netlist::verilog::{Form, PackageOptions, cross_check, package};
use netlist::{Change, Design, Mutation, elaborate, mutate};
use rust_hdl_core::prelude::Block;
use std::path::Path;
use testing::tools::{available, prove, provers_available, run};

const VECTORS: u64 = 2000;

pub fn write_package(design: &Design, vectors: u64, folder: &Path) {
    let inputs = &design.top().inputs;
    let stimulus: Vec<Vec<u128>> = (0..vectors)
        .map(|cycle| inputs.iter().enumerate().map(|(i, port)| stimulus(cycle, i, port.width)).collect())
        .collect();
    let form = Form { reset: true, ..Form::default() };
    let options = PackageOptions { form, ..PackageOptions::default() };
    for file in package(design, &options, &stimulus).unwrap() {
        std::fs::write(folder.join(file.name), file.contents).unwrap();
    }
}

fn elaborated<M: Block + Default>(name: &str) -> (M, Design) {
    let mut module = M::default();
    module.connect_all();
    let design = elaborate(&module, name).unwrap_or_else(|error| panic!("{error}"));
    (module, design)
}

/// Lint, simulation, synthesis and equivalence of one module.
fn check_with_tools<M: Driven>(name: &str) {
    let (module, design) = elaborated::<M>(name);
    lint_and_simulate(&design, VECTORS);
    synthesise(&design);
    prove_equivalent(&module, &design, &[]);
}

/// No warning from Verilator, and the testbench passes in Icarus.
pub fn lint_and_simulate(design: &Design, vectors: u64) {
    let name = design.top().name.as_str();
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_package(design, vectors, folder);
    let source = format!("{name}.v");
    if available("verilator") {
        let lint = run(folder, "verilator", &["--lint-only", "-Wall", "--top-module", name, &source]);
        assert_eq!(lint.as_deref(), Ok(""), "{name}");
    }
    if available("iverilog") {
        let mut sources = vec![format!("{name}_tb.v"), source];
        // Where there is a checker, the testbench has an instance of it.
        sources.extend(Some(format!("{name}_checker.sv")).filter(|checker| folder.join(checker).exists()));
        let sources: Vec<&str> = sources.iter().map(String::as_str).collect();
        run(folder, "iverilog", &[&["-g2012", "-Wall", "-o", "simulation"], &sources[..]].concat()).unwrap();
        let printed = run(folder, "vvp", &["-n", "simulation"]).unwrap();
        assert!(printed.contains(&format!("PASS: {name}, {vectors} vectors")), "{printed}");
    }
}

/// The package's yosys script runs through, with its checks; returns its statistics.
pub fn synthesise(design: &Design) -> Option<String> {
    if !available("yosys") {
        return None;
    }
    let folder = tempfile::tempdir().unwrap();
    let name = &design.top().name;
    write_package(design, 1, folder.path());
    run(folder.path(), "yosys", &["-q", "-s", &format!("{name}.ys")]).unwrap();
    Some(std::fs::read_to_string(folder.path().join(format!("{name}_cells.txt"))).unwrap())
}

/// yosys and ABC prove our Verilog equivalent to rust-hdl's.
pub fn prove_equivalent(module: &dyn Block, design: &Design, black_boxes: &[&str]) {
    if provers_available() {
        let result = equivalence(&netlist::verilog::text(design), module, design, black_boxes);
        result.unwrap_or_else(|error| panic!("{}: {error}", design.top().name));
    }
}

fn equivalence(ours: &str, module: &dyn Block, design: &Design, boxes: &[&str]) -> Result<(), String> {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("ours.v", ours);
    write("multiply.v", cross_check::MULTIPLICATION);
    write("reference.v", &cross_check::reference_verilog(module, &design.top().name));
    let script = cross_check::equivalence_script(module, design, "ours.v", "reference.v", boxes);
    write("equivalence.ys", &script);
    let is_sequential = design.modules.iter().any(|module| !module.registers.is_empty());
    prove(folder.path(), "equivalence.ys", if is_sequential { "dsec" } else { "cec" })
}

/// A proof that cannot fail proves nothing: a fault in our Verilog is found.
#[test]
fn the_proof_finds_faults() {
    if !provers_available() {
        return;
    }
    let (module, design) = elaborated::<AddSub>("add_sub");
    let changes = [
        ("operand", Change::Increment),
        ("operand", Change::StuckBit { bit: 9, value: false }),
        ("r_tag", Change::Delay),
        ("r_tag", Change::Bypass),
    ];
    for (value, change) in changes {
        let mutation = Mutation { module: "add_sub".into(), value: value.into(), change };
        let mutant = mutate(&design, &mutation).unwrap();
        let result = equivalence(&netlist::verilog::text(&mutant), &module, &design, &[]);
        let error = result.expect_err("a mutant is no equivalent");
        assert!(error.contains("Networks are NOT EQUIVALENT"), "{error}");
    }
}

/// A testbench that cannot fail tests nothing: a fault in our Verilog is found, by either simulator, as are vectors
/// that end too early, and the simulator's exit code says so.
#[test]
fn the_testbench_finds_faults() {
    let (_, design) = elaborated::<AddSub>("add_sub");
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_package(&design, VECTORS, folder);
    let source = folder.join("add_sub.v");
    let mutation = Mutation { module: "add_sub".into(), value: "r_tag".into(), change: Change::Delay };
    let mutant = mutate(&design, &mutation).unwrap();
    let simulate: [(&str, &[&str], &str, &[&str]); 2] = [
        ("iverilog", &["-g2012", "-o", "simulation"], "vvp", &["-n", "simulation"]),
        (
            "verilator",
            &["--binary", "--timing", "-Wno-lint", "--top-module", "add_sub_tb"],
            "obj_dir/Vadd_sub_tb",
            &[],
        ),
    ];
    for (compiler, options, simulator, arguments) in simulate {
        if !available(compiler) {
            continue;
        }
        for (design, expected) in [(&design, "PASS: add_sub, 2000"), (&mutant, "FAIL: add_sub, ")] {
            std::fs::write(&source, netlist::verilog::text(design)).unwrap();
            let options = [options, &["add_sub_tb.v", "add_sub.v"]].concat();
            run(folder, compiler, &options).unwrap();
            let ended = run(folder, simulator, arguments);
            assert_eq!(ended.is_ok(), expected.starts_with("PASS"), "{compiler}: {ended:?}");
            let printed = ended.unwrap_or_else(|printed| printed);
            assert!(printed.contains(expected), "{compiler}: {printed}");
            if compiler == "iverilog" {
                let longer = [arguments, &["+count=2001"]].concat();
                let printed = run(folder, simulator, &longer).expect_err("a vector is missing");
                assert!(!printed.contains("PASS"), "{printed}");
            }
        }
    }
}

#[test]
fn operators() {
    check_with_tools::<Operators>("operators");
}

#[test]
fn machine() {
    check_with_tools::<Machine>("machine");
}

#[test]
fn add_sub() {
    check_with_tools::<AddSub>("add_sub");
}

#[test]
fn tree() {
    check_with_tools::<Tree>("tree");
}

#[test]
fn fields() {
    check_with_tools::<Fields>("fields");
}

#[test]
fn signed_ops() {
    check_with_tools::<SignedOps>("signed_ops");
}
