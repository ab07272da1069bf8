//! An independent oracle: Cramer's rule in rational numbers.
#![allow(dead_code, reason = "each user needs a part")]

use golden::Ray;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use scenes::Mesh;

type V3<T> = [T; 3];

/// Whether `ray`'s half-line meets some closed triangle of `mesh` outside whose plane it lies, exactly.
pub fn exact_hit(mesh: &Mesh, ray: &Ray) -> bool {
    (0..mesh.triangles.len()).any(|i| {
        let corners = mesh.corners(i);
        may_hit(&corners, ray) && exact_distance(&corners, ray).is_some_and(|t| !t.is_negative())
    })
}

/// False only where doubles leave no doubt that the line passes the triangle by.
fn may_hit(corners: &V3<V3<f32>>, ray: &Ray) -> bool {
    let d = ray.direction.map(f64::from);
    let [a, b, c] =
        corners.map(|v| -> V3<f64> { std::array::from_fn(|k| f64::from(v[k]) - f64::from(ray.origin[k])) });
    let edges = [(c, b), (a, c), (b, a)].map(|(p, q)| {
        let size = |v: V3<f64>| v.iter().map(|x| x.abs()).sum::<f64>();
        (dot(d, cross(p, q)), 1e-12 * size(d) * size(p) * size(q))
    });
    !(edges.iter().any(|(x, e)| *x > *e) && edges.iter().any(|(x, e)| *x < -*e))
}

/// The distance at which the ray's line meets the closed triangle, or `None` if it does not or lies in its plane.
pub fn exact_distance(corners: &V3<V3<f32>>, ray: &Ray) -> Option<BigRational> {
    let exact = |v: V3<f32>| v.map(|x| BigRational::from_float(x).expect("a finite number"));
    let [a, b, c] = corners.map(exact);
    let (o, d) = (exact(ray.origin), exact(ray.direction));
    let (e, f, s) = (difference(&b, &a), difference(&c, &a), difference(&o, &a));
    let p = cross(d.clone(), f.clone());
    let determinant = dot(e.clone(), p.clone());
    if determinant.is_zero() {
        return None;
    }
    let q = cross(s.clone(), e);
    let u = dot(s, p) / &determinant;
    let v = dot(d, q.clone()) / &determinant;
    let inside = !u.is_negative() && !v.is_negative() && u + v <= BigRational::one();
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
