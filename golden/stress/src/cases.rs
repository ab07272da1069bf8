//! The ways in which ray libraries lose hits, as measured on nine libraries.
//!
//! Cases 26 (invalid vertices) and 30 (no triangles) are errors of the builder and have no rays.

use super::shapes::{Random, blob, box_triangles, closed_sphere, grid, moved, soup};
use golden::{Aabb, Ray};
use scenes::Mesh;

/// A mesh and rays against it.
#[derive(Clone, Debug)]
pub struct Case {
    /// Number and content.
    pub name: &'static str,
    /// The geometry.
    pub mesh: Mesh,
    /// The rays.
    pub rays: Vec<Ray>,
    /// Whether every ray is known to hit something.
    pub closed: bool,
}

fn case(name: &'static str, mesh: Mesh, rays: Vec<Ray>, closed: bool) -> Case {
    Case { name, mesh, rays, closed }
}

/// All cases. The cases that need an object take [`stand_in`].
#[must_use]
pub fn all() -> Vec<Case> {
    let mut cases = closed_spheres();
    cases.extend(axis_rays_onto_a_grid());
    cases.push(rays_in_faces_of_boxes());
    cases.extend(scales(&stand_in()));
    cases.extend(duplicates_and_degenerates());
    cases.extend(tiny_huge_few_and_thin());
    cases
}

/// An object of the size and the number of triangles of a small scan.
#[must_use]
pub fn stand_in() -> Mesh {
    moved(&blob(5), 0.075, [0.0; 3])
}

fn towards(eye: [f32; 3], target: [f32; 3]) -> Ray {
    Ray::new(eye, std::array::from_fn(|k| target[k] - eye[k]))
}

