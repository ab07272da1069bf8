//! Stereolithography files, as text or binary.
//!
//! `stl_io` reads the facets. It takes every file that begins with `solid` for text, wants UTF-8, lower case and finite normals,
//! and ends at the first `endsolid`. The reader therefore decides by the size whether a file is binary, and rewrites text line by
//! line, so that only the corners matter. Equal corners become one vertex.

use std::collections::HashMap;
use std::io::Cursor;

use super::error::{FormatError, FormatErrorKind, Place, check_range};
use super::lines::Lines;
use super::report::{FileReport, Skip};
use super::{FileMesh, Format, Input, whole};
use crate::mesh::{MAX_TRIANGLES, Mesh};

const TITLE_BYTES: usize = 80;
const HEADER_BYTES: usize = 84;
const FACET_BYTES: usize = 50;
/// Bytes of a file that decide whether it is text.
const START_BYTES: usize = 512;
/// Bytes of an unknown keyword that a report shows.
const MOST_KEYWORD_BYTES: usize = 24;

/// Reads an STL file.
pub(super) fn read(input: Input<'_>) -> Result<FileMesh, FormatError> {
    let Input { source, name, .. } = input;
    let mut report = FileReport::new(Format::Stl);
    let bytes = whole(source).map_err(|e| FormatErrorKind::reading(e).at(name, Place::File))?;
    let (bytes, lines) = if is_text(&bytes) {
        let (text, lines) =
            rewritten(&bytes, &mut report).map_err(|(line, kind)| kind.at(name, Place::Line(line)))?;
        (text, Some(lines))
    } else {
        (checked(bytes, &mut report).map_err(|kind| kind.at(name, Place::File))?, None)
    };
    let place = |facet: usize| match &lines {
        None => Place::Element(format!("facet {}", facet + 1)),
        Some(lines) => lines.get(facet).map_or(Place::File, |&line| Place::Line(line)),
    };
    let mesh = facets(bytes, place).map_err(|(place, kind)| kind.at(name, place))?;
    Ok(FileMesh { mesh, report })
}

/// The number of facets that a binary file declares.
fn declared_facets(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(TITLE_BYTES..HEADER_BYTES)?;
    Some(u32::from_le_bytes(count.try_into().expect("four bytes")) as usize)
}

/// Whether the file is text. The title of a binary file may begin with `solid` as well.
fn is_text(bytes: &[u8]) -> bool {
    let is_binary =
        declared_facets(bytes).is_some_and(|facets| HEADER_BYTES + facets * FACET_BYTES == bytes.len());
    let start = bytes.trim_ascii_start();
    let solid = start.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    !is_binary && solid && !bytes[..bytes.len().min(START_BYTES)].contains(&0)
}

/// A binary file whose count fits what it holds, under a title that the parser does not take for text.
fn checked(mut bytes: Vec<u8>, report: &mut FileReport) -> Result<Vec<u8>, FormatErrorKind> {
    let Some(declared) = declared_facets(&bytes) else {
        let what =
            format!("it has {} bytes, and the header of a binary STL file {HEADER_BYTES}", bytes.len());
        return Err(FormatErrorKind::Truncated(what));
    };
    let held = (bytes.len() - HEADER_BYTES) / FACET_BYTES;
    if declared > held {
        return Err(FormatErrorKind::Truncated(format!("it declares {declared} facets and holds {held}")));
    }
    let beyond = bytes.len() - HEADER_BYTES - declared * FACET_BYTES;
    if beyond > 0 {
        report.skip_many("bytes after the last facet", Skip::Unknown, beyond as u64, 0);
    }
    bytes[..TITLE_BYTES].fill(0);
    Ok(bytes)
}

/// The facets of text as the parser wants them, and the line of each.
fn rewritten(bytes: &[u8], report: &mut FileReport) -> Result<(Vec<u8>, Vec<u64>), (u64, FormatErrorKind)> {
    let mut lines = Lines::new(bytes);
    let mut line = Vec::new();
    let mut text = b"solid s\n".to_vec();
    let mut facets = Vec::new();
    let mut inside = false;
    while lines.next(&mut line).map_err(|e| (lines.number, FormatErrorKind::reading(e)))?.is_some() {
        line.make_ascii_lowercase();
        let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        match words.next() {
            None => {}
            Some(b"facet") => {
                facets.push(lines.number);
                text.extend_from_slice(b"facet normal 0 0 0\n");
                inside = true;
            }
            Some(b"solid" | b"endsolid") if !inside => {}
            Some(b"color") => report.skip("color", Skip::Attribute, lines.number),
            Some(word) if !inside => {
                let word = &word[..word.len().min(MOST_KEYWORD_BYTES)];
                report.skip(&String::from_utf8_lossy(word), Skip::Unknown, lines.number);
            }
            Some(first) => {
                let start = text.len();
                text.extend_from_slice(first);
                let mut numbers = 0;
                for word in words {
                    if first == b"vertex" {
                        check_coordinate(word).map_err(|kind| (lines.number, kind))?;
                        numbers += 1;
                    }
                    text.push(b' ');
                    text.extend_from_slice(word);
                }
                if first == b"vertex" && numbers != 3 {
                    let what = format!("a vertex has {numbers} numbers instead of 3");
                    return Err((lines.number, FormatErrorKind::Invalid(what)));
                }
                inside = first != b"endfacet";
                if std::str::from_utf8(&text[start..]).is_err() {
                    return Err((lines.number, FormatErrorKind::NotText("bytes that are not UTF-8")));
                }
                text.push(b'\n');
            }
        }
        line.clear();
    }
    text.extend_from_slice(b"endsolid s\n");
    Ok((text, facets))
}

/// Refuses a word that is no coordinate.
fn check_coordinate(word: &[u8]) -> Result<(), FormatErrorKind> {
    let text = || String::from_utf8_lossy(word).into_owned();
    let value = std::str::from_utf8(word).ok().and_then(|word| word.parse().ok());
    check_range(value.ok_or_else(|| FormatErrorKind::NotANumber(text()))?, text)
}

/// The mesh of the facets of `bytes`, of which `place` says where facet `i` is.
fn facets(bytes: Vec<u8>, place: impl Fn(usize) -> Place) -> Result<Mesh, (Place, FormatErrorKind)> {
    let invalid = |facet, e: std::io::Error| (place(facet), FormatErrorKind::Invalid(e.to_string()));
    let mut cursor = Cursor::new(bytes);
    let mut mesh = Mesh::default();
    let mut vertices = HashMap::new();
    for (number, facet) in stl_io::create_stl_reader(&mut cursor).map_err(|e| invalid(0, e))?.enumerate() {
        let facet = facet.map_err(|e| invalid(number, e))?;
        if number == MAX_TRIANGLES {
            return Err((Place::File, FormatErrorKind::TooManyTriangles));
        }
        let mut triangle = [0; 3];
        for (corner, vertex) in triangle.iter_mut().zip(facet.vertices) {
            for x in vertex.0 {
                check_range(x, || x.to_string()).map_err(|kind| (place(number), kind))?;
            }
            *corner = *vertices.entry(vertex.0.map(f32::to_bits)).or_insert_with(|| {
                mesh.positions.push(vertex.0);
                mesh.positions.len() as u32 - 1
            });
        }
        mesh.triangles.push(triangle);
    }
    if mesh.triangles.is_empty() {
        return Err((Place::File, FormatErrorKind::NoTriangle));
    }
    Ok(mesh)
}
