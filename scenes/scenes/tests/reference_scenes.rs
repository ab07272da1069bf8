//! Loads the public scenes in the folder `scenes` of `$DUALSPLIT_DATA` and compares their counts with those that
//! other software found. If the variable is unset, the test passes without a check.

use std::path::PathBuf;
use std::time::Instant;

use scenes::{MeshReport, Scene, obj};

fn folder() -> Option<PathBuf> {
    testing::data("scenes")
}

#[test]
fn counts_of_public_scenes() {
    let Some(folder) = folder() else { return };
    // Name, triangles, triangles of zero area, duplicates, and the CRC-32 of all positions and indices, little-endian: a
    // change of the last changes every result that was published for the scene.
    let expected = [
        ("bunny", 69_451, 0, 0, 0x2b2a_1148),
        ("sibenik", 75_284, 9, 218, 0xc2eb_f2e5),
        ("sanmiguel_leaves", 241_608, 0, 0, 0x7ae2_91a7),
        ("crytek_sponza", 279_163, 1, 70, 0x6ca6_4b90),
        ("dragon", 871_414, 108, 0, 0x806d_0796),
    ];
    for (name, triangles, degenerate, duplicates, checksum) in expected {
        let start = Instant::now();
        let mesh = obj::load(folder.join(format!("{name}.obj.xz"))).unwrap();
        let load_ms = start.elapsed().as_millis();
        let report = MeshReport::new(&mesh);
        println!(
            "{name}: loaded in {load_ms} ms, {report:?} in {} ms",
            start.elapsed().as_millis() - load_ms
        );
        assert_eq!(
            (report.triangles, report.degenerate, report.duplicates),
            (triangles, degenerate, duplicates),
            "{name}"
        );
        let mut hasher = crc32fast::Hasher::new();
        mesh.positions.iter().flatten().for_each(|x| hasher.update(&x.to_le_bytes()));
        mesh.triangles.iter().flatten().for_each(|i| hasher.update(&i.to_le_bytes()));
        assert_eq!(hasher.finalize(), checksum, "{name}");
    }
}

/// Compares with a parse line by line, statement by statement.
#[test]
fn faces_and_coordinates_follow_the_file() {
    let Some(folder) = folder() else { return };
    let compressed = std::fs::read(folder.join("sibenik.obj.xz")).unwrap();
    let mut text = String::new();
    std::io::Read::read_to_string(&mut liblzma::read::XzDecoder::new(&compressed[..]), &mut text).unwrap();
    let statements = |keyword: &'static str| {
        text.lines().filter_map(move |line| line.strip_prefix(keyword)?.strip_prefix(' '))
    };
    let positions: Vec<[f32; 3]> = statements("v")
        .map(|line| {
            let numbers: Vec<f32> = line.split(' ').map(|word| word.parse().unwrap()).collect();
            numbers.try_into().unwrap()
        })
        .collect();
    let scene = Scene::load(folder.join("sibenik.obj.xz").to_str().unwrap(), 1.0, 0).unwrap();
    assert_eq!(scene.name, "sibenik");
    for (triangle, line) in statements("f").enumerate() {
        let corners: Vec<[f32; 3]> =
            line.split(' ').map(|word| positions[word.parse::<usize>().unwrap() - 1]).collect();
        assert_eq!(scene.mesh.corners(triangle).as_slice(), corners, "triangle {triangle}");
    }
}
