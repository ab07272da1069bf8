//! A reader that cleans OBJ text on its way to the parser.
//!
//! `tobj` parses numbers and resolves negative indices correctly, but it reports no line numbers, wants UTF-8, takes a polyline
//! for a polygon, starts a new vertex list at each group, and can panic on bad indices of normals. [`CleanReader`] therefore
//! checks each line and hands on only what forms the mesh: the coordinates of `v` and the position indices of `f`, in file order.

use std::io::{self, BufRead, Read};
use std::path::Path;

use super::statement::{
    Face, Kind, check_face, check_vertex, continued, first_word, kind, without_comment, words,
};
use crate::formats::error::{FormatError, FormatErrorKind, Place};
use crate::formats::lines::Lines;
use crate::formats::report::{FileReport, Skip};
use crate::mesh::MAX_TRIANGLES;

const CHUNK_BYTES: usize = 1 << 16;
const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();
/// Bytes of a keyword and of a name that a report shows.
const MOST_KEYWORD_BYTES: usize = 24;
const MOST_NAME_BYTES: usize = 80;
const UTF_16_MARKS: [&[u8]; 2] = [b"\xff\xfe", b"\xfe\xff"];

/// Presents `source` as the statements that form the mesh. The first fault ends the text, and the reader keeps it.
pub(super) struct CleanReader<'a, R> {
    lines: Lines<R>,
    path: &'a Path,
    report: FileReport,
    /// The current statement without comment, with continuation lines joined.
    statement: Vec<u8>,
    /// The line that was read last had an end.
    ended_line: bool,
    /// The statement before was skipped and ended in a backslash, so numbers on the next line belong to it.
    skipped_goes_on: bool,
    vertices: u64,
    triangles: usize,
    /// Indices beyond the vertices read so far, with their lines, in ascending order of both.
    forward_references: Vec<(u64, u64)>,
    cleaned: Vec<u8>,
    consumed: usize,
    ended: bool,
    fault: Option<FormatError>,
}

impl<'a, R: BufRead> CleanReader<'a, R> {
    pub(super) fn new(source: R, path: &'a Path) -> Self {
        Self {
            lines: Lines::new(source),
            path,
            report: FileReport::new(crate::formats::Format::Obj),
            statement: Vec::new(),
            ended_line: true,
            skipped_goes_on: false,
            vertices: 0,
            triangles: 0,
            forward_references: Vec::new(),
            cleaned: Vec::with_capacity(CHUNK_BYTES + 256),
            consumed: 0,
            ended: false,
            fault: None,
        }
    }

    /// Gives what was found to `report`.
    ///
    /// # Errors
    /// The fault that ended the text.
    pub(super) fn finish(self, report: &mut FileReport) -> Result<(), FormatError> {
        *report = self.report;
        self.fault.map_or(Ok(()), Err)
    }

    fn error(&self, line: u64, kind: FormatErrorKind) -> FormatError {
        kind.at(self.path, Place::Line(line))
    }

    /// Reads one statement; false at the end of the file. Only `v` and `f` go on after a backslash: elsewhere, names may end in
    /// one.
    fn read_statement(&mut self) -> Result<bool, FormatError> {
        self.statement.clear();
        loop {
            let start = self.statement.len();
            let read = self.lines.next(&mut self.statement);
            let ended = read.map_err(|e| self.error(self.lines.number + 1, FormatErrorKind::reading(e)))?;
            let Some(ended) = ended else { return Ok(start > 0) };
            self.ended_line = ended;
            if self.lines.number == 1 {
                if UTF_16_MARKS.iter().any(|mark| self.statement.starts_with(mark)) {
                    return Err(self.error(1, FormatErrorKind::NotText("UTF-16 text")));
                }
                if self.statement.starts_with(BYTE_ORDER_MARK) {
                    self.statement.drain(..BYTE_ORDER_MARK.len());
                }
            }
            let kept = without_comment(&self.statement[start..]).len();
            let commented = start + kept < self.statement.len();
            self.statement.truncate(start + kept);
            let geometry = matches!(kind(first_word(&self.statement)), Kind::Vertex | Kind::Face);
            if !geometry || commented || !continued(&self.statement) {
                return Ok(true);
            }
            let end = self.statement.trim_ascii_end().len() - 1;
            self.statement.truncate(end);
            self.statement.push(b' ');
        }
    }

