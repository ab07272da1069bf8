use glam::DVec3;

use super::random::Random;
use super::*;
use crate::obj;
use crate::{MAX_TRIANGLES, Mesh, MeshReport};

/// Detail at which every scene has between 5,000 and 250,000 triangles.
const SMALL: f64 = 0.02;

fn small(name: &str) -> Scene {
    build(name, SMALL, 0).unwrap()
}

/// CRC-32 of all positions and indices, little-endian.
fn checksum(mesh: &Mesh) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    mesh.positions.iter().flatten().for_each(|x| hasher.update(&x.to_le_bytes()));
    mesh.triangles.iter().flatten().for_each(|i| hasher.update(&i.to_le_bytes()));
    hasher.finalize()
}

/// A change of these values changes every result that was published for a scene.
#[test]
fn scenes_are_bit_identical_on_every_machine() {
    let expected = [
        ("atrium", 0xb887_14d9, 0x6ddb_7f76),
        ("statue", 0xd07d_0161, 0x1715_bd1e),
        ("courtyard", 0x8570_723d, 0x381c_8990),
        ("powerplant", 0xf4d7_916c, 0x430a_cd0d),
        ("vegetation", 0xabee_aff6, 0xb139_f28f),
        ("hairball", 0x7174_cc83, 0x4b3c_7fdc),
    ];
    assert_eq!(
        expected.map(|(name, ..)| name).as_slice(),
        CATALOGUE.iter().map(|e| e.name).collect::<Vec<_>>()
    );
    let found = expected.map(|(name, ..)| {
        let of_seed = |seed| checksum(&build(name, SMALL, seed).unwrap().mesh);
        (name, of_seed(0), of_seed(1))
    });
    assert_eq!(found, expected, "{found:#010x?}");
}

#[test]
fn the_catalogue_states_full_sizes() {
    for entry in CATALOGUE {
        assert_eq!(count_triangles(entry.name, 1.0, 0).unwrap(), entry.triangles as u64, "{}", entry.name);
        assert!(entry.triangles <= MAX_TRIANGLES);
        for seed in 1..4 {
            let count = count_triangles(entry.name, 1.0, seed).unwrap() as f64;
            assert!((count / entry.triangles as f64 - 1.0).abs() < 0.02, "{} with seed {seed}", entry.name);
        }
    }
}

#[test]
fn sizes_are_those_of_the_originals() {
    let millions =
        [("atrium", 0.26), ("statue", 1.15), ("courtyard", 10.5), ("powerplant", 12.7), ("hairball", 2.88)];
    for (name, size) in millions {
        let ours = find(name).unwrap().triangles as f64 * 1e-6;
        assert!((ours / size - 1.0).abs() < 0.03, "{name}: {ours} M instead of {size} M");
    }
    assert!((1_100_000..1_900_000).contains(&find("vegetation").unwrap().triangles));
}

#[test]
fn triangles_follow_the_detail() {
    for entry in CATALOGUE {
        let coarsest = count_triangles(entry.name, 1e-9, 0).unwrap();
        assert!((1_000..25_000).contains(&coarsest), "{}: {coarsest}", entry.name);
        let mut before = 0;
        for step in 0..=40 {
            let detail = 1e-3 * libm::pow(10.0, f64::from(step) * 3.0 / 40.0);
            let count = count_triangles(entry.name, detail.min(1.0), 0).unwrap();
            assert!(count >= before, "{}: {count} after {before} at detail {detail}", entry.name);
            before = count;
            let wanted = detail * entry.triangles as f64;
            if wanted > 1.5 * coarsest as f64 {
                let ratio = count as f64 / wanted;
                assert!((0.97..=1.000_01).contains(&ratio), "{}: {ratio} at detail {detail}", entry.name);
            }
        }
        assert_eq!(before, entry.triangles as u64);
    }
}

#[test]
fn counting_agrees_with_building() {
    for entry in CATALOGUE {
        for (detail, seed) in [(1e-9, 0), (0.003, 1), (SMALL, 2)] {
            let scene = build(entry.name, detail, seed).unwrap();
            let counted = count_triangles(entry.name, detail, seed).unwrap();
            assert_eq!(scene.mesh.triangles.len() as u64, counted, "{} at {detail}", entry.name);
        }
    }
}

