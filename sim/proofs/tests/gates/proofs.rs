//! Proofs about the hardware, and that they fail when it is broken.

use pipelines::catalogue::{StandardFormat, Top};

use gates::prove::{Limits, Verdict, verilog};
use netlist::{mutate, mutations};
use proofs::{Sums, Theorem};
use testing::tools::available;
use testing::{cases, long};

fn prove(top: Top, format: StandardFormat) {
    let start = std::time::Instant::now();
    let proof = Theorem::of(top, format, |_| ()).unwrap().prove(Limits::default(), || ());
    println!("{top} {format}: {proof:?} in {:.2} s", start.elapsed().as_secs_f64());
    assert_eq!(proof.verdict, Verdict::Equal, "{top} {format}");
}

/// All operand pairs, all rounding directions.
#[test]
fn units_of_eight_bits() {
    for format in [StandardFormat::E5m2, StandardFormat::E4m3] {
        for top in [Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp] {
            prove(top, format);
        }
    }
}

#[test]
fn order_in_every_format() {
    for &format in StandardFormat::ALL {
        for top in [Top::FpMinMax, Top::FpCmp] {
            prove(top, format);
        }
    }
}

#[test]
fn control_of_both_pipelines() {
    for top in [Top::DualSplit, Top::DualSplitLean, Top::RayBox, Top::RayBoxLean] {
        prove(top, StandardFormat::Binary32);
    }
}

/// The exported Verilog, read by another elaborator, computes the same as the graph that is simulated: outputs, next states
/// and the operands of the multiplier arrays.
#[test]
fn exported_verilog_is_the_simulated_hardware() {
    if !available("yosys") {
        return;
    }
    let tops = [Top::IntAdd, Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp, Top::DualSplit];
    for top in
        tops.into_iter().filter(|top| *top != Top::DualSplit || long("the pipeline's exported Verilog"))
    {
        let folder = tempfile::tempdir().unwrap();
        let design = top.design(StandardFormat::Binary32).unwrap();
        let miter = verilog::exported(&design, folder.path()).unwrap();
        let start = std::time::Instant::now();
        let proof = miter.prove(Limits::default());
        println!("{top}: {} pairs, {proof:?} in {:.2} s", miter.pairs.len(), start.elapsed().as_secs_f64());
        assert_eq!(proof.verdict, Verdict::Equal, "{top}");
        if top == Top::FpCmp {
            let spoilt = netlist::verilog::text(&design).replace("a_i == b_i", "a_i == ~b_i");
            let miter = verilog::compared(&design, &spoilt, folder.path()).unwrap();
            assert!(matches!(miter.prove(Limits::default()).verdict, Verdict::Differs { .. }));
        }
    }
}

/// Every mutant of the control that simulation can tell from the original is refuted.
#[test]
fn proofs_fail_for_mutants() {
    let original = Top::DualSplit.design(StandardFormat::Binary32).unwrap();
    let control = ["dual_split", "dual_split_ray_select", "dual_split_select", "dual_split_fold"];
    let is_control = |module: &str| control.contains(&module);
    let all: Vec<_> = mutations(&original).into_iter().filter(|m| is_control(&m.module)).collect();
    let mut refuted = 0;
    let mut survivors = Vec::new();
    // A sample that is spread over the modules.
    let sample: Vec<_> = all.iter().step_by(all.len() / cases(12, 4) as usize + 1).collect();
    for &mutation in &sample {
        let theorem = Theorem::of(Top::DualSplit, StandardFormat::Binary32, |design| {
            *design = mutate(design, mutation).unwrap();
        });
        match theorem.map(|theorem| theorem.prove(Limits::default(), || ()).verdict) {
            Ok(Verdict::Differs { .. }) | Err(_) => refuted += 1,
            Ok(_) => survivors.push(format!("{mutation:?}")),
        }
    }
    println!("{refuted} of {} refuted; equal: {survivors:?}", sample.len());
    assert!(refuted * 4 >= sample.len() * 3, "{survivors:?}");
}

/// The adder in every format, all operands and rounding directions; in short the narrow formats.
#[test]
fn adders_by_distance_of_exponents() {
    let is_narrow = |format: StandardFormat| format.format().width() <= 16;
    let is_chosen = |&&format: &&StandardFormat| is_narrow(format) || long(&format!("the adder in {format}"));
    for &format in StandardFormat::ALL.iter().filter(is_chosen) {
        let start = std::time::Instant::now();
        let sums = Sums::new(format, |_| ()).unwrap();
        let proof = sums.prove(Limits::default(), || ());
        println!("{format}: {} cases, {proof:?} in {:.2} s", sums.cases.len(), start.elapsed().as_secs_f64());
        assert_eq!(proof.verdict, Verdict::Equal, "{format}");
    }
}

/// A broken adder is refuted: a sample of faults in the rounder, the shift and the adder itself.
#[test]
fn adder_proofs_fail_for_mutants() {
    let original = Top::FpAdd.design(StandardFormat::Binary16).unwrap();
    let all = mutations(&original);
    let sample: Vec<_> = all.iter().step_by(all.len() / cases(12, 4) as usize + 1).collect();
    for &mutation in &sample {
        let sums = Sums::new(StandardFormat::Binary16, |design| *design = mutate(design, mutation).unwrap());
        match sums.map(|sums| sums.prove(Limits::default(), || ()).verdict) {
            Ok(Verdict::Differs { .. }) | Err(_) => {}
            Ok(verdict) => panic!("{verdict:?}, and the adder is broken: {mutation}"),
        }
    }
}

/// The binary32 adder against exact addition of 278-bit integers, for a sample of the pairs of exponents that is spread
/// over all: another reference than that of all exponents above.
#[test]
fn binary32_adder_for_some_exponents() {
    let start = std::time::Instant::now();
    let mut theorem = Theorem::of(Top::FpAdd, StandardFormat::Binary32, |_| ()).unwrap();
    println!("stated in {:.2} s", start.elapsed().as_secs_f64());
    // Neighbours in exponent, where digits cancel, and pairs from anywhere.
    let near =
        (0..256usize).step_by(cases(23, 115) as usize).flat_map(|a| [a * 256 + a, a * 256 + (a + 1) % 256]);
    let chosen: Vec<usize> = near.chain((0..65_536).step_by(cases(1_637, 16_370) as usize)).collect();
    theorem.cases = chosen.into_iter().map(|case| theorem.cases[case].clone()).collect();
    let cases = theorem.cases.len();
    let proof = theorem.prove(Limits::default(), || ());
    println!("{cases} cases: {proof:?} in {:.2} s", start.elapsed().as_secs_f64());
    assert_eq!(proof.verdict, Verdict::Equal);
}
