use super::*;
use crate::formats::report::Skip;

pub const TEXT: &str = "ply\nformat ascii 1.0\ncomment made by hand\nobj_info none\nelement vertex 4\nproperty float x\n\
    property float y\nproperty float z\nproperty uchar red\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n\
    0 0 0.5 255\n1 0 0.5 255\n1 1 0.5 0\n0 1 0.1 0\n3 0 1 2\n3 0 2 3\n";

/// The text with `from` replaced by `to`.
fn with(from: &str, to: &str) -> String {
    assert!(TEXT.contains(from), "{from}");
    TEXT.replace(from, to)
}

fn mesh(text: &[u8]) -> Mesh {
    named(text, "a.ply").unwrap().mesh
}

#[test]
fn text_in_all_its_forms() {
    assert_eq!(mesh(TEXT.as_bytes()), square());
    for (from, to) in [
        ("\n", "\r\n"),
        ("\n", "\r"),
        ("vertex_indices", "vertex_index"),
        ("property float", "property double"),
        ("1 0 0.5 255", "1. 0.0e0 .5 255"),
        ("1 0 0.5 255", "+1 -0.e1 5.e-1 255"),
        ("end_header\n", "end_header\n\n"),
        ("3 0 1 2\n", "  3 0\t1  2  \n"),
        ("element face", "element material 1\nproperty int id\nelement face"),
    ] {
        let changed = with(from, to);
        let changed =
            if to.contains("material") { changed.replace("3 0 1 2", "7\n3 0 1 2") } else { changed };
        assert_eq!(mesh(changed.as_bytes()), square(), "{changed:?}");
    }
    let latin =
        [b"ply\nformat ascii 1.0\ncomment caf\xe9\n", TEXT.split_once("none\n").unwrap().1.as_bytes()]
            .concat();
    assert_eq!(mesh(&latin), square());
    let trimmed = TEXT.trim_end();
    assert_eq!(mesh(trimmed.as_bytes()), square());
}

#[test]
fn binary_of_both_orders() {
    let positions = square().positions;
    let header = |order: &str, ending: &str| {
        format!(
            "ply\nformat binary_{order}_endian 1.0\nelement face 1\nproperty list uint ushort vertex_indices\nproperty float q\n\
             element vertex 4\nproperty float x\nproperty float y\nproperty short n\nproperty float z\nend_header\n"
        )
        .replace('\n', ending)
    };
    for (order, ending) in [("little", "\n"), ("big", "\n"), ("little", "\r\n"), ("big", "\r")] {
        let big = order == "big";
        let mut bytes = header(order, ending).into_bytes();
        let mut push = |value: &[u8]| bytes.extend(value.iter().copied());
        let four = |x: u32| if big { x.to_be_bytes() } else { x.to_le_bytes() };
        let two = |x: u16| if big { x.to_be_bytes() } else { x.to_le_bytes() };
        push(&four(4));
        (0..4).for_each(|i| push(&two(i)));
        // A value that looks like an end of a line.
        push(&four(0x0a0d_0a0d));
        for [x, y, z] in &positions {
            push(&four(x.to_bits()));
            push(&four(y.to_bits()));
            push(&two(9));
            push(&four(z.to_bits()));
        }
        let file = named(&bytes, "a.ply").unwrap();
        assert_eq!(file.mesh, square(), "{order} {ending:?}");
        for length in header(order, ending).len()..bytes.len() {
            assert_refused(&bytes[..length], "a.ply", "a.ply: ", &["truncated"]);
        }
        bytes.push(7);
        assert_eq!(named(&bytes, "a.ply").unwrap().report.count(Skip::Unknown), 1);
    }
}

#[test]
fn polygons_and_faces_without_area() {
    let text = with("element face 2", "element face 3").replace("3 0 1 2\n3 0 2 3", "4 0 1 2 3\n2 0 1\n0");
    let file = named(text.as_bytes(), "a.ply").unwrap();
    assert_eq!(file.mesh, square());
    assert_eq!((file.report.count(Skip::NoTriangle), file.report.polygons.non_planar), (2, 1));
    let strips = with("end_header", "element tristrips 1\nproperty list int int vertex_indices\nend_header");
    let file = named(format!("{strips}4 0 1 2 3\n").as_bytes(), "a.ply").unwrap();
    assert_eq!(file.report.count(Skip::Geometry), 1);
}

#[test]
fn faults_name_line_or_element() {
    for (from, to, start, words) in [
        ("1 0 0.5 255", "1 0 nan 255", "a.ply:14: ", &["nan", "not finite"][..]),
        ("1 0 0.5 255", "1 0 -1.#IND00 255", "a.ply:14: ", &["-1.#IND00"]),
        ("1 0 0.5 255", "1 0 1e37 255", "a.ply:14: ", &["range"]),
        ("1 0 0.5 255", "1 0 x 255", "a.ply:14: ", &[]),
        ("1 0 0.5 255", "1 0", "a.ply:14: ", &[]),
        ("3 0 1 2", "3 0 1 -2", "a.ply:17: ", &["negative"]),
        ("3 0 1 2", "3 0 1 4", "a.ply: face 0: ", &["4 is out of range"]),
        ("3 0 1 2", "3 0 1", "a.ply:17: ", &[]),
        ("3 0 2 3\n", "", "a.ply", &["truncated"]),
        ("element face 2", "element face 4000000000", "a.ply: element face: ", &["4000000000", "truncated"]),
        (
            "element vertex 4",
            "element vertex 18446744073709551615",
            "a.ply: element vertex: ",
            &["truncated"],
        ),
        ("element vertex 4", "element vertex 99999999999999999999", "a.ply:5: ", &[]),
        ("property float z\n", "", "a.ply: element vertex: ", &["x, y, z"]),
        (
            "property list uchar int vertex_indices",
            "property int vertex_indices",
            "a.ply: element face: ",
            &[],
        ),
        ("property uchar red", "property float x", "a.ply: ", &["same name"]),
        ("element face 2", "element vertex 2", "a.ply: ", &["same name"]),
        ("element face 2", "element empty 9\nelement face 2", "a.ply: element empty: ", &["no property"]),
        ("property uchar red", "property half red", "a.ply:9: ", &[]),
        ("end_header\n", "", "a.ply", &[]),
        ("format ascii 1.0\n", "", "a.ply", &[]),
        ("3 0 1 2\n3 0 2 3", "2 0 1\n2 0 2", "a.ply: ", &["no triangle"]),
    ] {
        assert_refused(with(from, to).as_bytes(), "a.ply", start, words);
    }
    assert_refused(b"plyish", "a.ply", "a.ply:1: ", &["ply"]);
}
