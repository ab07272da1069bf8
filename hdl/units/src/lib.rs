//! The arithmetic units, each with the latency of the published unit that it stands for.
//!
//! | module | operation | latency (cycles) |
//! |---|---|---|
//! | [`FpAdd`] | addition, subtraction | 2 |
//! | [`FpMul`] | multiplication | 2 |
//! | [`FpMinMax`] | minimum, maximum | 1 |
//! | [`FpCmp`] | less, less or equal, equal | 1 |
//! | [`IntAdd`] | integer addition | 1 |
//!
//! [`fp::Arithmetic`] states the results bit for bit. Addition and multiplication share their first layer, which splits a word into
//! its fields, and their last layer, the only rounder. [`blocks`] has registers and delays, [`clocking`] runs a module in
//! `rust-hdl`'s own simulator.
//!
//! ```
//! use rust_hdl_core::prelude::Block;
//! use units::clocking::Clocked;
//!
//! // Eight exponent and 24 significand bits: binary32.
//! let mut adder = <units::fp_add!(8, 24)>::default();
//! adder.connect_all();
//! adder.en_i.next = true;
//! adder.valid_i.next = true;
//! adder.a_i.next = u64::from(1.5_f32.to_bits()).into();
//! adder.b_i.next = u64::from(2.25_f32.to_bits()).into();
//! adder.tick();
//! adder.tick();
//! assert!(adder.valid_o.val());
//! assert_eq!(f32::from_bits(adder.result_o.val().to_u32()), 3.75);
//! ```

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

/// The part of a module's name that tells its format and whether it flushes subnormals.
fn variant<const E: usize, const S: usize>(flush: bool) -> String {
    let name = crate::widths::format::<E, S>().systematic_name();
    if flush { format!("{name}_ftz") } else { name }
}
