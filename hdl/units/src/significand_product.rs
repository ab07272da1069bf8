//! The multiplier arrays: the product of a significand with one half of another.
//!
//! With `b = b_upper * 2^H + b_lower` and `H` half the bits, rounded up, `a * b = a b_upper * 2^H + a b_lower`. Either array has half
//! the rows of a whole one, which is what fits in a cycle; whoever uses the two adds their products in the next.
//!
//! A leaf module of its own, so that a proof can treat it as a black box and synthesis can choose its multiplier. `rust-hdl`
//! multiplies 16 by 16 bits only, so that this module has its kernel written twice: for simulation, and as the syntax tree
//! that other kernels get from the macro.

use crate::widths::derived_width;
use netlist::module::named;
use rust_hdl_core::ast::{VerilogExpression, VerilogLiteral, VerilogOp, VerilogStatement};
use rust_hdl_core::prelude::*;

/// `product = a * b_lower`, or with `UPPER` `a * b_upper`.
///
/// ```text
///        +--------------------+
/// a_i -->| S                P |--> product_o
/// b_i -->| S                  |
///        | SignificandProduct |
///        +--------------------+
/// ```
/// Combinational, unsigned, exact: `P = 2 S`, `S <= 24`. The product has at most `S +` [`half`]`(S)` bits.
#[derive(LogicBlock, Default, Clone, Debug)]
pub struct SignificandProduct<const S: usize, const P: usize, const UPPER: bool> {
    /// First factor.
    pub a_i: Signal<In, Bits<S>>,
    /// Second factor, of which one half counts.
    pub b_i: Signal<In, Bits<S>>,
    /// Product.
    pub product_o: Signal<Out, Bits<P>>,
}

/// Bits of the lower half of a word of `bits` bits.
#[must_use]
pub const fn half(bits: usize) -> usize {
    bits.div_ceil(2)
}

impl<const S: usize, const P: usize, const UPPER: bool> SignificandProduct<S, P, UPPER> {
    /// Where the half begins, and how many bits it has.
    const HALF: (usize, usize) = if UPPER { (half(S), S - half(S)) } else { (0, half(S)) };
}

impl<const S: usize, const P: usize, const UPPER: bool> Logic for SignificandProduct<S, P, UPPER> {
    fn update(&mut self) {
        let (low, width) = Self::HALF;
        let factor = self.b_i.val().to_u64() >> low & ((1 << width) - 1);
        self.product_o.next = (self.a_i.val().to_u64() * factor).into();
    }

    fn connect(&mut self) {
        self.product_o.connect();
    }

    fn hdl(&self) -> Verilog {
        use VerilogExpression::{Binary, Cast, Literal, Signal, Slice};
        let signal = |name: &str| Box::new(Signal(name.to_owned()));
        let (low, width) = Self::HALF;
        let low = Box::new(Literal(VerilogLiteral::from(low as u64)));
        let factor = Cast(Box::new(Slice(signal("b_i"), width, low)), S);
        let product = Binary(signal("a_i"), VerilogOp::Mul, Box::new(factor));
        Verilog::Combinatorial(vec![VerilogStatement::Assignment(*signal("product_o"), product)])
    }

    fn timing(&self) -> Vec<TimingInfo> {
        const { assert!(P == derived_width!(P, 0, S) && S <= 24) };
        named("significand_product", &format!("w{S}_{}", if UPPER { "upper" } else { "lower" }))
    }
}
