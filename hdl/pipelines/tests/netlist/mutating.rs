//! Mutations change what they name, and a comparison of outputs notices each.

use crate::modules::*;
use crate::support::stimulus;
use netlist::{Change, Design, Evaluator, Mutation, MutationError, elaborate, flatten, mutate, mutations};
use rust_hdl_core::prelude::*;

/// The first cycle in which two designs of the same ports differ.
fn first_difference(left: &Design, right: &Design, cycles: u64) -> Option<u64> {
    let (left, right) = (flatten(left).ok()?, flatten(right).ok()?);
    let (mut a, mut b) = (Evaluator::new(&left), Evaluator::new(&right));
    (0..cycles).find(|&cycle| {
        let inputs: Vec<u128> =
            left.inputs.iter().enumerate().map(|(i, port)| stimulus(cycle, i, port.width)).collect();
        a.cycle(&inputs) != b.cycle(&inputs)
    })
}

fn design<M: Block + Default>(name: &str) -> Design {
    elaborate(&M::default(), name).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn every_standard_mutation_is_noticed() {
    let designs = [design::<AddSub>("add_sub"), design::<Tree>("tree"), design::<Machine>("machine")];
    let mut total = 0;
    for design in designs {
        for mutation in mutations(&design) {
            let mutant = mutate(&design, &mutation).unwrap();
            total += 1;
            assert!(first_difference(&design, &mutant, 3000).is_some(), "{mutation} survives");
        }
    }
    assert!(total > 60, "{total} mutations");
}

#[test]
fn chosen_mutations_do_what_they_say() {
    let original = design::<AddSub>("add_sub");
    let with = |value: &str, change| Mutation { module: "add_sub".into(), value: value.into(), change };
    // Cycle in which a change first shows: at once behind the register, one cycle later before it.
    let cases = [
        (with("result", Change::Bypass), Some(0)),
        (with("r_sum", Change::Bypass), Some(0)),
        (with("r_sum", Change::Delay), Some(1)),
        (with("r_tag", Change::Constant(3)), Some(0)),
        (with("sum", Change::SwapOperands), Some(1)),
        (with("operand", Change::Exchange("sum_1".into())), Some(1)),
        (with("operand", Change::Replace("sum_1".into())), None),
        (with("zero", Change::Operator(netlist::BinaryOp::Ne)), Some(0)),
    ];
    for (mutation, expected) in cases {
        let mutant = mutate(&original, &mutation).unwrap_or_else(|error| panic!("{error}"));
        let found = first_difference(&original, &mutant, 2000);
        match expected {
            Some(cycle) => assert!(found.is_some_and(|found| found >= cycle), "{mutation}: {found:?}"),
            None => assert!(found.is_some(), "{mutation}: {found:?}"),
        }
    }
    assert_eq!(first_difference(&original, &original, 2000), None);
}

#[test]
fn impossible_mutations_are_errors() {
    let design = design::<AddSub>("add_sub");
    let with = |value: &str, change| {
        mutate(&design, &Mutation { module: "add_sub".into(), value: value.into(), change })
    };
    assert!(matches!(with("nothing", Change::Invert), Err(MutationError::NotFound { .. })));
    assert!(matches!(with("sum", Change::Bypass), Err(MutationError::NotApplicable(_))));
    assert!(matches!(
        with("sum", Change::StuckBit { bit: 10, value: true }),
        Err(MutationError::NotApplicable(_))
    ));
    assert!(matches!(with("sum_1", Change::Replace("sum".into())), Err(MutationError::Loop(_))));
    assert!(matches!(with("r_sum", Change::Replace("r_tag".into())), Err(MutationError::NotApplicable(_))));
}
