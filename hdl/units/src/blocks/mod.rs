//! Building blocks without arithmetic meaning: register, delay line.

mod delay;
mod dff;

pub use crate::{dff_setup, module};
pub use delay::Delay;
pub use dff::Dff;

/// `Self` with the constants on the left of the semicolon and the defaults of the fields on its right.
#[macro_export]
macro_rules! module {
    ($($constant:ident = $value:expr),* ; $($field:ident),* $(,)?) => {
        Self { $($constant: $value,)* $($field: Default::default(),)* }
    };
}
