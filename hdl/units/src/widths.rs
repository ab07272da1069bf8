//! The widths that follow from a format, for every module and for those who name one.
//!
//! A module's generics are the exponent bits `E` and the significand bits `S` with the hidden one, the widths below that it
//! needs, in the order of the table, and its own, such as the bits `T` of the tag. Rust cannot compute a type's width
//! from another generic, which is why a module has them as generics; [`check_widths!`](crate::check_widths) holds them to the
//! table, and the macros named like the modules, such as [`fp_add!`](crate::fp_add), fill them in.
//!
//! | generic | what is so wide | bits |
//! |---|---|---|
//! | `W` | a word | `E + S` |
//! | `X` | an exponent in computation, with its sign | `E + 2` |
//! | `R` | a significand with round and sticky bit | `S + 2` |
//! | `N` | an aligned significand, and the sum of two | `S + 4` |
//! | `P` | the product of two significands | `2 S` |

use fp::Format;

/// The format with `E` exponent and `S` significand bits.
///
/// # Panics
/// If the units do not support it.
#[must_use]
pub fn format<const E: usize, const S: usize>() -> Format {
    Format::new(E as u32, S as u32).unwrap_or_else(|error| panic!("{error}"))
}

/// The width that the table of [`widths`](crate::widths) calls by the given letter, of the format with the given exponent and
/// significand bits.
#[macro_export]
macro_rules! derived_width {
    (W, $e:expr, $s:expr) => {
        $e + $s
    };
    (X, $e:expr, $s:expr) => {
        $e + 2
    };
    (R, $e:expr, $s:expr) => {
        $s + 2
    };
    (N, $e:expr, $s:expr) => {
        $s + 4
    };
    (P, $e:expr, $s:expr) => {
        2 * $s
    };
}

/// Asserts, when a module is instantiated, that its listed generics are the widths of its format `E`, `S`.
#[macro_export]
macro_rules! check_widths {
    ($($width:ident),+) => {
        const { $(assert!(
            $width == $crate::derived_width!($width, E, S),
            "a width does not follow from the format: see the table in units::widths"
        );)+ }
    };
}

/// A module's type in a format: `in_format!([FpAdd] [W X R N] 5, 11, 1)` is `FpAdd<5, 11, 16, 7, 13, 15, 1>`.
#[macro_export]
macro_rules! in_format {
    ([$($module:tt)+] [$($width:ident)*] $e:expr, $s:expr $(, $own:expr)*) => {
        $($module)+<{ $e }, { $s }, $({ $crate::derived_width!($width, $e, $s) },)* $({ $own }),*>
    };
}

pub use crate::{check_widths, derived_width, in_format};
