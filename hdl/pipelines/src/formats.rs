//! Modules by name and format, with the derived widths filled in.
//!
//! `units::fp_add!(5, 11)` is the adder type with 5 exponent and 11 significand bits; the modules of this file name
//! those of the common formats, such as [`binary16::FpAdd`]. The tag is one bit wide unless a third argument says
//! otherwise.

/// The [`DualSplitPipeline`](crate::DualSplitPipeline) with the given exponent bits, significand bits, role
/// comparators (2 as published, or 0) and tag bits.
#[macro_export]
macro_rules! dual_split {
    ($e:expr, $s:expr, $c:expr, $t:expr) => {
        $crate::in_format!([$crate::DualSplitPipeline] [W X R N P] $e, $s, $c, $t)
    };
}

/// The [`RayBoxPipeline`](crate::RayBoxPipeline) with the given exponent bits, significand bits, comparators (2
/// as published, or 1) and tag bits.
#[macro_export]
macro_rules! ray_box {
    ($e:expr, $s:expr, $c:expr, $t:expr) => {
        $crate::in_format!([$crate::RayBoxPipeline] [W X R N P] $e, $s, $c, $t)
    };
}

/// The [`RayBoxParallel`](crate::RayBoxParallel) with the given exponent bits, significand bits, boxes, comparators
/// for each box and tag bits.
#[macro_export]
macro_rules! ray_box_parallel {
    ($e:expr, $s:expr, $k:expr, $c:expr, $t:expr) => {
        $crate::in_format!([$crate::RayBoxParallel] [W X R N P] $e, $s, $k, $c, $t)
    };
}

/// The [`SharedUnits`](crate::SharedUnits) with the given exponent bits, significand bits and tag bits.
#[macro_export]
macro_rules! shared_units {
    ($e:expr, $s:expr, $t:expr) => {
        $crate::in_format!([$crate::SharedUnits] [W X R N P] $e, $s, $t)
    };
}

macro_rules! formats {
    ($($(#[$doc:meta])* $format:ident: $e:literal, $s:literal;)*) => { $(
        $(#[$doc])*
        pub mod $format {
            /// Adder and subtractor.
            pub type FpAdd = units::fp_add!($e, $s);
            /// Multiplier.
            pub type FpMul = units::fp_mul!($e, $s);
            /// Minimum and maximum.
            pub type FpMinMax = units::fp_min_max!($e, $s);
            /// Comparison.
            pub type FpCmp = units::fp_cmp!($e, $s);
            /// Dual-split pipeline with the published inventory.
            pub type DualSplitPipeline = dual_split!($e, $s, 2, 1);
            /// Ray-box pipeline with the published inventory.
            pub type RayBoxPipeline = ray_box!($e, $s, 2, 1);
        }
    )* };
}

formats! {
    /// IEEE 754 single precision.
    binary32: 8, 24;
    /// Single precision's range with half precision's significand.
    tf32: 8, 11;
    /// The upper half of a binary32.
    bfloat16: 8, 8;
    /// IEEE 754 half precision.
    binary16: 5, 11;
    /// The upper half of a binary16.
    e5m2: 5, 3;
    /// Eight bits with four of exponent.
    e4m3: 4, 4;
}

/// Dual-split pipeline in binary32 without redundant comparators.
pub type DualSplitPipelineLean = dual_split!(8, 24, 0, 1);
/// Ray-box pipeline in binary32 without redundant comparators.
pub type RayBoxPipelineLean = ray_box!(8, 24, 1, 1);
/// Two ray-box pipelines in binary32.
pub type RayBoxX2 = ray_box_parallel!(8, 24, 2, 2, 1);
/// Four ray-box pipelines in binary32.
pub type RayBoxX4 = ray_box_parallel!(8, 24, 4, 2, 1);
/// Eight ray-box pipelines in binary32.
pub type RayBoxX8 = ray_box_parallel!(8, 24, 8, 2, 1);
/// The multiprocessor's shared units in binary32, with both pipelines' routing.
pub type SharedUnits = shared_units!(8, 24, 1);
