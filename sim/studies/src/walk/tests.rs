//! Tests that the walk has a step for each event of the traversal, and that its best triangle is the hit.

use super::*;
use golden::build::{BuildOptions, Quality, build};
use golden::structure::{StructureKind, pack_triangles};
use golden::traverse::Counters;
use golden::{Mode, Ray};
use render::CameraRays;
use scenes::Scene;

/// The numbers of visits, triangle tests and pushes among `steps`, as the kernels count them.
fn counts(steps: &[Step]) -> (u64, u64, u64) {
    let count = |wanted: fn(&Step) -> bool| steps.iter().filter(|step| wanted(step)).count() as u64;
    (
        count(|step| matches!(step, Step::Node { .. } | Step::Box { .. })),
        count(|step| matches!(step, Step::Triangle { .. })),
        count(|step| matches!(step, Step::Push { .. })),
    )
}

#[test]
fn walks_are_the_kernels() {
    let scene = Scene::load("hairball", 0.001, 0).unwrap();
    let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
    let triangles = pack_triangles(&scene.mesh, &tree);
    let structures = StructureKind::ALL.map(|kind| Structure::convert(kind, &tree, &triangles).unwrap());
    let camera = CameraRays::new(&scene.camera, 24, 24).unwrap();
    let rays = (0..576).map(|i| camera.ray((i % 24) as f32 + 0.5, (i / 24) as f32 + 0.5));
    let scaled = Ray { direction: [3.0, -2.0, -1.5], ..camera.ray(12.0, 12.0) };
    let mut hits = 0;
    for ray in rays.chain([scaled]) {
        for mode in [Mode::Fast, Mode::Robust] {
            let prepared = TraversalRay::new(&ray, mode).unwrap();
            for structure in &structures {
                let Walk { steps, hit } = walk(structure, &prepared);
                assert_eq!(hit, structure.closest(&ray, mode), "{}", structure.kind());
                let mut counters = Counters::default();
                structure.closest_prepared(&prepared, &mut counters);
                let Counters { node_visits, triangle_tests, pushes, .. } = counters;
                assert_eq!(counts(&steps), (node_visits, triangle_tests, pushes));
                let best = steps.iter().rev().find_map(|step| match step {
                    Step::Triangle { triangle, t, best: true, .. } => Some((*triangle, t.unwrap())),
                    _ => None,
                });
                assert_eq!(best.map(|(triangle, _)| triangle), hit.map(|hit| hit.triangle));
                assert_eq!(best.map(|(_, t)| prepared.given_t(t)), hit.map(|hit| hit.t));
                hits += u32::from(hit.is_some());
            }
        }
    }
    assert_eq!(hits, 159 * 2 * structures.len() as u32, "159 rays hit, in both modes and all structures");
}
