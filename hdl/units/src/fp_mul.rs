//! Floating-point multiplication.
//!
//! The product of two `S`-bit significands has `P = 2 S` bits and is exact. If its top bit is to be the result's
//! leading bit, the biased exponent is
//!
//! ```text
//! e = exponent_a + exponent_b - bias + 1
//! ```
//!
//! A product of normal numbers has its leading one in one of the top two bits; each leading zero of a subnormal operand
//! moves it down by one more. While the array multiplies, the zeros `z` of both operands are counted and the shift is
//! fixed: left by `min(z, e - 1)`, or right by `1 - e` if `e < 1`, where the result is subnormal. The last left shift, by
//! at most one, looks at the product itself.
//!
//! | cycle | work |
//! |---|---|
//! | 1 | unpack, multiply; count zeros, exponent and shift amounts |
//! | 2 | shift, round |
//!
//! | corner case | result |
//! |---|---|
//! | NaN operand, or 0 * infinity | canonical NaN |
//! | infinity and a number that is not zero | infinity of the product's sign |
//! | zero and a number | zero of the product's sign |

use super::{FpUnpack, LeadingZeros, Rounder, SignificandProduct, StickyShift};
use crate::blocks::{ClockEnable, Dff, Valid, dff_setup, module};
use crate::widths::{check_widths, format};
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// `result = a * b`.
///
/// ```text
///                +-----------+
///        a_i --->| W       W |---> result_o
///        b_i --->| W         |
/// rounding_i --->| 3  FpMul  |
///    valid_i --->|           |---> valid_o
///      tag_i --->| T       T |---> tag_o
///       en_i --->|           |
///      clk_i --->|           |
///                +-----------+
/// ```
/// Latency 2. `rounding_i` is coded as [`fp::Rounding`].
///
/// Two operations with one stall:
///
/// ```text
/// cycle      0   1   2   3   4   5
/// clk_i      ~\_/~\_/~\_/~\_/~\_/~\_/
/// en_i       ~~~~~~~~\___/~~~~~~~~~~~
/// valid_i    ~~~~~~~~\_______________
/// a_i, b_i   X A X B X---------------
/// valid_o    ________/~~~~~~~~~~~\___
/// result_o   --------X A     X B X---
/// ```
///
/// The same in the simulator:
///
/// ```
/// use units::clocking::Clocked;
///
/// let mut unit = <units::fp_mul!(8, 24)>::default();
/// let operands = [(1.5, 2.5), (1e30, 1e30)];
/// let mut shown = Vec::new();
/// for cycle in 0..5 {
///     unit.clocking.en_i.next = cycle != 2;
///     unit.valid_i.next = cycle < 2;
///     let (a, b) = operands[cycle % 2];
///     unit.a_i.next = u64::from(f32::to_bits(a)).into();
///     unit.b_i.next = u64::from(f32::to_bits(b)).into();
///     unit.tick();
///     shown.push(unit.valid_o.val().then(|| f32::from_bits(unit.result_o.val().to_u32())));
/// }
/// assert_eq!(shown, [None, Some(3.75), Some(3.75), Some(f32::INFINITY), None]);
/// ```
#[derive(LogicBlock, Clone, Debug)]
pub struct FpMul<
    const E: usize,
    const S: usize,
    const W: usize,
    const X: usize,
    const R: usize,
    const P: usize,
    const T: usize,
