//! A hit lies on the ray's segment: nothing behind the origin is found, even from inside a triangle's bounding box.

use golden::traverse::brute_force;
use golden::{Mode, Ray};
use proptest::prelude::*;

/// Signed distance of `p` from the plane of `triangle`, times twice its area, and the same for a direction.
fn plane(triangle: &[[f32; 3]; 3], p: [f32; 3], d: [f32; 3]) -> (f64, f64) {
    let [a, b, c] = triangle.map(|v| v.map(f64::from));
    let sub = |x: [f64; 3], y: [f64; 3]| [x[0] - y[0], x[1] - y[1], x[2] - y[2]];
    let (e, f) = (sub(b, a), sub(c, a));
    let n = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
    let dot = |x: [f64; 3]| n[0] * x[0] + n[1] * x[1] + n[2] * x[2];
    (dot(sub(p.map(f64::from), a)), dot(d.map(f64::from)))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn triangles_behind_the_origin_are_missed(
        triangle in prop::array::uniform3(prop::array::uniform3(-1.0f32..1.0)),
        origin in prop::array::uniform3(-1.0f32..1.0),
        direction in prop::array::uniform3(-1.0f32..1.0),
    ) {
        let (height, slope) = plane(&triangle, origin, direction);
        // So far from the plane that rounding cannot decide, and away from it.
        prop_assume!(height.abs() > 1e-4);
        let direction = if height * slope < 0.0 { direction.map(|d| -d) } else { direction };
        let mesh = stress::shapes::soup([triangle]);
        let packed = [golden::triangle::Triangle::new(&mesh, 0, true)];
        for mode in [Mode::Fast, Mode::Robust] {
            prop_assert_eq!(brute_force(&packed, &Ray::new(origin, direction), mode), None);
        }
    }
}
