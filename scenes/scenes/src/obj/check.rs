//! A reader that checks OBJ text on its way to the parser.
//!
//! `tobj` parses numbers, resolves negative indices and triangulates correctly, but it reports no line
//! numbers, drops a face with two corners, takes a polyline for a polygon, starts a new vertex list at each
//! group, and can panic on bad indices of normals. [`CheckedReader`] therefore checks each line and hands on
//! only what forms the mesh: the coordinates of `v` and the position indices of `f`, in file order.

use std::io::{self, BufRead, Read};
use std::path::Path;

use super::error::{ObjError, ObjErrorKind};
use crate::mesh::{MAX_COORDINATE, MAX_TRIANGLES};

const CHUNK_BYTES: usize = 1 << 16;
const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// Presents `source` as the statements that form the mesh. The first fault ends the text, and the reader keeps it.
pub(super) struct CheckedReader<'a, R> {
    source: R,
    path: &'a Path,
    /// The current statement, with continuation lines joined.
    statement: Vec<u8>,
    line: u64,
    vertices: u64,
    triangles: usize,
    /// Indices beyond the vertices read so far, with their lines, in ascending order of both.
    forward_references: Vec<(u64, u64)>,
    checked: Vec<u8>,
    consumed: usize,
    ended: bool,
    fault: Option<ObjError>,
}

impl<'a, R: BufRead> CheckedReader<'a, R> {
    pub(super) fn new(source: R, path: &'a Path) -> Self {
        Self {
            source,
            path,
            statement: Vec::new(),
            line: 0,
            vertices: 0,
            triangles: 0,
            forward_references: Vec::new(),
            checked: Vec::with_capacity(CHUNK_BYTES + 256),
            consumed: 0,
            ended: false,
            fault: None,
        }
    }

    /// The fault that ended the text, if any.
    pub(super) fn into_fault(self) -> Option<ObjError> {
        self.fault
    }

    fn error(&self, line: Option<u64>, kind: ObjErrorKind) -> ObjError {
        ObjError { path: self.path.to_owned(), line, kind }
    }

    /// Reads one statement; false at the end of the file.
    fn read_statement(&mut self) -> Result<bool, ObjError> {
        self.statement.clear();
        loop {
            let start = self.statement.len();
            let read = self.source.read_until(b'\n', &mut self.statement);
            let bytes = read.map_err(|e| self.error(Some(self.line + 1), read_error_kind(e)))?;
            if bytes == 0 {
                return Ok(start > 0);
            }
            self.line += 1;
            if self.line == 1 && self.statement.starts_with(BYTE_ORDER_MARK) {
                self.statement.drain(..BYTE_ORDER_MARK.len());
            }
            if self.statement.trim_ascii_end().last() != Some(&b'\\') {
                return Ok(true);
            }
            let end = self.statement.trim_ascii_end().len() - 1;
            self.statement.truncate(end);
            self.statement.push(b' ');
        }
    }

    fn check_statement(&mut self) -> Result<(), ObjErrorKind> {
        let text = std::str::from_utf8(&self.statement).map_err(|_| ObjErrorKind::NotUtf8)?;
        let text = text.split_once('#').map_or(text, |(statement, _comment)| statement);
        let mut words = text.split_ascii_whitespace();
        match words.next() {
            Some("v") => {
                check_vertex(words, &mut self.checked)?;
                self.vertices += 1;
            }
            Some("f") => {
                let (triangles, highest) = check_face(words, self.vertices, &mut self.checked)?;
                self.triangles += triangles;
                if self.triangles > MAX_TRIANGLES {
                    return Err(ObjErrorKind::TooManyTriangles);
                }
                let known = self.forward_references.last().map_or(self.vertices, |&(index, _)| index);
                if highest > known.max(self.vertices) {
                    self.forward_references.push((highest, self.line));
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn check_end(&self) -> Result<(), ObjError> {
        let beyond = self.forward_references.iter().find(|&&(index, _)| index > self.vertices);
        if let Some(&(index, line)) = beyond {
            let kind = ObjErrorKind::IndexOutOfRange {
                index: i64::try_from(index).unwrap_or(i64::MAX),
                vertices: self.vertices,
            };
            return Err(self.error(Some(line), kind));
        }
        if self.triangles == 0 {
            return Err(self.error(None, ObjErrorKind::NoTriangle));
        }
        Ok(())
    }

    /// Fills `checked` with whole statements.
    fn refill(&mut self) -> Result<(), ObjError> {
        self.checked.clear();
        self.consumed = 0;
        while self.checked.len() < CHUNK_BYTES && !self.ended {
            if self.read_statement()? {
                if let Err(kind) = self.check_statement() {
                    let cut = !self.statement.ends_with(b"\n");
                    return Err(self.error(Some(self.line), if cut { truncated(kind) } else { kind }));
                }
            } else {
                self.ended = true;
                self.check_end()?;
            }
        }
        Ok(())
    }
}

impl<R: BufRead> BufRead for CheckedReader<'_, R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.consumed == self.checked.len()
            && let Err(fault) = self.refill()
        {
            self.checked.clear();
            self.ended = true;
            self.fault = Some(fault);
            return Err(io::Error::from(io::ErrorKind::InvalidData));
        }
        Ok(&self.checked[self.consumed..])
    }

    fn consume(&mut self, amount: usize) {
        self.consumed += amount;
    }
}

impl<R: BufRead> Read for CheckedReader<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut available = self.fill_buf()?;
        let bytes = available.read(buffer)?;
        self.consume(bytes);
        Ok(bytes)
    }
}

