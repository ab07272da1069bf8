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

    proptest! {
        #[test]
        fn the_three_evaluations_agree(o in any_point(), d in any_point(), t in [any_point(), any_point(), any_point()]) {
            let exact = signs(in_big_integers(o, d, &t));
            if let Some(x) = in_128_bits(o, d, &t) {
                prop_assert_eq!(signs(x), exact);
            }
            if let Some(x) = filtered(o, d, &t) {
                prop_assert_eq!(signs(x), exact);
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
}
