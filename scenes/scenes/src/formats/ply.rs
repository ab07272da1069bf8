//! Stanford PLY files, as text or binary.
//!
//! `ply-rs-bw` reads the header and each element. The reader checks before it calls that crate: the header's lines, whose comments
//! may hold any bytes, the declared counts against the bytes that are left, and numbers such as `.5`, which the crate's grammar
//! does not know.

use std::path::Path;

use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};

use super::error::{FormatError, FormatErrorKind, Place, check_range};
use super::polygons::Triangulator;
use super::report::{FileReport, Skip};
use super::{FileMesh, Format, Input, whole};
use crate::mesh::Mesh;

const AXES: [&str; 3] = ["x", "y", "z"];
/// Names of the property that lists a face's vertices.
const CORNERS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// Reads a PLY file.
pub(super) fn read(input: Input<'_>) -> Result<FileMesh, FormatError> {
    let Input { source, name, .. } = input;
    let bytes = whole(source).map_err(|e| FormatErrorKind::reading(e).at(name, Place::File))?;
    let (header, payload) = Payload::of(&bytes, name)?;
    let mut report = FileReport::new(Format::Ply);
    let mut mesh = Mesh::default();
    // The corners of all faces, and where those of each face end.
    let (mut corners, mut ends) = (Vec::new(), Vec::new());
    let mut elements = payload;
    for (_, element) in &header.elements {
        elements.check_count(element)?;
        match element.name.as_str() {
            "vertex" => {
                elements.require(element, &AXES, |kind| matches!(kind, PropertyType::Scalar(_)))?;
                elements.each(element, |item: Item| {
                    mesh.positions.push(item.checked_position()?);
                    Ok(())
                })?;
            }
            "face" => {
                elements.require(element, &CORNERS, |kind| matches!(kind, PropertyType::List(..)))?;
                elements.each(element, |item: Item| {
                    corners.extend(item.corners()?);
                    ends.push(corners.len());
                    Ok(())
                })?;
            }
            other => {
                let why = if other == "tristrips" { Skip::Geometry } else { Skip::Attribute };
                report.skip_many(other, why, element.count as u64, 0);
                elements.each(element, |_: Item| Ok(()))?;
            }
        }
    }
    let beyond = elements.bytes.trim_ascii().len();
    if beyond > 0 {
        report.skip_many("bytes after the last element", Skip::Unknown, beyond as u64, 0);
    }
    let mut triangulator = Triangulator::new();
    let starts = std::iter::once(0).chain(ends.iter().copied());
    for (number, (start, &end)) in starts.zip(&ends).enumerate() {
        let face = &corners[start..end];
        let fault = |kind: FormatErrorKind| kind.at(name, Place::Element(format!("face {number}")));
        let vertices = mesh.positions.len() as u64;
        if let Some(&index) = face.iter().find(|&&index| u64::from(index) >= vertices) {
            return Err(fault(FormatErrorKind::IndexOutOfRange { index: index.into(), vertices }));
        }
        if face.len() < 3 {
            report.skip_many("faces of fewer than three corners", Skip::NoTriangle, 1, 0);
        } else {
            triangulator.push(&mesh.positions, face, &mut mesh.triangles).map_err(fault)?;
        }
    }
    report.polygons = triangulator.counts;
    if mesh.triangles.is_empty() {
        return Err(FormatErrorKind::NoTriangle.at(name, Place::File));
    }
    Ok(FileMesh { mesh, report })
}

/// The elements of a file, of which the next is read.
struct Payload<'a> {
    bytes: &'a [u8],
    encoding: Encoding,
    /// Lines that were read, the header's among them; for text.
    line: u64,
    name: &'a Path,
}

impl<'a> Payload<'a> {
    /// The header of `bytes`, and what follows it.
    fn of(bytes: &'a [u8], name: &'a Path) -> Result<(Header, Self), FormatError> {
        let (text, lines, rest) = header(bytes)
            .map_err(|(line, what)| FormatErrorKind::Invalid(what).at(name, Place::Line(line)))?;
        let mut reader = Reader::new(text.as_bytes());
        let header = Parser::<Item>::new().read_header(&mut reader).map_err(|e| {
            // The cleaned header has a line for each line of the file.
            let place = e.line().map_or(Place::File, |line| Place::Line(line as u64));
            FormatErrorKind::Invalid(first_line(&e.to_string())).at(name, place)
        })?;
        let declared = text.lines().filter(|line| line.starts_with("property")).count();
        let distinct: usize = header.elements.values().map(|element| element.properties.len()).sum();
        let elements = text.lines().filter(|line| line.starts_with("element")).count();
        if declared != distinct || elements != header.elements.len() {
            let what = "two elements, or two properties of an element, have the same name".to_owned();
            return Err(FormatErrorKind::Invalid(what).at(name, Place::File));
        }
        let encoding = header.encoding;
        Ok((header, Self { bytes: rest, encoding, line: lines, name }))
    }

