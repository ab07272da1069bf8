//! The netlist computes what rust-hdl simulates; what is wrong is an error that says where.

use crate::modules::*;
use crate::support::{assert_same, assert_same_after, driven};
use pipelines::formats::binary32;
use rust_hdl_core::prelude::*;

const CYCLES: u64 = 3000;

macro_rules! simulates_alike {
    ($($name:ident: $module:ty;)*) => { $(
        #[test]
        fn $name() {
            assert_same::<$module>(stringify!($name), CYCLES);
        }
    )* };
}
simulates_alike! {
    operators: Operators;
    machine: Machine;
    add_sub: AddSub;
    tree: Tree;
    fields: Fields;
}

/// rust-hdl's `signed_bit_cast` recurses for ever on the most negative value, so that is left out.
#[test]
fn signed_operations() {
    assert_same_after::<SignedOps>("signed_operations", CYCLES, |inputs| {
        for value in inputs.iter_mut().filter(|value| **value == 0x80) {
            *value = 0x81;
        }
    });
}

driven!(
    binary32::FpAdd,
    (clocking.clk_i),
    [clocking.en_i, valid_i, tag_i, a_i, b_i, subtract_i, rounding_i],
    [valid_o, tag_o, result_o]
);
driven!(
    binary32::FpMul,
    (clocking.clk_i),
    [clocking.en_i, valid_i, tag_i, a_i, b_i, rounding_i],
    [valid_o, tag_o, result_o]
);
driven!(
    binary32::FpMinMax,
    (clocking.clk_i),
    [clocking.en_i, valid_i, tag_i, a_i, b_i, maximum_i, propagate_nan_i],
    [valid_o, tag_o, result_o]
);
driven!(
    binary32::FpCmp,
    (clocking.clk_i),
    [clocking.en_i, valid_i, tag_i, a_i, b_i],
    [valid_o, tag_o, lt_o, le_o, eq_o]
);
driven!(
    binary32::DualSplitPipeline,
    (clocking.clk_i),
    [
        clocking.en_i,
        valid_i,
        tag_i,
        node.header_i,
        node.plane_0_i,
        node.plane_1_i,
        ray.origin.origin_x_i,
        ray.origin.origin_y_i,
        ray.origin.origin_z_i,
        ray.reciprocals.inv_entry_x_i,
        ray.reciprocals.inv_entry_y_i,
        ray.reciprocals.inv_entry_z_i,
        ray.reciprocals.inv_exit_x_i,
        ray.reciprocals.inv_exit_y_i,
        ray.reciprocals.inv_exit_z_i,
        ray.interval.t_min_i,
        ray.interval.t_max_i,
    ],
    [
        valid_o,
        tag_o,
        step.code_o,
        step.near_offset_o,
        step.near_t_min_o,
        step.near_t_max_o,
        step.far_offset_o,
        step.far_t_min_o,
        step.far_t_max_o,
    ]
);
simulates_alike! {
    fp_add: binary32::FpAdd;
    fp_mul: binary32::FpMul;
    fp_min_max: binary32::FpMinMax;
    fp_cmp: binary32::FpCmp;
    dual_split: binary32::DualSplitPipeline;
}
