//! Bytes that do not matter, what is skipped, and polygons.

use super::*;
use crate::formats::report::Skip;

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn file(bytes: &[u8]) -> FileMesh {
    read_input(Input { source: &mut &*bytes, name: Path::new("test.obj"), folder: None }).unwrap()
}

fn error(text: &str) -> String {
    read(text.as_bytes(), "test.obj").unwrap_err().to_string()
}

fn counts(file: &FileMesh) -> Vec<(&str, Skip, u64, u64)> {
    file.report.skipped.iter().map(|s| (s.what.as_str(), s.why, s.count, s.first_line)).collect()
}

/// Twice the area of the mesh, signed by its direction as seen along z.
fn area(mesh: &Mesh) -> f64 {
    let of = |t| {
        let [a, b, c] = mesh.corners(t).map(|p| p.map(f64::from));
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    (0..mesh.triangles.len()).map(of).sum()
}

/// Sum of the triangles' unsigned areas, twice; equal to [`area`] only if all go round the same way.
fn covered(mesh: &Mesh) -> f64 {
    let one = |t| area(&Mesh { positions: mesh.positions.clone(), triangles: vec![mesh.triangles[t]] }).abs();
    (0..mesh.triangles.len()).map(one).sum()
}

#[test]
fn names_and_comments_may_hold_any_bytes() {
    for name in [&b"Caf\xe9"[..], b"\x83\x65\x83\x58\x83\x67", b"\xff\xff"] {
        let text =
            [b"# ", name, b"\no ", name, b"\nusemtl ", name, b"\n", SQUARE.as_bytes(), b"f 1 2 3 # ", name]
                .concat();
        let file = file(&text);
        assert_eq!(file.mesh.triangles, [[0, 1, 2]]);
        assert_eq!(file.report.replaced_names, 2);
        let (first, line) = file.report.first_replaced_name.unwrap();
        assert!(first.starts_with("o ") && first.contains('\u{fffd}') && line == 2, "{first}");
    }
}

#[test]
fn elements_that_are_no_triangle_are_counted() {
    let file = file(format!("{SQUARE}f 1 2\nl 1 2 3\nf 3\np 1\nl 3 4\nf 1 2 3\n").as_bytes());
    assert_eq!(file.mesh.triangles, [[0, 1, 2]]);
    let expected = [
        ("faces of fewer than three corners", Skip::NoTriangle, 2, 5),
        ("l", Skip::NoTriangle, 2, 6),
        ("p", Skip::NoTriangle, 1, 8),
    ];
    assert_eq!(counts(&file), expected);
    assert_eq!(file.report.notes().len(), 3);
    assert!(error(&format!("{SQUARE}f 1 9\nf 1 2 3\n")).starts_with("test.obj:5: vertex index 9"));
}

#[test]
fn every_skipped_statement_is_counted() {
    let text = format!(
        "vt 0 0\nvn 0 0 1\ncurv 0 1 1 \\\n 2 3 \\\n 4\nfo 1 2 3\nFacet 1\n{SQUARE}cstype bezier\nf 1 2 3\nFacet 2\nvt 1 \\\n"
    );
    let expected = [
        ("vt", Skip::Attribute, 2, 1),
        ("vn", Skip::Attribute, 1, 2),
        ("curv", Skip::Geometry, 1, 3),
        ("fo", Skip::Geometry, 1, 6),
        ("Facet", Skip::Unknown, 2, 7),
        ("cstype", Skip::Geometry, 1, 12),
    ];
    let file = file(text.as_bytes());
    assert_eq!(counts(&file), expected);
    assert_eq!(file.report.notes().len(), 4);
    // However many kinds there are, the report stays short.
    let kinds: String = (0..1000).map(|kind| format!("kind{kind} 0\n")).collect();
    let report = self::file(format!("{SQUARE}f 1 2 3\n{kinds}").as_bytes()).report;
    assert_eq!((report.skipped.len(), report.count(Skip::Unknown)), (33, 1000));
}

#[test]
fn a_number_sign_inside_a_word_starts_no_comment() {
    for (word, what) in [
        ("-1.#IND00", "is not finite"),
        ("1.#INF", "is not finite"),
        ("1.#QNAN", "is not finite"),
        ("-nan(ind)", "is not finite"),
        ("3#4", "is not a number"),
    ] {
        let message = error(&format!("v 0 0 0\nv 1 0 0\nv 0 1 {word}\nf 1 2 3\n"));
        assert!(
            message.starts_with("test.obj:3: ") && message.contains(word) && message.contains(what),
            "{message}"
        );
    }
    assert_eq!(file(format!("{SQUARE}f 1 2 3 #4\n").as_bytes()).mesh.triangles, [[0, 1, 2]]);
}

#[test]
fn only_vertices_and_faces_go_on_after_a_backslash() {
    for line in ["usemtl Wood\\", "o C:\\", "# path\\", "g a b \\ ", "unknown \\", "l 1 2 \\"] {
        let file = file(format!("{SQUARE}{line}\nf 1 2 3\n{line}\nf 1 3 4\n").as_bytes());
        assert_eq!(file.mesh.triangles, [[0, 1, 2], [0, 2, 3]], "{line}");
    }
    assert_eq!(file(format!("{SQUARE}f 1 2 3 # \\\nf 1 3 4\n").as_bytes()).mesh.triangles.len(), 2);
    assert_eq!(
        file(format!("{SQUARE}f 1 2 \\\n3\\\n 4\n").as_bytes()).mesh.triangles,
        [[0, 1, 2], [0, 2, 3]]
    );
}

#[test]
fn a_carriage_return_ends_a_line() {
    let text = format!("# head\r{SQUARE}f 1 2 3\r\nf 1 3 4\r");
    let expected = file(text.as_bytes());
    assert_eq!(expected.mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(file(text.replace("\r\n", "\r").replace('\n', "\r").as_bytes()).mesh, expected.mesh);
    let message = error("v 0 0 0\rv 1 0 0\rv 0 1 x\rf 1 2 3\r");
    assert!(message.starts_with("test.obj:3: `x`"), "{message}");
}

#[test]
fn concave_polygons_keep_their_outline() {
    let dart = file(b"v 0 0 0\nv 2 -1 0\nv 0.5 0 0\nv 2 1 0\nf 2 3 4 1\n");
    assert_eq!((area(&dart.mesh), covered(&dart.mesh)), (1.0, 1.0));
    assert_eq!(dart.report.polygons.concave, 1);
    let u = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\n";
    for face in ["f 1 2 3 4 5 6 7 8", "f 4 5 6 7 8 1 2 3", "f 8 7 6 5 4 3 2 1"] {
        let file = file(format!("{u}{face}\n").as_bytes());
        assert_eq!((area(&file.mesh).abs(), covered(&file.mesh)), (14.0, 14.0), "{face}");
        assert_eq!(area(&file.mesh) > 0.0, face != "f 8 7 6 5 4 3 2 1", "{face}");
        assert_eq!(file.report.polygons.concave, 1, "{face}");
        assert!(file.report.notes()[0].contains("concave"));
    }
}

/// The folder with faulty inputs, if there is one: each loads as its description says.
#[test]
fn faulty_inputs() {
    let Some(folder) = testing::data("faults") else { return };
    let load = |name: &str| super::super::load(&folder.join(name), None);
    for (name, triangles, twice_the_area) in [
        ("concave_dart.obj", 2, 1.0),
        ("concave_U.obj", 6, 14.0),
        ("latin1.obj", 1, 1.0),
        ("f2.obj", 1, 1.0),
        ("cr_only.obj", 1, 1.0),
        ("cr_mixed.obj", 1, 1.0),
        ("usemtl.obj", 2, 2.0),
    ] {
        let mesh = load(name).unwrap().mesh;
        assert_eq!((mesh.triangles.len(), covered(&mesh)), (triangles, twice_the_area), "{name}");
    }
    assert!(load("latin1.obj").unwrap().report.first_replaced_name.unwrap().0.contains("Caf\u{fffd}"));
    let message = load("ind.obj").unwrap_err().to_string();
    assert!(message.contains("ind.obj:3: ") && message.contains("-1.#IND00"), "{message}");
}
