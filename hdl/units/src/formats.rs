//! Units by format, with the derived widths filled in: `units::fp_add!(5, 11)` is the adder type with 5 exponent and 11
//! significand bits. The tag is one bit wide unless a third argument says otherwise.

/// The [`FpAdd`](crate::FpAdd) with the given exponent bits, significand bits and tag bits.
#[macro_export]
macro_rules! fp_add {
    ($e:expr, $s:expr) => { $crate::fp_add!($e, $s, 1) };
    ($e:expr, $s:expr, $t:expr) => {
        $crate::FpAdd<{ $e }, { $s }, { $e + $s }, { $e + 2 }, { $s + 2 }, { $s + 4 }, { $t }>
    };
}

/// The [`FpMul`](crate::FpMul) with the given exponent bits, significand bits and tag bits.
#[macro_export]
macro_rules! fp_mul {
    ($e:expr, $s:expr) => { $crate::fp_mul!($e, $s, 1) };
    ($e:expr, $s:expr, $t:expr) => {
        $crate::FpMul<{ $e }, { $s }, { $e + $s }, { $e + 2 }, { $s + 2 }, { 2 * $s }, { $t }>
    };
}
