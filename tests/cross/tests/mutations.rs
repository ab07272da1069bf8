//! Faults that engineers make, put into the elaborated netlist at run time, and the check that notices each.
//!
//! The check is the one of `equivalence.rs`: the mutant's outputs against golden's claims. A second list has the
//! mutants that no check of outputs can notice, each with the reason; a test keeps that list honest.

use equivalence::{check, testbench};
use netlist::verilog::Form;
use netlist::verilog::testbench::{Start, vectors};
use netlist::{BinaryOp, Change, Mutation, flatten, mutate};
use pipelines::catalogue::{StandardFormat, Top};
use std::fmt::Write;

/// Lengths of the streams that a mutant goes through until one notices it, in cycles.
const STREAMS: [u64; 3] = [400, 4_000, 40_000];

/// Random cycles in an exported testbench where the user asks for no other number.
const EXPORTED_CYCLES: u32 = 1000;

/// Where, what, and the change: module (all its specialisations), value, fault.
type Row = (Top, &'static str, &'static str, Change, &'static str);

fn with(name: &str) -> Change {
    Change::Replace(name.to_owned())
}

fn exchange(name: &str) -> Change {
    Change::Exchange(name.to_owned())
}

/// One row for each fault.
fn faults() -> Vec<Row> {
    use Change::{
        Bypass, Constant, Delay, IgnoreEnable, Increment, Invert, Operator, StuckBit, SwapOperands,
    };
    use Top::*;
    let carry = Change::TakeBits { other: "encoded".to_owned(), low: 23, count: 9 };
    vec![
        // Addition.
        (FpAdd, "sticky_shift", "sticky", Constant(0), "dropped sticky bit in alignment"),
        (FpAdd, "sticky_shift", "value_6", with("value_5"), "alignment never shifts by 16"),
        (FpAdd, "fp_add", "swap", Constant(0), "operands not ordered by exponent"),
        (FpAdd, "fp_add", "distance", with("a_above_b"), "the other difference of the exponents"),
        (FpAdd, "fp_add", "high", SwapOperands, "adds where it should subtract"),
        (FpAdd, "fp_add", "sign_b", Invert, "adds when told to subtract"),
        (FpAdd, "fp_add", "high_sign", SwapOperands, "sign of the smaller operand"),
        (FpAdd, "fp_add", "negative", Constant(0), "negative difference taken for a positive one"),
        (FpAdd, "fp_add", "normal", with("normal_1"), "negative difference not negated"),
        (FpAdd, "fp_add", "difference", with("sum"), "inverted difference not inverted back"),
        (FpAdd, "fp_add", "result_sign", with("result_sign_1"), "wrong sign of an exact zero"),
        (FpAdd, "rounder", "lost_i", Constant(0), "dropped sticky bit in normalisation"),
        // Anticipation of the leading one.
        (FpAdd, "fp_add", "p", with("p_1"), "first operand never aligned for anticipation"),
        (FpAdd, "fp_add", "near", Constant(0), "operands anticipated as if of equal exponents"),
        (
            FpAdd,
            "fp_add",
            "after_plus",
            with("after_minus"),
            "runs of cancelling digits end in the wrong place",
        ),
        (FpAdd, "fp_add", "first", Constant(0), "every digit taken for one in a run"),
        (FpAdd, "fp_add", "ends_3", with("ends_2"), "far operands anticipated as if near"),
        (FpAdd, "fp_add", "ends", with("ends_3"), "sums anticipated as if differences"),
        (FpAdd, "fp_add", "ends_2", with("ends_1"), "normalises below the least exponent"),
        (FpAdd, "leading_zeros", "count", with("count_5"), "last leading zero not counted"),
        (FpAdd, "rounder", "exponent_i", Increment, "exponent of the window off by one"),
        (FpAdd, "fp_add", "nan", Constant(0), "infinity - infinity is infinity"),
        (FpAdd, "fp_add", "infinity", Constant(0), "infinite operands taken for numbers"),
        (FpAdd, "fp_add", "exponent", Increment, "exponent off by one"),
        (FpAdd, "fp_unpack", "exponent", with("encoded_exponent"), "subnormals' exponent taken as 0, not 1"),
        (FpAdd, "fp_unpack", "significand", with("significand_1"), "subnormals given a hidden bit"),
        // Rounding.
        (FpAdd, "rounder", "magnitude_2", carry.clone(), "missed carry into the exponent (sum)"),
        (FpMul, "rounder", "magnitude_2", carry, "missed carry into the exponent (product)"),
        (FpAdd, "rounder", "magnitude_2", with("encoded"), "never rounds up"),
        (FpAdd, "rounder", "inexact", Constant(0), "directed rounding forgets inexact results"),
        (FpAdd, "rounder", "away", Constant(0), "rounds down and up toward zero"),
        (FpMul, "rounder", "to_infinity", Constant(1), "overflow toward zero gives infinity"),
        (FpMul, "rounder", "overflow", Constant(0), "overflow not recognised"),
        (FpMul, "rounder", "exponent_2", with("exponent_i"), "subnormal results encoded as normal ones"),
        (FpAdd, "rounder", "complement_i", Constant(0), "complement not completed to a negation"),
        (FpMul, "rounder", "kept", SwapOperands, "window taken from the other place"),
        (FpMul, "rounder", "sticky", with("lost_i"), "last bit of the window forgotten"),
        (FpMul, "rounder", "nan_i", Constant(0), "NaN result replaced by a number"),
        (FpMul, "rounder", "word_2", with("magnitude"), "sign lost"),
        (FpMul, "rounder", "rounding_i", Constant(0), "rounding direction ignored"),
        // Multiplication.
        (
            FpMul,
            "significand_product",
            "b_i",
            StuckBit { bit: 11, value: false },
            "a row of the lower array missing",
        ),
        (
            FpMul,
            "significand_product",
            "b_i",
            StuckBit { bit: 12, value: false },
            "a row of the upper array missing",
        ),
        (FpMul, "fp_mul", "carry", Constant(0), "the lower product's upper half forgotten"),
        (FpMul, "fp_mul", "product", with("sum"), "the two products not added"),
        (FpMul, "leading_zeros", "count", with("count_5"), "last leading zero not counted"),
        (FpMul, "fp_mul", "subnormal", SwapOperands, "zeros of the normal operand counted"),
        (FpMul, "fp_mul", "tiny", Constant(0), "subnormal products not recognised"),
        (FpMul, "fp_mul", "right", Constant(0), "subnormal products not shifted"),
        (FpMul, "fp_mul", "right_shift", Constant(0), "the shifter to the right never taken"),
        (FpMul, "fp_mul", "below", Increment, "one bit too many taken for lost"),
        (FpMul, "fp_mul", "lost", Constant(0), "dropped sticky bit of the product"),
        (FpMul, "fp_mul", "left_amount", with("zeros"), "normalises below the least exponent"),
        (FpMul, "fp_mul", "zero_factor", Constant(0), "infinity * 0 is infinity"),
        (FpMul, "fp_mul", "sign", Constant(0), "sign of the product always plus"),
        (FpMul, "fp_mul", "top_exponent", Increment, "bias off by one"),
        (FpMul, "fp_mul", "exponent", Increment, "exponent of the window off by one"),
        // Minimum, maximum, comparison, offset.
        (FpMinMax, "fp_min_max", "propagate_nan_i", Invert, "the other NaN mode"),
        (FpMinMax, "fp_min_max", "maximum_i", Invert, "minimum for maximum"),
        (FpMinMax, "fp_min_max", "any_negative", Constant(0), "negative numbers in order of magnitude"),
        (FpMinMax, "fp_min_max", "chosen", with("chosen_2"), "NaN not canonical"),
        (FpMinMax, "fp_min_max", "nan_b", Constant(0), "NaN of the second operand not seen"),
        (FpMinMax, "fp_min_max", "choose_a", Invert, "the other operand"),
        (FpCmp, "fp_cmp", "ordered", Constant(1), "NaN compares"),
        (FpCmp, "fp_cmp", "any_magnitude", Constant(1), "-0 less than +0"),
        (FpCmp, "fp_cmp", "any_negative", Constant(0), "negative numbers in order of magnitude"),
        (FpCmp, "fp_cmp", "le", with("lt"), "<= is <"),
        (FpCmp, "fp_cmp", "below", SwapOperands, "operands swapped"),
        (IntAdd, "int_add", "sum", Increment, "off by one"),
        (IntAdd, "int_add", "sum", StuckBit { bit: 31, value: false }, "31 bits wide"),
        // Latency, valid, tag, enable.
        (IntAdd, "int_add", "sum", Delay, "one cycle late"),
        (FpAdd, "fp_add", "valid_1", Bypass, "valid one cycle early"),
        (FpAdd, "fp_add", "result", Delay, "result one cycle late"),
        (FpAdd, "fp_add", "tag_2", Bypass, "tag one cycle early"),
        (FpMul, "fp_mul", "valid_2", Constant(1), "always valid"),
        (FpMul, "fp_mul", "sum", IgnoreEnable, "product does not stall"),
        (FpMul, "fp_mul", "valid_1", IgnoreEnable, "valid does not stall"),
        (FpMinMax, "fp_min_max", "result", Bypass, "result one cycle early"),
        (FpCmp, "fp_cmp", "tag", Constant(0), "tag lost"),
        // Dual-split pipeline.
        (DualSplit, "dual_split_select", "dual", Constant(0), "dual carve decoded as a split"),
        (DualSplit, "dual_split_select", "min_side$0", Invert, "corner bit of plane 0 inverted"),
        (DualSplit, "dual_split_select", "axis$1", with("axis$0"), "both planes on the first axis"),
        (DualSplit, "dual_split_select", "plane_0", exchange("plane_1"), "planes swapped"),
        (DualSplit, "ray_select", "inv", with("inv_entry"), "role of the reciprocal ignored"),
        (DualSplit, "ray_select", "leaving", Invert, "role of the reciprocal inverted"),
        (DualSplit, "ray_select", "origin_y_i", exchange("origin_z_i"), "origin's y and z swapped"),
        (DualSplit, "node_header", "offset_o", StuckBit { bit: 25, value: false }, "offsets of 25 bits"),
        (DualSplit, "int_add", "b_i", Constant(0), "child size ignored"),
        (DualSplit, "dual_split_fold", "near_offset", SwapOperands, "near and far child swapped"),
        (DualSplit, "dual_split_fold", "far_offset", SwapOperands, "far slot holds the near child"),
        (DualSplit, "dual_split_fold", "route_exit", with("t_0_i"), "plane 0 always taken for the exit"),
        (
            DualSplit,
            "dual_split_fold",
            "latest_entry",
            with("entry_t"),
            "second entry of a dual carve dropped",
        ),
        (
            DualSplit,
            "dual_split_fold",
            "earliest_exit",
            with("exit_t"),
            "second exit of a dual carve dropped",
        ),
        (DualSplit, "dual_split_fold", "near_start", with("t_min_7"), "carve accepted by its exit alone"),
        (
            DualSplit,
            "dual_split_fold",
            "near_t_max",
            with("t_max_8"),
            "near child keeps its parent's interval",
        ),
        (DualSplit, "dual_split_fold", "leaf", Constant(0), "leaf bit ignored"),
        (DualSplit, "dual_split_fold", "t_max_7", Bypass, "interval one cycle early"),
        (DualSplit, "dual_split_fold", "header_i", Constant(0), "every node taken for a split at offset 0"),
        (DualSplit, "delay", "stage$0", Delay, "waiting lines one cycle too long"),
        (DualSplit, "delay", "stage$0", IgnoreEnable, "waiting lines do not stall"),
        (DualSplitLean, "dual_split_select", "negative$1", Constant(0), "direction of the ray ignored"),
        // Ray-box pipeline, its parallel forms and the shared block.
        (RayBox, "ray_box_select", "inv_low$0", SwapOperands, "role of the reciprocal inverted"),
        (RayBox, "ray_box_fold", "t_entry", Bypass, "entry distance one cycle early"),
        (RayBox, "fp_cmp", "ordered", Constant(1), "NaN interval taken for a hit"),
        (RayBoxLean, "fp_cmp", "le", with("less"), "box touched in one point missed"),
        (RayBoxX2, "ray_box_x2", "box_min_x_i$0", exchange("box_min_x_i$1"), "lanes' boxes mixed up"),
        (SharedUnits, "shared_units", "ray_box", exchange("dual_split"), "routing codes mixed up"),
        (SharedUnits, "shared_units", "add_valid$6", Constant(0), "free unit not available"),
        // An operator in place of another.
        (FpMul, "fp_mul", "exponent_sum", Operator(BinaryOp::Sub), "exponents subtracted"),
        (FpMinMax, "fp_min_max", "below", Operator(BinaryOp::SignedLt), "bit patterns compared as signed"),
    ]
}

/// Mutants that behave like the original, and the reasons.
fn equivalent() -> Vec<Row> {
    use Change::{Constant, Operator};
    vec![
        (
            Top::FpAdd,
            "fp_add",
            "swap",
            Operator(BinaryOp::Le),
            "differs for equal exponents only, and then either operand may be the first: the difference may be negative",
        ),
        (
            Top::FpMinMax,
            "fp_min_max",
            "below",
            Operator(BinaryOp::Le),
            "differs for equal words only, and then either operand is the same word",
        ),
        (
            Top::DualSplit,
            "fp_cmp",
            "lt",
            Constant(0),
            "only the role comparators have `lt`; it implies the sign bit, which is or-ed to it: the published \
             comparators are redundant",
        ),
    ]
}

/// The first difference that a stream shows, as cycle and output.
fn noticed(top: Top, module: &str, value: &str, change: &Change) -> Result<Option<(u64, String)>, String> {
    let design = top.design(StandardFormat::Binary32).map_err(|error| error.to_string())?;
    let mutation = Mutation { module: module.into(), value: value.into(), change: change.clone() };
    let mutant = mutate(&design, &mutation).map_err(|error| error.to_string())?;
    let netlist = flatten(&mutant).map_err(|error| error.to_string())?;
    for cycles in STREAMS {
        let outcome = check(&netlist, top, StandardFormat::Binary32, cycles, 1);
        if let Some(first) = outcome.first {
            return Ok(Some((first.cycle, first.output)));
        }
    }
    Ok(None)
}

#[test]
fn every_fault_is_noticed() {
    let faults = faults();
    let mut table =
        format!("{:<16}{:<20}{:<18}{:<56}{:>6}  {}\n", "unit", "module", "value", "fault", "cycle", "output");
    let mut wrong = Vec::new();
    for (top, module, value, change, fault) in &faults {
        let result = noticed(*top, module, value, change);
        let (cycle, output) = match &result {
            Ok(Some((cycle, output))) => (cycle.to_string(), output.as_str()),
            Ok(None) => ("-".to_owned(), "SURVIVES"),
            Err(error) => ("-".to_owned(), error.as_str()),
        };
        let _ = writeln!(table, "{:<16}{module:<20}{value:<18}{fault:<56}{cycle:>6}  {output}", top.name());
        if !matches!(result, Ok(Some(_))) {
            wrong.push(format!("{top}: {module}.{value}, {fault}: {output}"));
        }
    }
    println!("{table}\n{} faults", faults.len());
    assert!(faults.len() >= 40);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether the vectors of a default export tell the mutant's outputs from the original's. The testbench compares every output in
/// every cycle.
fn is_seen_by_the_testbench(top: Top, module: &str, value: &str, change: &Change) -> bool {
    let design = top.design(StandardFormat::Binary32).unwrap();
    let form = Form { reset: true, ..Form::default() };
    let start = Start::of(&design, &form).unwrap();
    let cycles = testbench(top, StandardFormat::Binary32, &flatten(&design).unwrap(), EXPORTED_CYCLES, 0);
    let mutation = Mutation { module: module.into(), value: value.into(), change: change.clone() };
    let mutant = mutate(&design, &mutation).unwrap();
    vectors(&design, &start, cycles.clone()).unwrap() != vectors(&mutant, &start, cycles).unwrap()
}

#[test]
fn the_exported_testbench_sees_every_fault() {
    let unseen: Vec<String> = (faults().iter())
        .filter(|(top, module, value, change, _)| !is_seen_by_the_testbench(*top, module, value, change))
        .map(|(top, module, value, _, fault)| format!("{top}: {module}.{value}, {fault}"))
        .collect();
    assert!(unseen.is_empty(), "{}", unseen.join("\n"));
}

#[test]
fn equivalent_mutants_are_equivalent() {
    for (top, module, value, change, reason) in equivalent() {
        let result = noticed(top, module, value, &change);
        assert_eq!(result, Ok(None), "{top}: {module}.{value}: not true that it {reason}");
    }
}