    fn clean_statement(&mut self) -> Result<(), FormatErrorKind> {
        let first = first_word(&self.statement);
        if first.is_empty() {
            return Ok(());
        }
        match kind(first) {
            Kind::Skipped(skip) => return self.skip(skip),
            Kind::Vertex => {
                check_vertex(words(&self.statement).skip(1), &mut self.cleaned)?;
                self.vertices += 1;
            }
            Kind::Face => self.face()?,
        }
        self.skipped_goes_on = false;
        Ok(())
    }

    fn face(&mut self) -> Result<(), FormatErrorKind> {
        let corner_words = words(&self.statement).skip(1);
        let Face { corners, highest } = check_face(corner_words, self.vertices, &mut self.cleaned)?;
        let known = self.forward_references.last().map_or(self.vertices, |&(index, _)| index);
        if highest > known.max(self.vertices) {
            self.forward_references.push((highest, self.lines.number));
        }
        if corners < 3 {
            // What the last line of a cut file holds is more likely a part of a face.
            if !self.ended_line {
                return Err(FormatErrorKind::Truncated("inside its last line".to_owned()));
            }
            self.report.skip("faces of fewer than three corners", Skip::NoTriangle, self.lines.number);
            return Ok(());
        }
        self.triangles += corners - 2;
        if self.triangles > MAX_TRIANGLES {
            return Err(FormatErrorKind::TooManyTriangles);
        }
        Ok(())
    }

    /// Counts a statement that forms no triangle.
    fn skip(&mut self, skip: Skip) -> Result<(), FormatErrorKind> {
        let first = first_word(&self.statement);
        let number = first.first().is_some_and(|byte| byte.is_ascii_digit() || b"+-.".contains(byte));
        let belongs_to_the_one_before = self.skipped_goes_on && number;
        self.skipped_goes_on = continued(&self.statement);
        if belongs_to_the_one_before {
            return Ok(());
        }
        if self.statement.contains(&0) {
            return Err(FormatErrorKind::NotText("a zero byte"));
        }
        let keyword = &first[..first.len().min(MOST_KEYWORD_BYTES)];
        self.report.skip(&String::from_utf8_lossy(keyword), skip, self.lines.number);
        if let Err(error) = std::str::from_utf8(&self.statement)
            && error.valid_up_to() >= first.len()
        {
            let text = &self.statement[..self.statement.len().min(MOST_NAME_BYTES)];
            self.report.replaced_name(String::from_utf8_lossy(text).trim(), self.lines.number);
        }
        Ok(())
    }

    fn check_end(&self) -> Result<(), FormatError> {
        let beyond = self.forward_references.iter().find(|&&(index, _)| index > self.vertices);
        if let Some(&(index, line)) = beyond {
            let kind = FormatErrorKind::IndexOutOfRange {
                index: i64::try_from(index).unwrap_or(i64::MAX),
                vertices: self.vertices,
            };
            return Err(self.error(line, kind));
        }
        if self.triangles == 0 {
            return Err(FormatErrorKind::NoTriangle.at(self.path, Place::File));
        }
        Ok(())
    }

    /// Fills `cleaned` with whole statements.
    fn refill(&mut self) -> Result<(), FormatError> {
        self.cleaned.clear();
        self.consumed = 0;
        while self.cleaned.len() < CHUNK_BYTES && !self.ended {
            if self.read_statement()? {
                if let Err(kind) = self.clean_statement() {
                    let kind = if self.ended_line { kind } else { truncated(kind) };
                    return Err(self.error(self.lines.number, kind));
                }
            } else {
                self.ended = true;
                self.check_end()?;
            }
        }
        Ok(())
    }
}

impl<R: BufRead> BufRead for CleanReader<'_, R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.consumed == self.cleaned.len()
            && let Err(fault) = self.refill()
        {
            self.cleaned.clear();
            self.ended = true;
            self.fault = Some(fault);
            return Err(io::Error::from(io::ErrorKind::InvalidData));
        }
        Ok(&self.cleaned[self.consumed..])
    }

    fn consume(&mut self, amount: usize) {
        self.consumed += amount;
    }
}

impl<R: BufRead> Read for CleanReader<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut available = self.fill_buf()?;
        let bytes = available.read(buffer)?;
        self.consume(bytes);
        Ok(bytes)
    }
}

/// What a fault in the last line of a file without a final line end most likely means.
fn truncated(kind: FormatErrorKind) -> FormatErrorKind {
    match kind {
        FormatErrorKind::VertexLength(_)
        | FormatErrorKind::EmptyFace
        | FormatErrorKind::NotANumber(_)
        | FormatErrorKind::BadIndex(_) => FormatErrorKind::Truncated("inside its last line".to_owned()),
        other => other,
    }
}
