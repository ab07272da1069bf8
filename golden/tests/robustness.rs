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
use support::oracle::exact_hit;
use support::shapes::{Random, blob, closed_sphere, grid, moved};
use support::soup;

/// How many rays of a case are compared with brute force, and with the oracle where they miss.
const BRUTE_FORCE_TESTS: usize = 20_000_000;

struct Case {
    name: &'static str,
    mesh: Mesh,
    rays: Vec<Ray>,
    /// Whether every ray is known to hit.
    closed: bool,
}

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

fn check(name: &'static str, mesh: Mesh, rays: Vec<Ray>, closed: bool) {
    assert_eq!(count(&Case { name, mesh, rays, closed }), Misses::default(), "{name}");
}

fn towards(eye: [f32; 3], target: [f32; 3]) -> Ray {
    Ray::new(eye, std::array::from_fn(|k| target[k] - eye[k]))
}

/// Rays from random points well inside the unit sphere, scaled and moved, to `targets` in turn.
fn from_inside(targets: &[[f32; 3]], scale: f32, offset: [f32; 3], count: usize) -> Vec<Ray> {
    let mut random = Random::new(7);
    (0..count)
        .map(|i| {
            let eye = random.in_sphere().map(|x| 0.5 * x * scale);
            towards(std::array::from_fn(|k| eye[k] + offset[k]), targets[i % targets.len()])
        })
        .collect()
}

fn edge_midpoints(mesh: &Mesh) -> Vec<[f32; 3]> {
    let midpoint = |[a, b, _]: [[f32; 3]; 3]| std::array::from_fn(|k| (a[k] + b[k]) / 2.0);
    (0..mesh.triangles.len()).map(|i| midpoint(mesh.corners(i))).collect()
}

#[test]
fn cases_0_to_5_closed_sphere_from_inside() {
    let sphere = closed_sphere(5);
    let rays = from_inside(&sphere.positions, 1.0, [0.0; 3], 20_000);
    check("0 sphere, eye -> vertices", sphere.clone(), rays, true);
    let rays = from_inside(&edge_midpoints(&sphere), 1.0, [0.0; 3], 20_000);
    check("1 sphere, eye -> edge midpoints", sphere.clone(), rays, true);
    let rays = sphere.positions.iter().cycle().take(20_000).map(|p| towards([0.0; 3], *p)).collect();
    check("2 sphere, centre -> vertices", sphere.clone(), rays, true);
    for (name, scale, offset) in [
        ("3 sphere x 1e6", 1e6, [0.0; 3]),
        ("4 sphere x 1e-6", 1e-6, [0.0; 3]),
        ("5 sphere + 1e4", 1.0, [1e4; 3]),
    ] {
        let mesh = moved(&sphere, scale, offset);
        let rays = from_inside(&mesh.positions, scale, offset, 20_000);
        check(name, mesh, rays, true);
    }
}

#[test]
fn cases_6_to_9_axis_parallel_rays_onto_a_grid() {
    let mesh = grid(64);
    let down = |x: f32, y: f32, zero: f32| Ray::new([x, y, 10.0], [zero, zero, -1.0]);
    let lattice = || (0..65).flat_map(|y| (0..65).map(move |x| (x as f32, y as f32)));
    for (name, zero) in [("6 grid vertices, +0", 0.0), ("7 grid vertices, -0", -0.0)] {
        check(name, mesh.clone(), lattice().map(|(x, y)| down(x, y, zero)).collect(), true);
    }
    let inner = || lattice().filter(|(x, y)| *x < 64.0 && *y < 64.0);
    check("8 grid edges", mesh.clone(), inner().map(|(x, y)| down(x + 0.5, y, 0.0)).collect(), true);
    let on = inner().map(|(x, y)| Ray::new([x + 0.25, y + 0.5, 0.0], [0.1, 0.2, -1.0])).collect();
    check("9 origin on the triangle", mesh, on, true);
    // The same with planes in general position: the origin is a corner, which is on its triangles exactly.
    let sphere = closed_sphere(4);
    let on = sphere.positions.iter().map(|p| Ray::new(*p, p.map(|x| -x))).collect();
    check("9b origin on a corner", sphere, on, true);
}

