//! The Verilog means what the netlist means: linted, simulated, synthesised, proved equal to rust-hdl's.

use crate::modules::*;
use crate::support::{Driven, stimulus};
use crate::tools::{available, run};
use hdl::netlist::{Design, elaborate};
use hdl::verilog::{PackageOptions, cross_check, package, text};
use rust_hdl_core::prelude::Block;
use std::path::Path;

const VECTORS: u64 = 2000;

fn write_package(design: &Design, vectors: u64, folder: &Path) {
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
    check_design(&module, &design, &[]);
}

/// Lint, simulation, synthesis and equivalence of a design, its module beside it.
pub fn check_design(module: &impl Block, design: &Design, black_boxes: &[&str]) {
    let name = design.top().name.as_str();
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_package(design, VECTORS, folder);
    let source = format!("{name}.v");
    if available("verilator") {
        let lint = run(folder, "verilator", &["--lint-only", "-Wall", "--top-module", name, &source]);
        assert_eq!(lint.as_deref(), Ok(""), "{}", text(design));
    }
    if available("iverilog") {
        let bench = format!("{name}_tb.v");
        run(folder, "iverilog", &["-g2005", "-Wall", "-o", "simulation", &bench, &source]).unwrap();
        let printed = run(folder, "vvp", &["-n", "simulation"]).unwrap();
        assert!(printed.contains(&format!("PASS: {name}, {VECTORS} vectors")), "{printed}\n{}", text(design));
    }
    if available("yosys") {
        run(folder, "yosys", &["-q", "-s", &format!("{name}.ys")]).unwrap();
        std::fs::write(folder.join("reference.v"), cross_check::reference_verilog(module, name)).unwrap();
        let script = cross_check::equivalence_script(design, &source, "reference.v", black_boxes);
        std::fs::write(folder.join("equivalence.ys"), script).unwrap();
        run(folder, "yosys", &["-q", "-s", "equivalence.ys"])
            .unwrap_or_else(|error| panic!("{name}: {error}"));
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
