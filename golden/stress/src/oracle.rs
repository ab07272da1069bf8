//! The exact nearest triangles of a ray: Cramer's rule in rational numbers, independent of the traversal kernels and of
//! the triangle test.
//!
//! Doubles with an error bound decide the cases that they can, and rational numbers the rest. Candidates come from
//! the boxes of a hierarchy, widened beyond the rounding of double precision. A ray hits a triangle where the ray's
//! line meets it, edges and corners included. It does not hit a triangle in whose plane it lies, nor a triangle
//! without area.

use golden::build::{BinaryTree, Content};
use golden::{Aabb, Ray};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use scenes::Mesh;
use std::collections::BTreeMap;

type V3<T> = [T; 3];

/// Answers for rays against one mesh.
#[derive(Clone, Copy, Debug)]
pub struct Oracle<'a> {
    mesh: &'a Mesh,
    tree: &'a BinaryTree,
}

/// A triangle that is hit, with a lower bound of its distance in units of the ray's direction.
struct Candidate {
    triangle: u32,
    low: f64,
}

impl<'a> Oracle<'a> {
    /// The oracle of `mesh`, over which `tree` is a hierarchy.
    #[must_use]
    pub fn new(mesh: &'a Mesh, tree: &'a BinaryTree) -> Self {
        Self { mesh, tree }
    }

    /// The triangles that are hit at exactly the least distance in `t_min..=t_max`, in ascending order; none if nothing is.
    ///
    /// A ray outside the supported range (see [`golden::ray`]) hits nothing.
    #[must_use]
    pub fn nearest(&self, ray: &Ray) -> Vec<u32> {
        let finite = ray.origin.iter().chain(&ray.direction).all(|x| x.is_finite());
        let ordered = ray.t_min <= ray.t_max && ray.t_max >= 0.0;
        if !(finite && ordered && ray.direction.iter().any(|d| *d != 0.0)) {
            return vec![];
        }
        let mut exact = Exact { mesh: self.mesh, ray, known: BTreeMap::new() };
        let mut hits: Vec<Candidate> = vec![];
        let mut best = f64::INFINITY;
        let mut stack = vec![0usize];
        while let Some(at) = stack.pop() {
            let node = &self.tree.nodes[at];
            match entry(&node.aabb, ray) {
                Some(entry) if entry <= best => {}
                _ => continue,
            }
            match node.content {
                Content::Inner { .. } => stack.extend(self.tree.children(node)),
                Content::Leaf { first_primitive, primitive_count } => {
                    let range = first_primitive as usize..(first_primitive + primitive_count) as usize;
                    for &triangle in &self.tree.primitives[range] {
                        if let Some((low, high)) = exact.bounds(triangle) {
                            best = best.min(high);
                            hits.push(Candidate { triangle, low });
                        }
                    }
                }
            }
        }
        hits.retain(|hit| hit.low <= best);
        if hits.len() > 1 {
            let distances: Vec<BigRational> = hits
                .iter()
                .map(|hit| exact.distance(hit.triangle).expect("a triangle that is hit"))
                .collect();
            let least = distances.iter().min().expect("more than one").clone();
            let mut distances = distances.iter();
            hits.retain(|_| distances.next() == Some(&least));
        }
        let mut nearest: Vec<u32> = hits.iter().map(|hit| hit.triangle).collect();
        nearest.sort_unstable();
        nearest
    }
}

/// Exact distances along one ray, computed once for triangles with the same corners.
struct Exact<'a> {
    mesh: &'a Mesh,
    ray: &'a Ray,
    known: BTreeMap<V3<V3<u32>>, Option<BigRational>>,
}

