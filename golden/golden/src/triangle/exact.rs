//! Exact signs of the edge functions of a ray and a triangle, and of the distance between them.
//!
//! With the corners `a, b, c` relative to the ray's origin and its direction `d`, the edge functions are the triple
//! products `U = d.(c x b)`, `V = d.(a x c)`, `W = d.(b x a)`; the ray's line meets the closed triangle if
//! no two of them have opposite signs and not all are zero, at `t = a.(c x b) / (U + V + W)`. The inputs are
//! floats, hence integers times a power of two, and so are the differences and the products: integer
//! arithmetic gives every sign exactly. Doubles with an error bound decide all but the near-zero cases (Shewchuk's
//! filter, "Adaptive Precision Floating-Point Arithmetic", 1997), 128-bit integers those whose coordinates span few
//! binades, big integers the rest.

use num_bigint::BigInt;
use num_traits::{One, Signed as _, ToPrimitive, Zero};
use std::cmp::Ordering;

type V3<T> = [T; 3];

/// What the exact evaluation tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Signed {
    /// `[U, V, W]`, each with its exact sign (or exactly zero) and of nearly the right size, up to one positive
    /// factor common to the three.
    pub edges: V3<f64>,
    /// How `t` compares with zero, if the line meets the triangle.
    pub depth_sign: Ordering,
}

/// Evaluates the edge functions and the sign of the distance. All inputs must be finite.
#[must_use]
pub fn evaluate(origin: V3<f32>, direction: V3<f32>, corners: &[V3<f32>; 3]) -> Signed {
    let [u, v, w, volume] = filtered(origin, direction, corners)
        .or_else(|| in_128_bits(origin, direction, corners))
        .unwrap_or_else(|| in_big_integers(origin, direction, corners));
    let edges = [u, v, w];
    let forward = edges.iter().all(|x| *x >= 0.0);
    let depth = if forward { volume } else { -volume };
    Signed { edges, depth_sign: depth.partial_cmp(&0.0).expect("no product is NaN") }
}

/// The factors of `U`, `V`, `W` and `a.(c x b)`.
fn factors<T>([a, b, c]: &V3<V3<T>>, d: &V3<T>) -> [[V3<T>; 3]; 4]
where
    T: Clone,
{
    [[d, c, b], [d, a, c], [d, b, a], [a, c, b]].map(|triple| triple.map(V3::clone))
}

/// Doubles: rounding in the three differences, the products and the sums adds up to at most 8 half-units of
/// the permanent; twice that is asked for. Nothing over- or underflows, since the inputs are single precision.
fn filtered(origin: V3<f32>, direction: V3<f32>, corners: &[V3<f32>; 3]) -> Option<[f64; 4]> {
    const BOUND: f64 = 16.0 * f64::EPSILON / 2.0;
    let corners =
        corners.map(|v| -> V3<f64> { std::array::from_fn(|k| f64::from(v[k]) - f64::from(origin[k])) });
    let products = factors(&corners, &direction.map(f64::from)).map(|[d, p, q]| {
        let (mut sum, mut permanent) = (0.0, 0.0);
        for (k, component) in d.iter().enumerate() {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let (plus, minus) = (p[i] * q[j], p[j] * q[i]);
            sum += component * (plus - minus);
            permanent += component.abs() * (plus.abs() + minus.abs());
        }
        (sum, permanent * BOUND)
    });
    products.iter().all(|(sum, bound)| sum.abs() > *bound).then(|| products.map(|(sum, _)| sum))
}

/// `x` as `mantissa * 2^exponent`.
fn decompose(x: f32) -> (i32, i32) {
    let bits = x.to_bits();
    let (biased, fraction) = ((bits >> 23 & 0xff) as i32, (bits & 0x007f_ffff) as i32);
    let mantissa = if biased == 0 { fraction } else { fraction | 1 << 23 };
    (if bits >> 31 == 0 { mantissa } else { -mantissa }, biased.max(1) - 150)
}

/// The least exponent among the non-zero values, and the number of bits that the largest then needs.
fn span(values: impl Iterator<Item = f32>) -> (i32, u32) {
    let exponents = values.filter(|x| *x != 0.0).map(|x| {
        let (mantissa, exponent) = decompose(x);
        (exponent, exponent + (32 - mantissa.unsigned_abs().leading_zeros()) as i32)
    });
    let (low, high) = exponents.fold((i32::MAX, i32::MIN), |(l, h), (e, top)| (l.min(e), h.max(top)));
    if low == i32::MAX { (0, 0) } else { (low, (high - low) as u32) }
}

