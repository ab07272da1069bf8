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
//! its fields, and their last layer, the only rounder. [`blocks`] has registers and delays. [`clocking`] runs a module
//! in `rust-hdl`'s own simulator.
//!
//! ```
//! use netlist::{Evaluator, elaborate, flatten};
//! use rust_hdl_core::prelude::Block;
//!
//! // Eight exponent and 24 significand bits: binary32.
//! let mut adder = <units::fp_add!(8, 24)>::default();
//! adder.connect_all();
//! let adder = flatten(&elaborate(&adder, "adder")?)?;
//!
//! let mut simulation = Evaluator::new(&adder);
//! let inputs = [("en_i", 1), ("a_i", f32::to_bits(1.5)), ("b_i", f32::to_bits(2.25))];
//! for (name, value) in inputs {
//!     simulation.set_input(adder.input(name).expect("a port of the adder"), value.into());
//! }
//! for _cycle in 0..2 {
//!     simulation.settle();
//!     simulation.clock();
//! }
//! simulation.settle();
//! let sum = simulation.output(adder.output("result_o").expect("a port of the adder"));
//! assert_eq!(sum, f32::to_bits(3.75).into());
//! # Ok::<(), netlist::ElaborateError>(())
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
pub use significand_product::{SignificandProduct, half};

/// The source file of each kind of module, for what is exported with its comments.
pub const SOURCES: &[(&str, &str)] = &[
    ("delay", include_str!("blocks/delay.rs")),
    ("fp_add", include_str!("fp_add.rs")),
    ("fp_cmp", include_str!("fp_cmp.rs")),
    ("fp_min_max", include_str!("fp_min_max.rs")),
    ("fp_mul", include_str!("fp_mul.rs")),
    ("fp_unpack", include_str!("fp_unpack.rs")),
    ("int_add", include_str!("int_add.rs")),
    ("leading_zeros", include_str!("leading_zeros.rs")),
    ("rounder", include_str!("rounder.rs")),
    ("significand_product", include_str!("significand_product.rs")),
    ("sticky_shift", include_str!("sticky_shift.rs")),
];

use fp_unpack::FpUnpack;
use leading_zeros::LeadingZeros;
use rounder::Rounder;
use sticky_shift::StickyShift;
