//! Operations on lanes, in sets of equal names and meanings: the generated text is included once for each.
//!
//! | type | holds | in memory |
//! |---|---|---|
//! | `Bit` | one bit of each lane | [`Bits`] |
//! | `Word` | up to 32 bits of each lane | a [`Row`] |
//! | `Double` | up to 64 bits of each lane | two [`Row`]s, the low halves first |
//!
//! A set works on a chunk of the lanes at a time: all 16 with AVX-512, 8 with AVX2, one without either. Words are
//! unsigned; sums, differences and products wrap around at 32 or 64 bits; a shift by the lane's width or more gives
//! zero. `leading_zeros_w` counts the leading zeros of a word of 32 bits that has at least one bit set.

// Which operations the programs use depends on the hardware that they are made from.
#[cfg(target_arch = "x86_64")]
#[allow(dead_code)]
pub mod avx2;
#[cfg(target_arch = "x86_64")]
#[allow(dead_code)]
pub mod avx512;
#[allow(dead_code)]
pub mod scalar;

/// Copies of a netlist that a program simulates at once.
pub const LANES: usize = 16;

/// A value of up to 32 bits in each lane, or half of one of up to 64 bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C, align(64))]
pub struct Row(pub [u32; LANES]);

/// A bit of each lane, lane 0 lowest.
///
/// The type is wider than it needs to be. If the bits lay side by side, the compiler would gather them into vectors
/// for a few operations, at a loss.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(C, align(4))]
pub struct Bits(pub u16);