fn in_128_bits(origin: V3<f32>, direction: V3<f32>, corners: &[V3<f32>; 3]) -> Option<[f64; 4]> {
    // Differences have at most 41 bits, so three of them and a sum of six products at most 126 and a sign.
    const BITS: u32 = 40;
    let (e_point, bits_point) = span(corners.iter().flatten().chain(&origin).copied());
    let (e_direction, bits_direction) = span(direction.into_iter());
    if bits_point > BITS || bits_direction > BITS {
        return None;
    }
    let integer = |x: f32, e: i32| -> i128 {
        let (mantissa, exponent) = decompose(x);
        if mantissa == 0 { 0 } else { i128::from(mantissa) << (exponent - e) }
    };
    let corners = corners.map(|v| -> V3<i128> {
        std::array::from_fn(|k| integer(v[k], e_point) - integer(origin[k], e_point))
    });
    Some(factors(&corners, &direction.map(|x| integer(x, e_direction))).map(|[d, p, q]| {
        let term = |k: usize| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            d[k] * (p[i] * q[j] - p[j] * q[i])
        };
        (term(0) + term(1) + term(2)) as f64
    }))
}

fn in_big_integers(origin: V3<f32>, direction: V3<f32>, corners: &[V3<f32>; 3]) -> [f64; 4] {
    let (e_point, _) = span(corners.iter().flatten().chain(&origin).copied());
    let (e_direction, _) = span(direction.into_iter());
    let integer = |x: f32, e: i32| -> BigInt {
        let (mantissa, exponent) = decompose(x);
        if mantissa == 0 { BigInt::zero() } else { BigInt::from(mantissa) << (exponent - e) }
    };
    let corners = corners.map(|v| -> V3<BigInt> {
        std::array::from_fn(|k| integer(v[k], e_point) - integer(origin[k], e_point))
    });
    let [u, v, w, volume] =
        factors(&corners, &direction.map(|x| integer(x, e_direction))).map(|[d, p, q]| {
            let term = |k: usize| {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                &d[k] * (&p[i] * &q[j] - &p[j] * &q[i])
            };
            term(0) + term(1) + term(2)
        });
    let bits = [&u, &v, &w].into_iter().map(BigInt::bits).max().unwrap_or(0);
    let [u, v, w] = [u, v, w].map(|x| to_double(&x, bits));
    [u, v, w, to_double(&volume, volume.bits())]
}