    /// Refuses a count of elements that the rest of the file cannot hold.
    fn check_count(&self, element: &ElementDef) -> Result<(), FormatError> {
        let at_file = |kind: FormatErrorKind| {
            Err(kind.at(self.name, Place::Element(format!("element {}", element.name))))
        };
        if element.properties.is_empty() && element.count > 0 {
            return at_file(FormatErrorKind::Invalid("it has no property".to_owned()));
        }
        let text = self.encoding == Encoding::Ascii;
        let bytes_each: usize = element
            .properties
            .values()
            .map(|property| match &property.data_type {
                // A digit and what ends it.
                _ if text => 2,
                PropertyType::Scalar(kind) | PropertyType::List(kind, _) => bytes(kind),
            })
            .sum();
        // The last line of text may have no end.
        let most = (self.bytes.len() + usize::from(text)) / bytes_each.max(1);
        if element.count > most {
            let what = format!("it declares {} of them, and there is room for {most}", element.count);
            return at_file(FormatErrorKind::Truncated(what));
        }
        Ok(())
    }

    /// Refuses an element without the properties that it needs: all of [`AXES`], or one of [`CORNERS`].
    fn require(
        &self,
        element: &ElementDef,
        names: &[&str],
        is_kind: impl Fn(&PropertyType) -> bool,
    ) -> Result<(), FormatError> {
        let has =
            |name: &&str| element.properties.get(*name).is_some_and(|property| is_kind(&property.data_type));
        let enough = if names == AXES { names.iter().all(has) } else { names.iter().any(has) };
        if enough || element.count == 0 {
            return Ok(());
        }
        let what =
            format!("it needs the properties {}", names.join(if names == AXES { ", " } else { " or " }));
        Err(FormatErrorKind::Invalid(what).at(self.name, Place::Element(format!("element {}", element.name))))
    }

    /// Reads all of `element`, and gives each to `take`.
    fn each(
        &mut self,
        element: &ElementDef,
        mut take: impl FnMut(Item) -> Result<(), FormatErrorKind>,
    ) -> Result<(), FormatError> {
        let parser = Parser::<Item>::new();
        for number in 0..element.count {
            let item = match self.encoding {
                Encoding::Ascii => self.text_line(element).and_then(|line| {
                    parser
                        .read_ascii_element(&line, element)
                        .map_err(|e| not_finite(&line).unwrap_or_else(|| invalid(&e)))
                }),
                Encoding::BinaryLittleEndian => {
                    parser.read_little_endian_element(&mut self.bytes, element).map_err(|e| invalid(&e))
                }
                Encoding::BinaryBigEndian => {
                    parser.read_big_endian_element(&mut self.bytes, element).map_err(|e| invalid(&e))
                }
            };
            item.and_then(&mut take).map_err(|kind| {
                let place = match self.encoding {
                    Encoding::Ascii => Place::Line(self.line),
                    _ => Place::Element(format!("{} {number}", element.name)),
                };
                kind.at(self.name, place)
            })?;
        }
        Ok(())
    }

    /// The next line that has a word, with its numbers as the parser's grammar wants them.
    fn text_line(&mut self, element: &ElementDef) -> Result<String, FormatErrorKind> {
        loop {
            let (line, rest) = split_line(self.bytes);
            if line.is_empty() && rest.is_empty() && self.bytes.is_empty() {
                return Err(FormatErrorKind::Truncated(format!("inside the elements {}", element.name)));
            }
            self.bytes = rest;
            self.line += 1;
            let mut text = String::with_capacity(line.len() + 8);
            for word in String::from_utf8_lossy(line).split_ascii_whitespace() {
                if !text.is_empty() {
                    text.push(' ');
                }
                push_number(&mut text, word);
            }
            if !text.is_empty() {
                return Ok(text);
            }
        }
    }
}

