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
    (clk_i),
    [en_i, valid_i, tag_i, a_i, b_i, subtract_i, rounding_i],
    [valid_o, tag_o, result_o]
);
driven!(binary32::FpMul, (clk_i), [en_i, valid_i, tag_i, a_i, b_i, rounding_i], [valid_o, tag_o, result_o]);
driven!(
    binary32::FpMinMax,
    (clk_i),
    [en_i, valid_i, tag_i, a_i, b_i, maximum_i, propagate_nan_i],
    [valid_o, tag_o, result_o]
);
driven!(binary32::FpCmp, (clk_i), [en_i, valid_i, tag_i, a_i, b_i], [valid_o, tag_o, lt_o, le_o, eq_o]);
driven!(
    binary32::DualSplitPipeline,
    (clk_i),
    [
        en_i,
        valid_i,
        tag_i,
        header_i,
        plane_0_i,
        plane_1_i,
        origin_x_i,
        origin_y_i,
        origin_z_i,
        inv_entry_x_i,
        inv_entry_y_i,
        inv_entry_z_i,
        inv_exit_x_i,
        inv_exit_y_i,
        inv_exit_z_i,
        t_min_i,
        t_max_i,
    ],
    [
        valid_o,
        tag_o,
        code_o,
        near_offset_o,
        near_t_min_o,
        near_t_max_o,
        far_offset_o,
        far_t_min_o,
        far_t_max_o,
    ]
);
simulates_alike! {
    fp_add: binary32::FpAdd;
    fp_mul: binary32::FpMul;
    fp_min_max: binary32::FpMinMax;
    fp_cmp: binary32::FpCmp;
    dual_split: binary32::DualSplitPipeline;
}
