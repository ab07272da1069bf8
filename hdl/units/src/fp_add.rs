//! Floating-point addition and subtraction.
//!
//! Let `a` have the larger exponent (else swap), `d` the difference of the exponents. Both significands get three bits below
//! the last place; the one of `b` is shifted right by `d`, a sticky bit standing for all that falls off, and added or
//! subtracted:
//!
//! ```text
//! sum = significand_a * 2^3 +- (significand_b * 2^3 >> d)
//! ```
//!
//! Three bits suffice: if `d >= 2`, a difference loses at most one leading bit, which leaves a round bit
//! and the sticky bit; if `d <= 1`, it is exact. The sum is then shifted left until it fills the rounder's window, but never by more
//! than the exponent, so that a subnormal result is exact and needs no case of its own.
//!
//! *The difference is formed inverted*, as `!x + y = -(x - y) - 1`, which spares the adder its incoming carry. If `d = 0`, the
//! significand of `b` may be the larger one, which nobody compares. The difference is negative then; its complement goes
//! into the rounder's window, and the rounder's increment completes the negation. As such a difference is exact, the
//! increment is free.
//!
//! *The shift is known before the sum.* A sum has its leading one in the upper two places, a difference with `d >= 2` in the two
//! places below the top. Where `d <= 1`, the digits `p - q` of the nearly aligned significands tell the place (Schmookler and
//! Nowka, "Leading zero anticipation and detection", ARITH 2001). Each digit is -1, 0 or 1. The first that is not 0, `s`, starts a
//! run, which digits `-s` continue; each of them cancels the place before it. The leading one is where the run ends or one
//! place below. A marker where the exponent would run out bounds the shift.
//!
//! | cycle | work |
//! |---|---|
//! | 1 | unpack, order by exponent, align, add or subtract; meanwhile, anticipate the leading one |
//! | 2 | normalise, round |
//!
//! | corner case | result |
//! |---|---|
//! | NaN operand, or infinities whose difference is taken | canonical NaN |
//! | infinity and anything else | that infinity |
//! | x + (-x) for finite x | +0, or -0 if rounding down |
//! | zeros of equal sign | that zero |

use super::{FpUnpack, LeadingZeros, Rounder, StickyShift};
use crate::blocks::{ClockEnable, Dff, Valid, dff_setup, module};
use crate::widths::{check_widths, format};
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// `result = a + b`, or `a - b`.
///
/// ```text
///                +-----------+
///        a_i --->| W       W |---> result_o
///        b_i --->| W         |
/// subtract_i --->|           |
/// rounding_i --->| 3  FpAdd  |
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
/// let mut unit = <units::fp_add!(8, 24)>::default();
/// let operands = [(1.5, 2.25), (1.0, 1e-8)];
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
/// assert_eq!(shown, [None, Some(3.75), Some(3.75), Some(1.0), None]);
/// ```
#[derive(LogicBlock, Clone, Debug)]
pub struct FpAdd<
    const E: usize,
    const S: usize,
    const W: usize,
    const X: usize,
    const R: usize,
    const N: usize,
    const T: usize,
