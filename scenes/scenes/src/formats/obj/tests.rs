use std::io::Write;

use liblzma::write::XzEncoder;
use proptest::prelude::*;

use super::*;
use crate::MAX_COORDINATE;
use crate::formats::SaveError;
use crate::formats::error::Place;

const XZ_MAGIC_BYTES: usize = 6;
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn parse(text: &str) -> Result<Mesh, FormatError> {
    read(text.as_bytes(), "test.obj")
}

fn triangles(text: &str) -> Vec<[u32; 3]> {
    parse(text).unwrap().triangles
}

fn compressed(text: &[u8]) -> Vec<u8> {
    let mut encoder = XzEncoder::new(Vec::new(), 1);
    encoder.write_all(text).unwrap();
    encoder.finish().unwrap()
}

/// Asserts the line of the error, its kind by a part of its name, and that the message names the file.
fn assert_rejected(bytes: &[u8], line: Option<u64>, kind: &str) {
    let error = read(bytes, "bad.obj").expect_err("the text is bad");
    assert_eq!(error.place, line.map_or(Place::File, Place::Line), "{error}");
    let name = format!("{:?}", error.kind);
    assert!(name.starts_with(kind), "{name} instead of {kind}");
    let message = error.to_string();
    let place = line.map_or("bad.obj: ".to_owned(), |line| format!("bad.obj:{line}: "));
    assert!(message.starts_with(&place), "{message}");
    assert!(message.contains("; "), "no remedy in: {message}");
}

#[test]
fn polygons_become_fans_in_file_order() {
    let text = format!("{SQUARE}f 1 2 3 4\nf 3 2 1\nf -4 -3 -2\n");
    assert_eq!(triangles(&text), [[0, 1, 2], [0, 2, 3], [2, 1, 0], [0, 1, 2]]);
}

#[test]
fn groups_and_objects_share_vertices_and_keep_the_order() {
    let text = format!(
        "mtllib none.mtl\no a\n{SQUARE}usemtl red\ng one two\nf 1 2 3\no b\nusemtl blue\ns off\nf 1 3 4\n\
         v 2 2 2\ng one\nf 1/1 2/2 5/3\nf 1//1 2//1 5//1\nf 1/9/9 5/8/8 3/7/7\nl 1 2 3\np 1\nf 2 3 5\n"
    );
    let expected = [[0, 1, 2], [0, 2, 3], [0, 1, 4], [0, 1, 4], [0, 4, 2], [1, 2, 4]];
    assert_eq!(triangles(&text), expected);
    assert_eq!(parse(&text).unwrap().positions.len(), 5);
}

#[test]
fn line_ends_indents_comments_and_continuations() {
    let text = "\u{feff}# head\r\nv 0 0 0 # origin\r\n\tv  1\t0 0\r\n  v 1 \\\r\n1 0\r\n\r\nf 1 \\\r\n 2 \\\r\n 3\r\n#f 9 9 9\r\n";
    let mesh = parse(text).unwrap();
    assert_eq!(mesh.positions, [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]);
    assert_eq!(mesh.triangles, [[0, 1, 2]]);
}

#[test]
fn no_line_feed_at_the_end() {
    assert_eq!(triangles(&format!("{SQUARE}f 1 2 3")), [[0, 1, 2]]);
}

#[test]
fn vertices_may_follow_their_faces() {
    assert_eq!(triangles(&format!("f 1 2 3\n{SQUARE}")), [[0, 1, 2]]);
}

