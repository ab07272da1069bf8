//! Four `f32` lanes: SSE2 where there is x86-64, plain arrays elsewhere, with the same results bit for bit.
//!
//! Only operations that IEEE 754 defines lane by lane are here, so both versions agree. [`F32x4::max`] and
//! [`F32x4::min`] are the native ones: the second operand where either is NaN or both are zeros.

#[cfg(target_arch = "x86_64")]
mod lanes {
    use std::arch::x86_64::*;

    /// Four lanes.
    #[derive(Clone, Copy)]
    pub struct F32x4(__m128);

    // SAFETY: every intrinsic below is part of SSE or SSE2, which x86-64 always has; `load` reads 16 bytes of
    // an array of that size.
    impl F32x4 {
        #[inline(always)]
        pub fn new(x: [f32; 4]) -> Self {
            Self::load(&x)
        }
        #[inline(always)]
        pub fn splat(x: f32) -> Self {
            unsafe { Self(_mm_set1_ps(x)) }
        }
        #[inline(always)]
        pub fn load(x: &[f32; 4]) -> Self {
            unsafe { Self(_mm_loadu_ps(x.as_ptr())) }
        }
        #[inline(always)]
        pub fn store(self, to: &mut [f32; 4]) {
            unsafe { _mm_storeu_ps(to.as_mut_ptr(), self.0) }
        }
        #[inline(always)]
        pub fn pairs(low: &[f32; 2], high: &[f32; 2]) -> Self {
            unsafe {
                Self(_mm_castpd_ps(_mm_loadh_pd(_mm_load_sd(low.as_ptr().cast()), high.as_ptr().cast())))
            }
        }
        #[inline(always)]
        pub fn shuffle<const LANES: i32>(self, b: Self) -> Self {
            unsafe { Self(_mm_shuffle_ps::<LANES>(self.0, b.0)) }
        }
        #[inline(always)]
        pub fn sign_bits(self) -> u32 {
            unsafe { _mm_movemask_ps(self.0) as u32 }
        }
        #[inline(always)]
        pub fn xxyy(xy: &[f32; 2]) -> Self {
            let xy = Self::pairs(xy, &[0.0; 2]);
            xy.interleave_low(xy)
        }
        #[inline(always)]
        pub fn negated(self) -> Self {
            unsafe { Self(_mm_xor_ps(_mm_set1_ps(-0.0), self.0)) }
        }
        #[inline(always)]
        pub fn w(self) -> f32 {
            unsafe { _mm_cvtss_f32(_mm_shuffle_ps::<0b11_11_11_11>(self.0, self.0)) }
        }
        #[inline(always)]
        pub fn to_array(self) -> [f32; 4] {
            let mut x = [0.0; 4];
            unsafe { _mm_storeu_ps(x.as_mut_ptr(), self.0) };
            x
        }
        #[inline(always)]
        pub fn sub(self, b: Self) -> Self {
            unsafe { Self(_mm_sub_ps(self.0, b.0)) }
        }
        #[inline(always)]
        pub fn mul(self, b: Self) -> Self {
            unsafe { Self(_mm_mul_ps(self.0, b.0)) }
        }
        #[inline(always)]
        pub fn max(self, b: Self) -> Self {
            unsafe { Self(_mm_max_ps(self.0, b.0)) }
        }
        #[inline(always)]
        pub fn min(self, b: Self) -> Self {
            unsafe { Self(_mm_min_ps(self.0, b.0)) }
        }
        #[inline(always)]
        pub fn abs(self) -> Self {
            unsafe { Self(_mm_andnot_ps(_mm_set1_ps(-0.0), self.0)) }
        }
        #[inline(always)]
        pub fn gt(self, b: Self) -> u32 {
            unsafe { _mm_movemask_ps(_mm_cmpgt_ps(self.0, b.0)) as u32 }
        }
        #[inline(always)]
        pub fn le(self, b: Self) -> u32 {
            unsafe { _mm_movemask_ps(_mm_cmple_ps(self.0, b.0)) as u32 }
        }
        #[inline(always)]
        pub fn yzx(self) -> Self {
            unsafe { Self(_mm_shuffle_ps::<0b11_00_10_01>(self.0, self.0)) }
        }
        #[inline(always)]
        pub fn zxy(self) -> Self {
            unsafe { Self(_mm_shuffle_ps::<0b11_01_00_10>(self.0, self.0)) }
        }
        #[inline(always)]
        pub fn zwxy(self) -> Self {
            unsafe { Self(_mm_movehl_ps(self.0, self.0)) }
        }
        #[inline(always)]
        pub fn x(self) -> f32 {
            unsafe { _mm_cvtss_f32(self.0) }
        }
        #[inline(always)]
        pub fn yzwx(self) -> Self {
            unsafe { Self(_mm_shuffle_ps::<0b00_11_10_01>(self.0, self.0)) }
        }
        #[inline(always)]
        pub fn or(self, mask: Self) -> Self {
            unsafe { Self(_mm_or_ps(self.0, mask.0)) }
        }
        #[inline(always)]
        pub fn or_not(self, mask: Self) -> Self {
            unsafe {
                let ones = _mm_castsi128_ps(_mm_set1_epi32(-1));
                Self(_mm_or_ps(self.0, _mm_xor_ps(mask.0, ones)))
            }
        }
        #[inline(always)]
        pub fn interleave_low(self, b: Self) -> Self {
            unsafe { Self(_mm_unpacklo_ps(self.0, b.0)) }
        }
        #[inline(always)]
        pub fn interleave_high(self, b: Self) -> Self {
            unsafe { Self(_mm_unpackhi_ps(self.0, b.0)) }
        }
        #[inline(always)]
        pub fn y(self) -> f32 {
            unsafe { _mm_cvtss_f32(_mm_shuffle_ps::<0b01_01_01_01>(self.0, self.0)) }
        }
        #[inline(always)]
        pub fn z(self) -> f32 {
            unsafe { _mm_cvtss_f32(_mm_movehl_ps(self.0, self.0)) }
        }
        #[inline(always)]
        pub fn exchange(self, b: Self, mask: Self) -> (Self, Self) {
            unsafe {
                let x = _mm_and_ps(_mm_xor_ps(self.0, b.0), mask.0);
                (Self(_mm_xor_ps(self.0, x)), Self(_mm_xor_ps(b.0, x)))
            }
        }
    }
}

