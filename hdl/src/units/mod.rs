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
//! What the results are bit for bit is stated by [`golden::fp::Arithmetic`].

mod fp_cmp;
mod fp_min_max;
mod int_add;

pub use fp_cmp::FpCmp;
pub use fp_min_max::FpMinMax;
pub use int_add::IntAdd;