> {
    /// Clock and enable.
    pub clocking: ClockEnable,
    /// Operands are valid.
    pub valid_i: Signal<In, Bit>,
    /// Tag of this operation.
    pub tag_i: Signal<In, Bits<T>>,
    /// First factor.
    pub a_i: Signal<In, Bits<W>>,
    /// Second factor.
    pub b_i: Signal<In, Bits<W>>,
    /// Rounding direction.
    pub rounding_i: Signal<In, Bits<3>>,
    /// Result is valid.
    pub valid_o: Signal<Out, Bit>,
    /// Tag of the result.
    pub tag_o: Signal<Out, Bits<T>>,
    /// Rounded product.
    pub result_o: Signal<Out, Bits<W>>,

    // Cycle 1.
    bias: Constant<Bits<X>>,
    sign_index: Constant<Bits<8>>,
    a: FpUnpack<E, S, W>,
    b: FpUnpack<E, S, W>,
    array: SignificandProduct<S, P>,
    zeros_a: LeadingZeros<S, X>,
    zeros_b: LeadingZeros<S, X>,
    zeros: Signal<Local, Bits<X>>,
    wide_a: Signal<Local, Bits<X>>,
    wide_b: Signal<Local, Bits<X>>,
    exponent_sum: Signal<Local, Bits<X>>,
    top_exponent: Signal<Local, Bits<X>>,
    tiny: Signal<Local, Bit>,
    room: Signal<Local, Bits<X>>,
    shortfall: Signal<Local, Bits<X>>,
    left_amount: Signal<Local, Bits<X>>,
    right_amount: Signal<Local, Bits<E>>,
    start_exponent: Signal<Local, Bits<X>>,
    zero_factor: Signal<Local, Bit>,
    infinite_factor: Signal<Local, Bit>,

    // Between the cycles.
    valid_1: Valid,
    tag_1: Dff<Bits<T>>,
    rounding: Dff<Bits<3>>,
    nan: Dff<Bit>,
    infinity: Dff<Bit>,
    sign: Dff<Bit>,
    exponent: Dff<Bits<X>>,
    left: Dff<Bits<X>>,
    right: Dff<Bits<E>>,
    product: Dff<Bits<P>>,

    // Cycle 2.
    top_index: Constant<Bits<8>>,
    high_offset: Constant<Bits<8>>,
    low_mask: Constant<Bits<P>>,
    normal: Signal<Local, Bits<P>>,
    raw_exponent: Signal<Local, Bits<X>>,
    high: Signal<Local, Bits<P>>,
    low: Signal<Local, Bits<P>>,
    raw_significand: Signal<Local, Bits<R>>,
    denormalise: StickyShift<R, E>,
    rounder: Rounder<E, S, W, X, R>,

    // Outputs.
    valid_2: Valid,
    tag_2: Dff<Bits<T>>,
    result: Dff<Bits<W>>,
}

impl<
    const E: usize,
    const S: usize,
    const W: usize,
    const X: usize,
    const R: usize,
    const P: usize,
    const T: usize,
> Default for FpMul<E, S, W, X, R, P, T>
{
    fn default() -> Self {
        check_widths!(W, X, R, P);
        let index = |i: usize| Constant::new((i as u64).into());
        module! {
            // One less than the bias, which is the form that the exponent's equation needs.
            bias = Constant::new((format::<E, S>().bias() as u64 - 1).into()),
            sign_index = index(X - 1),
            top_index = index(P - 1),
            high_offset = index(P - R),
            low_mask = Constant::new(((1u64 << (P - R)) - 1).into());
            a, b, rounder, clocking, valid_i, tag_i, a_i, b_i, rounding_i, valid_o, tag_o, result_o,
            array, zeros_a, zeros_b, zeros, wide_a, wide_b, exponent_sum, top_exponent, tiny, room, shortfall,
            left_amount, right_amount, start_exponent, zero_factor, infinite_factor,
            valid_1, tag_1, rounding, nan, infinity, sign, exponent, left, right, product,
            normal, raw_exponent, high, low, raw_significand, denormalise,
            valid_2, tag_2, result,
        }
    }
}

impl<
    const E: usize,
    const S: usize,
    const W: usize,
    const X: usize,
    const R: usize,
    const P: usize,
    const T: usize,