/// `x` as a double, scaled so that a number of `bits` bits comes near 2^900; what vanishes beside it becomes 1.
fn to_double(x: &BigInt, bits: u64) -> f64 {
    let scaled = if bits > 900 { x >> (bits - 900) } else { x.clone() };
    match (x.is_zero(), scaled.abs() > BigInt::one()) {
        (true, _) => 0.0,
        (false, true) => scaled.to_f64().unwrap_or(f64::MAX),
        (false, false) if x.is_negative() => -1.0,
        (false, false) => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::FromPrimitive;
    use proptest::prelude::*;

    fn signs(x: [f64; 4]) -> [i32; 4] {
        x.map(|x| if x == 0.0 { 0 } else { x.signum() as i32 })
    }

    fn any_finite() -> impl Strategy<Value = f32> {
        prop_oneof![
            (-8i8..8).prop_map(f32::from),
            any::<u32>().prop_map(f32::from_bits).prop_filter("finite", |x| x.is_finite()),
            (-1.0f32..1.0),
        ]
    }

    fn any_point() -> impl Strategy<Value = V3<f32>> {
        [any_finite(), any_finite(), any_finite()]
    }

    fn any_triangle() -> impl Strategy<Value = V3<V3<f32>>> {
        [any_point(), any_point(), any_point()]
    }

    /// `x` in units of the least positive number.
    fn integer(x: f32) -> BigInt {
        BigInt::from_f64(f64::from(x) * 2f64.powi(149)).unwrap()
    }

    /// `[U, V, W]` and `a.(c x b)` by determinants of integers, with a common factor for each of the two.
    fn reference(origin: V3<f32>, direction: V3<f32>, corners: &V3<V3<f32>>) -> [BigInt; 4] {
        let [a, b, c] =
            corners.map(|v| -> V3<BigInt> { std::array::from_fn(|k| integer(v[k]) - integer(origin[k])) });
        let d = direction.map(integer);
        let determinant = |x: &V3<BigInt>, y: &V3<BigInt>, z: &V3<BigInt>| {
            &x[0] * &y[1] * &z[2] + &x[1] * &y[2] * &z[0] + &x[2] * &y[0] * &z[1]
                - &x[2] * &y[1] * &z[0]
                - &x[1] * &y[0] * &z[2]
                - &x[0] * &y[2] * &z[1]
        };
        [determinant(&d, &c, &b), determinant(&d, &a, &c), determinant(&d, &b, &a), determinant(&a, &c, &b)]
    }

    /// Whether `[U, V, W]` are the reference's times one positive factor, but for rounding.
    fn in_proportion(found: [f64; 4], reference: &[BigInt; 4]) -> bool {
        let [u, v, w, _] = found;
        let [x, y, z, _] = reference;
        // 500 bits below the largest, and its highest 500 bits.
        let shift = [x, y, z].map(|x| x.bits()).into_iter().max().unwrap_or(0).saturating_sub(500);
        let exact = [x, y, z].map(|x| (x >> shift).to_f64().unwrap());
        let (found, exact): (V3<f64>, V3<f64>) = ([u, v, w], exact);
        let largest = (0..3).fold(0, |m, k| if exact[k].abs() > exact[m].abs() { k } else { m });
        (0..3).all(|k| (found[k] / found[largest] - exact[k] / exact[largest]).abs() < 1e-9)
            || exact[largest] == 0.0
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]

        #[test]
        fn every_evaluation_has_the_signs_of_the_integers(o in any_point(), d in any_point(), t in any_triangle()) {
            let exact = reference(o, d, &t);
            let expected = exact.each_ref().map(|x| [-1, 0, 1][(x.signum() + 1u32).to_usize().unwrap()]);
            prop_assert_eq!(signs(in_big_integers(o, d, &t)), expected);
            prop_assert!(in_proportion(in_big_integers(o, d, &t), &exact));
            if let Some(x) = in_128_bits(o, d, &t) {
                prop_assert_eq!(signs(x), expected);
                prop_assert!(in_proportion(x, &exact));
            }
            if let Some(x) = filtered(o, d, &t) {
                prop_assert_eq!(signs(x), expected);
            }
            let Signed { edges, depth_sign } = evaluate(o, d, &t);
            prop_assert_eq!(signs([edges[0], edges[1], edges[2], 0.0])[..3].to_vec(), expected[..3].to_vec());
            let side: i32 = expected[..3].iter().sum();
            if side != 0 && expected[..3].iter().all(|sign| sign * side >= 0) {
                prop_assert_eq!(depth_sign, (expected[3] * side).cmp(&0));
            }
        }

        #[test]
        fn a_point_on_an_edge_gives_exactly_zero(
            o in [-100i16..100, -100i16..100, -100i16..100],
            a in [-100i16..100, -100i16..100, -100i16..100],
            b in [-100i16..100, -100i16..100, -100i16..100],
            c in [-100i16..100, -100i16..100, -100i16..100],
        ) {
            // Aim at the midpoint of edge ab: twice the direction keeps it an integer.
            let f = |v: [i16; 3]| v.map(f32::from);
            let d = std::array::from_fn(|k| f32::from(a[k] + b[k] - 2 * o[k]));
            prop_assert_eq!(evaluate(f(o), d, &[f(a), f(b), f(c)]).edges[2], 0.0);
        }
    }

    #[test]
    fn doubles_decide_down_to_their_error_bound() {
        const E: f32 = 1.0 / 16_777_216.0;
        // The cross product of c and b is (0, -E^2, E^2): each component is a difference of two numbers near 1.
        let corners = [[0.0, -7.0, 3.0], [1.0 - 2.0 * E, 1.0 - E, 1.0 - E], [1.0 - E, 1.0, 1.0]];
        let (e, square) = (f64::from(E), f64::from(E).powi(2));
        // U and the volume are just above 8 half units of their permanents, about 2 and 20.
        let expected = [square, 7.0 * (1.0 - e), -7.0 * (1.0 - 2.0 * e), 10.0 * square];
        assert_eq!(filtered([0.0; 3], [0.0, 0.0, 1.0], &corners), Some(expected));
        // Here the permanent of U is about 3, while U is the same.
        assert_eq!(filtered([0.0; 3], [0.5, 0.0, 1.0], &corners), None);
        let signed = evaluate([0.0; 3], [0.5, 0.0, 1.0], &corners);
        assert_eq!(signs([signed.edges[0], signed.edges[1], signed.edges[2], 0.0]), [1, 1, -1, 0]);
        // An edge function that is zero is left to integers, even where each of its products is zero.
        let right = [[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [0.0, 4.0, 2.0]];
        assert_eq!(filtered([1.0, 0.0, 0.0], [0.0, 0.0, 1.0], &right), None);
    }

    #[test]
    fn products_of_one_unit_keep_their_sign() {
        let unit = f32::from_bits(1);
        let [a, b, c] = [[0.0, 0.0, unit], [unit, 0.0, unit], [0.0, unit, unit]];
        let evaluated = |corners| in_big_integers([0.0; 3], [0.0, 0.0, unit], &corners);
        assert_eq!(evaluated([a, b, c]), [-1.0, 0.0, 0.0, -1.0]);
        assert_eq!(evaluated([a, c, b]), [1.0, 0.0, 0.0, 1.0]);
    }

    /// 128 bits have room for numbers that span 40 bits.
    #[test]
    fn the_range_of_128_bits_ends_at_forty() {
        let fits = |point_exponent: i32, direction_exponent: i32| {
            let [point, component] = [point_exponent, direction_exponent].map(|e| 2f32.powi(e));
            let corners = [[point, 0.0, 2.0], [4.0, 0.0, 2.0], [0.0, 4.0, 2.0]];
            in_128_bits([1.0, 1.0, 0.0], [component, 0.0, 1.0], &corners).is_some()
        };
        // A float has 24 bits, so that 4 and 2^-14 span 2 + 14 + 24, and 1 and 2^-16 span 16 + 24.
        assert!(fits(-14, -16));
        assert!(!fits(-15, 0));
        assert!(!fits(0, -17));
    }
}