/// Operations that follow from others in every set.
macro_rules! derived_operations {
    ($(#[$attribute:meta])*) => {
        /// Bits chosen by a bit.
        $(#[$attribute])*
        #[inline]
        pub fn select_b(select: Bit, when_true: Bit, when_false: Bit) -> Bit {
            or_b(and_b(select, when_true), and_b(not_b(select), when_false))
        }

        /// Whether any bit of `x` that `bits` has is set.
        $(#[$attribute])*
        #[inline]
        pub fn test_w(x: Word, bits: Word) -> Bit {
            ne_w(and_w(x, bits), word(0))
        }

        /// Whether any bit of `x` that `bits` has is set.
        $(#[$attribute])*
        #[inline]
        pub fn test_d(x: Double, bits: Double) -> Bit {
            ne_d(and_d(x, bits), double(0))
        }

        /// `x` with its lowest bit, which is clear, replaced.
        $(#[$attribute])*
        #[inline]
        pub fn or_bit_w(x: Word, bit: Bit) -> Word {
            select_w(bit, or_w(x, word(1)), x)
        }

        /// `x` with its lowest bit, which is clear, replaced.
        $(#[$attribute])*
        #[inline]
        pub fn or_bit_d(x: Double, bit: Bit) -> Double {
            select_d(bit, or_d(x, double(1)), x)
        }

        /// Whether the number of set bits is odd.
        $(#[$attribute])*
        #[inline]
        pub fn parity_w(x: Word) -> Bit {
            let x = xor_w(x, shr_const_w::<16>(x));
            let x = xor_w(x, shr_const_w::<8>(x));
            let x = xor_w(x, shr_const_w::<4>(x));
            let x = xor_w(x, shr_const_w::<2>(x));
            test_w(xor_w(x, shr_const_w::<1>(x)), word(1))
        }

        /// Whether the number of set bits is odd.
        $(#[$attribute])*
        #[inline]
        pub fn parity_d(x: Double) -> Bit {
            parity_w(narrow(xor_d(x, shr_const_d::<32>(x))))
        }

        /// The least of `x` and the greatest word.
        $(#[$attribute])*
        #[inline]
        pub fn saturate(x: Double) -> Word {
            select_w(ne_d(shr_const_d::<32>(x), double(0)), word(u32::MAX), narrow(x))
        }
    };
}
use derived_operations;

/// Doubles as pairs of words, in terms of the set's operations on those.
///
/// Narrowing and widening then cost nothing; with vectors of 64-bit lanes they would need instructions across lanes.
#[cfg(target_arch = "x86_64")]
macro_rules! doubles_of_words {
    (#[$attribute:meta]) => {
        /// Up to 64 bits of each lane.
        #[derive(Clone, Copy)]
        pub struct Double {
            low: Word,
            high: Word,
        }
        doubles_of_words! { @functions #[$attribute]
            double(x: u64) -> Double = Double { low: word(x as u32), high: word((x >> 32) as u32) };
            widen(a: Word) -> Double = Double { low: a, high: word(0) };
            narrow(a: Double) -> Word = a.low;
            select_d(select: Bit, a: Double, b: Double) -> Double =
                Double { low: select_w(select, a.low, b.low), high: select_w(select, a.high, b.high) };
            and_d(a: Double, b: Double) -> Double = Double { low: and_w(a.low, b.low), high: and_w(a.high, b.high) };
            or_d(a: Double, b: Double) -> Double = Double { low: or_w(a.low, b.low), high: or_w(a.high, b.high) };
            xor_d(a: Double, b: Double) -> Double = Double { low: xor_w(a.low, b.low), high: xor_w(a.high, b.high) };
            add_d(a: Double, b: Double) -> Double = {
                let (low, high) = (add_w(a.low, b.low), add_w(a.high, b.high));
                Double { low, high: select_w(lt_w(low, a.low), add_w(high, word(1)), high) }
            };
            sub_d(a: Double, b: Double) -> Double = {
                let (low, high) = (sub_w(a.low, b.low), sub_w(a.high, b.high));
                Double { low, high: select_w(lt_w(a.low, b.low), sub_w(high, word(1)), high) }
            };
            mul_d(a: Double, b: Double) -> Double = {
                let Double { low, high } = mul_wide(a.low, b.low);
                let cross = add_w(mul_w(a.low, b.high), mul_w(a.high, b.low));
                Double { low, high: add_w(high, cross) }
            };
            shl_d(a: Double, by: Word) -> Double = {
                // One of the two amounts is beyond 32, and its shift gives zero.
                let (less, more) = (sub_w(word(32), by), sub_w(by, word(32)));
                let crossing = or_w(shr_w(a.low, less), shl_w(a.low, more));
                Double { low: shl_w(a.low, by), high: or_w(shl_w(a.high, by), crossing) }
            };
            shr_d(a: Double, by: Word) -> Double = {
                let (less, more) = (sub_w(word(32), by), sub_w(by, word(32)));
                let crossing = or_w(shl_w(a.high, less), shr_w(a.high, more));
                Double { low: or_w(shr_w(a.low, by), crossing), high: shr_w(a.high, by) }
            };
            eq_d(a: Double, b: Double) -> Bit = and_b(eq_w(a.low, b.low), eq_w(a.high, b.high));
            ne_d(a: Double, b: Double) -> Bit = or_b(ne_w(a.low, b.low), ne_w(a.high, b.high));
            lt_d(a: Double, b: Double) -> Bit =
                or_b(lt_w(a.high, b.high), and_b(eq_w(a.high, b.high), lt_w(a.low, b.low)));
            le_d(a: Double, b: Double) -> Bit =
                or_b(lt_w(a.high, b.high), and_b(eq_w(a.high, b.high), le_w(a.low, b.low)));
            signed_lt_d(a: Double, b: Double) -> Bit =
                or_b(signed_lt_w(a.high, b.high), and_b(eq_w(a.high, b.high), lt_w(a.low, b.low)));
            signed_le_d(a: Double, b: Double) -> Bit =
                or_b(signed_lt_w(a.high, b.high), and_b(eq_w(a.high, b.high), le_w(a.low, b.low)));
        }

        /// Shift left by a constant below 64.
        #[inline]
        #[$attribute]
        pub fn shl_const_d<const N: u32>(a: Double) -> Double {
            shl_d(a, word(N))
        }

        /// Shift right by a constant below 64.
        #[inline]
        #[$attribute]
        pub fn shr_const_d<const N: u32>(a: Double) -> Double {
            shr_d(a, word(N))
        }

        /// Shift right by a constant below 64, filled with the sign.
        #[inline]
        #[$attribute]
        pub fn sar_const_d<const N: u32>(a: Double) -> Double {
            // Shifting with the sign bit flipped, and subtracting what that bit has become, fills with the sign.
            let sign = double(1 << 63);
            sub_d(shr_const_d::<N>(xor_d(a, sign)), shr_const_d::<N>(sign))
        }

        /// Reads a double of each lane.
        #[inline]
        #[$attribute]
        pub fn load_d<const N: usize>(rows: &[Row; N], at: usize, chunk: usize) -> Double {
            Double { low: load_w(rows, at, chunk), high: load_w(rows, at + 1, chunk) }
        }

        /// Writes a double of each lane.
        #[inline]
        #[$attribute]
        pub fn store_d<const N: usize>(rows: &mut [Row; N], at: usize, chunk: usize, value: Double) {
            store_w(rows, at, chunk, value.low);
            store_w(rows, at + 1, chunk, value.high);
        }
    };
    (@functions #[$attribute:meta] $($name:ident($($operand:ident: $type:ty),*) -> $result:ty = $value:expr;)*) => { $(
        #[doc = concat!("See [`super`]: `", stringify!($name), "` on pairs of words.")]
        #[inline]
        #[$attribute]
        pub fn $name($($operand: $type),*) -> $result {
            $value
        }
    )* };
}
#[cfg(target_arch = "x86_64")]
use doubles_of_words;
