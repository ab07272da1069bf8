//! Traversal in a narrower format: the same pipelines with fewer exponent and significand bits.
//!
//! A [`Precision`] names a format and a [`Variant`]. [`Variant::Naive`] rounds everything to nearest and loses hits;
//! [`Variant::Conservative`] may visit more nodes and returns, bit for bit, the hits of
//! [`Mode::Robust`]. The triangle test stays in binary32 in both.
//!
//! # What the hardware does
//! The scene is scaled by `2^s` ([`Scale`]), which changes exponents only. Of a box, min planes are rounded down and
//! max planes up at conversion. A ray carries, per axis, two bounds of its origin and two of its
//! reciprocal, all in the format. With `s` the sign bit of the direction:
//!
//! | plane | subtracts | rounded | role | multiplies by | rounded |
//! |---|---|---|---|---|---|
//! | min side | upper bound of the origin | down | entry if `s = 0`, exit if `s = 1` | by role | by role |
//! | max side | lower bound of the origin | up | exit if `s = 0`, entry if `s = 1` | by role | by role |
//! | either | | | entry | reciprocal rounded towards zero | down |
//! | either | | | exit | padded reciprocal rounded away from zero | up |
//!
//! Compared with the binary32 pipeline of [`Mode::Robust`], which already selects the reciprocal by role, a ray needs
//! **three more registers** (the second bound of its origin), and each plane **one 2:1 multiplexer** as wide as
//! the format, which selects the bound by the plane's side; the ray-box pipeline, whose planes have fixed sides, needs none. The
//! rounding ports are driven by two bits that exist: `{1, max side}` at the adder and `{1, exit}` at the multiplier are the
//! codes of down and up. No unit is added. `t_min` enters rounded down and `t_max` up, and so does the distance of
//! a hit before it discards stacked nodes: one conversion from binary32 per ray and per hit.
//!
//! # Why the conservative variant loses nothing
//! Write `F` for the format's numbers times `2^-s`. [`Scale`] keeps the least of them at or above 2^-149, so that every
//! element of `F` is a binary32 number or beyond the largest. Hence, for real `x <= y`,
//!
//! ```text
//! (1)  down_F(x) <= nearest_32(y),    nearest_32(x) <= up_F(y)
//! ```
//!
//! because `down_F(x) <= y` is itself a binary32 number, which rounding to nearest cannot pass. (Beyond the largest:
//! an element of `F` there is at least 2^128, and what lies above it rounds to infinity.) Now compare both traversals
//! on a plane of a box, with `p, o, i` in binary32 robust mode and `P, O, I` in `F`, first for `s = 0`.
//!
//! * *Entry.* `P <= p`, `O >= o`, so by (1) `X = down(P - O) <= x = nearest(p - o)`. If `X <= 0` (also -inf, and the NaN of
//!   `0 * inf`, which the fold drops), the product does not exceed zero and constrains nothing, as `t_min >= 0`. If `X > 0`,
//!   then `0 < I <= i`, both infinite if the direction is zero on this axis, `X I <= x i`, and by (1) `down(X I) <= nearest(x i)`.
//! * *Exit.* `P >= p`, `O <= o`, so `X = up(P - O) >= x`. If `x < 0`, the exit in binary32 is below zero (`|x| >= 2^-149`,
//!   `i >= 1`), the box is missed there, and nothing is to be shown. If `x >= 0`, then `X >= 0`, `I >= i`, and `up(X I) >= nearest(x i)`,
//!   or NaN, which constrains nothing.
//!
//! For `s = 1` replace every coordinate by its negative: min and max sides, down and up of the difference change
//! places, which is the table above. Infinite operands meet only as `P - O` of the same direction (a plane is rounded to
//! infinity outward, an origin away from it), never as `inf - inf`; a reciprocal is never zero. So **every box's
//! interval in `F` contains that in binary32** robust mode, and with `t_min` down, `t_max` up, so does the interval at
//! every node. A hit's `t` lies in the binary32 interval of every box around its triangle (see
//! [`crate::triangle`]), and its rounding up keeps it above every entry that is not to be discarded. All triangles that
//! binary32 tests and accepts are therefore tested, with the same test: the hit is the same, ties included.
//! Flushing subnormals ([`Subnormals::Flush`]) keeps directed rounding directed and changes nothing in the argument.
//!
//! # Where the naive variant fails
//! With `p` significand bits, a box thinner than about `2^-p` times its distance from the scaled origin may be rounded away from
//! its triangles, and entry and exit at a shared edge or corner may cross: the hit is lost. With 5 exponent bits or fewer,
//! reciprocals beyond the largest number become infinite: a plane that contains the origin gives NaN and
//! constrains nothing, every other constrains all. `dualsplit stress` counts both. Use the conservative variant.

mod arithmetic;
mod narrow;
mod ray;
mod scale;

pub use crate::structure::NarrowStructure;
pub use arithmetic::NarrowArithmetic;
pub(crate) use narrow::Planes;
pub use narrow::{Narrow, NarrowDst};
pub use ray::NarrowRay;
pub use scale::Scale;

use crate::ray::Mode;
use fp::{Format, Subnormals};
use std::fmt;

#[cfg(test)]
mod interval_tests;

/// How the operations of a narrow format are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variant {
    /// Everything to nearest even, one value for the origin and one for the reciprocal.
    Naive,
    /// Bounds throughout, as this module derives.
    Conservative,
}

impl Variant {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Naive, Self::Conservative];

    /// The variant's name on the command line and in result files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Naive => "naive",
            Self::Conservative => "conservative",
        }
    }

    /// The mode in which rays are prepared and triangles tested.
    #[must_use]
    pub fn mode(self) -> Mode {
        match self {
            Self::Naive => Mode::Fast,
            Self::Conservative => Mode::Robust,
        }
    }
}

/// A format with the way in which it is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Precision {
    /// Format of planes, rays and distances.
    pub format: Format,
    /// Rounding.
    pub variant: Variant,
    /// What happens to subnormals.
    pub subnormals: Subnormals,
}

impl Precision {
    /// `format` used as `variant` says, with gradual underflow.
    #[must_use]
    pub const fn new(format: Format, variant: Variant) -> Self {
        Self { format, variant, subnormals: Subnormals::Keep }
    }
}

/// `binary16-conservative`, with `-flush` behind it where subnormals are flushed.
impl fmt::Display for Precision {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}", self.format, self.variant.name())?;
        if self.subnormals == Subnormals::Flush { f.write_str("-flush") } else { Ok(()) }
    }
}
