//! The floating-point units through every check.

use crate::verilog::check_design;
use hdl::formats::binary32;
use hdl::netlist::{elaborate, guard, inventory};
use hdl::units::IntAdd;
use rust_hdl_core::prelude::Block;

fn check<M: Block + Default>(name: &str) {
    let mut module = M::default();
    module.connect_all();
    let report = guard(&module).unwrap_or_else(|error| panic!("{name}: {error}"));
    println!("{name}: {report:?}");
    let design = elaborate(&module, name).unwrap_or_else(|error| panic!("{name}: {error}"));
    println!("{}", serde_json::to_string_pretty(&inventory(&design).unwrap()).unwrap());
    println!("{}", hdl::verilog::text(&design));
    check_design(&module, &design, &["significand_product"]);
}

#[test]
fn int_add() {
    check::<IntAdd<32, 4>>("int_add");
}

#[test]
fn fp_cmp() {
    check::<binary32::FpCmp>("fp_cmp");
}

#[test]
fn fp_min_max() {
    check::<binary32::FpMinMax>("fp_min_max");
}

#[test]
fn fp_add() {
    check::<binary32::FpAdd>("fp_add");
}

#[test]
fn fp_mul() {
    check::<binary32::FpMul>("fp_mul");
}