#[cfg(not(target_arch = "x86_64"))]
mod lanes {
    use std::array::from_fn;

    /// Four lanes.
    #[derive(Clone, Copy)]
    pub struct F32x4([f32; 4]);

    impl F32x4 {
        #[inline(always)]
        pub fn new(x: [f32; 4]) -> Self {
            Self(x)
        }
        #[inline(always)]
        pub fn splat(x: f32) -> Self {
            Self([x; 4])
        }
        #[inline(always)]
        pub fn load(x: &[f32; 4]) -> Self {
            Self(*x)
        }
        #[inline(always)]
        pub fn store(self, to: &mut [f32; 4]) {
            *to = self.0;
        }
        #[inline(always)]
        pub fn pairs([x, y]: &[f32; 2], [z, w]: &[f32; 2]) -> Self {
            Self([*x, *y, *z, *w])
        }
        #[inline(always)]
        pub fn shuffle<const LANES: i32>(self, b: Self) -> Self {
            let lane = |i: i32| (LANES >> (2 * i) & 3) as usize;
            Self([self.0[lane(0)], self.0[lane(1)], b.0[lane(2)], b.0[lane(3)]])
        }
        #[inline(always)]
        pub fn sign_bits(self) -> u32 {
            (0..4).map(|i| u32::from(self.0[i].is_sign_negative()) << i).sum()
        }
        #[inline(always)]
        pub fn xxyy([x, y]: &[f32; 2]) -> Self {
            Self([*x, *x, *y, *y])
        }
        #[inline(always)]
        pub fn negated(self) -> Self {
            Self(self.0.map(|x| -x))
        }
        #[inline(always)]
        pub fn w(self) -> f32 {
            self.0[3]
        }
        #[inline(always)]
        pub fn to_array(self) -> [f32; 4] {
            self.0
        }
        #[inline(always)]
        pub fn sub(self, b: Self) -> Self {
            Self(from_fn(|i| self.0[i] - b.0[i]))
        }
        #[inline(always)]
        pub fn mul(self, b: Self) -> Self {
            Self(from_fn(|i| self.0[i] * b.0[i]))
        }
        #[inline(always)]
        pub fn max(self, b: Self) -> Self {
            Self(from_fn(|i| if self.0[i] > b.0[i] { self.0[i] } else { b.0[i] }))
        }
        #[inline(always)]
        pub fn min(self, b: Self) -> Self {
            Self(from_fn(|i| if self.0[i] < b.0[i] { self.0[i] } else { b.0[i] }))
        }
        #[inline(always)]
        pub fn abs(self) -> Self {
            Self(self.0.map(f32::abs))
        }
        #[inline(always)]
        pub fn gt(self, b: Self) -> u32 {
            (0..4).map(|i| u32::from(self.0[i] > b.0[i]) << i).sum()
        }
        #[inline(always)]
        pub fn le(self, b: Self) -> u32 {
            (0..4).map(|i| u32::from(self.0[i] <= b.0[i]) << i).sum()
        }
        #[inline(always)]
        pub fn yzx(self) -> Self {
            let [x, y, z, w] = self.0;
            Self([y, z, x, w])
        }
        #[inline(always)]
        pub fn zxy(self) -> Self {
            let [x, y, z, w] = self.0;
            Self([z, x, y, w])
        }
        #[inline(always)]
        pub fn zwxy(self) -> Self {
            let [_, _, z, w] = self.0;
            Self([z, w, z, w])
        }
        #[inline(always)]
        pub fn x(self) -> f32 {
            self.0[0]
        }
        #[inline(always)]
        pub fn yzwx(self) -> Self {
            let [x, y, z, w] = self.0;
            Self([y, z, w, x])
        }
        #[inline(always)]
        pub fn or(self, mask: Self) -> Self {
            Self(from_fn(|i| f32::from_bits(self.0[i].to_bits() | mask.0[i].to_bits())))
        }
        #[inline(always)]
        pub fn or_not(self, mask: Self) -> Self {
            Self(from_fn(|i| f32::from_bits(self.0[i].to_bits() | !mask.0[i].to_bits())))
        }
        #[inline(always)]
        pub fn interleave_low(self, b: Self) -> Self {
            Self([self.0[0], b.0[0], self.0[1], b.0[1]])
        }
        #[inline(always)]
        pub fn interleave_high(self, b: Self) -> Self {
            Self([self.0[2], b.0[2], self.0[3], b.0[3]])
        }
        #[inline(always)]
        pub fn y(self) -> f32 {
            self.0[1]
        }
        #[inline(always)]
        pub fn z(self) -> f32 {
            self.0[2]
        }
        #[inline(always)]
        pub fn exchange(self, b: Self, mask: Self) -> (Self, Self) {
            let pick =
                |p: [f32; 4], q: [f32; 4]| from_fn(|i| if mask.0[i].to_bits() == 0 { p[i] } else { q[i] });
            (Self(pick(self.0, b.0)), Self(pick(b.0, self.0)))
        }
    }
}

pub(crate) use lanes::F32x4;

/// The lanes that [`F32x4::shuffle`] takes: `a` and `b` of the first operand, `c` and `d` of the second.
pub(crate) const fn lanes(a: i32, b: i32, c: i32, d: i32) -> i32 {
    a | b << 2 | c << 4 | d << 6
}
