//! The words of a statement of OBJ text.

use std::borrow::Cow;

use crate::formats::error::{FormatErrorKind, check_range};
use crate::formats::report::Skip;

/// What a statement does.
pub(super) enum Kind {
    Vertex,
    Face,
    Skipped(Skip),
}

/// What the statement that begins with the word `first` does.
pub(super) fn kind(first: &[u8]) -> Kind {
    match first {
        b"v" => Kind::Vertex,
        b"f" => Kind::Face,
        b"p" | b"l" => Kind::Skipped(Skip::NoTriangle),
        b"vn" | b"vt" | b"o" | b"g" | b"s" | b"mg" | b"usemtl" | b"mtllib" | b"usemap" | b"maplib"
        | b"lod" | b"bevel" | b"c_interp" | b"d_interp" | b"shadow_obj" | b"trace_obj" => {
            Kind::Skipped(Skip::Attribute)
        }
        // Free-form curves and surfaces, obsolete patches and outlines, and text of other files.
        b"vp" | b"cstype" | b"deg" | b"bmat" | b"step" | b"curv" | b"curv2" | b"surf" | b"parm" | b"trim"
        | b"hole" | b"scrv" | b"sp" | b"end" | b"con" | b"ctech" | b"stech" | b"fo" | b"bsp" | b"bzp"
        | b"cdc" | b"cdp" | b"res" | b"call" | b"csh" => Kind::Skipped(Skip::Geometry),
        _ => Kind::Skipped(Skip::Unknown),
    }
}

/// The words of a line.
pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
}

/// The first word of a line, empty if it has none.
pub(super) fn first_word(line: &[u8]) -> &[u8] {
    words(line).next().unwrap_or_default()
}

/// The line up to the first word that begins with `#`.
pub(super) fn without_comment(line: &[u8]) -> &[u8] {
    let begins = |at: &usize| line[*at] == b'#' && (*at == 0 || line[at - 1].is_ascii_whitespace());
    let end = (0..line.len()).find(begins).unwrap_or(line.len());
    &line[..end]
}

/// Whether the statement goes on in the next line.
pub(super) fn continued(statement: &[u8]) -> bool {
    statement.trim_ascii_end().ends_with(b"\\")
}

fn lossy(word: &[u8]) -> Cow<'_, str> {
    String::from_utf8_lossy(word)
}

/// The number that `word` is.
fn number(word: &[u8]) -> Result<f32, FormatErrorKind> {
    if let Some(value) = std::str::from_utf8(word).ok().and_then(|text| text.parse().ok()) {
        return Ok(value);
    }
    // Some C libraries print `-1.#IND00`, `1.#INF` or `nan(ind)`.
    let lower = word.to_ascii_lowercase();
    let holds = |part: &[u8]| lower.windows(part.len()).any(|window| window == part);
    let not_finite = holds(b"1.#") || holds(b"nan") || holds(b"inf");
    let text = lossy(word).into_owned();
    Err(if not_finite { FormatErrorKind::NotFinite(text) } else { FormatErrorKind::NotANumber(text) })
}

/// Checks the numbers of a vertex; writes its coordinates, and its weight if it has one and no colour.
pub(super) fn check_vertex<'t>(
    words: impl Iterator<Item = &'t [u8]>,
    out: &mut Vec<u8>,
) -> Result<(), FormatErrorKind> {
    const MOST: usize = 7;
    let mut texts: [&[u8]; MOST] = [b""; MOST];
    let mut values = [0.0_f32; MOST];
    let mut length = 0;
    for word in words {
        if length < MOST {
            texts[length] = word;
            values[length] = number(word)?;
        }
        length += 1;
    }
    let written = match length {
        3 | 4 => length,
        6 | MOST => 3,
        _ => return Err(FormatErrorKind::VertexLength(length)),
    };
    let weight = if written == 4 { values[3] } else { 1.0 };
    if weight == 0.0 {
        return Err(FormatErrorKind::ZeroWeight);
    }
    for axis in 0..3 {
        let text = || lossy(texts[axis]).into_owned();
        check_range(values[axis], text)?;
        check_range(values[axis] / weight, text)?;
    }
    out.push(b'v');
    for text in &texts[..written] {
        push_word(out, text);
    }
    out.push(b'\n');
    Ok(())
}

/// What a face consists of.
pub(super) struct Face {
    pub(super) corners: usize,
    /// The highest positive index, which may refer to a vertex further on.
    pub(super) highest: u64,
}

/// Checks the corners of a face, and writes their position indices if there are three or more.
pub(super) fn check_face<'t>(
    words: impl Iterator<Item = &'t [u8]>,
    vertices: u64,
    out: &mut Vec<u8>,
) -> Result<Face, FormatErrorKind> {
    let start = out.len();
    out.push(b'f');
    let mut face = Face { corners: 0, highest: 0 };
    for word in words {
        let end = word.iter().position(|&byte| byte == b'/').unwrap_or(word.len());
        let text = &word[..end];
        let parsed = std::str::from_utf8(text).ok().and_then(|text| text.parse::<i64>().ok());
        let index = parsed.ok_or_else(|| FormatErrorKind::BadIndex(lossy(word).into_owned()))?;
        if index == 0 {
            return Err(FormatErrorKind::ZeroIndex);
        }
        if index < 0 && index.unsigned_abs() > vertices {
            return Err(FormatErrorKind::IndexOutOfRange { index, vertices });
        }
        face.highest = face.highest.max(u64::try_from(index).unwrap_or(0));
        push_word(out, text);
        face.corners += 1;
    }
    match face.corners {
        0 => return Err(FormatErrorKind::EmptyFace),
        1 | 2 => out.truncate(start),
        _ => out.push(b'\n'),
    }
    Ok(face)
}

fn push_word(out: &mut Vec<u8>, word: &[u8]) {
    out.push(b' ');
    out.extend_from_slice(word);
}
