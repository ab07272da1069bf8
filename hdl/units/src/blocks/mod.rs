//! Building blocks without arithmetic meaning: the ports of a clocked module, register, delay line.

mod clock_enable;
mod delay;
mod dff;

pub use crate::{dff_setup, module};
pub use clock_enable::ClockEnable;
pub use delay::Delay;
pub use dff::{Dff, Valid};

/// `Self` with the constants on the left of the semicolon and the defaults of the fields on its right.
#[macro_export]
macro_rules! module {
    ($($constant:ident = $value:expr),* ; $($field:ident),* $(,)?) => {
        Self { $($constant: $value,)* $($field: Default::default(),)* }
    };
}