#[test]
fn meshes_are_clean() {
    for entry in CATALOGUE {
        let scene = small(entry.name);
        let report = MeshReport::new(&scene.mesh);
        assert_eq!((report.degenerate, report.duplicates), (0, 0), "{}", entry.name);
        assert!(scene.mesh.positions.iter().flatten().all(|x| x.abs() < 200.0), "{}", entry.name);
        assert_eq!(scene.name, entry.name);
    }
}

#[test]
fn writing_and_reading_gives_the_same_mesh() {
    for entry in CATALOGUE {
        let mesh = small(entry.name).mesh;
        let mut text = Vec::new();
        obj::write(&mut text, entry.name, &mesh).unwrap();
        let back = obj::read(&text[..], entry.name).unwrap();
        assert_eq!(checksum(&back), checksum(&mesh), "{}", entry.name);
        assert_eq!(back, mesh, "{}", entry.name);
    }
}

#[test]
fn unknown_names_and_details() {
    assert_eq!(build("sponza", 1.0, 0), Err(BuildError::UnknownName("sponza".to_owned())));
    assert!(BuildError::UnknownName(String::new()).to_string().contains("hairball"));
    for detail in [0.0, -0.5, 1.0 + f64::EPSILON, f64::INFINITY] {
        assert_eq!(build("atrium", detail, 0), Err(BuildError::Detail(detail)));
    }
    assert!(matches!(count_triangles("atrium", f64::NAN, 0), Err(BuildError::Detail(_))));
}

/// Distance to the nearest triangle, by the method of Moeller and Trumbore with inclusive edges.
fn nearest(mesh: &Mesh, origin: DVec3, direction: DVec3) -> Option<f64> {
    let hits = (0..mesh.triangles.len()).filter_map(|i| {
        let [a, b, c] = mesh.corners(i).map(|p| DVec3::from(p.map(f64::from)));
        let (ab, ac) = (b - a, c - a);
        let p = direction.cross(ac);
        let determinant = ab.dot(p);
        let u = (origin - a).dot(p) / determinant;
        let q = (origin - a).cross(ab);
        let v = direction.dot(q) / determinant;
        let t = ac.dot(q) / determinant;
        (u >= -1e-9 && v >= -1e-9 && u + v <= 1.0 + 1e-9 && t > 1e-6).then_some(t)
    });
    hits.min_by(f64::total_cmp)
}

#[test]
fn no_ray_leaves_the_atrium() {
    for name in ["atrium", "statue"] {
        for detail in [1e-9, 0.05] {
            let scene = build(name, detail, 0).unwrap();
            let mut random = Random::new(7, 0, 0);
            for start in [scene.camera.eye, scene.light.position] {
                let mut origin = DVec3::from(start.map(f64::from));
                for _ in 0..150 {
                    let direction = random.direction();
                    let t = nearest(&scene.mesh, origin, direction);
                    let t =
                        t.unwrap_or_else(|| panic!("{name}: a ray from {origin} along {direction} leaves"));
                    // The next ray starts halfway to the hit, so that some rays reach the galleries too.
                    origin += direction * (0.5 * t);
                }
            }
        }
    }
}

#[test]
fn the_light_reaches_what_the_camera_looks_at() {
    for entry in CATALOGUE {
        let scene = build(entry.name, 0.004, 0).unwrap();
        let eye = DVec3::from(scene.camera.eye.map(f64::from));
        let forward = (DVec3::from(scene.camera.target.map(f64::from)) - eye).normalize();
        let light = DVec3::from(scene.light.position.map(f64::from));
        let mut random = Random::new(8, 0, 0);
        let (mut visible, mut lit) = (0, 0);
        for _ in 0..100 {
            let direction = (forward + random.direction() * 0.4).normalize();
            let Some(t) = nearest(&scene.mesh, eye, direction) else { continue };
            visible += 1;
            let point = eye + direction * (t * (1.0 - 1e-6));
            let to_light = light - point;
            let distance = to_light.length();
            if nearest(&scene.mesh, point, to_light / distance).is_none_or(|t| t >= distance) {
                lit += 1;
            }
        }
        assert!(visible > 20 && lit * 5 > visible, "{}: {visible} visible, {lit} lit", entry.name);
    }
}
