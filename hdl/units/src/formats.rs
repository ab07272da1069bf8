//! Units by format: `units::fp_add!(5, 11)` is the adder type with 5 exponent and 11 significand bits.
//!
//! The tag is one bit wide unless a third argument says otherwise. Without arguments, in a module whose generics are called as
//! in [`widths`](crate::widths), a macro names the unit of that module's format.

/// The [`FpAdd`](crate::FpAdd) with the given exponent bits, significand bits and tag bits.
#[macro_export]
macro_rules! fp_add {
    () => { $crate::FpAdd<E, S, W, X, R, N, 1> };
    ($e:expr, $s:expr) => { $crate::fp_add!($e, $s, 1) };
    ($e:expr, $s:expr, $t:expr) => { $crate::in_format!([$crate::FpAdd] [W X R N] $e, $s, $t) };
}

/// The [`FpMul`](crate::FpMul) with the given exponent bits, significand bits and tag bits.
#[macro_export]
macro_rules! fp_mul {
    () => { $crate::FpMul<E, S, W, X, R, P, 1> };
    ($e:expr, $s:expr) => { $crate::fp_mul!($e, $s, 1) };
    ($e:expr, $s:expr, $t:expr) => { $crate::in_format!([$crate::FpMul] [W X R P] $e, $s, $t) };
}

/// The [`FpMinMax`](crate::FpMinMax) with the given exponent bits, significand bits and tag bits.
#[macro_export]
macro_rules! fp_min_max {
    () => { $crate::FpMinMax<E, S, W, 1> };
    ($e:expr, $s:expr) => { $crate::fp_min_max!($e, $s, 1) };
    ($e:expr, $s:expr, $t:expr) => { $crate::in_format!([$crate::FpMinMax] [W] $e, $s, $t) };
}

/// The [`FpCmp`](crate::FpCmp) with the given exponent bits, significand bits and tag bits.
#[macro_export]
macro_rules! fp_cmp {
    () => { $crate::FpCmp<E, S, W, 1> };
    ($e:expr, $s:expr) => { $crate::fp_cmp!($e, $s, 1) };
    ($e:expr, $s:expr, $t:expr) => { $crate::in_format!([$crate::FpCmp] [W] $e, $s, $t) };
}
