//! Proofs for all inputs: units and pipelines compute what independently written references say.
//!
//! | what | reference | left out |
//! |---|---|---|
//! | every unit in both 8-bit formats | `exact.v`: integer arithmetic, rounded once; `units.v` | |
//! | every unit in binary32 | `units.v`: behavioural IEEE 754, proved equal to `exact.v` in 8 bits | the multiplier's array, which `product.rs` proves |
//! | each specialisation of adder and multiplier in the pipelines | `units.v` | the same |
//! | both pipelines and their lean forms | `dual_split.v`, `ray_box.v`: the step as documented | adders and multipliers |
//!
//! The proofs regard registers as wires. That suffices because units and pipelines are plain pipelines: all paths
//! from inputs to outputs have equally many registers, and `en_i` enables every register. A test checks both.
//!
//! Tested only, not proved: formats between 8 and 32 bits, flushed subnormals, the routing of the shared block.

mod proof;

use netlist::verilog::text;
use netlist::{Change, Design, Instance, ModuleId, Mutation, Op, inventory, mutate};
use pipelines::catalogue::{StandardFormat, Top};
use proof::{LeftOut, Proof, unit_sides};
use std::collections::BTreeSet;
use testing::long;
use testing::tools::{in_parallel, provers_available};

const UNITS: [Top; 5] = [Top::FpMul, Top::FpAdd, Top::FpMinMax, Top::FpCmp, Top::IntAdd];
const PIPELINES: [Top; 4] = [Top::DualSplit, Top::DualSplitLean, Top::RayBox, Top::RayBoxLean];
const SMALL_FORMATS: [StandardFormat; 2] = [StandardFormat::E5m2, StandardFormat::E4m3];

/// A unit's reference in `units.v` or `exact.v`, by its kind.
fn reference(style: &str, kind: &str, format: StandardFormat) -> String {
    let format = format.format();
    match kind {
        "int_add" => format!("{style}_int_add"),
        _ => format!("{style}_{kind} #({}, {})", format.exponent_bits(), format.significand_bits()),
    }
}

/// A unit of binary32 against `units.v`.
fn binary32_unit(design: &Design) -> Result<(), String> {
    let format = StandardFormat::Binary32;
    let kind = &design.top().kind;
    let left_out = if kind == "fp_mul" { LeftOut::Products } else { LeftOut::Nothing };
    let sides = unit_sides(design, &reference("reference", kind, format));
    Proof { design, format, sides, files: &[], left_out }.run()
}

/// A pipeline without its adders and multipliers.
fn pipeline(top: Top, design: &Design) -> Result<(), String> {
    let files: &[&str] = match top {
        Top::DualSplit | Top::DualSplitLean => &["dual_split.v"],
        _ => &["ray_box.v"],
    };
    let left_out = LeftOut::Arithmetic;
    Proof { design, format: StandardFormat::Binary32, sides: String::new(), files, left_out }.run()
}

/// A module of a design, with all beneath it.
fn part(design: &Design, module: ModuleId) -> Design {
    Design { modules: design.modules[..=module.index()].to_vec() }
}

#[test]
fn units_of_eight_bits_are_exact() {
    if !provers_available() {
        return;
    }
    let all = SMALL_FORMATS.into_iter().flat_map(|format| UNITS[..4].iter().map(move |&top| (top, format)));
    in_parallel(all, |(top, format)| {
        let design = top.design(format).unwrap();
        let style = if matches!(top, Top::FpAdd | Top::FpMul) { "exact" } else { "reference" };
        let sides = unit_sides(&design, &reference(style, top.name(), format));
        let proof = Proof { design: &design, format, sides, files: &["exact.v"], left_out: LeftOut::Nothing };
        proof.run().unwrap_or_else(|error| panic!("{top} {format}: {error}"));
    });
}

/// The proofs about binary32 rest on `units.v`. This proof compares `units.v` itself with exact integers, in eight bits.
#[test]
fn the_references_agree_in_eight_bits() {
    if !long("proofs of the references") || !provers_available() {
        return;
    }
    for format in SMALL_FORMATS {
        for top in [Top::FpAdd, Top::FpMul] {
            let design = top.design(format).unwrap();
            let sides = unit_sides(&design, &reference("reference", top.name(), format));
            let proof =
                Proof { design: &design, format, sides, files: &["exact.v"], left_out: LeftOut::Nothing };
            proof.run().unwrap_or_else(|error| panic!("{top} {format}: {error}"));
        }
    }
}

#[test]
fn units_of_binary32_are_ieee_754() {
    if !long("proofs of binary32") || !provers_available() {
        return;
    }
    in_parallel(UNITS, |top| {
        let result = binary32_unit(&top.design(StandardFormat::Binary32).unwrap());
        result.unwrap_or_else(|error| panic!("{top}: {error}"));
    });
}