/// Rays from random points well inside the unit sphere, scaled and moved, to `targets` in turn.
#[must_use]
pub fn from_inside(targets: &[[f32; 3]], scale: f32, offset: [f32; 3], count: usize) -> Vec<Ray> {
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

/// Cases 0 to 5: a closed sphere from inside.
#[must_use]
pub fn closed_spheres() -> Vec<Case> {
    let sphere = closed_sphere(5);
    let vertices = from_inside(&sphere.positions, 1.0, [0.0; 3], 20_000);
    let edges = from_inside(&edge_midpoints(&sphere), 1.0, [0.0; 3], 20_000);
    let centre = sphere.positions.iter().cycle().take(20_000).map(|p| towards([0.0; 3], *p)).collect();
    let mut cases = vec![
        case("0 sphere, eye -> vertices", sphere.clone(), vertices, true),
        case("1 sphere, eye -> edge midpoints", sphere.clone(), edges, true),
        case("2 sphere, centre -> vertices", sphere.clone(), centre, true),
    ];
    for (name, scale, offset) in [
        ("3 sphere x 1e6", 1e6, [0.0; 3]),
        ("4 sphere x 1e-6", 1e-6, [0.0; 3]),
        ("5 sphere + 1e4", 1.0, [1e4; 3]),
    ] {
        let mesh = moved(&sphere, scale, offset);
        let rays = from_inside(&mesh.positions, scale, offset, 20_000);
        cases.push(case(name, mesh, rays, true));
    }
    cases
}

/// Cases 6 to 9: axis-parallel rays onto whole-numbered vertices and edges, and rays that start on the surface.
#[must_use]
pub fn axis_rays_onto_a_grid() -> Vec<Case> {
    let mesh = grid(64);
    let down = |x: f32, y: f32, zero: f32| Ray::new([x, y, 10.0], [zero, zero, -1.0]);
    let lattice = || (0..65).flat_map(|y| (0..65).map(move |x| (x as f32, y as f32)));
    let inner = || lattice().filter(|(x, y)| *x < 64.0 && *y < 64.0);
    let vertices = |zero: f32| lattice().map(|(x, y)| down(x, y, zero)).collect();
    let edges = inner().map(|(x, y)| down(x + 0.5, y, 0.0)).collect();
    let on = inner().map(|(x, y)| Ray::new([x + 0.25, y + 0.5, 0.0], [0.1, 0.2, -1.0])).collect();
    // The same with planes in general position: the origin is a corner, which is on its triangles exactly.
    let sphere = closed_sphere(4);
    let on_corner = sphere.positions.iter().map(|p| Ray::new(*p, p.map(|x| -x))).collect();
    vec![
        case("6 grid vertices, +0", mesh.clone(), vertices(0.0), true),
        case("7 grid vertices, -0", mesh.clone(), vertices(-0.0), true),
        case("8 grid edges", mesh.clone(), edges, true),
        case("9 origin on the triangle", mesh, on, true),
        case("9b origin on a corner", sphere, on_corner, true),
    ]
}

/// Case 10: rays in the faces of boxes, through their middle and along their border.
#[must_use]
pub fn rays_in_faces_of_boxes() -> Case {
    let mut corners = vec![];
    let mut rays = vec![];
    for i in 0..64 {
        let low = [i % 4, i / 4 % 4, i / 16].map(|c| 3.0 * c as f32);
        let high = low.map(|x| x + 1.0);
        corners.extend(box_triangles(low, high));
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
    case("10 rays in faces of boxes", soup(corners), rays, true)
}

/// Rays from a point outside to the centroids of random triangles.
#[must_use]
pub fn to_centroids(mesh: &Mesh, count: usize, length: f32) -> Vec<Ray> {
    let bounds = Aabb::of_points(&mesh.positions);
    let eye = std::array::from_fn(|k| bounds.max[k] + (bounds.max[k] - bounds.min[k]));
    let mut random = Random::new(3);
    (0..count)
        .map(|_| {
            let [a, b, c] = mesh.corners(random.below(mesh.triangles.len()));
            let centroid = std::array::from_fn(|k| a[k] / 3.0 + b[k] / 3.0 + c[k] / 3.0);
            let ray = towards(eye, centroid);
            let norm = ray.direction.iter().map(|d| f64::from(*d) * f64::from(*d)).sum::<f64>().sqrt();
            let scale = if length == 0.0 { 1.0 } else { f64::from(length) / norm };
            Ray { direction: ray.direction.map(|d| (f64::from(d) * scale) as f32), ..ray }
        })
        .collect()
}

/// Cases 11 to 23: `object` at all scales, far from the origin, with directions of all lengths, and minute in a stadium.
#[must_use]
pub fn scales(object: &Mesh) -> Vec<Case> {
    let mut cases = vec![];
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
        let mesh = moved(object, scale, [offset, 0.0, 0.0]);
        let rays = to_centroids(&mesh, 1500, 0.0);
        cases.push(case(name, mesh, rays, false));
    }
    for (name, length) in
        [("19 |d| = 1e-20", 1e-20), ("20 |d| = 1e-8", 1e-8), ("21 |d| = 1e8", 1e8), ("22 |d| = 1e18", 1e18)]
    {
        cases.push(case(name, object.clone(), to_centroids(object, 1500, length), false));
    }
    let mut stadium = moved(object, 1e-3, [0.0; 3]);
    let rays = to_centroids(&stadium, 1500, 0.0);
    let first = stadium.positions.len() as u32;
    stadium.positions.extend([[-1e5, -1.0, -1e5], [1e5, -1.0, -1e5], [1e5, -1.0, 1e5], [-1e5, -1.0, 1e5]]);
    stadium.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    cases.push(case("23 teapot in a stadium", stadium, rays, true));
    cases
}

/// A closed sphere with points and segments among its triangles.
#[must_use]
pub fn sphere_with_degenerates() -> Mesh {
    let sphere = closed_sphere(3);
    let mut corners: Vec<_> = (0..sphere.triangles.len()).map(|i| sphere.corners(i)).collect();
    let mut random = Random::new(5);
    for _ in 0..200 {
        let (p, q) = (random.in_sphere(), random.in_sphere());
        corners.extend([[p, p, p], [p, q, p], [p, q, std::array::from_fn(|k| 2.0 * q[k] - p[k])]]);
    }
    soup(corners)
}

/// Cases 24 and 25: duplicates, points and segments.
#[must_use]
pub fn duplicates_and_degenerates() -> Vec<Case> {
    let one = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let same = soup(std::iter::repeat_n(one, 100_000));
    let rays = (0..16).map(|i| Ray::new([0.02 * i as f32, 0.25, 1.0], [0.0, 0.0, -1.0])).collect();
    let from_inside = from_inside(&closed_sphere(3).positions, 1.0, [0.0; 3], 500);
    vec![
        case("24 100,000 identical triangles", same, rays, true),
        case("25 points and segments among triangles", sphere_with_degenerates(), from_inside, true),
    ]
}

/// Cases 27 to 32: minute spheres, a single triangle, slivers, sizes over 25 orders of magnitude.
#[must_use]
pub fn tiny_huge_few_and_thin() -> Vec<Case> {
    let mut cases = vec![];
    for (name, radius) in [("27 sphere of radius 1e-40", 1e-40f32), ("28 sphere of radius 1e-20", 1e-20)] {
        let mesh = moved(&closed_sphere(3), radius, [0.0; 3]);
        let rays = from_inside(&mesh.positions, radius, [0.0; 3], 500);
        cases.push(case(name, mesh, rays, true));
    }
    let one = soup([[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]]);
    let ray = Ray::new([0.25, 0.25, 1.0], [0.0, 0.0, -1.0]);
    cases.push(case("29 single triangle", one, vec![ray], true));

    let mut random = Random::new(11);
    let slivers: Vec<[[f32; 3]; 3]> = (0..40_000)
        .map(|_| {
            let (p, d) = (random.in_sphere().map(|x| x * 1e3), random.in_sphere());
            let end = std::array::from_fn(|k| p[k] + d[k] * 1e4);
            [p, end, [p[0] + 1e-4, p[1], p[2]]]
        })
        .collect();
    let rays = (0..600).map(|i| towards([0.0, 2e4, 0.0], slivers[61 * i][1])).collect();
    cases.push(case("31 slivers", soup(slivers), rays, false));

    let sizes: Vec<[[f32; 3]; 3]> = (0..300)
        .map(|i| {
            let s = libm::powf(10.0, 25.0 * i as f32 / 300.0);
            [[s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, s]]
        })
        .collect();
    let rays = sizes.iter().map(|t| towards([0.0; 3], t[0].map(|x| x / 3.0 + t[0][0] / 3.0))).collect();
    cases.push(case("32 sizes 1 to 1e25", soup(sizes), rays, false));
    cases
}
