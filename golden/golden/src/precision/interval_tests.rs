//! Every plane, origin and direction of an 8-bit format against exact rationals: the derivation, checked by exhaustion.

use super::Planes;
use super::{NarrowArithmetic, NarrowRay, Scale, Variant};
use crate::ray::{PlaneDistances, Ray, TraversalRay};
use fp::{Arithmetic, Format, Subnormals};

/// Binary digits behind the point of a coordinate, a direction and a distance, as integers.
const COORDINATE: u32 = 64;
const DIRECTION: u32 = 44;
const DISTANCE: u32 = COORDINATE - DIRECTION;

/// `x * 2^digits`, which has to be a whole number.
fn whole(x: f32, digits: u32) -> i128 {
    let scaled = f64::from(x) * f64::from_bits(u64::from(1023 + digits) << 52);
    assert!(scaled.abs() < 2f64.powi(120) && scaled.fract() == 0.0, "{x} * 2^{digits}");
    scaled as i128
}

/// The finite numbers of `format`, each also with a binary32 number next to it that the format does not have.
fn numbers(format: Format, nudge: fn(f32) -> f32) -> Vec<f32> {
    let arithmetic = Arithmetic::new(format);
    let finite = (0..=format.mask()).map(|bits| arithmetic.to_f32(bits)).filter(|x| x.is_finite());
    finite.map(|x| if x == 0.0 { x } else { nudge(x) }).collect()
}

/// How many combinations break a bound; a plane is tested as the min and as the max side of a box.
fn violations(format: Format, subnormals: Subnormals, variant: Variant) -> (u64, u64) {
    let arithmetic = NarrowArithmetic::new(format, subnormals);
    let planes = Planes { arithmetic, scale: Scale::new(0), variant };
    let (mut tests, mut broken) = (0, 0);
    let nudges: [fn(f32) -> f32; 3] = [|x| x, f32::next_up, f32::next_down];
    for (i, nudge) in nudges.into_iter().enumerate() {
        let coordinates = numbers(format, nudge);
        // Directions are prepared so that no component exceeds 1. Nudged the other way than the rest.
        let directions = numbers(format, nudges[(3 - i) % 3]);
        for &d in directions.iter().filter(|d| d.abs() <= 1.0) {
            let mut wide =
                TraversalRay::new(&Ray::new([0.0; 3], [d, 1.0, 0.0]), variant.mode()).expect("a ray");
            for &o in &coordinates {
                wide.origin[0] = o;
                let ray = NarrowRay::new(&wide, arithmetic, Scale::new(0), variant);
                for &p in &coordinates {
                    let is_negative = ray.is_negative(0);
                    let entry = ray.entry(planes.plane(p, !is_negative), 0);
                    let exit = ray.exit(planes.plane(p, is_negative), 0);
                    tests += 1;
                    broken += u64::from(!bounds(entry, exit, (p, o, d)));
                    if variant == Variant::Conservative {
                        let (entry_32, exit_32) = (wide.entry(p, 0), wide.exit(p, 0));
                        let contained = (entry <= entry_32 || entry <= 0.0 || entry.is_nan())
                            && (exit >= exit_32 || exit_32 < 0.0 || exit == f32::INFINITY || exit.is_nan());
                        broken += u64::from(!contained);
                    }
                }
            }
        }
    }
    (tests, broken)
}

/// Whether `entry` and `exit` bound the exact `t = (p - o) / d` where that is not negative.
fn bounds(entry: f32, exit: f32, (p, o, d): (f32, f32, f32)) -> bool {
    let difference = whole(p, COORDINATE) - whole(o, COORDINATE);
    let direction = whole(d, DIRECTION);
    // (p - o) / d, with the direction made positive.
    let (difference, direction) =
        if d.is_sign_negative() { (-difference, -direction) } else { (difference, direction) };
    // Zero or NaN constrains nothing at entry, as does infinity or NaN at exit.
    let at_most =
        |t: f32| t.is_nan() || t <= 0.0 || t < f32::INFINITY && whole(t, DISTANCE) * direction <= difference;
    let at_least =
        |t: f32| t.is_nan() || t == f32::INFINITY || t >= 0.0 && whole(t, DISTANCE) * direction >= difference;
    match direction {
        // Parallel: all of the line is in front of the plane of entry, or none of it; likewise at exit.
        0 if difference > 0 => exit == f32::INFINITY || exit.is_nan(),
        0 if difference < 0 => entry == f32::NEG_INFINITY || entry.is_nan(),
        0 => entry.is_nan() || entry <= 0.0 && (exit.is_nan() || exit == f32::INFINITY),
        _ => at_most(entry) && (difference < 0 || at_least(exit)),
    }
}

#[test]
fn conservative_bounds_hold_for_every_operand_of_8_bit_formats() {
    for (format, subnormals) in [
        (Format::E4M3, Subnormals::Keep),
        (Format::E4M3, Subnormals::Flush),
        (Format::E5M2, Subnormals::Keep),
    ] {
        let (tests, broken) = violations(format, subnormals, Variant::Conservative);
        assert!(tests > 10_000_000, "{tests}");
        assert_eq!(broken, 0, "{format} {subnormals:?}: {broken} of {tests}");
    }
}

#[test]
fn naive_rounding_breaks_the_bounds_that_this_test_sees() {
    let (tests, broken) = violations(Format::E4M3, Subnormals::Keep, Variant::Naive);
    assert!(broken > tests / 10, "{broken} of {tests}");
}