impl Exact<'_> {
    /// The distance of `triangle` if the ray's line meets it.
    fn distance(&mut self, triangle: u32) -> Option<BigRational> {
        let corners = self.mesh.corners(triangle as usize);
        let bits = corners.map(|corner| corner.map(f32::to_bits));
        self.known.entry(bits).or_insert_with(|| exact_distance(&corners, self.ray)).clone()
    }

    /// Bounds of the distance of `triangle` if it is hit within the ray's range.
    fn bounds(&mut self, triangle: u32) -> Option<(f64, f64)> {
        let ray = self.ray;
        let (t_min, t_max) = (f64::from(ray.t_min).max(0.0), f64::from(ray.t_max));
        match filtered(&self.mesh.corners(triangle as usize), ray) {
            Filtered::Miss => return None,
            Filtered::Hit(low, high) if low > t_min && high < t_max => return Some((low, high)),
            Filtered::Hit(..) | Filtered::Unsure => {}
        }
        let t = self.distance(triangle)?;
        let bound = |x: f32| BigRational::from_float(x);
        let below = t.is_negative() || bound(ray.t_min).is_some_and(|t_min| t < t_min);
        let above = bound(ray.t_max).is_some_and(|t_max| t > t_max);
        if below || above {
            return None;
        }
        Some(enclose(&t))
    }
}

/// Relative widening that covers a handful of double roundings.
const SLACK: f64 = 1e-14;

/// A lower bound of the distance at which the half-line of `ray` enters `aabb`, or `None` where it certainly does not.
fn entry(aabb: &Aabb, ray: &Ray) -> Option<f64> {
    let (mut near, mut far) = (0.0f64, f64::INFINITY);
    for k in 0..3 {
        let (min, max, origin) = (f64::from(aabb.min[k]), f64::from(aabb.max[k]), f64::from(ray.origin[k]));
        let direction = f64::from(ray.direction[k]);
        if direction == 0.0 {
            if origin < min || origin > max {
                return None;
            }
            continue;
        }
        let (a, b) = ((min - origin) / direction, (max - origin) / direction);
        let (low, high) = (a.min(b), a.max(b));
        near = near.max(low - low.abs() * SLACK);
        far = far.min(high + high.abs() * SLACK);
    }
    (near <= far).then_some(near)
}

enum Filtered {
    Miss,
    Hit(f64, f64),
    Unsure,
}

/// Decides by doubles: triple products, each with a bound of its rounding errors (see [`golden::triangle::exact`]).
fn filtered(corners: &V3<V3<f32>>, ray: &Ray) -> Filtered {
    let d = ray.direction.map(f64::from);
    let [a, b, c] =
        corners.map(|v| -> V3<f64> { std::array::from_fn(|k| f64::from(v[k]) - f64::from(ray.origin[k])) });
    let triple = |x: V3<f64>, p: V3<f64>, q: V3<f64>| {
        let (mut sum, mut permanent) = (0.0, 0.0);
        for (k, component) in x.into_iter().enumerate() {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            sum += component * (p[i] * q[j] - p[j] * q[i]);
            permanent += component.abs() * ((p[i] * q[j]).abs() + (p[j] * q[i]).abs());
        }
        (sum, 16.0 * f64::EPSILON * permanent)
    };
    let edges = [triple(d, c, b), triple(d, a, c), triple(d, b, a)];
    let positive = edges.iter().filter(|(x, e)| *x > *e).count();
    let negative = edges.iter().filter(|(x, e)| *x < -*e).count();
    if positive > 0 && negative > 0 {
        return Filtered::Miss;
    }
    if positive != 3 && negative != 3 {
        return Filtered::Unsure;
    }
    let (volume, volume_error) = triple(a, c, b);
    let (sum, error) = edges.iter().fold((0.0, 0.0), |(s, e), (x, f)| (s + x, e + f));
    let (least, most) = (sum.abs() - 2.0 * error, sum.abs() + 2.0 * error);
    if least <= 0.0 {
        return Filtered::Unsure;
    }
    let volume = if sum < 0.0 { -volume } else { volume };
    let widened = |t: f64, by: f64| t + by * (t.abs() * SLACK + f64::MIN_POSITIVE);
    let (low, high) = (volume - volume_error, volume + volume_error);
    let low = widened(if low < 0.0 { low / least } else { low / most }, -1.0);
    let high = widened(if high < 0.0 { high / most } else { high / least }, 1.0);
    Filtered::Hit(low, high)
}