/// Elaboration makes an adder that only subtracts, and leaves out the outputs that nothing reads.
#[test]
fn specialised_units_of_binary32_are_ieee_754() {
    if !long("proofs of specialised units") || !provers_available() {
        return;
    }
    let mut seen = BTreeSet::new();
    let mut parts = Vec::new();
    for top in
        [Top::DualSplit, Top::DualSplitLean, Top::RayBox, Top::RayBoxLean, Top::RayBoxX2, Top::SharedUnits]
    {
        let design = top.design(StandardFormat::Binary32).unwrap();
        for (position, module) in design.modules.iter().enumerate() {
            let part = part(&design, ModuleId(position as u32));
            if ["fp_add", "fp_mul"].contains(&&*module.kind) && seen.insert(text(&part)) {
                parts.push((top, part));
            }
        }
    }
    println!("{} specialisations", parts.len());
    assert!(parts.len() >= 4);
    in_parallel(parts, |(top, part)| {
        binary32_unit(&part).unwrap_or_else(|error| panic!("{top}: {}: {error}", part.top().name));
    });
}

#[test]
fn pipelines_make_the_documented_steps() {
    if !long("proofs of the pipelines") || !provers_available() {
        return;
    }
    in_parallel(PIPELINES, |top| {
        let result = pipeline(top, &top.design(StandardFormat::Binary32).unwrap());
        result.unwrap_or_else(|error| panic!("{top}: {error}"));
    });
}

/// The conditions under which the proofs may regard registers as wires.
#[test]
fn units_and_pipelines_are_plain_pipelines() {
    for &format in StandardFormat::ALL {
        let exists = |top: &Top| top.formats().contains(&format);
        for top in UNITS.into_iter().chain(PIPELINES).filter(exists) {
            let design = top.design(format).unwrap();
            assert!(inventory(&design).unwrap().latency_cycles.is_some(), "{top} {format}");
            for module in &design.modules {
                let enable = module.inputs.iter().position(|port| port.name == "en_i");
                let is_enable = |node| enable.is_some_and(|i| module.graph.op(node) == Op::Input(i as u32));
                let is_enabled = |instance: &Instance| {
                    let child = design.module(instance.module);
                    let input = child.inputs.iter().position(|port| port.name == "en_i");
                    input.is_none_or(|input| is_enable(instance.inputs[input]))
                };
                assert!(module.registers.iter().all(|register| register.enable.is_some_and(is_enable)));
                assert!(module.instances.iter().all(is_enabled), "{top} {format}: {}", module.name);
            }
        }
    }
}

#[test]
fn the_proofs_find_faults() {
    if !long("proofs of faulty designs") || !provers_available() {
        return;
    }
    let faults = [
        (Top::FpAdd, "sticky_shift", "sticky", Change::Constant(0)),
        (Top::FpAdd, "rounder", "to_infinity", Change::Constant(1)),
        (Top::FpAdd, "fp_add", "ends_2", Change::Replace("ends_1".to_owned())),
        (Top::FpMul, "fp_mul", "zeros", Change::Increment),
        (Top::FpMul, "fp_mul", "product", Change::Replace("sum".to_owned())),
        (Top::FpMul, "fp_mul", "lost", Change::Constant(0)),
        (Top::FpCmp, "fp_cmp", "any_magnitude", Change::Constant(1)),
        (Top::FpMinMax, "fp_min_max", "chosen", Change::Replace("chosen_2".to_owned())),
        (Top::DualSplit, "dual_split_fold", "near_offset", Change::SwapOperands),
        (Top::DualSplit, "node_header", "offset_o", Change::StuckBit { bit: 25, value: false }),
        (Top::DualSplit, "ray_select", "inv", Change::Replace("inv_entry".to_owned())),
        (Top::RayBox, "ray_box_select", "inv_low$0", Change::SwapOperands),
        (Top::RayBoxLean, "fp_cmp", "le", Change::Replace("less".to_owned())),
    ];
    in_parallel(faults, |(top, module, value, change)| {
        let design = top.design(StandardFormat::Binary32).unwrap();
        let mutation = Mutation { module: module.into(), value: value.into(), change };
        let mutant = mutate(&design, &mutation).unwrap();
        let result = if PIPELINES.contains(&top) { pipeline(top, &mutant) } else { binary32_unit(&mutant) };
        let error = result.expect_err("a mutant is no equivalent");
        assert!(error.contains("Networks are NOT EQUIVALENT"), "{top}: {mutation}: {error}");
    });
}