> Logic for FpMul<E, S, W, X, R, P, T>
{
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(
            self,
            clocking.clk_i,
            valid_1,
            tag_1,
            rounding,
            nan,
            infinity,
            sign,
            exponent,
            left,
            right,
            product
        );
        dff_setup!(self, clocking.clk_i, valid_2, tag_2, result);

        // Cycle 1: multiply.
        self.a.word_i.next = self.a_i.val();
        self.b.word_i.next = self.b_i.val();
        self.array.a_i.next = self.a.significand_o.val();
        self.array.b_i.next = self.b.significand_o.val();
        self.zero_factor.next = !self.a.significand_o.val().any() | !self.b.significand_o.val().any();
        self.infinite_factor.next = self.a.infinity_o.val() | self.b.infinity_o.val();

        // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
        self.zeros_a.value_i.next = self.a.significand_o.val();
        self.zeros_b.value_i.next = self.b.significand_o.val();
        self.zeros.next = self.zeros_a.count_o.val() + self.zeros_b.count_o.val();
        self.wide_a.next = bit_cast::<X, E>(self.a.exponent_o.val());
        self.wide_b.next = bit_cast::<X, E>(self.b.exponent_o.val());
        self.exponent_sum.next = self.wide_a.val() + self.wide_b.val();
        self.top_exponent.next = self.exponent_sum.val() - self.bias.val();
        self.tiny.next =
            self.top_exponent.val().get_bit(self.sign_index.val().index()) | !self.top_exponent.val().any();
        self.room.next = self.top_exponent.val() - 1;
        self.shortfall.next = 1 - self.top_exponent.val();
        self.left_amount.next = self.zeros.val();
        if self.room.val() < self.zeros.val() {
            self.left_amount.next = self.room.val();
        }
        self.start_exponent.next = self.top_exponent.val() - self.left_amount.val();
        self.right_amount.next = 0.into();
        if self.tiny.val() {
            self.left_amount.next = 0.into();
            self.start_exponent.next = 1.into();
            self.right_amount.next = bit_cast::<E, X>(self.shortfall.val());
        }
        if self.clocking.en_i.val() {
            self.valid_1.d.next = self.valid_i.val();
            self.tag_1.d.next = self.tag_i.val();
            self.rounding.d.next = self.rounding_i.val();
            self.nan.d.next = self.a.nan_o.val()
                | self.b.nan_o.val()
                | (self.infinite_factor.val() & self.zero_factor.val());
            self.infinity.d.next = self.infinite_factor.val();
            self.sign.d.next = self.a.sign_o.val() ^ self.b.sign_o.val();
            self.exponent.d.next = self.start_exponent.val();
            self.left.d.next = self.left_amount.val();
            self.right.d.next = self.right_amount.val();
            self.product.d.next = self.array.product_o.val();
        }

        // Cycle 2: shift.
        self.normal.next = self.product.q.val() << self.left.q.val();
        self.raw_exponent.next = self.exponent.q.val();
        if !self.normal.val().get_bit(self.top_index.val().index()) & (self.exponent.q.val() != 1) {
            self.normal.next = self.normal.val() << 1;
            self.raw_exponent.next = self.exponent.q.val() - 1;
        }
        self.high.next = self.normal.val() >> self.high_offset.val();
        self.low.next = self.normal.val() & self.low_mask.val();
        self.raw_significand.next = bit_cast::<R, P>(self.high.val());
        if self.low.val().any() {
            self.raw_significand.next = self.raw_significand.val() | 1;
        }
        self.denormalise.value_i.next = self.raw_significand.val();
        self.denormalise.amount_i.next = self.right.q.val();

        // Round.
        self.rounder.sign_i.next = self.sign.q.val();
        self.rounder.exponent_i.next = self.raw_exponent.val();
        self.rounder.significand_i.next = self.denormalise.result_o.val();
        self.rounder.nan_i.next = self.nan.q.val();
        self.rounder.infinity_i.next = self.infinity.q.val();
        self.rounder.rounding_i.next = self.rounding.q.val();
        if self.clocking.en_i.val() {
            self.valid_2.d.next = self.valid_1.q.val();
            self.tag_2.d.next = self.tag_1.q.val();
            self.result.d.next = self.rounder.result_o.val();
        }
        self.valid_o.next = self.valid_2.q.val();
        self.tag_o.next = self.tag_2.q.val();
        self.result_o.next = self.result.q.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("fp_mul", &format!("{}_t{T}", format::<E, S>().systematic_name()))
    }
}
