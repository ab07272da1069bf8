//! Every structure against brute force, and the dual-split tree against its hierarchy, on inputs made to break them.

use super::{Leaves, Trace, brute_force};
use crate::build::{BuildOptions, Quality, build};
use crate::bvh::Bvh2;
use crate::dst::Dst;
use crate::structure::{Structure, StructureKind, pack_triangles};
use crate::{Mode, Ray, TraversalRay};
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

pub(crate) fn mesh() -> impl Strategy<Value = Mesh> {
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
pub(crate) fn ray(mesh: &Mesh) -> impl Strategy<Value = Ray> + use<> {
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

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, ..ProptestConfig::default() })]

    #[test]
    fn structures_agree_with_brute_force(
        (mesh, rays) in mesh().prop_flat_map(|m| {
            let rays = prop::collection::vec(ray(&m), 16);
            (Just(m), rays)
        }),
        max_leaf_size in 1u32..5,
    ) {
        let tree = build(&mesh, &BuildOptions { quality: Quality::Fast, max_leaf_size }).unwrap();
        tree.validate(&mesh).unwrap();
        let triangles = pack_triangles(&mesh, &tree);
        let dst = Dst::convert(&tree, triangles.clone()).unwrap();
        dst.validate(&tree).unwrap();
        let bvh = Bvh2::encode(&tree, triangles.clone());
        for mode in [Mode::Fast, Mode::Robust] {
            for ray in &rays {
                let expected = brute_force(&triangles, ray, mode);
                for kind in StructureKind::ALL {
                    let structure = Structure::convert(kind, &tree, &triangles).unwrap();
                    prop_assert_eq!(structure.closest(ray, mode), expected, "{} {:?} {:?}", kind, mode, ray);
                    prop_assert_eq!(structure.occluded(ray, mode), expected.is_some());
                }
                if let Some(prepared) = TraversalRay::new(ray, mode) {
                    let bits = |leaves: Vec<super::Leaf>| -> Vec<_> {
                        leaves.iter().map(|l| (l.first_triangle, l.t_entry.to_bits(), l.t_exit.to_bits())).collect()
                    };
                    prop_assert_eq!(bits(bvh.leaves(&prepared)), bits(dst.leaves(&prepared)));
                }
            }
        }
    }
}
