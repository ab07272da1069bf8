//! The relations between a format and the widths of its modules.

use fp::Format;

/// The format with `E` exponent and `S` significand bits.
///
/// # Panics
/// If the units do not support it.
#[must_use]
pub fn format<const E: usize, const S: usize>() -> Format {
    Format::new(E as u32, S as u32).unwrap_or_else(|error| panic!("{error}"))
}

/// Asserts, when a module is instantiated, that its derived widths fit its format.
#[macro_export]
macro_rules! check_widths {
    ($($relation:expr),+ $(,)?) => {
        const { $(assert!($relation, "a width does not follow from the format: see the table in the crate's root");)+ }
    };
}
pub use crate::check_widths;
