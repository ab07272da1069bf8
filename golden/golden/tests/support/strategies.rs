//! Meshes and rays made to break traversal.
#![allow(dead_code, reason = "each user needs a part")]

use golden::Ray;
use proptest::prelude::*;
use scenes::Mesh;

/// Coordinates on a small grid, so that planes, edges and origins coincide; or anything, at any scale.
fn coordinate() -> impl Strategy<Value = f32> {
    prop_oneof![
        4 => (-3i8..=3).prop_map(f32::from),
        1 => -3.0f32..3.0,
        1 => Just(-0.0f32),
        1 => any::<u32>().prop_map(f32::from_bits).prop_filter("in range", |x| x.abs() < 1e25),
    ]
}

fn point() -> impl Strategy<Value = [f32; 3]> {
    [coordinate(), coordinate(), coordinate()]
}

/// Meshes of up to 80 triangles at any scale, with coordinates that coincide.
pub fn mesh() -> impl Strategy<Value = Mesh> {
    let scale = prop_oneof![4 => Just(1.0f32), 1 => Just(1e-6), 1 => Just(1e9), 1 => Just(1e-30)];
    let triangles = prop::collection::vec([point(), point(), point()], 1..40);
    (scale, triangles, any::<bool>()).prop_map(|(scale, mut corners, duplicate)| {
        if duplicate {
            corners.extend_from_within(..corners.len().div_ceil(2));
        }
        let positions: Vec<_> = corners.into_iter().flatten().map(|p| p.map(|x| x * scale)).collect();
        let triangles = (0..positions.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        Mesh { positions, triangles }
    })
}

/// Rays along axes, within planes, and from anywhere towards a point of some triangle.
pub fn ray(mesh: &Mesh) -> impl Strategy<Value = Ray> + use<> {
    let targets = mesh.positions.clone();
    let any_target = (0..targets.len(), 0..targets.len(), prop_oneof![Just(0.0f32), Just(0.5), 0.0f32..1.0]);
    let bound = prop_oneof![3 => Just((0.0, f32::INFINITY)), 1 => (0.0f32..1.0, 0.5f32..2.0)];
    (any_target, point(), 0..4, bound).prop_map(move |((i, j, w), p, kind, (t_min, t_max))| {
        let target: [f32; 3] = std::array::from_fn(|k| targets[i][k] * (1.0 - w) + targets[j][k] * w);
        let (origin, direction) = match kind {
            0 => (p, std::array::from_fn(|k| target[k] - p[k])),
            1 => (targets[j], p),
            2 => {
                let axis = (p[0].abs() as usize) % 3;
                let sign = if p[1] < 0.0 { -1.0 } else { 1.0 };
                let direction = std::array::from_fn(|k| if k == axis { sign } else { 0.0f32.copysign(p[2]) });
                let origin = std::array::from_fn(|k| if k == axis { target[k] - sign } else { target[k] });
                (origin, direction)
            }
            _ => (p, p.map(|x| -x)),
        };
        Ray { origin, direction, t_min, t_max }
    })
}
