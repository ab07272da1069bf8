//! Floating-point comparison.
//!
//! Sign-magnitude words compare like unsigned integers, except that a negative operand reverses the outcome. Let `u`
//! be `a < b` on the words as unsigned integers. If both signs are clear, `a < b` is `u`; if both are set, it is the
//! reverse, `!u` (for `a != b`); if only `a` is negative, its word is the larger one, so that `u = 0` and again `!u` is
//! right; if only `b` is negative, `u = 1`, and `!u` is right. Hence `a < b` is `u` xor `(sign_a | sign_b)` wherever the
//! operands differ.

use crate::blocks::{ClockEnable, Dff, Valid, dff_setup, module};
use crate::widths::{check_widths, format};
use netlist::module::named;
use rust_hdl_core::prelude::*;

/// `lt = a < b`, `le = a <= b`, `eq = a == b`.
///
/// ```text
///            +------------+
///    a_i --->| W          |---> lt_o
///    b_i --->| W          |---> le_o
///            |   FpCmp    |---> eq_o
///  valid_i ->|            |---> valid_o
///    tag_i ->| T        T |---> tag_o
///     en_i ->|            |
///    clk_i ->|            |
///            +------------+
/// ```
/// Latency 1. All three are low if an operand is NaN; -0 equals +0; subnormals are numbers like any other.
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
/// lt_o, ...  ----X A X B     X---
/// ```
///
/// The same in the simulator:
///
/// ```
/// use units::clocking::Clocked;
///
/// let mut unit = <units::fp_cmp!(8, 24)>::default();
/// let operands = [(-0.0, 0.0), (1.0, f32::NAN)];
/// let mut shown = Vec::new();
/// for cycle in 0..4 {
///     unit.clocking.en_i.next = cycle != 2;
///     unit.valid_i.next = cycle < 2;
///     let (a, b) = operands[cycle % 2];
///     unit.a_i.next = u64::from(f32::to_bits(a)).into();
///     unit.b_i.next = u64::from(f32::to_bits(b)).into();
///     unit.tick();
///     shown.push(unit.valid_o.val().then(|| [unit.lt_o.val(), unit.le_o.val()]));
/// }
/// assert_eq!(shown, [Some([false, true]), Some([false; 2]), Some([false; 2]), None]);
/// ```
#[derive(LogicBlock, Clone, Debug)]
pub struct FpCmp<const E: usize, const S: usize, const W: usize, const T: usize> {
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
    /// Result is valid.
    pub valid_o: Signal<Out, Bit>,
    /// Tag of the result.
    pub tag_o: Signal<Out, Bits<T>>,
    /// `a < b`.
    pub lt_o: Signal<Out, Bit>,
    /// `a <= b`.
    pub le_o: Signal<Out, Bit>,
    /// `a == b`.
    pub eq_o: Signal<Out, Bit>,
    magnitude_mask: Constant<Bits<W>>,
    infinity: Constant<Bits<W>>,
    magnitude_a: Signal<Local, Bits<W>>,
    magnitude_b: Signal<Local, Bits<W>>,
    any_magnitude: Signal<Local, Bits<W>>,
    any_negative: Signal<Local, Bit>,
    ordered: Signal<Local, Bit>,
    below: Signal<Local, Bit>,
    equal: Signal<Local, Bit>,
    less: Signal<Local, Bit>,
    valid: Valid,
    tag: Dff<Bits<T>>,
    lt: Dff<Bit>,
    le: Dff<Bit>,
    eq: Dff<Bit>,
}

impl<const E: usize, const S: usize, const W: usize, const T: usize> Default for FpCmp<E, S, W, T> {
    fn default() -> Self {
        check_widths!(W);
        let format = format::<E, S>();
        module! {
            magnitude_mask = Constant::new(u64::from(format.magnitude(u32::MAX)).into()),
            infinity = Constant::new(u64::from(format.infinity()).into());
            clocking, valid_i, tag_i, a_i, b_i, valid_o, tag_o, lt_o, le_o, eq_o,
            magnitude_a, magnitude_b, any_magnitude, any_negative, ordered, below, equal, less,
            valid, tag, lt, le, eq,
        }
    }
}

impl<const E: usize, const S: usize, const W: usize, const T: usize> Logic for FpCmp<E, S, W, T> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clocking.clk_i, valid, tag, lt, le, eq);
        self.magnitude_a.next = self.a_i.val() & self.magnitude_mask.val();
        self.magnitude_b.next = self.b_i.val() & self.magnitude_mask.val();
        self.any_magnitude.next = self.magnitude_a.val() | self.magnitude_b.val();
        self.any_negative.next =
            (self.magnitude_a.val() != self.a_i.val()) | (self.magnitude_b.val() != self.b_i.val());
        self.ordered.next =
            (self.magnitude_a.val() <= self.infinity.val()) & (self.magnitude_b.val() <= self.infinity.val());
        self.below.next = self.a_i.val() < self.b_i.val();
        self.equal.next = (self.a_i.val() == self.b_i.val()) | !self.any_magnitude.val().any();
        self.less.next = (self.below.val() ^ self.any_negative.val()) & !self.equal.val();
        if self.clocking.en_i.val() {
            self.valid.d.next = self.valid_i.val();
            self.tag.d.next = self.tag_i.val();
            self.lt.d.next = self.ordered.val() & self.less.val();
            self.le.d.next = self.ordered.val() & (self.less.val() | self.equal.val());
            self.eq.d.next = self.ordered.val() & self.equal.val();
        }
        self.valid_o.next = self.valid.q.val();
        self.tag_o.next = self.tag.q.val();
        self.lt_o.next = self.lt.q.val();
        self.le_o.next = self.le.q.val();
        self.eq_o.next = self.eq.q.val();
    }

    fn timing(&self) -> Vec<TimingInfo> {
        named("fp_cmp", &format!("{}_t{T}", format::<E, S>().systematic_name()))
    }
}
