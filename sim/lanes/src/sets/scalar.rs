//! One lane at a time: for any machine, and for a single vector.

use super::{Bits, LANES, Row, derived_operations};

/// One bit.
pub type Bit = bool;
/// Up to 32 bits.
pub type Word = u32;
/// Up to 64 bits.
pub type Double = u64;

/// Chunks that the lanes are worked on in.
pub const CHUNKS: usize = LANES;

/// Operations of two operands that need no more than an expression.
macro_rules! operations {
    ($($name:ident($($operand:ident: $type:ty),*) -> $result:ty = $value:expr;)*) => { $(
        #[doc = concat!("See [`super`]: `", stringify!($value), "`.")]
        #[inline]
        pub fn $name($($operand: $type),*) -> $result {
            $value
        }
    )* };
}

operations! {
    bit(x: bool) -> Bit = x;
    word(x: u32) -> Word = x;
    double(x: u64) -> Double = x;
    and_b(a: Bit, b: Bit) -> Bit = a & b;
    or_b(a: Bit, b: Bit) -> Bit = a | b;
    xor_b(a: Bit, b: Bit) -> Bit = a ^ b;
    not_b(a: Bit) -> Bit = !a;
    and_w(a: Word, b: Word) -> Word = a & b;
    or_w(a: Word, b: Word) -> Word = a | b;
    xor_w(a: Word, b: Word) -> Word = a ^ b;
    add_w(a: Word, b: Word) -> Word = a.wrapping_add(b);
    sub_w(a: Word, b: Word) -> Word = a.wrapping_sub(b);
    mul_w(a: Word, b: Word) -> Word = a.wrapping_mul(b);
    shl_w(a: Word, b: Word) -> Word = a.checked_shl(b).unwrap_or(0);
    shr_w(a: Word, b: Word) -> Word = a.checked_shr(b).unwrap_or(0);
    leading_zeros_w(a: Word) -> Word = a.leading_zeros();
    eq_w(a: Word, b: Word) -> Bit = a == b;
    ne_w(a: Word, b: Word) -> Bit = a != b;
    lt_w(a: Word, b: Word) -> Bit = a < b;
    le_w(a: Word, b: Word) -> Bit = a <= b;
    signed_lt_w(a: Word, b: Word) -> Bit = (a as i32) < b as i32;
    signed_le_w(a: Word, b: Word) -> Bit = a as i32 <= b as i32;
    select_w(select: Bit, when_true: Word, when_false: Word) -> Word = if select { when_true } else { when_false };
    and_d(a: Double, b: Double) -> Double = a & b;
    or_d(a: Double, b: Double) -> Double = a | b;
    xor_d(a: Double, b: Double) -> Double = a ^ b;
    add_d(a: Double, b: Double) -> Double = a.wrapping_add(b);
    sub_d(a: Double, b: Double) -> Double = a.wrapping_sub(b);
    mul_d(a: Double, b: Double) -> Double = a.wrapping_mul(b);
    mul_wide(a: Word, b: Word) -> Double = u64::from(a) * u64::from(b);
    shl_d(a: Double, b: Word) -> Double = a.checked_shl(b).unwrap_or(0);
    shr_d(a: Double, b: Word) -> Double = a.checked_shr(b).unwrap_or(0);
    eq_d(a: Double, b: Double) -> Bit = a == b;
    ne_d(a: Double, b: Double) -> Bit = a != b;
    lt_d(a: Double, b: Double) -> Bit = a < b;
    le_d(a: Double, b: Double) -> Bit = a <= b;
    signed_lt_d(a: Double, b: Double) -> Bit = (a as i64) < b as i64;
    signed_le_d(a: Double, b: Double) -> Bit = a as i64 <= b as i64;
    select_d(select: Bit, when_true: Double, when_false: Double) -> Double = if select { when_true } else { when_false };
    widen(a: Word) -> Double = u64::from(a);
    narrow(a: Double) -> Word = a as u32;
}

/// Shifts by a constant.
macro_rules! constant_shifts {
    ($($name:ident($type:ty) = |$operand:ident, $amount:ident| $value:expr;)*) => { $(
        #[doc = concat!("See [`super`]: `", stringify!($value), "`.")]
        #[inline]
        pub fn $name<const $amount: u32>($operand: $type) -> $type {
            $value
        }
    )* };
}

constant_shifts! {
    shl_const_w(Word) = |a, N| a << N;
    shr_const_w(Word) = |a, N| a >> N;
    sar_const_w(Word) = |a, N| (a as i32 >> N) as u32;
    shl_const_d(Double) = |a, N| a << N;
    shr_const_d(Double) = |a, N| a >> N;
    sar_const_d(Double) = |a, N| (a as i64 >> N) as u64;
}

derived_operations! {}

/// Whether a bit is set in all lanes of a chunk.
#[inline]
pub fn all_set(bits: Bits, chunk: usize) -> bool {
    bits.0 >> chunk & 1 == 1
}

/// Reads a bit.
#[inline]
pub fn load_b<const N: usize>(bits: &[Bits; N], at: usize, chunk: usize) -> Bit {
    bits[at].0 >> chunk & 1 == 1
}

/// Writes a bit.
#[inline]
pub fn store_b<const N: usize>(bits: &mut [Bits; N], at: usize, chunk: usize, value: Bit) {
    bits[at].0 = bits[at].0 & !(1 << chunk) | u16::from(value) << chunk;
}

/// Reads a word.
#[inline]
pub fn load_w<const N: usize>(rows: &[Row; N], at: usize, chunk: usize) -> Word {
    rows[at].0[chunk]
}

/// Writes a word.
#[inline]
pub fn store_w<const N: usize>(rows: &mut [Row; N], at: usize, chunk: usize, value: Word) {
    rows[at].0[chunk] = value;
}

/// Reads a double.
#[inline]
pub fn load_d<const N: usize>(rows: &[Row; N], at: usize, chunk: usize) -> Double {
    u64::from(rows[at].0[chunk]) | u64::from(rows[at + 1].0[chunk]) << 32
}

/// Writes a double.
#[inline]
pub fn store_d<const N: usize>(rows: &mut [Row; N], at: usize, chunk: usize, value: Double) {
    rows[at].0[chunk] = value as u32;
    rows[at + 1].0[chunk] = (value >> 32) as u32;
}
