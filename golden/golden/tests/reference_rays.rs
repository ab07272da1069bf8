//! Traces the rays in `$DUALSPLIT_DATA/scenes` and compares with the hits that Embree 3.13 (robust) found. Passes without
//! a check if the variable is unset.

use golden::build::{BuildOptions, Quality, build};
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::traverse::Trace;
use golden::{Mode, Ray};
use rayon::prelude::*;
use render::ray_file::{FileHit, read_hits, read_rays};
use render::{CameraRays, RayClass};
use scenes::{Camera, Mesh, obj};
use std::path::PathBuf;

const SCENES: [&str; 5] = ["bunny", "sibenik", "sanmiguel_leaves", "crytek_sponza", "dragon"];

/// Side of the image that the primary rays are of, in pixels.
const SIDE: u32 = 64;

fn folder() -> Option<PathBuf> {
    testing::data("scenes")
}

/// The camera that the primary rays of `scene` come from.
fn camera(scene: &str, mesh: &Mesh) -> Camera {
    let (eye, target, up, fov_y_degrees) = match scene {
        "crytek_sponza" => ([-1200.0, 250.0, -30.0], [0.0, 280.0, -20.0], [0.0, 1.0, 0.0], 65.0),
        "sibenik" => ([-17.0, -12.5, 0.0], [0.0, -9.0, 0.0], [0.0, 1.0, 0.0], 60.0),
        "sanmiguel_leaves" => ([26.0, -2.42, 1.5], [15.0, -8.5, 7.0], [0.0, 0.0, 1.0], 60.0),
        _ => {
            let bounds = mesh.bounds().unwrap();
            let (center, diagonal) = (bounds.center(), bounds.diagonal());
            let offset = [0.15, 0.2, 0.9];
            let eye = std::array::from_fn(|axis| (center[axis] + offset[axis] * diagonal) as f32);
            (eye, center.map(|x| x as f32), [0.0, 1.0, 0.0], 45.0)
        }
    };
    Camera { eye, target, up, fov_y_degrees }
}

/// How many of `found` differ from `expected` in what is hit or missed, and how many by more than 1e-4 in distance.
fn differences(expected: &[Option<FileHit>], found: &[Option<FileHit>]) -> (usize, usize) {
    assert_eq!(expected.len(), found.len());
    let (mut outcome, mut distance) = (0, 0);
    for (a, b) in expected.iter().zip(found) {
        match (a, b) {
            (Some(a), Some(b)) => distance += usize::from((a.t - b.t).abs() > 1e-4 * a.t),
            (None, None) => {}
            _ => outcome += 1,
        }
    }
    (outcome, distance)
}

#[test]
fn hits_are_the_reference_s() {
    let Some(folder) = folder() else { return };
    let (mut rays, mut distances) = (0, 0);
    for scene in SCENES {
        let mesh = obj::load(folder.join(format!("{scene}.obj.xz"))).unwrap();
        let stream = read_rays(folder.join(format!("{scene}.rays.xz"))).unwrap();
        let expected = read_hits(folder.join(format!("{scene}.hits.xz"))).unwrap();
        assert_eq!((stream.primary_rays(), stream.waves[1].class), (SIDE * SIDE, RayClass::Secondary));
        let tree = build(&mesh, &BuildOptions::new(Quality::Fast)).unwrap();
        let triangles = pack_triangles(&mesh, &tree);
        let trace = |kind| -> Vec<Option<FileHit>> {
            let structure = Structure::convert(kind, &tree, &triangles).unwrap();
            let hit = |ray: &Ray| {
                structure.closest(ray, Mode::Robust).map(|hit| FileHit { triangle: hit.triangle, t: hit.t })
            };
            stream.rays.par_iter().map(hit).collect()
        };
        let found = trace(StructureKind::Dst);
        let (outcome, distance) = differences(&expected, &found);
        println!("{scene}: {} rays, {outcome} hit or miss, {distance} distances", found.len());
        assert_eq!(outcome, 0, "{scene}");
        rays += found.len();
        distances += distance;
        for kind in StructureKind::ALL {
            assert!(trace(kind) == found, "{scene} {kind}");
        }
    }
    assert!(distances as f64 <= 1e-5 * rays as f64, "{distances} of {rays}");
}

#[test]
fn primary_rays_are_the_reference_s() {
    let Some(folder) = folder() else { return };
    for scene in SCENES {
        let mesh = obj::load(folder.join(format!("{scene}.obj.xz"))).unwrap();
        let stream = read_rays(folder.join(format!("{scene}.rays.xz"))).unwrap();
        let camera = camera(scene, &mesh);
        let rays = CameraRays::new(&camera, SIDE, SIDE).unwrap();
        for (i, expected) in (0..SIDE * SIDE).zip(&stream.rays) {
            let found = rays.ray((i % SIDE) as f32 + 0.5, (i / SIDE) as f32 + 0.5);
            let close = |a: [f32; 3], b: [f32; 3], tolerance: f32| {
                a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance)
            };
            let scale = camera.eye.iter().fold(0f32, |m, x| m.max(x.abs()));
            assert!(close(found.origin, expected.origin, 1e-6 * scale), "{scene} {i} {found:?} {expected:?}");
            assert!(close(found.direction, expected.direction, 1e-6), "{scene} {i} {found:?} {expected:?}");
        }
    }
}
