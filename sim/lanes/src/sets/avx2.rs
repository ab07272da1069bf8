//! Eight lanes at a time with AVX2; a bit is a word of all ones or zeros.

use super::{Bits, LANES, Row, derived_operations, doubles_of_words};
use std::arch::x86_64::*;

/// A bit of each lane, in all bits of a word.
pub type Bit = __m256i;
/// Up to 32 bits of each lane.
pub type Word = __m256i;

/// Chunks that the lanes are worked on in.
pub const CHUNKS: usize = 2;
const CHUNK_LANES: usize = LANES / CHUNKS;

macro_rules! operations {
    ($($name:ident($($operand:ident: $type:ty),*) -> $result:ty = $value:expr;)*) => { $(
        #[doc = concat!("See [`super`]: `", stringify!($value), "`.")]
        #[inline]
        #[target_feature(enable = "avx2")]
        pub fn $name($($operand: $type),*) -> $result {
            $value
        }
    )* };
}

macro_rules! constant_shifts {
    ($($name:ident = $intrinsic:ident;)*) => { $(
        #[doc = concat!("See [`super`]: `", stringify!($intrinsic), "`.")]
        #[inline]
        #[target_feature(enable = "avx2")]
        pub fn $name<const N: u32>(a: Word) -> Word {
            // The compiler knows the amount, and makes the instruction with an immediate amount of this.
            $intrinsic(a, _mm_cvtsi32_si128(N as i32))
        }
    )* };
}

operations! {
    bit(x: bool) -> Bit = _mm256_set1_epi32(if x { -1 } else { 0 });
    word(x: u32) -> Word = _mm256_set1_epi32(x as i32);
    and_b(a: Bit, b: Bit) -> Bit = _mm256_and_si256(a, b);
    or_b(a: Bit, b: Bit) -> Bit = _mm256_or_si256(a, b);
    xor_b(a: Bit, b: Bit) -> Bit = _mm256_xor_si256(a, b);
    not_b(a: Bit) -> Bit = _mm256_xor_si256(a, _mm256_set1_epi32(-1));
    and_w(a: Word, b: Word) -> Word = _mm256_and_si256(a, b);
    or_w(a: Word, b: Word) -> Word = _mm256_or_si256(a, b);
    xor_w(a: Word, b: Word) -> Word = _mm256_xor_si256(a, b);
    add_w(a: Word, b: Word) -> Word = _mm256_add_epi32(a, b);
    sub_w(a: Word, b: Word) -> Word = _mm256_sub_epi32(a, b);
    mul_w(a: Word, b: Word) -> Word = _mm256_mullo_epi32(a, b);
    shl_w(a: Word, b: Word) -> Word = _mm256_sllv_epi32(a, b);
    shr_w(a: Word, b: Word) -> Word = _mm256_srlv_epi32(a, b);
    eq_w(a: Word, b: Word) -> Bit = _mm256_cmpeq_epi32(a, b);
    ne_w(a: Word, b: Word) -> Bit = not_b(_mm256_cmpeq_epi32(a, b));
    lt_w(a: Word, b: Word) -> Bit = not_b(le_w(b, a));
    le_w(a: Word, b: Word) -> Bit = _mm256_cmpeq_epi32(_mm256_min_epu32(a, b), a);
    signed_lt_w(a: Word, b: Word) -> Bit = _mm256_cmpgt_epi32(b, a);
    signed_le_w(a: Word, b: Word) -> Bit = not_b(_mm256_cmpgt_epi32(a, b));
    select_w(select: Bit, when_true: Word, when_false: Word) -> Word =
        _mm256_blendv_epi8(when_false, when_true, select);
    leading_zeros_w(a: Word) -> Word = {
        // The exponent of the number as a float. The bit below the leading one is cleared, so that the conversion
        // does not round up to a power of two. A set top bit makes the float negative, and with it the difference.
        let clear = _mm256_andnot_si256(_mm256_srli_epi32::<1>(a), a);
        let exponent = _mm256_srli_epi32::<23>(_mm256_castps_si256(_mm256_cvtepi32_ps(clear)));
        _mm256_max_epi32(_mm256_sub_epi32(word(158), exponent), word(0))
    };
    mul_wide(a: Word, b: Word) -> Double = {
        // Products of the even lanes and of the odd ones, 64 bits each.
        let even = _mm256_mul_epu32(a, b);
        let odd = _mm256_mul_epu32(_mm256_srli_epi64::<32>(a), _mm256_srli_epi64::<32>(b));
        Double {
            low: _mm256_blend_epi32::<0b1010_1010>(even, _mm256_slli_epi64::<32>(odd)),
            high: _mm256_blend_epi32::<0b1010_1010>(_mm256_srli_epi64::<32>(even), odd),
        }
    };
}

constant_shifts! {
    shl_const_w = _mm256_sll_epi32;
    shr_const_w = _mm256_srl_epi32;
    sar_const_w = _mm256_sra_epi32;
}

doubles_of_words! { #[target_feature(enable = "avx2")] }
derived_operations! { #[target_feature(enable = "avx2")] }

/// Whether a bit is set in all lanes of a chunk.
#[inline]
pub fn all_set(bits: Bits, chunk: usize) -> bool {
    bits.0 >> (CHUNK_LANES * chunk) & 0xff == 0xff
}

/// Reads a bit of each lane.
#[inline]
#[target_feature(enable = "avx2")]
pub fn load_b<const N: usize>(bits: &[Bits; N], at: usize, chunk: usize) -> Bit {
    let own = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    let all = _mm256_set1_epi32(i32::from(bits[at].0 >> (CHUNK_LANES * chunk)));
    _mm256_cmpeq_epi32(_mm256_and_si256(all, own), own)
}

/// Writes a bit of each lane.
#[inline]
#[target_feature(enable = "avx2")]
pub fn store_b<const N: usize>(bits: &mut [Bits; N], at: usize, chunk: usize, value: Bit) {
    let shift = CHUNK_LANES * chunk;
    let new = _mm256_movemask_ps(_mm256_castsi256_ps(value)) as u16;
    bits[at].0 = bits[at].0 & !(0xff << shift) | new << shift;
}

/// Reads a word of each lane.
#[inline]
#[target_feature(enable = "avx2")]
pub fn load_w<const N: usize>(rows: &[Row; N], at: usize, chunk: usize) -> Word {
    let half: &[u32; CHUNK_LANES] = rows[at].0.as_chunks().0.get(chunk).expect("one of two chunks");
    // SAFETY: half a row is as large as a vector and, since rows are aligned to 64 bytes, aligned like one.
    unsafe { _mm256_load_si256(half.as_ptr().cast()) }
}

/// Writes a word of each lane.
#[inline]
#[target_feature(enable = "avx2")]
pub fn store_w<const N: usize>(rows: &mut [Row; N], at: usize, chunk: usize, value: Word) {
    let half: &mut [u32; CHUNK_LANES] =
        rows[at].0.as_chunks_mut().0.get_mut(chunk).expect("one of two chunks");
    // SAFETY: as in `load_w`.
    unsafe { _mm256_store_si256(half.as_mut_ptr().cast(), value) }
}
