//! Floating-point addition and subtraction.
//!
//! Let `|a| >= |b|` (else swap), `d` the difference of their exponents. Both significands get three bits below the last
//! place; the smaller one is shifted right by `d`, a sticky bit standing for all that falls off, and added or
//! subtracted:
//!
//! ```text
//! sum = significand_a * 2^3 +- (significand_b * 2^3 >> d)
//! ```
//!
//! Three bits suffice: if `d >= 2`, a difference loses at most one leading bit, which leaves a round bit
//! and the sticky bit; if `d <= 1`, it is exact. The sum is then shifted left by `min(leading zeros, exponent)`: fully
//! normalised, or as far as the smallest exponent allows, so that a subnormal result is exact and needs no case of
//! its own.
//!
//! | cycle | work |
//! |---|---|
//! | 1 | unpack, order by magnitude, align, add or subtract |
//! | 2 | normalise, round |
//!
//! | corner case | result |
//! |---|---|
//! | NaN operand, or infinities whose difference is taken | canonical NaN |
//! | infinity and anything else | that infinity |
//! | x + (-x) for finite x | +0, or -0 if rounding down |
//! | zeros of equal sign | that zero |

use super::{FpUnpack, Rounder, StickyShift};
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

    // Cycle 1.
    magnitude_mask: Constant<Bits<W>>,
    a: FpUnpack<E, S, W>,
    b: FpUnpack<E, S, W>,
    sign_b: Signal<Local, Bit>,
    differ: Signal<Local, Bit>,
    magnitude_a: Signal<Local, Bits<W>>,
    magnitude_b: Signal<Local, Bits<W>>,
    swap: Signal<Local, Bit>,
    high_sign: Signal<Local, Bit>,
    high_exponent: Signal<Local, Bits<E>>,
    low_exponent: Signal<Local, Bits<E>>,
    high_significand: Signal<Local, Bits<S>>,
    low_significand: Signal<Local, Bits<S>>,
    high: Signal<Local, Bits<N>>,
    low: Signal<Local, Bits<N>>,
    align: StickyShift<N, E>,
    total: Signal<Local, Bits<N>>,

    // Between the cycles.
    valid_1: Valid,
    tag_1: Dff<Bits<T>>,
    rounding: Dff<Bits<3>>,
    nan: Dff<Bit>,
    infinity: Dff<Bit>,
    sign: Dff<Bit>,
    zero_sign: Dff<Bit>,
    exponent: Dff<Bits<E>>,
    sum: Dff<Bits<N>>,

    // Cycle 2.
    distance: [Constant<Bits<E>>; E],
    limit: [Constant<Bits<N>>; E],
    budget: Signal<Local, Bits<E>>,
    normal: Signal<Local, Bits<N>>,
    raw_exponent: Signal<Local, Bits<X>>,
    raw_significand: Signal<Local, Bits<N>>,
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
        // Row i shifts by 2^(E-1-i), if at least as many bits lead with zeros; a longer shift than the sum never is.
        let distance = |i: usize| 1usize << (E - 1 - i);
        let limit = |i: usize| if distance(i) < N { 1u64 << (N - distance(i)) } else { 0 };
        module! {
            magnitude_mask = Constant::new(u64::from(format::<E, S>().magnitude(u32::MAX)).into()),
            distance = std::array::from_fn(|i| Constant::new((distance(i) as u64).into())),
            limit = std::array::from_fn(|i| Constant::new(limit(i).into()));
            a, b, rounder, clocking, valid_i, tag_i, a_i, b_i, subtract_i, rounding_i, valid_o, tag_o, result_o,
            sign_b, differ, magnitude_a, magnitude_b, swap, high_sign, high_exponent, low_exponent, high_significand,
            low_significand, high, low, align, total,
            valid_1, tag_1, rounding, nan, infinity, sign, zero_sign, exponent, sum,
            budget, normal, raw_exponent, raw_significand, result_sign,
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
            zero_sign,
            exponent,
            sum
        );
        dff_setup!(self, clocking.clk_i, valid_2, tag_2, result);

        // Cycle 1: order the operands by magnitude.
        self.a.word_i.next = self.a_i.val();
        self.b.word_i.next = self.b_i.val();
        self.sign_b.next = self.b.sign_o.val() ^ self.subtract_i.val();
        self.differ.next = self.a.sign_o.val() ^ self.sign_b.val();
        self.magnitude_a.next = self.a_i.val() & self.magnitude_mask.val();
        self.magnitude_b.next = self.b_i.val() & self.magnitude_mask.val();
        self.swap.next = self.magnitude_a.val() < self.magnitude_b.val();
        self.high_sign.next = self.a.sign_o.val();
        self.high_exponent.next = self.a.exponent_o.val();
        self.low_exponent.next = self.b.exponent_o.val();
        self.high_significand.next = self.a.significand_o.val();
        self.low_significand.next = self.b.significand_o.val();
        if self.swap.val() {
            self.high_sign.next = self.sign_b.val();
            self.high_exponent.next = self.b.exponent_o.val();
            self.low_exponent.next = self.a.exponent_o.val();
            self.high_significand.next = self.b.significand_o.val();
            self.low_significand.next = self.a.significand_o.val();
        }

        // Align and add.
        self.high.next = bit_cast::<N, S>(self.high_significand.val());
        self.high.next = self.high.val() << 3;
        self.low.next = bit_cast::<N, S>(self.low_significand.val());
        self.align.value_i.next = self.low.val() << 3;
        self.align.amount_i.next = self.high_exponent.val() - self.low_exponent.val();
        self.total.next = self.high.val() + self.align.result_o.val();
        if self.differ.val() {
            self.total.next = self.high.val() - self.align.result_o.val();
        }
        if self.clocking.en_i.val() {
            self.valid_1.d.next = self.valid_i.val();
            self.tag_1.d.next = self.tag_i.val();
            self.rounding.d.next = self.rounding_i.val();
            self.nan.d.next = self.a.nan_o.val()
                | self.b.nan_o.val()
                | (self.a.infinity_o.val() & self.b.infinity_o.val() & self.differ.val());
            self.infinity.d.next = self.a.infinity_o.val() | self.b.infinity_o.val();
            self.sign.d.next = self.high_sign.val();
            self.zero_sign.d.next = (self.differ.val() & (self.rounding_i.val() == 2))
                | (!self.differ.val() & self.high_sign.val());
            self.exponent.d.next = self.high_exponent.val();
            self.sum.d.next = self.total.val();
        }

        // Cycle 2: normalise as far as the exponent allows.
        self.budget.next = self.exponent.q.val();
        self.normal.next = self.sum.q.val();
        for i in 0..E {
            if (self.normal.val() < self.limit[i].val()) & (self.budget.val() >= self.distance[i].val()) {
                self.normal.next = self.normal.val() << self.distance[i].val();
                self.budget.next = self.budget.val() - self.distance[i].val();
            }
        }
        self.raw_exponent.next = bit_cast::<X, E>(self.budget.val());
        self.raw_significand.next = self.normal.val() >> 2;
        if self.normal.val().get_bit(0) | self.normal.val().get_bit(1) {
            self.raw_significand.next = self.raw_significand.val() | 1;
        }

        // Round.
        self.result_sign.next = self.sign.q.val();
        if !self.sum.q.val().any() & !self.infinity.q.val() {
            self.result_sign.next = self.zero_sign.q.val();
        }
        self.rounder.sign_i.next = self.result_sign.val();
        self.rounder.exponent_i.next = self.raw_exponent.val() + 1;
        self.rounder.significand_i.next = bit_cast::<R, N>(self.raw_significand.val());
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
