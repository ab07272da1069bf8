//! Faulty units, compiled for the tests: the simulation of a design with one fault must show the fault.
//!
//! Most faults break one row of a shape that `codegen` recognises (see `sim/codegen/src/idioms.rs`).

use netlist::{Change, Design, Mutation, mutate};
use pipelines::catalogue::{StandardFormat, Top};

/// Top, module, value, and the change of the value.
pub fn faults() -> Vec<(Top, &'static str, &'static str, Change)> {
    use Change::{Constant, Increment, Invert, Replace, StuckBit, SwapOperands};
    let with = |other: &str| Replace(other.into());
    vec![
        (Top::FpAdd, "sticky_shift", "value_6", with("value_5")),
        (Top::FpAdd, "sticky_shift", "value_3", Invert),
        (Top::FpAdd, "sticky_shift", "lost_3", with("lost_2")),
        (Top::FpAdd, "sticky_shift", "sticky", Constant(0)),
        (Top::FpAdd, "sticky_shift", "amount_i", StuckBit { bit: 2, value: true }),
        (Top::FpAdd, "fp_add", "ends_3", with("ends_2")),
        (Top::FpAdd, "fp_add", "left", Increment),
        (Top::FpAdd, "fp_add", "normal", SwapOperands),
        (Top::FpMul, "leading_zeros", "count", with("count_5")),
        (Top::FpMul, "leading_zeros", "count_3", Increment),
        (Top::FpMul, "leading_zeros", "any$3_4", with("any$3_3")),
        (Top::FpMul, "leading_zeros", "value_i", StuckBit { bit: 23, value: false }),
    ]
}

/// The unit with a fault.
pub fn design((top, module, value, change): (Top, &str, &str, Change)) -> Design {
    let design = top.design(StandardFormat::Binary32).unwrap_or_else(|error| panic!("{top}: {error}"));
    let mutation = Mutation { module: module.into(), value: value.into(), change };
    mutate(&design, &mutation).unwrap_or_else(|error| panic!("{mutation}: {error}"))
}
