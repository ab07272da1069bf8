//! The integer reference against `rustc_apfloat`, the native type and its own stated properties.

use super::*;
use crate::operands::{Operands, patterns};
use rustc_apfloat::ieee::{IeeeFloat, Semantics};
use rustc_apfloat::{Float, FloatConvert, Round};

macro_rules! oracle {
    ($($name:ident: $exponent:literal, $significand:literal;)*) => { $(
        struct $name;
        impl Semantics for $name {
            const BITS: usize = $exponent + $significand;
            const EXP_BITS: usize = $exponent;
        }
    )* };
}

oracle! {
    E5M2: 5, 3;
    E4M3: 4, 4;
    E3M4: 3, 5;
    E2M3: 2, 4;
    Binary16: 5, 11;
    Bfloat16: 8, 8;
    Binary32: 8, 24;
}

fn direction(rounding: Rounding) -> Round {
    match rounding {
        Rounding::NearestEven => Round::NearestTiesToEven,
        Rounding::TowardZero => Round::TowardZero,
        Rounding::Down => Round::TowardNegative,
        Rounding::Up => Round::TowardPositive,
        Rounding::NearestAway => Round::NearestTiesToAway,
    }
}

fn format<S: Semantics>() -> Format {
    Format::new(S::EXP_BITS as u32, (S::BITS - S::EXP_BITS) as u32).unwrap()
}

fn bits<S: Semantics>(x: IeeeFloat<S>) -> u32 {
    if x.is_nan() { format::<S>().canonical_nan() } else { x.to_bits() as u32 }
}

/// Compares every operation on one pair of operands.
fn check<S: Semantics>(a: u32, b: u32) {
    let unit = Arithmetic::new(format::<S>());
    let number = |x: u32| IeeeFloat::<S>::from_bits(u128::from(x));
    let context = |op: &str, rounding| format!("{} {a:x} {op} {b:x} {rounding:?}", unit.format);
    for rounding in Rounding::ALL {
        let round = direction(rounding);
        let expected = bits(number(a).add_r(number(b), round).value);
        assert_eq!(unit.fp_add(a, b, false, rounding), expected, "{}", context("+", rounding));
        let expected = bits(number(a).sub_r(number(b), round).value);
        assert_eq!(unit.fp_add(a, b, true, rounding), expected, "{}", context("-", rounding));
        let expected = bits(number(a).mul_r(number(b), round).value);
        assert_eq!(unit.fp_mul(a, b, rounding), expected, "{}", context("*", rounding));
    }
    let (x, y) = (number(a), number(b));
    assert_eq!(unit.fp_cmp(a, b), Comparison { lt: x < y, le: x <= y, eq: x == y });
    for (maximum, nan_mode, expected) in [
        (false, NanMode::Propagate, x.minimum(y)),
        (true, NanMode::Propagate, x.maximum(y)),
        // apfloat's `min` and `max` leave the order of the zeros open.
        (
            false,
            NanMode::Number,
            if x.is_nan() {
                y
            } else if y.is_nan() {
                x
            } else {
                x.minimum(y)
            },
        ),
        (
            true,
            NanMode::Number,
            if x.is_nan() {
                y
            } else if y.is_nan() {
                x
            } else {
                x.maximum(y)
            },
        ),
    ] {
        assert_eq!(unit.fp_min_max(a, b, maximum, nan_mode), bits(expected), "{a:x} {b:x} {nan_mode:?}");
    }
}

fn exhaustive<S: Semantics>() {
    let codes = 1 << S::BITS;
    (0..codes).for_each(|a| (0..codes).for_each(|b| check::<S>(a, b)));
}

#[test]
fn e5m2_equals_apfloat_on_all_pairs() {
    exhaustive::<E5M2>();
}

#[test]
fn e4m3_equals_apfloat_on_all_pairs() {
    exhaustive::<E4M3>();
}

#[test]
fn e3m4_equals_apfloat_on_all_pairs() {
    exhaustive::<E3M4>();
}

