//! Every structure against brute force, and the leaves that a ray reaches in the dual-split tree and in planes of 8 bits against
//! those of the exact hierarchy, on inputs made to break them.

mod support;

use golden::build::{BuildOptions, Quality, build, collapse_wide};
use golden::bvh::Bvh2;
use golden::dst::Dst;
use golden::qbvh::QBvh;
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::traverse::{Leaves, Trace, brute_force};
use golden::triangle::Triangle;
use golden::{Mode, TraversalRay};
use proptest::prelude::*;
use std::collections::BTreeSet;
use support::strategies::{mesh, ray};

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
        let narrow = QBvh::<8>::encode(&collapse_wide(&tree), &triangles);
        narrow.validate().unwrap();
        for mode in [Mode::Fast, Mode::Robust] {
            for ray in &rays {
                let expected = brute_force(&triangles, ray, mode);
                for kind in StructureKind::ALL {
                    let structure = Structure::convert(kind, &tree, &triangles).unwrap();
                    prop_assert_eq!(structure.closest(ray, mode), expected, "{} {:?} {:?}", kind, mode, ray);
                    prop_assert_eq!(structure.occluded(ray, mode), expected.is_some());
                }
                if let Some(prepared) = TraversalRay::new(ray, mode) {
                    let bits = |leaves: Vec<golden::traverse::Leaf>| -> Vec<_> {
                        leaves.iter().map(|l| (l.first_triangle, l.t_entry.to_bits(), l.t_exit.to_bits())).collect()
                    };
                    prop_assert_eq!(bits(bvh.leaves(&prepared)), bits(dst.leaves(&prepared)));
                    let first = |leaves: Vec<golden::traverse::Leaf>, triangles: &[Triangle]| -> BTreeSet<u32> {
                        leaves.iter().map(|leaf| triangles[leaf.first_triangle as usize].index()).collect()
                    };
                    let exact = first(bvh.leaves(&prepared), &triangles);
                    prop_assert!(first(narrow.leaves(&prepared), &narrow.triangles).is_superset(&exact));
                }
            }
        }
    }
}
