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
//! moves it down by one more. While the arrays multiply, the zeros `z` of the subnormal operand are counted and the shift is
//! fixed: left by `min(z, e - 1)`, or right by `1 - e` if `e < 1`, where the result is subnormal. Two subnormal operands always have
//! such a result. That puts the leading one in the top two bits of the rounder's window.
//!
//! The two shifters work beside each other, as only one of them ever shifts. What is below the window is seen by a mask
//! on the product, which does not wait for them.
//!
//! | cycle | work |
//! |---|---|
//! | 1 | unpack, multiply with either half of `b`; count zeros, exponent and shift amounts |
//! | 2 | add the two products, shift, round |
//!
//! | corner case | result |
//! |---|---|
//! | NaN operand, or 0 * infinity | canonical NaN |
//! | infinity and a number that is not zero | infinity of the product's sign |
//! | zero and a number | zero of the product's sign |

use super::significand_product::half;
use super::{FpUnpack, LeadingZeros, Rounder, SignificandProduct};
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
    hidden_index: Constant<Bits<8>>,
    half: Constant<Bits<8>>,
    above_half: Constant<Bits<8>>,
    window_reach: Constant<Bits<X>>,
    a: FpUnpack<E, S, W>,
    b: FpUnpack<E, S, W>,
    array_lower: SignificandProduct<S, P, false>,
    array_upper: SignificandProduct<S, P, true>,
    upper: Signal<Local, Bits<P>>,
    lower: Signal<Local, Bits<P>>,
    carried: Signal<Local, Bits<P>>,
    subnormal: Signal<Local, Bits<S>>,
    leading: LeadingZeros<S, 5>,
    zeros: Signal<Local, Bits<X>>,
    wide_a: Signal<Local, Bits<X>>,
    wide_b: Signal<Local, Bits<X>>,
    exponent_sum: Signal<Local, Bits<X>>,
    top_exponent: Signal<Local, Bits<X>>,
    tiny: Signal<Local, Bit>,
    room: Signal<Local, Bits<X>>,
    shortfall: Signal<Local, Bits<X>>,
    left_amount: Signal<Local, Bits<X>>,
    start_exponent: Signal<Local, Bits<X>>,
    below_window: Signal<Local, Bits<X>>,
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
    right_shift: Dff<Bit>,
    left: Dff<Bits<5>>,
    right: Dff<Bits<E>>,
    below: Dff<Bits<X>>,
    sum: Dff<Bits<P>>,
    carry: Dff<Bits<S>>,

    // Cycle 2.
    ones: Constant<Bits<P>>,
    window_offset: Constant<Bits<8>>,
    product: Signal<Local, Bits<P>>,
    normal: Signal<Local, Bits<P>>,
    window: Signal<Local, Bits<P>>,
    lost: Signal<Local, Bits<P>>,
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
            hidden_index = index(S - 1),
            half = index(half(S)),
            above_half = index(P - half(S)),
            window_reach = Constant::new(((P - R) as u64).into()),
            ones = Constant::new(Bits::mask()),
            window_offset = index(P - R);
            a, b, rounder, clocking, valid_i, tag_i, a_i, b_i, rounding_i, valid_o, tag_o, result_o,
            array_lower, array_upper, upper, lower, carried, subnormal, leading, zeros, wide_a, wide_b, exponent_sum,
            top_exponent, tiny, room, shortfall, left_amount, start_exponent, below_window, zero_factor, infinite_factor,
            valid_1, tag_1, rounding, nan, infinity, sign, exponent, right_shift, left, right, below, sum, carry,
            product, normal, window, lost,
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
            right_shift,
            left,
            right,
            below,
            sum,
            carry
        );
        dff_setup!(self, clocking.clk_i, valid_2, tag_2, result);

        // Cycle 1: multiply. The sum of the two products has a word and a carry, whose bits below `half` are in the word.
        self.a.word_i.next = self.a_i.val();
        self.b.word_i.next = self.b_i.val();
        self.array_lower.a_i.next = self.a.significand_o.val();
        self.array_lower.b_i.next = self.b.significand_o.val();
        self.array_upper.a_i.next = self.a.significand_o.val();
        self.array_upper.b_i.next = self.b.significand_o.val();
        self.upper.next = self.array_upper.product_o.val() << self.half.val();
        self.lower.next = self.array_lower.product_o.val() << self.above_half.val();
        self.lower.next = self.lower.val() >> self.above_half.val();
        self.carried.next = self.array_lower.product_o.val() >> self.half.val();
        self.zero_factor.next = !self.a.significand_o.val().any() | !self.b.significand_o.val().any();
        self.infinite_factor.next = self.a.infinity_o.val() | self.b.infinity_o.val();

        // Meanwhile, the exponent of the product's top bit, and how far the product has to be shifted.
        self.subnormal.next = self.a.significand_o.val();
        if self.a.significand_o.val().get_bit(self.hidden_index.val().index()) {
            self.subnormal.next = self.b.significand_o.val();
        }
        self.leading.value_i.next = self.subnormal.val();
        self.zeros.next = bit_cast::<X, 5>(self.leading.count_o.val());
        self.wide_a.next = bit_cast::<X, E>(self.a.exponent_o.val());
        self.wide_b.next = bit_cast::<X, E>(self.b.exponent_o.val());
        self.exponent_sum.next = self.wide_a.val() + self.wide_b.val();
        self.top_exponent.next = self.exponent_sum.val() - self.bias.val();
        self.tiny.next =
            self.top_exponent.val().get_bit(self.sign_index.val().index()) | !self.top_exponent.val().any();
        self.room.next = self.top_exponent.val() - 1;
        self.shortfall.next = 1 - self.top_exponent.val();
        self.left_amount.next = self.zeros.val();
        self.start_exponent.next = self.room.val() - self.zeros.val();
        if self.room.val() < self.zeros.val() {
            self.left_amount.next = self.room.val();
            self.start_exponent.next = 0.into();
        }
        // Nothing is below a window that a shift to the left takes to the product's end.
        self.below_window.next = self.window_reach.val() - self.left_amount.val();
        if self.below_window.val().get_bit(self.sign_index.val().index()) {
            self.below_window.next = 0.into();
        }
        if self.tiny.val() {
            self.start_exponent.next = 0.into();
            self.below_window.next = self.window_reach.val() + self.shortfall.val();
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
            self.right_shift.d.next = self.tiny.val();
            self.left.d.next = bit_cast::<5, X>(self.left_amount.val());
            self.right.d.next = bit_cast::<E, X>(self.shortfall.val());
            self.below.d.next = self.below_window.val();
            self.sum.d.next = self.upper.val() | self.lower.val();
            self.carry.d.next = bit_cast::<S, P>(self.carried.val());
        }

        // Cycle 2: add, and shift either way.
        self.product.next = bit_cast::<P, S>(self.carry.q.val());
        self.product.next = self.product.val() << self.half.val();
        self.product.next = self.sum.q.val() + self.product.val();
        self.normal.next = self.product.val() << self.left.q.val();
        self.window.next = self.normal.val() >> self.window_offset.val();
        if self.right_shift.q.val() {
            self.window.next = self.product.val() >> self.window_offset.val();
            self.window.next = self.window.val() >> self.right.q.val();
        }
        self.lost.next = self.product.val() & !(self.ones.val() << self.below.q.val());

        // Round.
        self.rounder.sign_i.next = self.sign.q.val();
        self.rounder.exponent_i.next = self.exponent.q.val();
        self.rounder.window_i.next = bit_cast::<R, P>(self.window.val());
        self.rounder.lost_i.next = self.lost.val().any();
        self.rounder.complement_i.next = false;
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