#[test]
fn e2m3_equals_apfloat_on_all_pairs() {
    exhaustive::<E2M3>();
}

fn sampled<S: Semantics>() {
    let patterns = patterns(format::<S>());
    for &a in &patterns {
        for &b in &patterns {
            check::<S>(a, b);
        }
    }
    let mut stream = Operands::new(format::<S>(), 1);
    for _ in 0..100_000 {
        let (a, b) = stream.pair();
        check::<S>(a, b);
    }
}

#[test]
fn binary32_bfloat16_and_binary16_equal_apfloat_on_patterns_and_samples() {
    sampled::<Binary32>();
    sampled::<Bfloat16>();
    sampled::<Binary16>();
}

#[test]
fn conversions_equal_apfloat() {
    let unit = Arithmetic::new(Format::BINARY16);
    for x in patterns(Format::BINARY32) {
        for rounding in Rounding::ALL {
            let wide = IeeeFloat::<Binary32>::from_bits(u128::from(x));
            let narrow: IeeeFloat<Binary16> = wide.convert_r(direction(rounding), &mut false).value;
            assert_eq!(unit.from_f32(f32::from_bits(x), rounding), bits(narrow), "{x:x} {rounding:?}");
        }
    }
    for code in 0..1u32 << 16 {
        let narrow = IeeeFloat::<Binary16>::from_bits(u128::from(code));
        let wide: IeeeFloat<Binary32> = narrow.convert(&mut false).value;
        assert_eq!(unit.to_f32(code).to_bits(), bits(wide));
        let back = if unit.format.is_nan(code) { unit.format.canonical_nan() } else { code };
        assert_eq!(unit.from_f32(unit.to_f32(code), Rounding::Down), back);
    }
}

#[test]
fn flushing_never_crosses_the_exact_result() {
    let keep = Arithmetic::new(Format::E4M3);
    let flush = Arithmetic { subnormals: Subnormals::Flush, ..keep };
    let min_normal = keep.format.min_normal();
    let is_subnormal = |x| (1..min_normal).contains(&keep.format.magnitude(x));
    // The exact results of an 8-bit format fit a double.
    let value = |x| f64::from(keep.to_f32(x));
    let operands: Vec<u32> =
        (0..256).filter(|&x| !is_subnormal(x) && keep.format.magnitude(x) < keep.format.infinity()).collect();
    let mut flushed = 0;
    for &a in &operands {
        for &b in &operands {
            for (exact, result) in [
                (value(a) + value(b), [Rounding::Down, Rounding::Up].map(|r| flush.fp_add(a, b, false, r))),
                (value(a) * value(b), [Rounding::Down, Rounding::Up].map(|r| flush.fp_mul(a, b, r))),
            ] {
                assert!(value(result[0]) <= exact && exact <= value(result[1]), "{a:x} {b:x}");
                assert!(result.iter().all(|&r| !is_subnormal(r)));
                flushed += u32::from(exact != 0.0 && exact.abs() < value(min_normal));
            }
        }
    }
    assert!(flushed > 1000, "only {flushed} results were tiny");
    assert_eq!(flush.fp_add(1, min_normal, false, Rounding::NearestEven), min_normal);
    assert_eq!(flush.fp_mul(0x81, 0x38, Rounding::NearestEven), 0x80);
}

#[test]
fn binary32_minimum_and_maximum_are_the_native_policy() {
    let unit = Arithmetic::new(Format::BINARY32);
    for a in patterns(Format::BINARY32) {
        for b in patterns(Format::BINARY32) {
            let (x, y) = (f32::from_bits(a), f32::from_bits(b));
            for (maximum, nan_mode, native) in [
                (false, NanMode::Number, crate::minimum_number(x, y)),
                (true, NanMode::Number, crate::maximum_number(x, y)),
                (false, NanMode::Propagate, crate::minimum(x, y)),
                (true, NanMode::Propagate, crate::maximum(x, y)),
            ] {
                assert_eq!(unit.fp_min_max(a, b, maximum, nan_mode), native.to_bits());
            }
        }
    }
}
