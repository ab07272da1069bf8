//! A million rays aimed at what breaks traversal: none of their known hits may be lost, in any structure, in robust mode or in
//! any format that is used conservatively. `dualsplit stress` runs as many as it is asked for.

use fp::Format;
use golden::Mode;
use golden::build::{BuildOptions, build};
use golden::precision::{NarrowStructure, Precision, Variant};
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::traverse::{Trace, brute_force};
use scenes::Mesh;
use stress::aimed::Aim;
use stress::shapes::{box_triangles, closed_sphere, grid, soup};

/// Small meshes with planes in general position, planes that coincide, and faces that are planes of boxes.
fn meshes() -> [(&'static str, Mesh); 3] {
    let boxes = (0..27).flat_map(|i| {
        let low = [i % 3, i / 3 % 3, i / 9].map(|c| 1.5 * c as f32);
        box_triangles(low, low.map(|x| x + 1.0))
    });
    [("sphere", closed_sphere(3)), ("grid", grid(12)), ("boxes", soup(boxes))]
}

fn structure(mesh: &Mesh, kind: StructureKind) -> Structure {
    let tree = build(mesh, &BuildOptions::default()).unwrap();
    Structure::convert(kind, &tree, &pack_triangles(mesh, &tree)).unwrap()
}

#[test]
fn robust_mode_loses_no_known_hit() {
    for (name, mesh) in meshes() {
        let structures = [StructureKind::Dst, StructureKind::Bvh2].map(|kind| structure(&mesh, kind));
        for (i, aimed) in Aim::new(&mesh, Mode::Robust, 17).take(160_000).enumerate() {
            let structure = &structures[i % structures.len()];
            let found = structure.closest(&aimed.ray, Mode::Robust);
            assert!(!aimed.is_lost(found), "{name}: {aimed:?} found {found:?}");
        }
    }
}

#[test]
fn conservative_formats_lose_no_known_hit() {
    let formats = ["e8m22", "e8m17", "tf32", "bfloat16", "binary16", "e5m2", "e4m3", "e3m4"];
    for (name, mesh) in meshes() {
        let wide = [StructureKind::Dst, StructureKind::Bvh4].map(|kind| structure(&mesh, kind));
        let narrow: Vec<_> = formats
            .iter()
            .map(|f| Precision::new(f.parse::<Format>().unwrap(), Variant::Conservative))
            .zip(wide.iter().cycle())
            .map(|(precision, wide)| NarrowStructure::new(wide, precision))
            .collect();
        for (i, aimed) in Aim::new(&mesh, Mode::Robust, 23).take(160_000).enumerate() {
            let at = i % narrow.len();
            let found = narrow[at].closest(&aimed.ray, Mode::Robust);
            assert!(!aimed.is_lost(found), "{name}, {}: {aimed:?} found {found:?}", formats[at]);
        }
    }
}

/// What is known by construction is what testing every triangle finds, and naive rounding shows that losses are seen.
#[test]
fn losses_are_seen() {
    for (name, mesh) in meshes() {
        let wide = structure(&mesh, StructureKind::Dst);
        let Structure::Dst(dst) = &wide else { unreachable!("the kind that was asked for") };
        for aimed in Aim::new(&mesh, Mode::Robust, 5).take(200) {
            assert!(
                !aimed.is_lost(brute_force(&dst.triangles, &aimed.ray, Mode::Robust)),
                "{name}: {aimed:?}"
            );
        }
        // Whole numbers are exact in every format, so that the grid shows nothing.
        let naive = NarrowStructure::new(&wide, Precision::new(Format::BFLOAT16, Variant::Naive));
        let lost = Aim::new(&mesh, Mode::Fast, 5)
            .take(1000)
            .filter(|aimed| aimed.is_lost(naive.closest(&aimed.ray, Mode::Fast)))
            .count();
        assert!(lost > 10 || name == "grid", "{name}: {lost}");
    }
}
