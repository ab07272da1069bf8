use super::*;
use crate::formats::report::Skip;

pub const TEXT: &str = "solid square\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0.5\nvertex 1 0 0.5\nvertex 1 1 0.5\nendloop\n\
    endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0.5\nvertex 1 1 0.5\nvertex 0 1 0.1\nendloop\nendfacet\nendsolid square\n";

fn with(from: &str, to: &str) -> String {
    assert!(TEXT.contains(from), "{from}");
    TEXT.replace(from, to)
}

#[test]
fn text_in_all_its_forms() {
    for (from, to) in [
        ("\n", "\n"),
        ("\n", "\r\n"),
        ("\n", "\r"),
        ("vertex", "   VERTEX "),
        ("solid square\nfacet", "solid\nfacet"),
        ("normal 0 0 1", "normal -nan(ind) nan inf"),
        ("endsolid square\n", ""),
        // Several solids in one file.
        ("endfacet\nfacet", "endfacet\nendsolid square\nsolid other\nfacet"),
    ] {
        assert_eq!(named(with(from, to).as_bytes(), "a.stl").unwrap().mesh, square(), "{to:?}");
    }
    let latin = [b"solid caf\xe9\n", TEXT.split_once('\n').unwrap().1.as_bytes()].concat();
    assert_eq!(named(&latin, "a.stl").unwrap().mesh, square());
    assert_eq!(named(TEXT.as_bytes(), "standard input").unwrap().report.format, Format::Stl);
}

#[test]
fn a_binary_file_may_be_called_solid() {
    let mut bytes = written("a.stl");
    bytes[..12].copy_from_slice(b"solid square");
    assert_eq!(named(&bytes, "a.stl").unwrap().mesh, square());
    let whole = bytes.len();
    bytes.extend([0; 3]);
    assert_eq!(named(&bytes, "a.stl").unwrap().report.count(Skip::Unknown), 3);
    for length in [0, 1, 83, 84, whole - 50, whole - 1] {
        assert_refused(&bytes[..length], "a.stl", "a.stl: ", &["truncated"]);
    }
    bytes[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    assert_refused(&bytes, "a.stl", "a.stl: ", &["declares 4294967295 facets and holds 2"]);
    bytes[80..84].fill(0);
    assert_refused(&bytes, "a.stl", "a.stl: ", &["no triangle"]);
}

#[test]
fn faults_name_line_or_facet() {
    for (from, to, line, word) in [
        ("vertex 0 1 0.1", "vertex 0 1 x", 13, "`x`"),
        ("vertex 0 1 0.1", "vertex 0 1 nan", 13, "not finite"),
        ("vertex 0 1 0.1", "vertex 0 1 1e38", 13, "range"),
        ("vertex 0 1 0.1", "vertex 0 1", 13, "2 numbers"),
        ("vertex 0 1 0.1\n", "", 9, "vertex"),
        ("endfacet\nendsolid square\n", "", 9, "endfacet"),
        ("outer loop\nvertex 0 0 0.5\nvertex 1 1", "inner loop\nvertex 0 0 0.5\nvertex 1 1", 9, "inner"),
    ] {
        assert_refused(with(from, to).as_bytes(), "a.stl", &format!("a.stl:{line}: "), &[word]);
    }
    assert_refused(b"solid nothing\nendsolid nothing\n", "a.stl", "a.stl: ", &["no triangle"]);
    let mut bytes = written("a.stl");
    let second = 84 + 50 + 12;
    bytes[second..second + 4].copy_from_slice(&f32::NAN.to_le_bytes());
    assert_refused(&bytes, "a.stl", "a.stl: facet 2: ", &["NaN", "not finite"]);
}