#[test]
fn weights_divide_and_colours_are_ignored() {
    let text = "v 2 4 6 2\nv 1 0 0 0.1 0.2 0.3\nv 0 1 0 1 0.1 0.2 0.3\nf 1 2 3\n";
    assert_eq!(parse(text).unwrap().positions, [[1.0, 2.0, 3.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
}

#[test]
fn numbers_are_rounded_correctly() {
    // Halfway between two f32 and a little more; a denormal; the largest; a negative zero; many digits.
    let numbers = [
        ("1.000000059604644775390625", 1.0),
        ("1.00000005960464477539062500000001", 1.0 + f32::EPSILON),
        ("1e-45", f32::from_bits(1)),
        ("-0", -0.0),
        ("1.329227995784916e36", MAX_COORDINATE),
        ("0.1000000000000000055511151231257827", 0.1),
        ("+.5E+1", 5.0),
    ];
    for (text, expected) in numbers {
        let mesh = parse(&format!("v {text} 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).unwrap();
        assert_eq!(mesh.positions[0][0].to_bits(), expected.to_bits(), "{text}");
    }
}

#[test]
fn xz_is_recognised_by_content() {
    let text = format!("{SQUARE}f 1 2 3 4\n");
    let plain = parse(&text).unwrap();
    assert_eq!(read(&compressed(text.as_bytes())[..], "a").unwrap(), plain);
    let (head, tail) = text.as_bytes().split_at(20);
    let two_streams = [compressed(head), compressed(tail)].concat();
    assert_eq!(read(&two_streams[..], "a").unwrap(), plain);
}

#[test]
fn bad_vertices() {
    let lines = [
        ("v 1 2 NaN", "NotFinite"),
        ("v inf 2 3", "NotFinite"),
        ("v 1 -Infinity 3", "NotFinite"),
        ("v 1e39 2 3", "OutOfRange"),
        ("v 1 2 -1.3292281e36", "OutOfRange"),
        ("v 1e30 2 3 1e-10", "OutOfRange"),
        ("v 1 2 3 0", "ZeroWeight"),
        ("v 1 2 3 nan", "NotFinite"),
        ("v 1 2", "VertexLength"),
        ("v", "VertexLength"),
        ("v 1 2 3 4 5", "VertexLength"),
        ("v 1 2 3 4 5 6 7 8", "VertexLength"),
        ("v 1 2 three", "NotANumber"),
        ("v 1 2 0x3", "NotANumber"),
        ("v 1 2 3f 1 2 3", "NotANumber"),
    ];
    for (line, kind) in lines {
        assert_rejected(format!("{SQUARE}{line}\nf 1 2 3\n").as_bytes(), Some(5), kind);
    }
}

#[test]
fn bad_faces() {
    let lines = [
        ("f", "EmptyFace"),
        ("f 0 1 2", "ZeroIndex"),
        ("f 1 2 5", "IndexOutOfRange { index: 5, vertices: 4 }"),
        ("f 1 2 -5", "IndexOutOfRange { index: -5, vertices: 4 }"),
        ("f 1 2 9223372036854775807", "IndexOutOfRange"),
        ("f 1 2 99999999999999999999", "BadIndex"),
        ("f 1 2 x", "BadIndex"),
        ("f 1 2 /3", "BadIndex"),
        ("f 1 2 1.5", "BadIndex"),
    ];
    for (line, kind) in lines {
        assert_rejected(format!("{SQUARE}f 1 2 3\n{line}\nf 1 2 3\n").as_bytes(), Some(6), kind);
    }
}

#[test]
fn the_first_index_out_of_range_is_named() {
    let text = format!("f 1 2 4\nf 1 2 6\nf 1 2 5\nf 1 2 9\n{SQUARE}");
    assert_rejected(text.as_bytes(), Some(2), "IndexOutOfRange { index: 6, vertices: 4 }");
    let descending = format!("f 1 2 9\nf 1 2 6\n{SQUARE}");
    assert_rejected(descending.as_bytes(), Some(1), "IndexOutOfRange { index: 9, vertices: 4 }");
}

#[test]
fn empty_and_foreign_files() {
    assert_rejected(b"", None, "NoTriangle");
    assert_rejected(SQUARE.as_bytes(), None, "NoTriangle");
    assert_rejected(format!("{SQUARE}l 1 2 3\n").as_bytes(), None, "NoTriangle");
    assert_rejected(b"v 0 0 0\n\xff\xfe\x00\n", Some(2), "NotText");
    assert_rejected(b"\xff\xfev\x00 \x000\x00\n\x00", Some(1), "NotText");
}

#[test]
fn truncated_files() {
    assert_rejected(format!("{SQUARE}f 1 2 3\nv 1.0 2.0").as_bytes(), Some(6), "Truncated");
    assert_rejected(format!("{SQUARE}f 1 2 3\nf 1 2").as_bytes(), Some(6), "Truncated");
    assert_rejected(format!("{SQUARE}f 1 2 3\nv 1.0 2.0 -").as_bytes(), Some(6), "Truncated");
    let whole = compressed(format!("{SQUARE}f 1 2 3\n").as_bytes());
    for length in XZ_MAGIC_BYTES..whole.len() {
        let error = read(&whole[..length], "bad.obj").expect_err("the stream is cut");
        assert!(matches!(error.kind, FormatErrorKind::Truncated(_)), "{length} bytes: {error}");
    }
}

#[test]
fn damaged_streams() {
    let text: String = (0..2000).map(|i| format!("v {} {} {}\n", i, i * 7 % 13, i * i % 101)).collect();
    let whole = compressed(format!("{text}f 1 2 3\n").as_bytes());
    for position in (0..whole.len()).filter(|&position| position > XZ_MAGIC_BYTES).step_by(97) {
        let mut damaged = whole.clone();
        damaged[position] ^= 0x10;
        assert!(read(&damaged[..], "bad.obj").is_err(), "byte {position}");
    }
}

#[test]
fn missing_files() {
    let error = load("no/such/file.obj").unwrap_err();
    assert!(matches!(error.kind, FormatErrorKind::Open(_)));
    assert!(error.to_string().starts_with("no/such/file.obj: cannot open"), "{error}");
    let folder = tempfile::tempdir().unwrap();
    assert!(matches!(load(folder.path()).unwrap_err().kind, FormatErrorKind::Read(_)));
}

#[test]
fn too_many_triangles() {
    // One polygon with three corners more than there may be triangles, and the same with two more.
    let polygon = |corners: usize| format!("{SQUARE}f{}\n", " 1".repeat(corners));
    assert_rejected(polygon(crate::MAX_TRIANGLES + 3).as_bytes(), Some(5), "TooManyTriangles");
    let most = format!("{}v", polygon(crate::MAX_TRIANGLES + 2));
    assert_rejected(most.as_bytes(), Some(6), "Truncated");
}

#[test]
fn writing_is_exact_and_atomic() {
    let mesh = Mesh {
        positions: vec![
            [0.1, -0.0, 1e-45],
            [MAX_COORDINATE, f32::MIN_POSITIVE, -16_777_217.0],
            [1.0 / 3.0, -2.5, 1e20],
        ],
        triangles: vec![[0, 1, 2], [0, 0, 1]],
    };
    let folder = tempfile::tempdir().unwrap();
    for name in ["a.obj", "a.obj.xz"] {
        let path = folder.path().join(name);
        save(&path, "two words", &mesh, false).unwrap();
        let back = load(&path).unwrap();
        assert_eq!(back.triangles, mesh.triangles);
        let bits = |m: &Mesh| m.positions.iter().flatten().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&back), bits(&mesh));
        assert!(matches!(
            save(&path, "", &mesh, false),
            Err(SaveError::Write(base::output::WriteError::Exists(_)))
        ));
    }
}

#[test]
fn written_text() {
    let mesh = Mesh {
        positions: vec![[0.5, -0.0, 1e-7], [1.0, 0.0, 0.0], [0.0, 1e16, 3.0]],
        triangles: vec![[0, 1, 2]],
    };
    let mut text = Vec::new();
    write(&mut text, "my name", &mesh).unwrap();
    let expected =
        "# 1 triangles, 3 vertices\no my_name\nv 0.5 -0.0 1e-7\nv 1.0 0.0 0.0\nv 0.0 1e16 3.0\nf 1 2 3\n";
    assert_eq!(String::from_utf8(text).unwrap(), expected);
}

/// A mesh whose triangles name each vertex first in ascending order.
fn arbitrary_mesh() -> impl Strategy<Value = Mesh> {
    let coordinate = any::<u32>()
        .prop_map(f32::from_bits)
        .prop_map(|x| if x.is_finite() && x.abs() <= MAX_COORDINATE { x } else { 0.25 });
    prop::collection::vec([coordinate.clone(), coordinate.clone(), coordinate], 3..40).prop_flat_map(|p| {
        let count = p.len() as u32;
        prop::collection::vec([0..count, 0..count, 0..count], 0..40).prop_map(move |extra| {
            let first = (0..count / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
            let rest = (count / 3 * 3..count).map(|i| [i, 0, i]);
            Mesh { positions: p.clone(), triangles: first.chain(rest).chain(extra).collect() }
        })
    })
}

fn statement() -> impl Strategy<Value = String> {
    let number = prop_oneof![
        any::<f32>().prop_map(|x| x.to_string()),
        (-20i32..20).prop_map(|x| x.to_string()),
        "[-+.0-9eEinfaNx/]{0,12}",
    ];
    let keyword = prop_oneof![8 => Just("v"), 8 => Just("f"), 1 => prop::sample::select(vec![
        "o", "g", "usemtl", "mtllib", "vn", "vt", "l", "p", "s", "#", "", "\\", "ff"])];
    let end = prop_oneof![20 => Just("\n"), 2 => Just("\r\n"), 1 => Just("\\\n"), 1 => Just("")];
    (keyword, prop::collection::vec(number, 0..6), end)
        .prop_map(|(keyword, numbers, end)| format!("{keyword} {}{end}", numbers.join(" ")))
}

proptest! {
    #[test]
    fn random_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = read(&bytes[..], "random");
    }

    #[test]
    fn random_bytes_after_the_xz_header_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        prop_assert!(read(&[&compressed(b"v 0 0 0\n")[..12], &bytes].concat()[..], "random").is_err());
    }

    #[test]
    fn random_statements_give_a_valid_mesh_or_an_error(lines in prop::collection::vec(statement(), 0..60)) {
        let text = format!("{SQUARE}{}", lines.concat());
        match parse(&text) {
            Ok(mesh) => {
                prop_assert!(!mesh.triangles.is_empty());
                prop_assert!(mesh.triangles.iter().flatten().all(|&i| (i as usize) < mesh.positions.len()));
                prop_assert!(mesh.positions.iter().flatten().all(|x| x.abs() <= MAX_COORDINATE));
            }
            Err(error) => prop_assert!(!matches!(error.kind, FormatErrorKind::Rejected(_)), "{}", error),
        }
    }

    #[test]
    fn any_mesh_survives_writing_and_reading(mesh in arbitrary_mesh()) {
        let mut text = Vec::new();
        write(&mut text, "m", &mesh).unwrap();
        let back = read(&text[..], "m").unwrap();
        prop_assert_eq!(&back.triangles, &mesh.triangles);
        let bits = |m: &Mesh| m.positions.iter().map(|p| p.map(f32::to_bits)).collect::<Vec<_>>();
        prop_assert_eq!(bits(&back), bits(&mesh));
    }
}
