//! The elaborated netlist of every top equals golden: streams of thousands of operations with stalls and bubbles.
//!
//! A failure names the seed; `dualsplit check --unit U --seed S` finds it again.

use ::netlist::{Change, Mutation, flatten, mutate};
use cross::{netlist, netlist_in};
use equivalence::{Outcome, check};
use pipelines::catalogue::{StandardFormat, Top};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};

/// Classes that a stream of some thousand operations has to meet.
const UNIT_CLASSES: [&str; 9] = [
    "bubble",
    "stall",
    "NaN operand",
    "infinite operand",
    "subnormal operand",
    "-0 operand",
    "equal magnitudes",
    "infinity and zero",
    "two infinities",
];
const ROUNDED_CLASSES: [&str; 5] =
    ["zero result", "subnormal result", "normal result", "infinite result", "NaN result"];
const RAY_CLASSES: [&str; 10] = [
    "bubble",
    "stall",
    "NaN operand",
    "infinite operand",
    "subnormal operand",
    "-0 operand",
    "parallel axis",
    "plane at the origin",
    "empty interval",
    "interval of one point",
];
const NODE_CLASSES: [&str; 10] = [
    "split: miss",
    "split: one child",
    "split: two children",
    "bare leaf",
    "single carve: miss",
    "single carve: child",
    "single carve: leaf",
    "dual carve: miss",
    "dual carve: child",
    "dual carve: leaf",
];
const BOX_CLASSES: [&str; 2] = ["box hit", "box missed"];

fn required(top: Top) -> Vec<&'static str> {
    match top {
        Top::IntAdd => vec!["bubble", "stall", "carry out", "no carry out"],
        Top::FpAdd | Top::FpMul => [&UNIT_CLASSES[..], &ROUNDED_CLASSES].concat(),
        Top::FpMinMax | Top::FpCmp => UNIT_CLASSES.to_vec(),
        Top::DualSplit | Top::DualSplitLean => [&RAY_CLASSES[..], &NODE_CLASSES].concat(),
        Top::SharedUnits => [&RAY_CLASSES[..], &NODE_CLASSES, &BOX_CLASSES, &ROUNDED_CLASSES].concat(),
        _ => [&RAY_CLASSES[..], &BOX_CLASSES].concat(),
    }
}

/// Cycles of each stream: the larger the netlist, the fewer.
fn cycles(top: Top) -> u64 {
    match top {
        Top::IntAdd | Top::FpAdd | Top::FpMul | Top::FpMinMax | Top::FpCmp => 20_000,
        Top::DualSplit | Top::DualSplitLean | Top::RayBox | Top::RayBoxLean => 6_000,
        Top::RayBoxX2 | Top::RayBoxX4 | Top::RayBoxX8 => 2_000,
        Top::SharedUnits => 5_000,
    }
}

/// Streams of seeds that proptest draws.
fn streams(top: Top, format: StandardFormat, cycles: u64, seeds: u32) -> Outcome {
    let netlist = netlist_in(top, format);
    let total = std::cell::RefCell::new(Outcome::default());
    let config =
        Config { cases: seeds, rng_seed: RngSeed::Fixed(3), failure_persistence: None, ..Config::default() };
    let result = TestRunner::new(config).run(&any::<u64>().no_shrink(), |seed| {
        let outcome = check(&netlist, top, format, cycles, seed);
        prop_assert!(
            outcome.mismatches == 0,
            "{}",
            outcome.first.map(|first| first.to_string()).unwrap_or_default()
        );
        let mut total = total.borrow_mut();
        total.vectors += outcome.vectors;
        for (class, count) in outcome.classes {
            *total.classes.entry(class).or_default() += count;
        }
        Ok(())
    });
    result.unwrap_or_else(|error| panic!("{top} {format}, --vectors {cycles} --seed as given: {error}"));
    total.into_inner()
}

fn holds(top: Top) {
    let total = streams(top, StandardFormat::Binary32, cycles(top), 3);
    println!("{top}: {} vectors, {:?}", total.vectors, total.classes);
    for class in required(top) {
        let count = total.classes.get(class).copied().unwrap_or(0);
        assert!(count >= 20, "{top}: only {count} cycles of class `{class}`");
    }
}

macro_rules! every_top {
    ($($name:ident: $top:ident;)*) => {
        $(#[test] fn $name() { holds(Top::$top); })*

        #[test]
        fn no_top_is_left_out() {
            assert_eq!(Top::ALL, [$(Top::$top),*]);
        }
    };
}

every_top! {
    int_add_equals_golden: IntAdd;
    fp_add_equals_golden: FpAdd;
    fp_mul_equals_golden: FpMul;
    fp_min_max_equals_golden: FpMinMax;
    fp_cmp_equals_golden: FpCmp;
    dual_split_equals_golden: DualSplit;
    lean_dual_split_equals_golden: DualSplitLean;
    ray_box_equals_golden: RayBox;
    lean_ray_box_equals_golden: RayBoxLean;
    two_ray_boxes_equal_golden: RayBoxX2;
    four_ray_boxes_equal_golden: RayBoxX4;
    eight_ray_boxes_equal_golden: RayBoxX8;
    shared_units_equal_golden: SharedUnits;
}

#[test]
fn units_of_every_format_equal_golden() {
    for &format in StandardFormat::ALL {
        for top in [Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp] {
            streams(top, format, 5_000, 2);
        }
    }
}

#[test]
fn a_seed_names_its_stream() {
    let netlist = netlist(Top::FpAdd);
    let run = |seed| check(&netlist, Top::FpAdd, StandardFormat::Binary32, 500, seed);
    assert_eq!(run(1), run(1));
    assert_ne!(run(1).classes, run(2).classes);
}

/// A tag of any width comes back with its operation.
#[test]
fn wide_tags_come_back() {
    for (&top, bits) in Top::ALL.iter().flat_map(|top| [(top, 2), (top, 33)]) {
        let design = top.design_with_tag(StandardFormat::Binary32, bits).unwrap();
        let netlist = flatten(&design).unwrap();
        let tags = netlist.outputs.iter().filter(|(port, _)| port.name.contains("tag_o"));
        assert!(tags.clone().count() > 0 && tags.clone().all(|(port, _)| port.width == bits), "{top}");
        let outcome = check(&netlist, top, StandardFormat::Binary32, 300, 1);
        assert_eq!(outcome.mismatches, 0, "{top}, {bits} bits: {:?}", outcome.first);
    }
    // A bit that is lost on the way is noticed.
    let design = Top::DualSplit.design_with_tag(StandardFormat::Binary32, 33).unwrap();
    let change = Change::StuckBit { bit: 32, value: false };
    let mutation = Mutation { module: "dual_split".into(), value: "tag_o".into(), change };
    let netlist = flatten(&mutate(&design, &mutation).unwrap()).unwrap();
    assert!(check(&netlist, Top::DualSplit, StandardFormat::Binary32, 300, 1).mismatches > 0);
}
