//! Compares traversal speed with `obvhs` on the real scenes: same rays, one thread, medians of the
//! processor time of interleaved runs.
//!
//! `DUALSPLIT_DATA=... cargo run --release -p dualsplit-golden --example trace_speed [-- SCENE...]`
//!
//! SCENE is a real scene, or a built-in one and its detail, such as `hairball:1`.

#[path = "../tests/support/rays.rs"]
mod rays;
#[path = "../tests/support/mod.rs"]
mod support;

use golden::build::{BuildOptions, Quality, build};
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::traverse::Trace;
use golden::{Mode, Ray, with_structure};
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::ray::RayHit;
use obvhs::rt_triangle::RtTriangle;
use obvhs::triangle::Triangle;
use std::hint::black_box;
use std::time::Duration;

use cpu_time::ThreadTime;

const ROUNDS: usize = 7;

fn main() {
    let chosen: Vec<String> = std::env::args().skip(1).collect();
    println!("| scene | rays | obvhs Mrays/s | structure | mode | Mrays/s | vs obvhs | vs bvh2 |");
    println!("|---|---|---|---|---|---|---|---|");
    let all = support::SHARED_SCENES.map(str::to_owned);
    for name in if chosen.is_empty() { &all[..] } else { &chosen } {
        let mesh = match name.split_once(':') {
            Some((scene, detail)) => {
                let detail = detail.parse().expect("SCENE:DETAIL with a number");
                Some(scenes::Scene::load(scene, detail, 0).expect("a built-in scene").mesh)
            }
            None => support::shared_scene(name),
        };
        let Some(mesh) = mesh else {
            return eprintln!("set DUALSPLIT_DATA to the folder that holds scenes/");
        };
        compare(name, &mesh);
    }
}

fn trace_all(structure: &impl Trace, rays: &[Ray], mode: Mode) {
    for ray in rays {
        black_box(structure.closest(ray, mode));
    }
}

fn compare(name: &str, mesh: &scenes::Mesh) {
    let triangles: Vec<Triangle> = (0..mesh.triangles.len())
        .map(|i| {
            let [v0, v1, v2] = mesh.corners(i).map(Into::into);
            Triangle { v0, v1, v2 }
        })
        .collect();
    let mut build_time = Duration::ZERO;
    let peer = build_bvh2_from_tris(&triangles, BvhBuildParams::medium_build(), &mut build_time);
    let peer_triangles: Vec<RtTriangle> =
        peer.primitive_indices.iter().map(|&i| RtTriangle::from(&triangles[i as usize])).collect();
    let trace_peer = |rays: &[Ray]| {
        for ray in rays {
            let ray = obvhs::ray::Ray::new(ray.origin.into(), ray.direction.into(), ray.t_min, ray.t_max);
            let mut hit = RayHit::none();
            peer.ray_traverse(ray, &mut hit, |ray, i| peer_triangles[i].intersect(ray));
            black_box(hit.t);
        }
    };

    let leaf = std::env::var("LEAF").map_or(4, |l| l.parse().expect("a number"));
    let tree =
        build(mesh, &BuildOptions { quality: Quality::High, max_leaf_size: leaf }).expect("a valid mesh");
    let packed = pack_triangles(mesh, &tree);
    let ours: Vec<_> =
        StructureKind::ALL.map(|k| Structure::convert(k, &tree, &packed).expect("a small scene")).into();
    for structure in &ours {
        eprintln!("{name}: {} {:.1} MB", structure.kind(), structure.node_bytes() as f64 / 1e6);
    }
    let primary = rays::primary(name, &tree.nodes[0].aabb, 256);
    let diffuse = rays::diffuse(mesh, &ours[0], &primary, 5);
    for (label, rays) in [("primary", &primary), ("diffuse", &diffuse)] {
        let mut times: Vec<Vec<f64>> = vec![vec![]; 1 + 2 * ours.len()];
        let run = |i: usize| match i {
            0 => trace_peer(rays),
            _ => {
                let mode = if i % 2 == 1 { Mode::Fast } else { Mode::Robust };
                with_structure!(&ours[(i - 1) / 2], structure => trace_all(structure, rays, mode));
            }
        };
        for _ in 0..ROUNDS {
            for (i, times) in times.iter_mut().enumerate() {
                let start = ThreadTime::now();
                run(i);
                times.push(start.elapsed().as_secs_f64());
            }
        }
        let speed: Vec<f64> = times
            .iter_mut()
            .map(|t| {
                t.sort_by(f64::total_cmp);
                rays.len() as f64 / t[ROUNDS / 2] / 1e6
            })
            .collect();
        for i in 1..speed.len() {
            let (structure, mode) = (&ours[(i - 1) / 2], if i % 2 == 1 { "fast" } else { "robust" });
            println!(
                "| {name} | {label} {} | {:.2} | {} | {mode} | {:.2} | {:.2} | {:.2} |",
                rays.len(),
                speed[0],
                structure.kind(),
                speed[i],
                speed[i] / speed[0],
                speed[i] / speed[2 - i % 2],
            );
        }
    }
}