> {
    /// Clock and enable.
    pub clocking: ClockEnable,
    /// Operands are valid.
    pub valid_i: Signal<In, Bit>,
    /// Tag of this operation.
    pub tag_i: Signal<In, Bits<T>>,
    /// First operand.
    pub a_i: Signal<In, Bits<W>>,
    /// Second operand.
    pub b_i: Signal<In, Bits<W>>,
    /// High: `a - b`.
    pub subtract_i: Signal<In, Bit>,
    /// Rounding direction.
    pub rounding_i: Signal<In, Bits<3>>,
    /// Result is valid.
    pub valid_o: Signal<Out, Bit>,
    /// Tag of the result.
    pub tag_o: Signal<Out, Bits<T>>,
    /// Rounded sum or difference.
    pub result_o: Signal<Out, Bits<W>>,

    // Cycle 1: exponents.
    a: FpUnpack<E, S, W>,
    b: FpUnpack<E, S, W>,
    sign_b: Signal<Local, Bit>,
    differ: Signal<Local, Bit>,
    swap: Signal<Local, Bit>,
    a_above_b: Signal<Local, Bits<E>>,
    b_above_a: Signal<Local, Bits<E>>,
    distance: Signal<Local, Bits<E>>,
    high_sign: Signal<Local, Bit>,
    high_exponent: Signal<Local, Bits<E>>,

    // Cycle 1: sum.
    high_significand: Signal<Local, Bits<S>>,
    low_significand: Signal<Local, Bits<S>>,
    high: Signal<Local, Bits<N>>,
    low: Signal<Local, Bits<N>>,
    align: StickyShift<N, E>,
    total: Signal<Local, Bits<N>>,

    // Cycle 1: anticipation.
    top_bit: Constant<Bits<R>>,
    second_bit: Constant<Bits<R>>,
    near: Signal<Local, Bits<2>>,
    p: Signal<Local, Bits<R>>,
    q: Signal<Local, Bits<R>>,
    plus: Signal<Local, Bits<R>>,
    minus: Signal<Local, Bits<R>>,
    first: Signal<Local, Bits<R>>,
    after_plus: Signal<Local, Bits<R>>,
    after_minus: Signal<Local, Bits<R>>,
    ends: Signal<Local, Bits<R>>,
    zeros: LeadingZeros<R, 5>,

    // Between the cycles.
    valid_1: Valid,
    tag_1: Dff<Bits<T>>,
    rounding: Dff<Bits<3>>,
    nan: Dff<Bit>,
    infinity: Dff<Bit>,
    sign: Dff<Bit>,
    minus_1: Dff<Bit>,
    exponent: Dff<Bits<E>>,
    left: Dff<Bits<5>>,
    sum: Dff<Bits<N>>,

    // Cycle 2.
    top_index: Constant<Bits<8>>,
    difference: Signal<Local, Bits<N>>,
    negative: Signal<Local, Bit>,
    normal: Signal<Local, Bits<N>>,
    wide_exponent: Signal<Local, Bits<X>>,
    window: Signal<Local, Bits<N>>,
    result_sign: Signal<Local, Bit>,
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
    const N: usize,
    const T: usize,
> Default for FpAdd<E, S, W, X, R, N, T>
{
    fn default() -> Self {
        check_widths!(W, X, R, N);
        let bit = |i: usize| Constant::new((1u64 << i).into());
        module! {
            top_bit = bit(R - 1),
            second_bit = bit(R - 2),
            top_index = Constant::new((N as u64 - 1).into());
            a, b, rounder, clocking, valid_i, tag_i, a_i, b_i, subtract_i, rounding_i, valid_o, tag_o, result_o,
            sign_b, differ, swap, a_above_b, b_above_a, distance, high_sign, high_exponent, high_significand,
            low_significand, high, low, align, total,
            near, p, q, plus, minus, first, after_plus, after_minus, ends, zeros,
            valid_1, tag_1, rounding, nan, infinity, sign, minus_1, exponent, left, sum,
            difference, negative, normal, wide_exponent, window, result_sign,
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
    const N: usize,
    const T: usize,
> Logic for FpAdd<E, S, W, X, R, N, T>
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
            minus_1,
            exponent,
            left,
            sum
        );
        dff_setup!(self, clocking.clk_i, valid_2, tag_2, result);

        // Cycle 1: order the operands by exponent. Both differences are ready when it is known which one counts.
        self.a.word_i.next = self.a_i.val();
        self.b.word_i.next = self.b_i.val();
        self.sign_b.next = self.b.sign_o.val() ^ self.subtract_i.val();
        self.differ.next = self.a.sign_o.val() ^ self.sign_b.val();
        self.swap.next = self.a.encoded_exponent_o.val() < self.b.encoded_exponent_o.val();
        self.a_above_b.next = self.a.exponent_o.val() - self.b.exponent_o.val();
        self.b_above_a.next = self.b.exponent_o.val() - self.a.exponent_o.val();
        self.distance.next = self.a_above_b.val();
        self.high_sign.next = self.a.sign_o.val();
        self.high_exponent.next = self.a.exponent_o.val();
        self.high_significand.next = self.a.significand_o.val();
        self.low_significand.next = self.b.significand_o.val();
        if self.swap.val() {
            self.distance.next = self.b_above_a.val();
            self.high_sign.next = self.sign_b.val();
            self.high_exponent.next = self.b.exponent_o.val();
            self.high_significand.next = self.b.significand_o.val();
            self.low_significand.next = self.a.significand_o.val();
        }

        // Align and add; a difference is inverted.
        self.high.next = bit_cast::<N, S>(self.high_significand.val());
        self.high.next = self.high.val() << 3;
        if self.differ.val() {
            self.high.next = !self.high.val();
        }
        self.low.next = bit_cast::<N, S>(self.low_significand.val());
        self.align.value_i.next = self.low.val() << 3;
        self.align.amount_i.next = self.distance.val();
        self.total.next = self.high.val() + self.align.result_o.val();

        // Anticipate the leading one: align by one place, as if the exponents differed by at most one.
        self.near.next = bit_cast::<2, E>(self.a_above_b.val());
        self.p.next = bit_cast::<R, S>(self.a.significand_o.val());
        self.q.next = bit_cast::<R, S>(self.b.significand_o.val());
        if self.near.val() != 3 {
            self.p.next = self.p.val() << 1;
        }
        if self.near.val() != 1 {
            self.q.next = self.q.val() << 1;
        }
        self.plus.next = self.p.val() & !self.q.val();
        self.minus.next = self.q.val() & !self.p.val();
        self.first.next = self.plus.val() | self.minus.val();
        self.first.next = !(self.first.val() >> 1);
        self.after_plus.next = self.plus.val() << 1;
        self.after_minus.next = self.minus.val() << 1;
        self.ends.next = (self.first.val()
            & ((self.plus.val() & !self.after_minus.val()) | (self.minus.val() & !self.after_plus.val())))
            | (!self.first.val()
                & ((self.plus.val() & !self.after_plus.val())
                    | (self.minus.val() & !self.after_minus.val())));
        // The marker, and a one at the bottom, so that the count means something even for zero.
        self.ends.next = self.ends.val() | (self.top_bit.val() >> self.high_exponent.val()) | 1;
        if (self.distance.val() >> 1).any() {
            self.ends.next = self.ends.val() | self.second_bit.val();
        }
        if !self.differ.val() {
            self.ends.next = self.ends.val() | self.top_bit.val();
        }
        self.zeros.value_i.next = self.ends.val();
        if self.clocking.en_i.val() {
            self.valid_1.d.next = self.valid_i.val();
            self.tag_1.d.next = self.tag_i.val();
            self.rounding.d.next = self.rounding_i.val();
            self.nan.d.next = self.a.nan_o.val()
                | self.b.nan_o.val()
                | (self.a.infinity_o.val() & self.b.infinity_o.val() & self.differ.val());
            self.infinity.d.next = self.a.infinity_o.val() | self.b.infinity_o.val();
            self.sign.d.next = self.high_sign.val();
            self.minus_1.d.next = self.differ.val();
            self.exponent.d.next = self.high_exponent.val();
            self.left.d.next = self.zeros.count_o.val();
            self.sum.d.next = self.total.val();
        }

        // Cycle 2: normalise as far as the exponent allows.
        self.difference.next = self.sum.q.val();
        if self.minus_1.q.val() {
            self.difference.next = !self.sum.q.val();
        }
        self.negative.next =
            self.minus_1.q.val() & self.difference.val().get_bit(self.top_index.val().index());
        self.normal.next = self.difference.val() << self.left.q.val();
        if self.negative.val() {
            self.normal.next = !self.normal.val();
        }
        self.window.next = self.normal.val() >> 2;
        self.wide_exponent.next = bit_cast::<X, E>(self.exponent.q.val());

        // Round.
        self.result_sign.next = self.sign.q.val() ^ self.negative.val();
        if self.minus_1.q.val() & !self.difference.val().any() {
            self.result_sign.next = self.rounding.q.val() == 2;
        }
        self.rounder.sign_i.next = self.result_sign.val();
        self.rounder.exponent_i.next = self.wide_exponent.val() - bit_cast::<X, 5>(self.left.q.val());
        self.rounder.window_i.next = bit_cast::<R, N>(self.window.val());
        self.rounder.lost_i.next = self.normal.val().get_bit(0) | self.normal.val().get_bit(1);
        self.rounder.complement_i.next = self.negative.val();
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
        named("fp_add", &format!("{}_t{T}", format::<E, S>().systematic_name()))
    }
}