/// What a fault in the last line of a file without a final line feed most likely means.
fn truncated(kind: ObjErrorKind) -> ObjErrorKind {
    match kind {
        ObjErrorKind::VertexLength(_)
        | ObjErrorKind::FaceLength(_)
        | ObjErrorKind::NotANumber(_)
        | ObjErrorKind::BadIndex(_) => ObjErrorKind::Truncated("inside its last line".to_owned()),
        other => other,
    }
}

fn read_error_kind(error: io::Error) -> ObjErrorKind {
    match error.kind() {
        io::ErrorKind::UnexpectedEof => ObjErrorKind::Truncated("inside the xz stream".to_owned()),
        io::ErrorKind::InvalidData | io::ErrorKind::InvalidInput => ObjErrorKind::Damaged(error),
        _ => ObjErrorKind::Read(error),
    }
}

/// Checks the numbers of a vertex; writes its coordinates, and its weight if it has one and no colour.
fn check_vertex<'t>(words: impl Iterator<Item = &'t str>, out: &mut Vec<u8>) -> Result<(), ObjErrorKind> {
    const MOST: usize = 7;
    let mut texts = [""; MOST];
    let mut values = [0.0_f32; MOST];
    let mut length = 0;
    for word in words {
        if length < MOST {
            texts[length] = word;
            values[length] = word.parse().map_err(|_| ObjErrorKind::NotANumber(word.to_owned()))?;
        }
        length += 1;
    }
    let written = match length {
        3 | 4 => length,
        6 | MOST => 3,
        _ => return Err(ObjErrorKind::VertexLength(length)),
    };
    let weight = if written == 4 { values[3] } else { 1.0 };
    if weight == 0.0 {
        return Err(ObjErrorKind::ZeroWeight);
    }
    for axis in 0..3 {
        check_range(values[axis], texts[axis])?;
        check_range(values[axis] / weight, texts[axis])?;
    }
    out.push(b'v');
    for text in &texts[..written] {
        push_word(out, text);
    }
    out.push(b'\n');
    Ok(())
}

fn check_range(value: f32, text: &str) -> Result<(), ObjErrorKind> {
    if value.abs() <= MAX_COORDINATE {
        Ok(())
    } else if value.is_nan() || text.to_ascii_lowercase().contains("inf") {
        Err(ObjErrorKind::NotFinite(text.to_owned()))
    } else {
        Err(ObjErrorKind::OutOfRange(text.to_owned()))
    }
}

/// Checks the corners of a face, writes their position indices, and returns the number of triangles and the
/// highest positive index, which may refer to a vertex further on.
fn check_face<'t>(
    words: impl Iterator<Item = &'t str>,
    vertices: u64,
    out: &mut Vec<u8>,
) -> Result<(usize, u64), ObjErrorKind> {
    out.push(b'f');
    let mut corners = 0;
    let mut highest = 0;
    for word in words {
        let text = word.split_once('/').map_or(word, |(position, _others)| position);
        let index: i64 = text.parse().map_err(|_| ObjErrorKind::BadIndex(word.to_owned()))?;
        if index == 0 {
            return Err(ObjErrorKind::ZeroIndex);
        }
        if index < 0 && index.unsigned_abs() > vertices {
            return Err(ObjErrorKind::IndexOutOfRange { index, vertices });
        }
        highest = highest.max(u64::try_from(index).unwrap_or(0));
        push_word(out, text);
        corners += 1;
    }
    if corners < 3 {
        return Err(ObjErrorKind::FaceLength(corners));
    }
    out.push(b'\n');
    Ok((corners - 2, highest))
}

fn push_word(out: &mut Vec<u8>, word: &str) {
    out.push(b' ');
    out.extend_from_slice(word.as_bytes());
}
