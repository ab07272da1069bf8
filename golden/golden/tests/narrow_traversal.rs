//! Traversal in narrow formats against testing every triangle, on meshes and rays made to break it.

mod support;

use fp::{Format, Subnormals};
use golden::Mode;
use golden::build::{BuildOptions, Quality, build};
use golden::precision::{NarrowStructure, Precision, Variant};
use golden::ray::TraversalRay;
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::traverse::{Counters, Trace, brute_force};
use proptest::prelude::*;
use support::strategies::{mesh, ray};

fn any_format() -> impl Strategy<Value = Format> {
    let named =
        [Format::BINARY32, Format::TF32, Format::BFLOAT16, Format::BINARY16, Format::E5M2, Format::E4M3];
    prop_oneof![
        prop::sample::select(named.to_vec()),
        (2u32..=8, 2u32..=24).prop_filter_map("a format", |(e, s)| Format::new(e, s).ok()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 800, ..ProptestConfig::default() })]

    #[test]
    fn conservative_hits_are_those_of_brute_force(
        (mesh, rays) in mesh().prop_flat_map(|m| {
            let rays = prop::collection::vec(ray(&m), 16);
            (Just(m), rays)
        }),
        format in any_format(),
        flush in any::<bool>(),
    ) {
        let tree = build(&mesh, &BuildOptions { quality: Quality::Fast, max_leaf_size: 2 }).unwrap();
        let triangles = pack_triangles(&mesh, &tree);
        let subnormals = if flush { Subnormals::Flush } else { Subnormals::Keep };
        let precision = Precision { subnormals, ..Precision::new(format, Variant::Conservative) };
        for kind in StructureKind::ALL {
            let narrow = NarrowStructure::new(&Structure::convert(kind, &tree, &triangles).unwrap(), precision);
            for ray in &rays {
                let expected = brute_force(&triangles, ray, Mode::Robust);
                prop_assert_eq!(narrow.closest(ray, Mode::Robust), expected, "{} {} {:?}", kind, precision, ray);
                prop_assert_eq!(narrow.occluded(ray, Mode::Robust), expected.is_some());
            }
        }
    }

    #[test]
    fn naive_binary32_is_fast_mode(
        (mesh, rays) in mesh().prop_flat_map(|m| {
            let rays = prop::collection::vec(ray(&m), 16);
            (Just(m), rays)
        }),
    ) {
        let tree = build(&mesh, &BuildOptions { quality: Quality::Fast, max_leaf_size: 2 }).unwrap();
        let triangles = pack_triangles(&mesh, &tree);
        for kind in StructureKind::ALL {
            let wide = Structure::convert(kind, &tree, &triangles).unwrap();
            let narrow = NarrowStructure::new(&wide, Precision::new(Format::BINARY32, Variant::Naive));
            if narrow.scale().exponent() != 0 {
                return Ok(());
            }
            for ray in rays.iter().filter_map(|ray| TraversalRay::new(ray, Mode::Fast)) {
                let mut work = [Counters::default(); 2];
                let hit = wide.closest_prepared(&ray, &mut work[0]);
                prop_assert_eq!(narrow.closest_prepared(&ray, &mut work[1]), hit);
                prop_assert_eq!(work[0], work[1]);
            }
        }
    }
}

/// Fewer bits may cost visits, never hits.
#[test]
fn visits_grow_as_bits_fall() {
    let scene = scenes::procedural::build("statue", 0.002, 0).unwrap();
    let tree = build(&scene.mesh, &BuildOptions::default()).unwrap();
    let triangles = pack_triangles(&scene.mesh, &tree);
    let wide = Structure::convert(StructureKind::Dst, &tree, &triangles).unwrap();
    let camera = render::CameraRays::new(&scene.camera, 16, 16).unwrap();
    let rays: Vec<_> = (0..256)
        .map(|i| camera.ray((i % 16) as f32 + 0.5, (i / 16) as f32 + 0.5))
        .filter_map(|ray| TraversalRay::new(&ray, Mode::Robust))
        .collect();
    fn visits(structure: &impl Trace, rays: &[TraversalRay]) -> u64 {
        let mut counters = Counters::default();
        let hits = rays.iter().filter(|ray| structure.closest_prepared(ray, &mut counters).is_some()).count();
        assert!(hits > 20);
        counters.node_visits
    }
    let mut last = visits(&wide, &rays);
    for bits in [24, 16, 12, 8, 5] {
        let precision = Precision::new(Format::new(8, bits).unwrap(), Variant::Conservative);
        let narrow = NarrowStructure::new(&wide, precision);
        let now = visits(&narrow, &rays);
        assert!(now >= last, "{bits} bits: {now} visits, {last} before");
        last = now;
    }
}