#[test]
fn case_10_rays_in_the_faces_of_boxes() {
    let mut corners = vec![];
    let mut rays = vec![];
    for i in 0..64 {
        let low = [i % 4, i / 4 % 4, i / 16].map(|c| 3.0 * c as f32);
        let high = low.map(|x| x + 1.0);
        corners.extend(support::shapes::box_triangles(low, high));
        for axis in 0..3 {
            for (side, other) in [(0, 1), (0, 2), (1, 1), (1, 2), (2, 1), (2, 2)] {
                // Along `axis`, in the face of the next or the one after, through the face's middle or its border.
                let (face, across) = ((axis + other) % 3, (axis + 3 - other) % 3);
                let mut origin = [0.0; 3];
                origin[axis] = -1.0;
                origin[face] = if side == 0 { low[face] } else { high[face] };
                origin[across] = if side == 2 { low[across] } else { low[across] + 0.5 };
                let direction = std::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 });
                rays.push(Ray::new(origin, direction));
            }
        }
    }
    assert_eq!(rays.len(), 1152);
    check("10 rays in faces of boxes", soup(corners), rays, true);
}

/// Rays from a point outside to the centroids of random triangles.
fn to_centroids(mesh: &Mesh, count: usize, length: f32) -> Vec<Ray> {
    let bounds = golden::Aabb::of_points(&mesh.positions);
    let eye = std::array::from_fn(|k| bounds.max[k] + (bounds.max[k] - bounds.min[k]));
    let mut random = Random::new(3);
    (0..count)
        .map(|_| {
            let [a, b, c] = mesh.corners(random.below(mesh.triangles.len()));
            let centroid = std::array::from_fn(|k| a[k] / 3.0 + b[k] / 3.0 + c[k] / 3.0);
            let ray = towards(eye, centroid);
            let norm = ray.direction.iter().map(|d| f64::from(*d).powi(2)).sum::<f64>().sqrt();
            let scale = if length == 0.0 { 1.0 } else { f64::from(length) / norm };
            Ray { direction: ray.direction.map(|d| (f64::from(d) * scale) as f32), ..ray }
        })
        .collect()
}

fn bunnies() -> Vec<(&'static str, Mesh)> {
    let blob = ("blob", moved(&blob(5), 0.075, [0.0; 3]));
    std::iter::once(blob).chain(support::shared_scene("bunny").map(|mesh| ("bunny", mesh))).collect()
}

#[test]
fn cases_11_to_23_scales_offsets_and_direction_lengths() {
    for (which, bunny) in bunnies() {
        println!("{which}:");
        for (name, scale, offset) in [
            ("11 native scale", 1.0, 0.0),
            ("12 x 1e-3", 1e-3, 0.0),
            ("13 x 1e-6", 1e-6, 0.0),
            ("14 x 1e3", 1e3, 0.0),
            ("15 x 1e9", 1e9, 0.0),
            ("16 x 1e17", 1e17, 0.0),
            ("17 x 1e20", 1e20, 0.0),
            ("18 x 1e3 at x = 1e6", 1e3, 1e6),
        ] {
            let mesh = moved(&bunny, scale, [offset, 0.0, 0.0]);
            let rays = to_centroids(&mesh, 1500, 0.0);
            check(name, mesh, rays, false);
        }
        for (name, length) in [
            ("19 |d| = 1e-20", 1e-20),
            ("20 |d| = 1e-8", 1e-8),
            ("21 |d| = 1e8", 1e8),
            ("22 |d| = 1e18", 1e18),
        ] {
            check(name, bunny.clone(), to_centroids(&bunny, 1500, length), false);
        }
        let rays = to_centroids(&moved(&bunny, 1e-3, [0.0; 3]), 1500, 0.0);
        let mut stadium = moved(&bunny, 1e-3, [0.0; 3]);
        let first = stadium.positions.len() as u32;
        stadium.positions.extend([
            [-1e5, -1.0, -1e5],
            [1e5, -1.0, -1e5],
            [1e5, -1.0, 1e5],
            [-1e5, -1.0, 1e5],
        ]);
        stadium.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        check("23 teapot in a stadium", stadium, rays, true);
    }
}

