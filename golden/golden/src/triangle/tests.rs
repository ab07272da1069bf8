//! The triangle test: hits known by construction, the exact decision where rounding cannot decide, and bits that stay.

use super::*;
use crate::{Mode, Ray};
use base::split_mix;
use proptest::prelude::*;

type Corners = [[f32; 3]; 3];

fn packed(corners: Corners) -> Triangle {
    Triangle::new(&Mesh { positions: corners.to_vec(), triangles: vec![[0, 1, 2]] }, 0, true)
}

fn prepared(origin: [f32; 3], direction: [f32; 3]) -> TraversalRay {
    TraversalRay::new(&Ray::new(origin, direction), Mode::Robust).unwrap()
}

fn intersect(ray: &TraversalRay, triangle: &Triangle) -> Option<TriangleHit> {
    TriangleTest::new(ray).intersect(ray, triangle, ray.t_max)
}

/// `[x, y, z]` with `z` put on axis `axis`.
fn turned([x, y, z]: [f32; 3], axis: usize) -> [f32; 3] {
    let mut turned = [0.0; 3];
    (turned[(axis + 1) % 3], turned[(axis + 2) % 3], turned[axis]) = (x, y, z);
    turned
}

/// A right triangle in the plane at 2 on `axis`.
fn right_triangle(axis: usize) -> Corners {
    [[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [0.0, 4.0, 2.0]].map(|corner| turned(corner, axis))
}

/// Numbers whose products and sums are exact, along every axis, in either direction, for both windings.
#[test]
fn distance_and_weights_are_exact_where_no_operation_rounds() {
    for axis in 0..3 {
        let [a, b, c] = right_triangle(axis);
        for sign in [1.0, -1.0] {
            let direction = turned([0.25, -0.5, sign], axis);
            let origin = turned([1.0 - 2.0 * 0.25, 2.0 + 2.0 * 0.5, 2.0 - 2.0 * sign], axis);
            let ray = prepared(origin, direction);
            for (corners, u, v) in [
                ([a, b, c], 0.25, 0.5),
                ([b, c, a], 0.5, 0.25),
                ([c, a, b], 0.25, 0.25),
                ([a, c, b], 0.5, 0.25),
            ] {
                assert_eq!(intersect(&ray, &packed(corners)), Some(TriangleHit { t: 2.0, u, v }));
            }
        }
    }
}

#[test]
fn a_hit_lies_within_the_bounds_of_the_ray() {
    let triangle = packed(right_triangle(2));
    let test = |t_min: f32, t_max: f32| {
        let ray = Ray { origin: [1.0, 1.0, 0.0], direction: [0.0, 0.0, 1.0], t_min, t_max };
        intersect(&TraversalRay::new(&ray, Mode::Robust).unwrap(), &triangle).map(|hit| hit.t)
    };
    assert_eq!(test(0.0, f32::INFINITY), Some(2.0));
    assert_eq!(test(2.0, 2.0), Some(2.0));
    assert_eq!(test(0.0, 2.0f32.next_down()), None);
    assert_eq!(test(2.0f32.next_up(), 9.0), None);
    for (z, t) in [(2.0, Some(0.0)), (3.0, None), (2.0f32.next_up(), None)] {
        let ray = prepared([1.0, 1.0, z], [0.0, 0.0, 1.0]);
        assert_eq!(intersect(&ray, &triangle).map(|hit| hit.t), t, "from {z}");
    }
}

/// The ray meets the plane so near to its origin that the distance rounds to zero, whose sign is then that of the exact distance.
#[test]
fn a_triangle_behind_the_origin_by_less_than_any_number_is_missed() {
    let ray = prepared([0.0, f32::from_bits(1), 0.0], [0.0, 0.0, 1.0]);
    for (z, t) in [(0.25, Some(0.0)), (-0.25, None)] {
        let triangle = packed([[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, z]]);
        assert_eq!(intersect(&ray, &triangle).map(|hit| hit.t), t, "{z}");
    }
}

/// The closed triangle is hit on its edges and corners, and one unit in the last place outside of them it is missed.
#[test]
fn edges_and_corners_belong_to_the_triangle() {
    let triangle = packed(right_triangle(2));
    let hit = |x: f32, y: f32| {
        let found = intersect(&prepared([x, y, 0.0], [0.0, 0.0, 1.0]), &triangle);
        found.map(|hit| [hit.t, hit.u, hit.v])
    };
    for ([x, y], weights) in [
        ([0.0, 0.0], [0.0, 0.0]),
        ([4.0, 0.0], [1.0, 0.0]),
        ([0.0, 4.0], [0.0, 1.0]),
        ([1.0, 0.0], [0.25, 0.0]),
        ([0.0, 3.0], [0.0, 0.75]),
        ([1.0, 3.0], [0.25, 0.75]),
    ] {
        assert_eq!(hit(x, y), Some([2.0, weights[0], weights[1]]), "({x}, {y})");
    }
    let tiny = f32::from_bits(1);
    for [x, y] in [
        [-tiny, 1.0],
        [1.0, -tiny],
        [1.0f32.next_up(), 3.0],
        [1.0, 3.0f32.next_up()],
        [4.0f32.next_up(), 0.0],
    ] {
        assert_eq!(hit(x, y), None, "({x}, {y})");
    }
}

/// The box is `1..3` on each axis. Its slabs begin at the given distances, and each is 2 long.
#[test]
fn a_distance_is_clamped_to_the_box_of_the_triangle() {
    let corners: Corners = [[1.0, 1.0, 1.0], [3.0, 2.0, 3.0], [2.0, 3.0, 1.5]];
    for octant in 0..8 {
        let signs: [f32; 3] = std::array::from_fn(|axis| if octant >> axis & 1 == 0 { 1.0 } else { -1.0 });
        let clamped = |slabs: [f32; 3], t: f32| {
            let origin =
                std::array::from_fn(|k| if signs[k] > 0.0 { 1.0 - slabs[k] } else { 3.0 + slabs[k] });
            let ray = TraversalRay::new(&Ray::new(origin, signs), Mode::Fast).unwrap();
            let hit = TriangleHit { t, u: 0.25, v: 0.5 };
            let found = within_box(&ray, &packed(corners), hit, ray.t_max)?;
            assert_eq!((found.u, found.v), (hit.u, hit.v));
            Some(found.t)
        };
        for slabs in [[1.0, 0.5, 0.75], [0.75, 1.0, 0.5], [0.5, 0.75, 1.0]] {
            for (t, expected) in [(0.5, 1.0), (1.0, 1.0), (1.75, 1.75), (2.5, 2.5), (9.0, 2.5)] {
                assert_eq!(clamped(slabs, t), Some(expected), "{signs:?} {slabs:?}");
            }
        }
        // An empty interval is a miss, and so is one behind the origin.
        assert_eq!(clamped([3.0, 0.5, 1.0], 2.75), None);
        assert_eq!(clamped([-3.0, -2.5, -2.75], 1.0), None);
        assert_eq!(clamped([-1.0, 1.0, 0.0], 1.5), Some(1.0), "an interval of one distance");
    }
}

#[test]
fn rays_in_the_plane_and_triangles_without_area_are_misses() {
    let corners @ [a, b, _] = right_triangle(2);
    assert_eq!(intersect(&prepared([-1.0, 1.0, 2.0], [1.0, 0.0, 0.0]), &packed(corners)), None);
    let onto_edge = prepared([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    assert_eq!(intersect(&onto_edge, &packed([a, b, b])), None);
    assert_eq!(intersect(&onto_edge, &packed([a, a, a])), None);
}

#[test]
fn a_triangle_keeps_its_index_its_corners_and_the_end_of_its_leaf() {
    let corners: Corners = [[1.0, 2.0, 3.0], [-4.0, 5.0, -6.0], [7.0, -8.0, 9.0]];
    let mesh = Mesh { positions: corners.to_vec(), triangles: vec![[2, 1, 0]; 7] };
    for (index, last) in [(0, false), (5, true), (6, false)] {
        let triangle = Triangle::new(&mesh, index, last);
        assert_eq!((triangle.index(), triangle.is_last()), (index, last));
        assert_eq!(triangle.corners(), [corners[2], corners[1], corners[0]]);
        assert_eq!(triangle.aabb(), Aabb { min: [-4.0, -8.0, -6.0], max: [7.0, 5.0, 9.0] });
        assert!(triangle.is_valid());
    }
    let triangle = Triangle::new(&mesh, 5, true);
    // All bits are used but four, of which one is always set.
    assert_eq!(Triangle { tag: 0x43ff_ffff, ..triangle }.index(), (1 << 26) - 1);
    assert!(Triangle { tag: 0x4bff_ffff, ..triangle }.is_valid());
    for bit in [26, 28, 29, 30, 31] {
        assert!(!Triangle { tag: triangle.tag ^ 1 << bit, ..triangle }.is_valid(), "bit {bit}");
    }
    for bad in [f32::NAN, f32::INFINITY] {
        let mut other = triangle;
        other.rows[1][2] = bad;
        assert!(!other.is_valid(), "{bad}");
    }
}

#[test]
fn a_leaf_ends_with_the_triangle_that_is_marked() {
    let mesh = Mesh { positions: right_triangle(0).to_vec(), triangles: vec![[0, 1, 2]; 5] };
    let marks = [false, true, true, false, false];
    let triangles: Vec<Triangle> = (0..5).map(|i| Triangle::new(&mesh, i, marks[i as usize])).collect();
    assert_eq!(leaf_at(&triangles, 0), Some(&triangles[..2]));
    assert_eq!(leaf_at(&triangles, 1), Some(&triangles[1..2]));
    assert_eq!(leaf_at(&triangles, 2), Some(&triangles[2..3]));
    assert_eq!(leaf_at(&triangles, 3), None, "no triangle ends the leaf");
    assert_eq!(leaf_at(&triangles, 6), None);
}

/// Rays at points near the edges of random triangles, at all distances from an edge down to the last place, at all scales, from
/// all origins, among them some next to the triangle's plane. Every eleventh triangle is a few units in the last place large.
fn near_edges(count: u32) -> impl Iterator<Item = (TraversalRay, Triangle)> {
    let mut state = 0;
    let mut number = move || (split_mix::next(&mut state) >> 40) as f32 / 8_388_608.0 - 1.0;
    (0..count).filter_map(move |i| {
        let scale = 2f32.powi(i as i32 % 81 - 38);
        let [a, mut b, mut c]: Corners = std::array::from_fn(|_| std::array::from_fn(|_| number() * scale));
        if i % 11 == 0 {
            [b, c] = [b, c]
                .map(|v| std::array::from_fn(|k| f32::from_bits(a[k].to_bits() ^ v[k].to_bits() >> 20 & 3)));
        }
        let (along, across) = (number(), number().signum() * 2f32.powi(-(i as i32 % 29)));
        let target: [f32; 3] = std::array::from_fn(|k| a[k] + along * (b[k] - a[k]) + across * (c[k] - a[k]));
        let distance = if i % 3 == 0 { 2f32.powi(-(i as i32 % 31)) } else { 1.0 };
        let origin: [f32; 3] = std::array::from_fn(|k| target[k] + distance * number() * scale);
        let direction: [f32; 3] = if i % 7 == 0 {
            std::array::from_fn(|_| (2.0 * number()).round())
        } else {
            std::array::from_fn(|k| target[k] - origin[k])
        };
        let ray = TraversalRay::new(&Ray::new(origin, direction), Mode::Robust)?;
        Some((ray, packed([a, b, c])))
    })
}

#[test]
fn single_precision_decides_as_the_exact_test_does() {
    let (mut hits, mut misses) = (0, 0);
    for (ray, triangle) in near_edges(100_000) {
        let found = intersect(&ray, &triangle);
        let exact = exact_hit(ray.origin, ray.direction, &triangle.corners())
            .and_then(|hit| within_box(&ray, &triangle, hit, ray.t_max));
        assert_eq!(found.is_some(), exact.is_some(), "{ray:?} {triangle:?}: {found:?}, {exact:?}");
        if let (Some(found), Some(exact)) = (found, exact) {
            hits += 1;
            assert!(
                (found.u - exact.u).abs() < 1e-2 && (found.v - exact.v).abs() < 1e-2,
                "{found:?} {exact:?}"
            );
        } else {
            misses += 1;
        }
    }
    assert_eq!((hits, misses), (21_432, 74_147));
}

/// In another unit of length, a ray meets a triangle at the same weights, and at the distance in that unit.
#[test]
fn hits_do_not_depend_on_the_unit_of_length() {
    let scaled = |ray: &TraversalRay, triangle: &Triangle, scale: f32| {
        let corners = triangle.corners().map(|corner| corner.map(|x| x * scale));
        let ray = prepared(ray.origin.map(|x| x * scale), ray.direction);
        intersect(&ray, &packed(corners)).map(|hit| TriangleHit { t: hit.t / scale, ..hit })
    };
    let mut hits = 0;
    // Triangles of a size near 1, so that nothing becomes subnormal; half a scene's tests are near an edge.
    for (ray, triangle) in near_edges(100_000).filter(|(_, triangle)| (0.01..100.0).contains(&size(triangle)))
    {
        let found = intersect(&ray, &triangle);
        hits += u32::from(found.is_some());
        for exponent in [66, -60, 100] {
            assert_eq!(
                scaled(&ray, &triangle, 2f32.powi(exponent)),
                found,
                "2^{exponent}: {ray:?} {triangle:?}"
            );
        }
    }
    assert!(hits > 1000, "{hits}");
}

fn size(triangle: &Triangle) -> f32 {
    triangle.corners().as_flattened().iter().fold(0.0, |most: f32, x| most.max(x.abs()))
}

/// Hits do not depend on the machine. The bits also show which of the two tests decides: the exact one rounds less.
#[test]
fn the_bits_of_hits_do_not_change() {
    let digest = near_edges(100_000).fold(0u64, |digest, (ray, triangle)| {
        let bits = intersect(&ray, &triangle).map_or([0; 3], |hit| [hit.t, hit.u, hit.v].map(f32::to_bits));
        bits.into_iter()
            .fold(digest, |digest, word| (digest ^ u64::from(word)).wrapping_mul(0x0100_0000_01b3))
    });
    assert_eq!(digest, 1_263_523_215_290_178_047);
}

fn point() -> impl Strategy<Value = [f32; 3]> {
    // Zeros make directions with components of zero, along which no distance can be told.
    prop::array::uniform3(prop_oneof![Just(0i8), -100i8..100].prop_map(f32::from))
}

proptest! {
    /// The middle of an edge is met halfway along a direction of twice the length, and single precision does not decide it.
    #[test]
    fn the_test_decides_an_edge_as_the_exact_hit(o in point(), [a, b, c] in prop::array::uniform3(point())) {
        let direction = std::array::from_fn(|k| a[k] + b[k] - 2.0 * o[k]);
        let mesh = Mesh { positions: vec![a, b, c], triangles: vec![[0, 1, 2]] };
        let Some(ray) = TraversalRay::new(&Ray::new(o, direction), Mode::Robust) else { return Ok(()) };
        let found = TriangleTest::new(&ray).intersect(&ray, &Triangle::new(&mesh, 0, true), f32::INFINITY);
        let exact = exact_hit(ray.origin, ray.direction, &[a, b, c]);
        prop_assert_eq!(found.map(|hit| (hit.u, hit.v)), exact.map(|hit| (hit.u, hit.v)));
        if let (Some(found), Some(exact)) = (found, exact) {
            prop_assert_eq!((exact.u, exact.v, ray.given_t(exact.t)), (0.5, 0.0, 0.5));
            prop_assert!((found.t - exact.t).abs() <= 4e-7 * exact.t);
        }
    }
}
