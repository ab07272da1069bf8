//! The netlist computes what rust-hdl simulates; what is wrong is an error that says where.

use crate::modules::*;
use crate::support::assert_same;
use hdl::netlist::elaborate;

const CYCLES: u64 = 3000;

#[test]
fn every_language_feature_simulates_alike() {
    assert_same::<Operators>("operators", CYCLES);
    assert_same::<Machine>("machine", CYCLES);
    assert_same::<AddSub>("add_sub", CYCLES);
    assert_same::<Tree>("tree", CYCLES);
    assert_same::<SignedOps>("signed_ops", CYCLES);
    assert_same::<Fields>("fields", CYCLES);
}
