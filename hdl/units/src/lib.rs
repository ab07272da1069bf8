//! The arithmetic units, each with the latency of the published unit it stands for.
//!
//! | module | operation | latency (cycles) |
//! |---|---|---|
//! | [`FpAdd`] | addition, subtraction | 2 |
//! | [`FpMul`] | multiplication | 2 |
//! | [`FpMinMax`] | minimum, maximum | 1 |
//! | [`FpCmp`] | less, less or equal, equal | 1 |
//! | [`IntAdd`] | integer addition | 1 |
//!
//! What the results are bit for bit is stated by [`fp::Arithmetic`]. Addition and multiplication share their
//! first layer, which splits a word into its fields, and their last one, the only rounder.

pub mod blocks;
pub mod clocking;
mod formats;
mod fp_add;
mod fp_cmp;
mod fp_min_max;
mod fp_mul;
mod fp_unpack;
mod int_add;
mod leading_zeros;
mod rounder;
mod significand_product;
mod sticky_shift;
pub mod widths;

pub use fp_add::FpAdd;
pub use fp_cmp::FpCmp;
pub use fp_min_max::FpMinMax;
pub use fp_mul::FpMul;
pub use int_add::IntAdd;
pub use significand_product::SignificandProduct;

use fp_unpack::FpUnpack;
use leading_zeros::LeadingZeros;
use rounder::Rounder;
use sticky_shift::StickyShift;
