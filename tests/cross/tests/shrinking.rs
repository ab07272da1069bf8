//! Streams of arbitrary inputs that shrink, so that a failure comes down to the one cycle and the bits that matter.

use cross::netlist;
use equivalence::{Model, compare};
use fp::Format;
use fp::operands::patterns;
use netlist::{Change, Flat, Mutation, flatten, mask, mutate};
use pipelines::catalogue::{StandardFormat, Top};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestError, TestRunner};

/// A word that shrinks towards zero.
fn word(width: u32) -> BoxedStrategy<u128> {
    if width < 32 {
        return (0..=mask(width)).boxed();
    }
    let special = proptest::sample::select(patterns(Format::BINARY32)).prop_map(u128::from);
    prop_oneof![0..=mask(width), special].boxed()
}

/// Up to 40 cycles of arbitrary inputs. The shared block's routing stays as it is at power-up.
fn cycles(netlist: &Flat) -> impl Strategy<Value = Vec<Vec<u128>>> + use<> {
    let mode = netlist.input("mode_i");
    let inputs: Vec<BoxedStrategy<u128>> = netlist.inputs.iter().map(|port| word(port.width)).collect();
    proptest::collection::vec(inputs, 1..40).prop_map(move |mut cycles| {
        cycles.iter_mut().for_each(|inputs| mode.into_iter().for_each(|mode| inputs[mode] = 0));
        cycles
    })
}

fn run(top: Top, netlist: &Flat, cases: u32) -> Result<(), TestError<Vec<Vec<u128>>>> {
    let config = Config {
        cases,
        rng_seed: RngSeed::Fixed(7),
        failure_persistence: None,
        max_shrink_iters: 20_000,
        ..Config::default()
    };
    TestRunner::new(config).run(&cycles(netlist), |mut cycles| {
        // Idle cycles bring the last operations out.
        let mut idle = vec![0; netlist.inputs.len()];
        idle[netlist.input("en_i").unwrap()] = 1;
        cycles.extend(std::iter::repeat_n(idle, 10));
        let model = Model::new(top, StandardFormat::Binary32, netlist);
        let outcome = compare(netlist, model, cycles, |_, _| ());
        prop_assert!(outcome.mismatches == 0, "{:?}", outcome.first);
        Ok(())
    })
}

#[test]
fn arbitrary_cycles_equal_golden() {
    for &top in Top::ALL {
        let cases = if matches!(top, Top::RayBoxX4 | Top::RayBoxX8 | Top::SharedUnits) { 10 } else { 60 };
        let result = run(top, &netlist(top), cases);
        assert!(result.is_ok(), "{top}: {result:?}");
    }
}

#[test]
fn a_failure_shrinks_to_a_minimal_vector() {
    let design = Top::FpCmp.design(StandardFormat::Binary32).unwrap();
    let change = Change::Constant(1);
    let mutation = Mutation { module: "fp_cmp".into(), value: "ordered".into(), change };
    let netlist = flatten(&mutate(&design, &mutation).unwrap()).unwrap();
    let Err(TestError::Fail(_, minimal)) = run(Top::FpCmp, &netlist, 200) else {
        panic!("a comparator that orders NaN passes");
    };
    println!("{minimal:x?}");
    assert_eq!(minimal.len(), 1, "one cycle is enough: {minimal:x?}");
    let operands = ["a_i", "b_i"].map(|name| minimal[0][netlist.input(name).unwrap()] as u32);
    let nan = operands.iter().filter(|&&bits| f32::from_bits(bits).is_nan()).count();
    assert_eq!(nan, 1, "one NaN, and a zero: {operands:x?}");
    assert!(operands.contains(&0), "{operands:x?}");
}