/// The line at the start of `bytes` without its end, and what follows.
fn split_line(bytes: &[u8]) -> (&[u8], &[u8]) {
    let end = bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(bytes.len());
    let (line, rest) = bytes.split_at(end);
    let rest = rest.strip_prefix(b"\r\n").or_else(|| rest.get(1..)).unwrap_or_default();
    (line, rest)
}

/// Appends a number with digits on both sides of its point.
fn push_number(text: &mut String, word: &str) {
    let Some((before, after)) = word.split_once('.') else { return text.push_str(word) };
    text.push_str(before);
    if matches!(before, "" | "-" | "+") {
        text.push('0');
    }
    text.push('.');
    if after.is_empty() || after.starts_with(['e', 'E']) {
        text.push('0');
    }
    text.push_str(after);
}

/// The header as text without comments, the number of its lines, and what follows it; or the line at fault and why.
fn header(bytes: &[u8]) -> Result<(String, u64, &[u8]), (u64, String)> {
    let first = bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(bytes.len());
    // In binary files, only what ends the first line ends the last: the next byte may look like an end.
    let ending: &[u8] = match &bytes[first..] {
        [b'\r', b'\n', ..] => b"\r\n",
        [b'\r', ..] => b"\r",
        _ => b"\n",
    };
    let mut rest = bytes;
    let mut text = String::new();
    let mut lines = 0;
    loop {
        let end = rest.windows(ending.len()).position(|window| window == ending);
        let line = &rest[..end.unwrap_or(rest.len())];
        lines += 1;
        let words = String::from_utf8_lossy(line);
        let words = words.trim();
        if lines == 1 && words != "ply" {
            return Err((1, "the first line is not `ply`".to_owned()));
        }
        // A line for each line keeps the numbers of lines.
        let keep = !words.is_empty() && !words.starts_with("comment") && !words.starts_with("obj_info");
        text.push_str(if keep { words } else { "comment" });
        text.push('\n');
        rest = end.map_or(&[][..], |end| &rest[end + ending.len()..]);
        if words == "end_header" {
            return Ok((text, lines, rest));
        }
        if rest.is_empty() {
            return Err((lines, "the header has no end".to_owned()));
        }
    }
}

fn first_line(text: &str) -> String {
    text.lines().next().unwrap_or_default().trim_start_matches("Line ").to_owned()
}

/// What an error of the parser means.
fn invalid(error: &ply_rs_bw::parser::ParseError) -> FormatErrorKind {
    if error.kind() == std::io::ErrorKind::UnexpectedEof {
        return FormatErrorKind::Truncated("inside an element".to_owned());
    }
    FormatErrorKind::Invalid(first_line(&error.to_string()))
}

/// The word of `line` that is infinite or not a number, which the parser's grammar does not know.
fn not_finite(line: &str) -> Option<FormatErrorKind> {
    let word = line.split(' ').find(|word| word.contains(|c: char| "nN#".contains(c)))?;
    Some(FormatErrorKind::NotFinite(word.to_owned()))
}

fn bytes(kind: &ScalarType) -> usize {
    match kind {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}

/// What counts of an element: a position or the corners of a face.
struct Item {
    position: [f32; 3],
    /// `None` for a negative index.
    corners: Option<Vec<u32>>,
}

impl Item {
    fn checked_position(&self) -> Result<[f32; 3], FormatErrorKind> {
        for x in self.position {
            check_range(x, || x.to_string())?;
        }
        Ok(self.position)
    }

    fn corners(self) -> Result<Vec<u32>, FormatErrorKind> {
        self.corners
            .ok_or_else(|| FormatErrorKind::Invalid("a vertex index is negative or no integer".to_owned()))
    }

    fn set(&mut self, name: &str, value: f32) -> PropertyAccessResult {
        let Some(axis) = AXES.iter().position(|axis| *axis == name) else {
            return PropertyAccessResult::Ignored;
        };
        self.position[axis] = value;
        PropertyAccessResult::Set
    }
}

impl PropertyAccess for Item {
    fn new() -> Self {
        Self { position: [0.0; 3], corners: Some(Vec::new()) }
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if CORNERS.contains(&name) {
            self.corners = property.to_u32_list();
            return PropertyAccessResult::Set;
        }
        property.to_f32_lossy().map_or(PropertyAccessResult::Ignored, |value| self.set(name, value))
    }

    fn set_float(&mut self, name: &str, value: f32) -> PropertyAccessResult {
        self.set(name, value)
    }
}