#[test]
fn cases_24_to_26_duplicates_degenerates_and_invalid_vertices() {
    let one = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let rays = (0..16).map(|i| Ray::new([0.02 * i as f32, 0.25, 1.0], [0.0, 0.0, -1.0])).collect();
    check("24 100,000 identical triangles", soup(std::iter::repeat_n(one, 100_000)), rays, true);

    let sphere = closed_sphere(3);
    let mut corners: Vec<_> = (0..sphere.triangles.len()).map(|i| sphere.corners(i)).collect();
    let mut random = Random::new(5);
    for _ in 0..200 {
        let (p, q) = (random.in_sphere(), random.in_sphere());
        corners.extend([[p, p, p], [p, q, p], [p, q, std::array::from_fn(|k| 2.0 * q[k] - p[k])]]);
    }
    let rays = from_inside(&sphere.positions, 1.0, [0.0; 3], 500);
    check("25 points and segments among triangles", soup(corners.clone()), rays, true);

    for bad in [f32::NAN, f32::INFINITY] {
        corners[17][1][2] = bad;
        let error = build(&soup(corners.clone()), &BuildOptions::default()).unwrap_err();
        assert!(matches!(error, BuildError::NonFiniteVertex { triangle: 17, .. }), "26: {error}");
    }
}

#[test]
fn cases_27_to_32_tiny_huge_few_and_thin() {
    for (name, radius) in [("27 sphere of radius 1e-40", 1e-40f32), ("28 sphere of radius 1e-20", 1e-20)] {
        let mesh = moved(&closed_sphere(3), radius, [0.0; 3]);
        let rays = from_inside(&mesh.positions, radius, [0.0; 3], 500);
        check(name, mesh, rays, true);
    }
    let one = soup([[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]]);
    check("29 single triangle", one, vec![Ray::new([0.25, 0.25, 1.0], [0.0, 0.0, -1.0])], true);
    let error = build(&Mesh::default(), &BuildOptions::default()).unwrap_err();
    assert_eq!(error, BuildError::NoTriangles, "30 zero triangles");

    let mut random = Random::new(11);
    let slivers: Vec<[[f32; 3]; 3]> = (0..40_000)
        .map(|_| {
            let (p, d) = (random.in_sphere().map(|x| x * 1e3), random.in_sphere());
            let end = std::array::from_fn(|k| p[k] + d[k] * 1e4);
            [p, end, [p[0] + 1e-4, p[1], p[2]]]
        })
        .collect();
    let rays = (0..600).map(|i| towards([0.0, 2e4, 0.0], slivers[61 * i][1])).collect();
    check("31 slivers", soup(slivers), rays, false);

    let sizes: Vec<[[f32; 3]; 3]> = (0..300)
        .map(|i| {
            let s = 10f32.powf(25.0 * i as f32 / 300.0);
            [[s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, s]]
        })
        .collect();
    let rays = sizes.iter().map(|t| towards([0.0; 3], t[0].map(|x| x / 3.0 + t[0][0] / 3.0))).collect();
    check("32 sizes 1 to 1e25", soup(sizes), rays, false);
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
        let ray = towards(eye, [random.uniform() * 600.0, 2e-4, 2e-4]);
        if let Some(hit) = brute_force(&triangle, &ray, Mode::Robust) {
            let x = f64::from(eye[0]) + f64::from(hit.t) * f64::from(ray.direction[0]);
            assert!((-1e-3..=600.001).contains(&x), "{ray:?} hit at x = {x}");
        }
    }
}
