//! The ways in which ray libraries lose hits, as measured on nine of them: each case has to come out at zero misses.
//!
//! Three counts. In robust mode traversal has to agree with testing every triangle, in every structure. A closed mesh
//! seen from inside has to be hit by every ray. And where a mesh is open, whatever an oracle in rational numbers
//! hits has to be hit. `DUALSPLIT_DATA` adds the Stanford bunny to the generated stand-in for it.

mod support;

use golden::build::{BuildError, BuildOptions, Quality, build};
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::traverse::{Counters, Trace, brute_force};
use golden::triangle::Triangle;
use golden::{Hit, Mode, Ray, TraversalRay};
use scenes::Mesh;
use stress::cases::{self, Case};
use stress::oracle::exact_hit;
use stress::shapes::{Random, closed_sphere, grid, soup};

/// How many rays of a case are compared with brute force, and with the oracle where they miss.
const BRUTE_FORCE_TESTS: usize = 20_000_000;

#[derive(Debug, Default, PartialEq)]
struct Misses {
    against_brute_force: usize,
    of_closed: usize,
    against_oracle: usize,
}

fn count(case: &Case) -> Misses {
    let tree = build(&case.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
    let triangles = pack_triangles(&case.mesh, &tree);
    let structures = StructureKind::ALL.map(|kind| Structure::convert(kind, &tree, &triangles).unwrap());
    let compared = (BRUTE_FORCE_TESTS / case.mesh.triangles.len()).max(8);
    let mut misses = Misses::default();
    for (i, ray) in case.rays.iter().enumerate() {
        let hits = structures.each_ref().map(|s| s.closest(ray, Mode::Robust));
        let expected = if i < compared { brute_force(&triangles, ray, Mode::Robust) } else { hits[0] };
        misses.against_brute_force += usize::from(hits.iter().any(|hit| bits(hit) != bits(&expected)));
        for (structure, hit) in structures.iter().zip(&hits) {
            assert_eq!(structure.occluded(ray, Mode::Robust), hit.is_some());
        }
        if hits[0].is_none() {
            misses.of_closed += usize::from(case.closed);
            misses.against_oracle += usize::from(exact_hit(&case.mesh, ray));
        }
    }
    println!("{:44} {:6} rays {misses:?}", case.name, case.rays.len());
    misses
}

fn bits(hit: &Option<Hit>) -> Option<(u32, u32)> {
    hit.map(|hit| (hit.t.to_bits(), hit.triangle))
}

fn check_all(cases: impl IntoIterator<Item = Case>) {
    for case in cases {
        assert_eq!(count(&case), Misses::default(), "{}", case.name);
    }
}

#[test]
fn cases_0_to_5_closed_sphere_from_inside() {
    check_all(cases::closed_spheres());
}

#[test]
fn cases_6_to_9_axis_parallel_rays_onto_a_grid() {
    check_all(cases::axis_rays_onto_a_grid());
}

#[test]
fn case_10_rays_in_the_faces_of_boxes() {
    let case = cases::rays_in_faces_of_boxes();
    assert_eq!(case.rays.len(), 1152);
    check_all([case]);
}

#[test]
fn cases_11_to_23_scales_offsets_and_direction_lengths() {
    check_all(cases::scales(&cases::stand_in()));
    if let Some(bunny) = support::shared_scene("bunny") {
        println!("bunny:");
        check_all(cases::scales(&bunny));
    }
}

#[test]
fn cases_24_to_26_duplicates_degenerates_and_invalid_vertices() {
    check_all(cases::duplicates_and_degenerates());
    let mesh = cases::sphere_with_degenerates();
    for bad in [f32::NAN, f32::INFINITY] {
        let mut mesh = mesh.clone();
        mesh.positions[mesh.triangles[17][1] as usize][2] = bad;
        let error = build(&mesh, &BuildOptions::default()).unwrap_err();
        assert!(matches!(error, BuildError::NonFiniteVertex { triangle: 17, .. }), "26: {error}");
    }
}

#[test]
fn cases_27_to_32_tiny_huge_few_and_thin() {
    check_all(cases::tiny_huge_few_and_thin());
    let error = build(&Mesh::default(), &BuildOptions::default()).unwrap_err();
    assert_eq!(error, BuildError::NoTriangles, "30 zero triangles");
}

#[test]
fn invalid_rays_miss_and_end() {
    let mesh = closed_sphere(2);
    let tree = build(&mesh, &BuildOptions::default()).unwrap();
    let triangles = pack_triangles(&mesh, &tree);
    let good = Ray::new([0.0; 3], [1.0, 0.0, 0.0]);
    for kind in StructureKind::ALL {
        let structure = Structure::convert(kind, &tree, &triangles).unwrap();
        assert!(structure.closest(&good, Mode::Robust).is_some());
        for ray in [
            Ray { direction: [0.0; 3], ..good },
            Ray { direction: [f32::NAN, 0.0, 1.0], ..good },
            Ray { origin: [0.0, f32::NAN, 0.0], ..good },
            Ray { t_min: 3.0, t_max: 2.0, ..good },
            Ray { t_max: 0.0, ..good },
        ] {
            assert_eq!(structure.closest(&ray, Mode::Robust), None, "{ray:?}");
        }
    }
}

#[test]
fn axis_parallel_rays_visit_no_more_than_their_neighbours() {
    let mesh = grid(64);
    let tree = build(&mesh, &BuildOptions::default()).unwrap();
    let triangles = pack_triangles(&mesh, &tree);
    for kind in StructureKind::ALL {
        let structure = Structure::convert(kind, &tree, &triangles).unwrap();
        let visits = |ray: &Ray| {
            let mut counters = Counters::default();
            let ray = TraversalRay::new(ray, Mode::Robust).unwrap();
            structure.closest_prepared(&ray, &mut counters);
            counters.node_visits
        };
        for i in 0..65 {
            let ray = Ray::new([i as f32, 32.0, 10.0], [0.0, 0.0, -1.0]);
            let turned = (0..8).map(|k| {
                let (x, y) = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)][k];
                visits(&Ray { direction: [x as f32 * 1e-6, y as f32 * 1e-6, -1.0], ..ray })
            });
            let limit = 5 * turned.max().unwrap() + 4 * u64::from(tree.max_depth());
            assert!(visits(&ray) <= limit, "{kind} {i}: {} > {limit}", visits(&ray));
        }
    }
}

#[test]
fn a_hit_lies_in_the_box_of_its_triangle() {
    let mesh = soup([[[0.0, 0.0, 0.0], [600.0, 1e-3, 0.0], [600.0, 0.0, 1e-3]]]);
    let triangle = [Triangle::new(&mesh, 0, true)];
    let mut random = Random::new(9);
    for _ in 0..10_000 {
        let eye = [random.uniform() * 600.0, random.uniform() - 0.5, random.uniform() - 0.5];
        let target = [random.uniform() * 600.0, 2e-4, 2e-4];
        let ray = Ray::new(eye, std::array::from_fn(|k| target[k] - eye[k]));
        if let Some(hit) = brute_force(&triangle, &ray, Mode::Robust) {
            let x = f64::from(eye[0]) + f64::from(hit.t) * f64::from(ray.direction[0]);
            assert!((-1e-3..=600.001).contains(&x), "{ray:?} hit at x = {x}");
        }
    }
}