/// Doubles around a rational number.
fn enclose(t: &BigRational) -> (f64, f64) {
    use num_traits::ToPrimitive;
    let near = t.to_f64().unwrap_or(f64::INFINITY);
    let slack = near.abs() * SLACK + f64::MIN_POSITIVE;
    (near - slack, near + slack)
}

/// Whether `ray`'s half-line meets some closed triangle of `mesh` outside whose plane it lies, exactly.
#[must_use]
pub fn exact_hit(mesh: &Mesh, ray: &Ray) -> bool {
    (0..mesh.triangles.len()).any(|i| {
        let corners = mesh.corners(i);
        let possible = !matches!(filtered(&corners, ray), Filtered::Miss);
        possible && exact_distance(&corners, ray).is_some_and(|t| !t.is_negative())
    })
}

/// The distance at which the ray's line meets the closed triangle, or `None` if it does not or lies in its plane.
///
/// # Panics
/// If a coordinate is not finite.
#[must_use]
pub fn exact_distance(corners: &V3<V3<f32>>, ray: &Ray) -> Option<BigRational> {
    let exact = |v: V3<f32>| v.map(|x| BigRational::from_float(x).expect("a finite number"));
    let [a, b, c] = corners.map(exact);
    let (o, d) = (exact(ray.origin), exact(ray.direction));
    let (e, f, s) = (difference(&b, &a), difference(&c, &a), difference(&o, &a));
    let p = cross(d.clone(), f.clone());
    let determinant: BigRational = dot(e.clone(), p.clone());
    if determinant.is_zero() {
        return None;
    }
    let q = cross(s.clone(), e);
    let u = dot(s, p) / &determinant;
    let v = dot(d, q.clone()) / &determinant;
    let one = BigRational::from_integer(BigInt::one());
    let inside = !u.is_negative() && !v.is_negative() && u + v <= one;
    inside.then(|| dot(f, q) / determinant)
}

fn difference(a: &V3<BigRational>, b: &V3<BigRational>) -> V3<BigRational> {
    std::array::from_fn(|k| &a[k] - &b[k])
}

fn cross<T>(a: V3<T>, b: V3<T>) -> V3<T>
where
    T: Clone + std::ops::Mul<Output = T> + std::ops::Sub<Output = T>,
{
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone()
    })
}

fn dot<T>(a: V3<T>, b: V3<T>) -> T
where
    T: std::ops::Mul<Output = T> + std::ops::Add<Output = T>,
{
    let [a0, a1, a2] = a;
    let [b0, b1, b2] = b;
    a0 * b0 + a1 * b1 + a2 * b2
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::strategies::{mesh, ray};
    use golden::build::{BuildOptions, build};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

        /// The boxes and the filter change nothing: the same as the exact distances of all triangles.
        #[test]
        fn agrees_with_all_triangles_in_rationals(
            (mesh, rays) in mesh().prop_flat_map(|m| {
                let rays = prop::collection::vec(ray(&m), 8);
                (Just(m), rays)
            }),
        ) {
            let tree = build(&mesh, &BuildOptions::default()).unwrap();
            let oracle = Oracle::new(&mesh, &tree);
            for ray in &rays {
                let valid = ray.direction.iter().any(|d| *d != 0.0)
                    && ray.direction.iter().chain(&ray.origin).all(|x| x.is_finite());
                let exact: Vec<_> = (0..mesh.triangles.len())
                    .filter(|_| valid)
                    .filter_map(|i| Some((exact_distance(&mesh.corners(i), ray)?, i as u32)))
                    .filter(|(t, _)| *t >= BigRational::from_float(ray.t_min.max(0.0)).unwrap())
                    .filter(|(t, _)| BigRational::from_float(ray.t_max).is_none_or(|t_max| *t <= t_max))
                    .collect();
                let least = exact.iter().map(|(t, _)| t).min();
                let expected: Vec<u32> =
                    exact.iter().filter(|(t, _)| Some(t) == least).map(|(_, i)| *i).collect();
                prop_assert_eq!(oracle.nearest(ray), expected, "{:?}", ray);
            }
        }
    }
}
