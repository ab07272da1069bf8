//! C's `<stdint.h>` types as `softfloat-sys` uses them.
//!
//! The registry's crate of this name runs CMake to measure these types. `softfloat-sys` builds for x86-64 Linux
//! alone, where the System V ABI fixes them, so that this replacement (see `[patch]` in the workspace manifest) needs
//! no tool.
#![allow(non_camel_case_types)]

/// `int_fast32_t`.
pub type int_fast32_t = i64;
/// `int_fast64_t`.
pub type int_fast64_t = i64;
/// `uint_fast8_t`.
pub type uint_fast8_t = u8;
/// `uint_fast32_t`.
pub type uint_fast32_t = u64;
/// `uint_fast64_t`.
pub type uint_fast64_t = u64;
