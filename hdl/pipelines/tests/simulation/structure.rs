//! rust-hdl's own checks of every module: all inputs connected, no combinational loop, no input written.

use pipelines::formats::{
    DualSplitPipelineLean, RayBoxPipelineLean, RayBoxX2, SharedUnits, binary16, binary32, e4m3,
};
use rust_hdl_core::prelude::*;
use units::{IntAdd, SignificandProduct};

fn check<B: Block>(mut top: B) {
    top.connect_all();
    if let Err(error) = check_all(&top) {
        panic!("{}: {error:?}", std::any::type_name::<B>());
    }
}

#[test]
fn units_pass_the_structural_checks() {
    check(binary32::FpAdd::default());
    check(binary32::FpMul::default());
    check(binary32::FpMinMax::default());
    check(binary32::FpCmp::default());
    check(IntAdd::<32, 1>::default());
    check(SignificandProduct::<24, 48, false>::default());
    check(SignificandProduct::<24, 48, true>::default());
    check(binary16::FpAdd::default());
    check(e4m3::FpMul::default());
}

#[test]
fn pipelines_pass_the_structural_checks() {
    check(binary32::DualSplitPipeline::default());
    check(DualSplitPipelineLean::default());
    check(binary32::RayBoxPipeline::default());
    check(RayBoxPipelineLean::default());
    check(RayBoxX2::default());
    check(SharedUnits::default());
}
