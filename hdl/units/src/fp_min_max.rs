//! Floating-point minimum and maximum, with both treatments of NaN that IEEE 754-2019 (section 9.6) defines.
//!
//! Numbers are ordered by their words: with `u` the unsigned comparison `a < b` of the words, `a` orders before `b` if
//! `u` xor `(sign_a | sign_b)` (see [`super::FpCmp`]), and -0 thereby orders before +0. Where the words are equal, it
//! does not matter which operand is chosen.
//!
//! | a | b | `propagate_nan_i` = 0 | `propagate_nan_i` = 1 |
//! |---|---|---|---|
//! | number | number | the lesser (greater) | the lesser (greater) |
//! | number | NaN | a | NaN |
//! | NaN | number | b | NaN |
//! | NaN | NaN | NaN | NaN |
//!
//! Every NaN result is canonical.

use crate::blocks::{ClockEnable, Dff, Valid, dff_setup, module};
use crate::widths::{check_widths, format};
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// The lesser of `a` and `b`, or the greater.
///
/// ```text
///                    +------------+
///            a_i --->| W        W |---> result_o
///            b_i --->| W          |
///      maximum_i --->|            |
/// propagate_nan_i -->|  FpMinMax  |
///        valid_i --->|            |---> valid_o
///          tag_i --->| T        T |---> tag_o
///           en_i --->|            |
///          clk_i --->|            |
///                    +------------+
/// ```
/// Latency 1. -0 orders before +0; subnormals are numbers like any other.
///
/// Two operations with one stall:
///
/// ```text
/// cycle      0   1   2   3   4
/// clk_i      ~\_/~\_/~\_/~\_/~\_/
/// en_i       ~~~~~~~~\___/~~~~~~~
/// valid_i    ~~~~~~~~\___________
/// a_i, b_i   X A X B X-----------
/// valid_o    ____/~~~~~~~~~~~\___
/// result_o   ----X A X B     X---
/// ```
///
/// The same in the simulator:
///
/// ```
/// use units::clocking::Clocked;
///
/// let mut unit = <units::fp_min_max!(8, 24)>::default();
/// unit.maximum_i.next = true;
/// let operands = [(1.5, 2.5), (f32::NAN, -1.0)];
/// let mut shown = Vec::new();
/// for cycle in 0..4 {
///     unit.clocking.en_i.next = cycle != 2;
///     unit.valid_i.next = cycle < 2;
///     let (a, b) = operands[cycle % 2];
///     unit.a_i.next = u64::from(f32::to_bits(a)).into();
///     unit.b_i.next = u64::from(f32::to_bits(b)).into();
///     unit.tick();
///     shown.push(unit.valid_o.val().then(|| f32::from_bits(unit.result_o.val().to_u32())));
/// }
/// assert_eq!(shown, [Some(2.5), Some(-1.0), Some(-1.0), None]);
/// ```
#[derive(LogicBlock, Clone, Debug)]
pub struct FpMinMax<const E: usize, const S: usize, const W: usize, const T: usize> {
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
    /// Low: minimum; high: maximum.
    pub maximum_i: Signal<In, Bit>,
    /// Low: `minimumNumber`, `maximumNumber`; high: `minimum`, `maximum`.
    pub propagate_nan_i: Signal<In, Bit>,
    /// Result is valid.
    pub valid_o: Signal<Out, Bit>,
    /// Tag of the result.
    pub tag_o: Signal<Out, Bits<T>>,
    /// Minimum or maximum.
    pub result_o: Signal<Out, Bits<W>>,
    magnitude_mask: Constant<Bits<W>>,
    infinity: Constant<Bits<W>>,
    canonical_nan: Constant<Bits<W>>,
    magnitude_a: Signal<Local, Bits<W>>,
    magnitude_b: Signal<Local, Bits<W>>,
    nan_a: Signal<Local, Bit>,
    nan_b: Signal<Local, Bit>,
    nan: Signal<Local, Bit>,
    any_negative: Signal<Local, Bit>,
    below: Signal<Local, Bit>,
    choose_a: Signal<Local, Bit>,
    chosen: Signal<Local, Bits<W>>,
    valid: Valid,
    tag: Dff<Bits<T>>,
    result: Dff<Bits<W>>,
}

impl<const E: usize, const S: usize, const W: usize, const T: usize> Default for FpMinMax<E, S, W, T> {
    fn default() -> Self {
        check_widths!(W);
        let format = format::<E, S>();
        module! {
            magnitude_mask = Constant::new(u64::from(format.magnitude(u32::MAX)).into()),
            infinity = Constant::new(u64::from(format.infinity()).into()),
            canonical_nan = Constant::new(u64::from(format.canonical_nan()).into());
            clocking, valid_i, tag_i, a_i, b_i, maximum_i, propagate_nan_i, valid_o, tag_o, result_o,
            magnitude_a, magnitude_b, nan_a, nan_b, nan, any_negative, below, choose_a, chosen,
            valid, tag, result,
        }
    }
}

impl<const E: usize, const S: usize, const W: usize, const T: usize> Logic for FpMinMax<E, S, W, T> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clocking.clk_i, valid, tag, result);
        self.magnitude_a.next = self.a_i.val() & self.magnitude_mask.val();
        self.magnitude_b.next = self.b_i.val() & self.magnitude_mask.val();
        self.nan_a.next = self.magnitude_a.val() > self.infinity.val();
        self.nan_b.next = self.magnitude_b.val() > self.infinity.val();
        self.nan.next = (self.nan_a.val() & self.nan_b.val())
            | (self.propagate_nan_i.val() & (self.nan_a.val() | self.nan_b.val()));
        self.any_negative.next =
            (self.magnitude_a.val() != self.a_i.val()) | (self.magnitude_b.val() != self.b_i.val());
        self.below.next = self.a_i.val() < self.b_i.val();
        self.choose_a.next = self.nan_b.val()
            | (!self.nan_a.val() & (self.below.val() ^ self.any_negative.val() ^ self.maximum_i.val()));
        self.chosen.next = self.b_i.val();
        if self.choose_a.val() {
            self.chosen.next = self.a_i.val();
        }
        if self.nan.val() {
            self.chosen.next = self.canonical_nan.val();
        }
        if self.clocking.en_i.val() {
            self.valid.d.next = self.valid_i.val();
            self.tag.d.next = self.tag_i.val();
            self.result.d.next = self.chosen.val();
        }
        self.valid_o.next = self.valid.q.val();
        self.tag_o.next = self.tag.q.val();
        self.result_o.next = self.result.q.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("fp_min_max", &format!("{}_t{T}", format::<E, S>().systematic_name()))
    }
}
