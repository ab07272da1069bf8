//! Sixteen lanes at a time with AVX-512; bits are mask registers.

use super::{Bits, Row, derived_operations, doubles_of_words};
use std::arch::x86_64::*;

/// A bit of each lane.
pub type Bit = __mmask16;
/// Up to 32 bits of each lane.
pub type Word = __m512i;

/// Chunks that the lanes are worked on in.
pub const CHUNKS: usize = 1;

macro_rules! operations {
    ($($name:ident($($operand:ident: $type:ty),*) -> $result:ty = $value:expr;)*) => { $(
        #[doc = concat!("See [`super`]: `", stringify!($value), "`.")]
        #[inline]
        #[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq")]
        pub fn $name($($operand: $type),*) -> $result {
            $value
        }
    )* };
}

macro_rules! constant_shifts {
    ($($name:ident = $intrinsic:ident;)*) => { $(
        #[doc = concat!("See [`super`]: `", stringify!($intrinsic), "`.")]
        #[inline]
        #[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq")]
        pub fn $name<const N: u32>(a: Word) -> Word {
            $intrinsic::<N>(a)
        }
    )* };
}

operations! {
    bit(x: bool) -> Bit = if x { u16::MAX } else { 0 };
    word(x: u32) -> Word = _mm512_set1_epi32(x as i32);
    and_b(a: Bit, b: Bit) -> Bit = a & b;
    or_b(a: Bit, b: Bit) -> Bit = a | b;
    xor_b(a: Bit, b: Bit) -> Bit = a ^ b;
    not_b(a: Bit) -> Bit = !a;
    and_w(a: Word, b: Word) -> Word = _mm512_and_si512(a, b);
    or_w(a: Word, b: Word) -> Word = _mm512_or_si512(a, b);
    xor_w(a: Word, b: Word) -> Word = _mm512_xor_si512(a, b);
    add_w(a: Word, b: Word) -> Word = _mm512_add_epi32(a, b);
    sub_w(a: Word, b: Word) -> Word = _mm512_sub_epi32(a, b);
    mul_w(a: Word, b: Word) -> Word = _mm512_mullo_epi32(a, b);
    shl_w(a: Word, b: Word) -> Word = _mm512_sllv_epi32(a, b);
    shr_w(a: Word, b: Word) -> Word = _mm512_srlv_epi32(a, b);
    eq_w(a: Word, b: Word) -> Bit = _mm512_cmpeq_epu32_mask(a, b);
    ne_w(a: Word, b: Word) -> Bit = _mm512_cmpneq_epu32_mask(a, b);
    lt_w(a: Word, b: Word) -> Bit = _mm512_cmplt_epu32_mask(a, b);
    le_w(a: Word, b: Word) -> Bit = _mm512_cmple_epu32_mask(a, b);
    signed_lt_w(a: Word, b: Word) -> Bit = _mm512_cmplt_epi32_mask(a, b);
    signed_le_w(a: Word, b: Word) -> Bit = _mm512_cmple_epi32_mask(a, b);
    select_w(select: Bit, when_true: Word, when_false: Word) -> Word =
        _mm512_mask_blend_epi32(select, when_false, when_true);
    leading_zeros_w(a: Word) -> Word = _mm512_lzcnt_epi32(a);
    mul_wide(a: Word, b: Word) -> Double = {
        // Products of the even lanes and of the odd ones, 64 bits each.
        let even = _mm512_mul_epu32(a, b);
        let odd = _mm512_mul_epu32(_mm512_srli_epi64::<32>(a), _mm512_srli_epi64::<32>(b));
        Double {
            low: _mm512_mask_blend_epi32(0xaaaa, even, _mm512_slli_epi64::<32>(odd)),
            high: _mm512_mask_blend_epi32(0xaaaa, _mm512_srli_epi64::<32>(even), odd),
        }
    };
}

constant_shifts! {
    shl_const_w = _mm512_slli_epi32;
    shr_const_w = _mm512_srli_epi32;
    sar_const_w = _mm512_srai_epi32;
}

doubles_of_words! { #[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq")] }
derived_operations! { #[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq")] }

/// Whether a bit is set in all lanes of a chunk.
#[inline]
pub fn all_set(bits: Bits, _chunk: usize) -> bool {
    bits.0 == u16::MAX
}

/// Reads a bit of each lane.
#[inline]
#[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq")]
pub fn load_b<const N: usize>(bits: &[Bits; N], at: usize, _chunk: usize) -> Bit {
    bits[at].0
}

/// Writes a bit of each lane.
#[inline]
#[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq")]
pub fn store_b<const N: usize>(bits: &mut [Bits; N], at: usize, _chunk: usize, value: Bit) {
    bits[at].0 = value;
}

/// Reads a word of each lane.
#[inline]
#[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq")]
pub fn load_w<const N: usize>(rows: &[Row; N], at: usize, _chunk: usize) -> Word {
    // SAFETY: a row is as large as a vector and aligned like one.
    unsafe { _mm512_load_si512(std::ptr::from_ref(&rows[at]).cast()) }
}

/// Writes a word of each lane.
#[inline]
#[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq")]
pub fn store_w<const N: usize>(rows: &mut [Row; N], at: usize, _chunk: usize, value: Word) {
    // SAFETY: as in `load_w`.
    unsafe { _mm512_store_si512(std::ptr::from_mut(&mut rows[at]).cast(), value) }
}
