//! The netlist computes what rust-hdl simulates; what is wrong is an error that says where.

use crate::modules::*;
use crate::support::{assert_same, assert_same_after};

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
