//! Rays per second, closest hit, one thread: every structure in both modes beside `obvhs` and `bvh`.
//!
//! `cargo bench -p dualsplit-golden --bench traverse [-- FILTER]`. With `DUALSPLIT_DATA` set, the real scenes are added to the
//! built-in ones. `examples/trace_speed.rs` prints the ratios of interleaved runs.

#[path = "../tests/support/rays.rs"]
mod rays;
#[path = "../tests/support/mod.rs"]
mod support;

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use divan::Bencher;
use divan::counter::ItemsCount;
use golden::build::{BuildOptions, Quality, build};
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::traverse::Trace;
use golden::{Mode, Ray, with_structure};
use nalgebra::{Point3, Vector3};
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::ray::RayHit;
use obvhs::rt_triangle::RtTriangle;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

fn main() {
    divan::main();
}

const RAYS: [&str; 2] = ["primary", "diffuse"];
const BUILT_IN: [&str; 2] = ["atrium", "hairball"];

/// Scene and kind of rays.
fn workloads() -> Vec<(String, &'static str)> {
    let shared = if std::env::var_os("DUALSPLIT_DATA").is_some() { &support::SHARED_SCENES[..] } else { &[] };
    let names = BUILT_IN.iter().chain(shared);
    names.flat_map(|name| RAYS.map(|rays| ((*name).to_owned(), rays))).collect()
}

struct Workload {
    mesh: scenes::Mesh,
    structures: [Structure; StructureKind::ALL.len()],
    rays: BTreeMap<&'static str, Vec<Ray>>,
}

/// The workload of a scene; made once and kept.
fn workload(name: &str) -> &'static Workload {
    static MADE: Mutex<BTreeMap<String, &'static Workload>> = Mutex::new(BTreeMap::new());
    let mut made = MADE.lock().unwrap_or_else(PoisonError::into_inner);
    made.entry(name.to_owned()).or_insert_with(|| Box::leak(Box::new(make(name))))
}

fn make(name: &str) -> Workload {
    let mesh = if BUILT_IN.contains(&name) {
        scenes::Scene::load(name, 0.25, 0).expect("a built-in scene").mesh
    } else {
        support::shared_scene(name).expect("DUALSPLIT_DATA is set")
    };
    let tree = build(&mesh, &BuildOptions::new(Quality::High)).expect("a valid mesh");
    let triangles = pack_triangles(&mesh, &tree);
    let structures =
        StructureKind::ALL.map(|kind| Structure::convert(kind, &tree, &triangles).expect("a small scene"));
    let primary = rays::primary(name, &tree.nodes[0].aabb, 256);
    let diffuse = rays::diffuse(&mesh, &structures[0], &primary, 5);
    Workload { mesh, structures, rays: BTreeMap::from([("primary", primary), ("diffuse", diffuse)]) }
}

/// Structure, scene and kind of rays.
type Traced = (StructureKind, String, &'static str);

fn traced() -> Vec<Traced> {
    let of = |kind| workloads().into_iter().map(move |(name, rays)| (kind, name, rays));
    StructureKind::ALL.into_iter().flat_map(of).collect()
}

#[divan::bench(args = traced())]
fn fast(bencher: Bencher<'_, '_>, traced: &Traced) {
    trace(bencher, traced, Mode::Fast);
}

#[divan::bench(args = traced())]
fn robust(bencher: Bencher<'_, '_>, traced: &Traced) {
    trace(bencher, traced, Mode::Robust);
}

fn trace(bencher: Bencher<'_, '_>, (kind, name, rays): &Traced, mode: Mode) {
    fn run(bencher: Bencher<'_, '_>, rays: &[Ray], structure: &impl Trace, mode: Mode) {
        bencher
            .counter(ItemsCount::new(rays.len()))
            .bench(|| rays.iter().filter(|ray| structure.closest(ray, mode).is_some()).count());
    }
    let workload = workload(name);
    let structure = workload.structures.iter().find(|s| s.kind() == *kind).expect("every kind is made");
    with_structure!(structure, structure => run(bencher, &workload.rays[rays], structure, mode));
}

#[divan::bench(args = workloads())]
fn peer_obvhs_medium(bencher: Bencher<'_, '_>, (name, rays): &(String, &'static str)) {
    let workload = workload(name);
    let triangles: Vec<_> = (0..workload.mesh.triangles.len())
        .map(|i| {
            let [v0, v1, v2] = workload.mesh.corners(i).map(Into::into);
            obvhs::triangle::Triangle { v0, v1, v2 }
        })
        .collect();
    let mut build_time = Duration::ZERO;
    let bvh: Bvh2 = build_bvh2_from_tris(&triangles, BvhBuildParams::medium_build(), &mut build_time);
    let leaves: Vec<RtTriangle> =
        bvh.primitive_indices.iter().map(|&i| RtTriangle::from(&triangles[i as usize])).collect();
    let rays: Vec<_> = workload.rays[rays]
        .iter()
        .map(|ray| obvhs::ray::Ray::new(ray.origin.into(), ray.direction.into(), ray.t_min, ray.t_max))
        .collect();
    bencher.counter(ItemsCount::new(rays.len())).bench(|| {
        rays.iter()
            .filter(|ray| {
                let mut hit = RayHit::none();
                bvh.ray_traverse(**ray, &mut hit, |ray, i| leaves[i].intersect(ray))
            })
            .count()
    });
}

/// A triangle as the `bvh` crate wants it.
struct Shape {
    corners: [Point3<f32>; 3],
    node: usize,
}

impl Bounded<f32, 3> for Shape {
    fn aabb(&self) -> Aabb<f32, 3> {
        self.corners.iter().fold(Aabb::empty(), |aabb, corner| aabb.grow(corner))
    }
}

impl BHShape<f32, 3> for Shape {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

#[divan::bench(args = workloads())]
fn peer_bvh(bencher: Bencher<'_, '_>, (name, rays): &(String, &'static str)) {
    let workload = workload(name);
    let mut shapes: Vec<_> = (0..workload.mesh.triangles.len())
        .map(|i| Shape { corners: workload.mesh.corners(i).map(Point3::from), node: 0 })
        .collect();
    let bvh = Bvh::build(&mut shapes);
    let rays: Vec<_> = workload.rays[rays]
        .iter()
        .map(|ray| bvh::ray::Ray::new(Point3::from(ray.origin), Vector3::from(ray.direction)))
        .collect();
    bencher.counter(ItemsCount::new(rays.len())).bench(|| {
        rays.iter()
            .filter(|ray| {
                let mut nearest = f32::INFINITY;
                for shape in bvh.nearest_traverse_iterator(ray, &shapes) {
                    let [a, b, c] = &shape.corners;
                    nearest = nearest.min(ray.intersects_triangle(a, b, c).distance);
                }
                nearest.is_finite()
            })
            .count()
    });
}
