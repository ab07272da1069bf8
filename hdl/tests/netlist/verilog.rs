//! The Verilog means what the netlist means: linted, simulated, synthesised, proved equal to rust-hdl's.

use crate::modules::*;
use crate::support::{Driven, stimulus};
use crate::tools::{available, run};
use hdl::netlist::{Change, Design, Mutation, elaborate, mutate};
use hdl::verilog::{PackageOptions, cross_check, package};
use rust_hdl_core::prelude::Block;
use std::path::Path;

const VECTORS: u64 = 2000;

pub fn write_package(design: &Design, vectors: u64, folder: &Path) {
    let inputs = &design.top().inputs;
    let stimulus: Vec<Vec<u128>> = (0..vectors)
        .map(|cycle| inputs.iter().enumerate().map(|(i, port)| stimulus(cycle, i, port.width)).collect())
        .collect();
    let options = PackageOptions { description: "", period_ns: 1.0 };
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
        let bench = format!("{name}_tb.v");
        run(folder, "iverilog", &["-g2005", "-Wall", "-o", "simulation", &bench, &source]).unwrap();
        let printed = run(folder, "vvp", &["-n", "simulation"]).unwrap();
        assert!(printed.contains(&format!("PASS: {name}, {vectors} vectors")), "{printed}");
    }
}

/// The package's yosys script runs through, with its checks.
pub fn synthesise(design: &Design) {
    if available("yosys") {
        let folder = tempfile::tempdir().unwrap();
        write_package(design, 1, folder.path());
        run(folder.path(), "yosys", &["-q", "-s", &format!("{}.ys", design.top().name)]).unwrap();
    }
}

/// yosys proves our Verilog equivalent to rust-hdl's.
pub fn prove_equivalent(module: &dyn Block, design: &Design, black_boxes: &[&str]) {
    if available("yosys") {
        let result = equivalence(&hdl::verilog::text(design), module, design, black_boxes);
        result.unwrap_or_else(|error| panic!("{}: {error}", design.top().name));
    }
}

fn equivalence(ours: &str, module: &dyn Block, design: &Design, boxes: &[&str]) -> Result<String, String> {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("ours.v", ours);
    write("reference.v", &cross_check::reference_verilog(module, &design.top().name));
    write("equivalence.ys", &cross_check::equivalence_script(design, "ours.v", "reference.v", boxes));
    run(folder.path(), "yosys", &["-q", "-s", "equivalence.ys"])
}

/// A proof that cannot fail proves nothing: a fault in our Verilog is found.
#[test]
fn the_proof_finds_faults() {
    if !available("yosys") {
        return;
    }
    let (module, design) = elaborated::<AddSub>("add_sub");
    for change in [Change::Increment, Change::StuckBit { bit: 9, value: false }] {
        let mutation = Mutation { module: "add_sub".into(), value: "operand".into(), change };
        let mutant = mutate(&design, &mutation).unwrap();
        let result = equivalence(&hdl::verilog::text(&mutant), &module, &design, &[]);
        let error = result.expect_err("a mutant is no equivalent");
        assert!(error.contains("unproven $equiv"), "{error}");
    }
}

/// A testbench that cannot fail tests nothing: a fault in our Verilog is found.
#[test]
fn the_testbench_finds_faults() {
    if !available("iverilog") {
        return;
    }
    let (_, design) = elaborated::<AddSub>("add_sub");
    let folder = tempfile::tempdir().unwrap();
    write_package(&design, VECTORS, folder.path());
    let mutation = Mutation { module: "add_sub".into(), value: "r_tag".into(), change: Change::Delay };
    let mutant = mutate(&design, &mutation).unwrap();
    std::fs::write(folder.path().join("add_sub.v"), hdl::verilog::text(&mutant)).unwrap();
    run(folder.path(), "iverilog", &["-g2005", "-o", "simulation", "add_sub_tb.v", "add_sub.v"]).unwrap();
    let printed = run(folder.path(), "vvp", &["-n", "simulation"]).unwrap();
    assert!(printed.contains("FAIL: add_sub, "), "{printed}");
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
