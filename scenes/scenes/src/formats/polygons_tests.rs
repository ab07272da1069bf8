use proptest::prelude::*;

use super::*;

/// Turns the polygon of all `positions` into triangles.
fn triangles(positions: &[[f32; 3]]) -> (Vec<[u32; 3]>, PolygonCounts) {
    let corners: Vec<u32> = (0..positions.len() as u32).collect();
    let mut triangulator = Triangulator::new();
    let mut triangles = vec![];
    triangulator.push(positions, &corners, &mut triangles).unwrap();
    (triangles, triangulator.counts)
}

fn fan(corners: u32) -> Vec<[u32; 3]> {
    (2..corners).map(|i| [0, i - 1, i]).collect()
}

fn counts(concave: u64, non_planar: u64, self_crossing: u64) -> PolygonCounts {
    PolygonCounts { concave, non_planar, self_crossing }
}

/// Points `xy` on a slanted plane, exactly.
fn slanted(xy: &[[f32; 2]]) -> Vec<[f32; 3]> {
    xy.iter().map(|&[x, y]| [x, x + 2.0 * y, y]).collect()
}

#[test]
fn convex_polygons_are_fans() {
    let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    assert_eq!(triangles(&slanted(&square)), (fan(4), counts(0, 0, 0)));
    // Corners on a side, and corners twice.
    let straight = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]];
    assert_eq!(triangles(&slanted(&straight)), (fan(7), counts(0, 0, 0)));
    // No area at all.
    assert_eq!(triangles(&slanted(&[[1.0, 1.0]; 5])), (fan(5), counts(0, 0, 0)));
    assert_eq!(triangles(&[[0.0; 3], [1.0; 3], [3.0; 3], [2.0; 3]]), (fan(4), counts(0, 0, 0)));
}

#[test]
fn a_fan_that_covers_a_concave_polygon_stays() {
    let dart = [[0.5, 0.0], [2.0, 1.0], [0.0, 0.0], [2.0, -1.0]];
    let (found, found_counts) = triangles(&slanted(&dart));
    assert_eq!((found, found_counts), (fan(4), counts(1, 0, 0)));
}

#[test]
fn bent_quads_are_not_planar() {
    let bent = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.1], [0.0, 1.0, 0.0]];
    assert_eq!(triangles(&bent), (fan(4), counts(0, 1, 0)));
    // Rounding of coordinates far from the origin is no bend.
    let far = [[1e6, 1e6, 7.0], [1e6 + 1.0, 1e6, 7.0], [1e6 + 1.0, 1e6 + 1.0, 7.0625], [1e6, 1e6 + 1.0, 7.0]];
    assert_eq!(triangles(&far).1, counts(0, 0, 0));
}

#[test]
fn crossing_sides_are_counted() {
    let bow_tie = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
    assert_eq!(triangles(&slanted(&bow_tie)).1.self_crossing, 1);
    let star: Vec<[f32; 2]> = (0..5)
        .map(|i| f64::from(i * 2) * std::f64::consts::TAU / 5.0)
        .map(|a| [libm::cos(a) as f32, libm::sin(a) as f32])
        .collect();
    let (found, found_counts) = triangles(&slanted(&star));
    assert_eq!(found_counts.self_crossing, 1);
    assert!(!found.is_empty());
}

#[test]
fn a_hole_that_is_cut_open_stays_open() {
    // A square with a square hole; a cut leads in and out along the same line.
    let xy = [
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 4.0],
        [0.0, 4.0],
        [0.0, 0.0],
        [1.0, 1.0],
        [1.0, 3.0],
        [3.0, 3.0],
        [3.0, 1.0],
        [1.0, 1.0],
    ];
    let positions = slanted(&xy);
    let (found, found_counts) = triangles(&positions);
    assert_eq!(found_counts, counts(1, 0, 0));
    assert_eq!(twice_the_area(&xy, &found), (24.0, 24.0));
}

#[test]
fn large_polygons_are_refused_unless_they_are_convex() {
    let zigzag: Vec<[f32; 3]> = (0..2 * MOST_CORNERS)
        .map(|i| {
            let (x, up) = if i < MOST_CORNERS { (i, 0.0) } else { (2 * MOST_CORNERS - i, 2.0) };
            [x as f32, up + (i % 2) as f32 * 0.5, 0.0]
        })
        .collect();
    let corners: Vec<u32> = (0..zigzag.len() as u32).collect();
    let refused = Triangulator::new().push(&zigzag, &corners, &mut vec![]);
    assert!(matches!(refused, Err(FormatErrorKind::LargePolygon(8192))));
    let convex: Vec<[f32; 3]> = (0..5000u32).map(|i| [i as f32, (i * (i + 1) / 2) as f32, 0.0]).collect();
    assert_eq!(triangles(&convex), (fan(5000), counts(0, 0, 0)));
}

/// Twice the signed and the unsigned area of the triangles of the outline `xy`, seen so that both are positive in its plane.
fn twice_the_area(xy: &[[f32; 2]], triangles: &[[u32; 3]]) -> (f64, f64) {
    let areas = triangles.iter().map(|t| {
        let [a, b, c] = t.map(|i| xy[i as usize].map(f64::from));
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    });
    (areas.clone().sum(), areas.map(f64::abs).sum())
}

proptest! {
    /// Simple polygons, star-shaped around a point that is not a corner, in any plane: the triangles have the area of the
    /// outline and go round as it does, so they cover it and nothing else.
    #[test]
    fn triangles_cover_the_outline(
        radii in prop::collection::vec(1i16..100, 4..40),
        first in 0usize..40,
        reverse in any::<bool>(),
        axes in 0usize..3,
    ) {
        let n = radii.len();
        let mut xy: Vec<[f32; 2]> = radii.iter().enumerate().map(|(i, &radius)| {
            let angle = i as f64 * std::f64::consts::TAU / n as f64;
            [(f64::from(radius) * libm::cos(angle)).round() as f32, (f64::from(radius) * libm::sin(angle)).round() as f32]
        }).collect();
        xy.rotate_left(first % n);
        if reverse {
            xy.reverse();
        }
        let outline: f64 = (0..n).map(|i| {
            let ([ax, ay], [bx, by]) = (xy[i].map(f64::from), xy[(i + 1) % n].map(f64::from));
            ax * by - ay * bx
        }).sum();
        let positions: Vec<[f32; 3]> = slanted(&xy).iter().map(|p| std::array::from_fn(|i| p[(i + axes) % 3])).collect();
        let (found, counts) = triangles(&positions);
        prop_assert!(counts.non_planar == 0);
        if counts.self_crossing == 0 {
            prop_assert_eq!(twice_the_area(&xy, &found), (outline, outline.abs()));
        }
    }

    #[test]
    fn any_polygon_gives_valid_triangles(positions in prop::collection::vec(any::<[i8; 3]>(), 3..60)) {
        let positions: Vec<[f32; 3]> = positions.iter().map(|p| p.map(f32::from)).collect();
        let (found, _) = triangles(&positions);
        prop_assert!(!found.is_empty() && found.len() <= positions.len() - 2 + 2 * positions.len());
        prop_assert!(found.iter().flatten().all(|&i| (i as usize) < positions.len()));
    }
}
