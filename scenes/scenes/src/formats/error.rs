//! What can be wrong with a file of geometry, where it is, and what to do about it.

use std::fmt;
use std::io;
use std::path::PathBuf;

use thiserror::Error;

use super::MOST_BYTES;
use crate::mesh::{MAX_COORDINATE, MAX_TRIANGLES};
use base::input::{FREE_BYTES, Limit, MOST_XZ_MEMORY, RATIO};

/// A rejected file. Its message is `FILE: what is wrong; what to do`, with the line or the element after the file.
#[derive(Debug, Error)]
#[error("{}{place}: {kind}", path.display())]
pub struct FormatError {
    /// The file as it was named by the caller.
    pub path: PathBuf,
    /// What is at fault in the file.
    pub place: Place,
    /// What is wrong.
    pub kind: FormatErrorKind,
}

/// A part of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// No single part.
    File,
    /// A line, counted from 1. A statement that continues over several lines has the number of its last line.
    Line(u64),
    /// An element that has no line, such as `face 7`.
    Element(String),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => Ok(()),
            Self::Line(line) => write!(f, ":{line}"),
            Self::Element(element) => write!(f, ": {element}"),
        }
    }
}

/// The reasons for which a file is rejected.
#[derive(Debug, Error)]
pub enum FormatErrorKind {
    /// The file cannot be opened.
    #[error("cannot open the file ({0}); check its name and permissions")]
    Open(io::Error),
    /// The file cannot be read to its end.
    #[error("cannot read on ({0}); check the disk, or copy the file again")]
    Read(io::Error),
    /// The file ends inside the compressed stream, inside a statement or before all that it declares.
    #[error("the file ends too early ({0}); it is truncated: copy or export it again")]
    Truncated(String),
    /// The compressed stream is damaged.
    #[error("the compressed stream is damaged ({0}); copy or compress the file again")]
    Damaged(io::Error),
    /// The compressed stream holds more than the limit.
    #[error(
        "the file holds more than {} MiB plus {RATIO} times its compressed size, which no real scene does; unpack it, \
         if it is to be trusted",
        FREE_BYTES >> 20
    )]
    Expands,
    /// The file is said to be of a format, and is of another.
    #[error(
        "--format {0}, but the file begins as a file of the format {1} does; leave --format away, or write --format {1}"
    )]
    OtherFormat(&'static str, &'static str),
    /// The file, unpacked, has more bytes than its reader takes.
    #[error("more than {} MiB; split the model into several files", MOST_BYTES >> 20)]
    TooManyBytes,
    /// The xz stream needs more memory than the limit.
    #[error(
        "unpacking the xz stream takes more than {} MiB of memory; compress the file with a preset of `xz`, such as `xz -9`",
        MOST_XZ_MEMORY >> 20
    )]
    XzMemory,
    /// The file is no text.
    #[error(
        "the line holds {0}, and the format is text in UTF-8 or an extension of ASCII; convert it, or name another file"
    )]
    NotText(&'static str),
    /// The file has a format that is not read.
    #[error("{0} files are not read; export the model as {names}", names = super::names())]
    NotRead(&'static str),
    /// Neither the name nor the content says which format the file has.
    #[error("neither its name nor its content says which format the file has; say it with --format, one of {names}", names = super::names())]
    UnknownFormat,
    /// The file does not follow its format.
    #[error("{0}; export the file again")]
    Invalid(String),
    /// The file needs something of its format that is not supported.
    #[error("{0}, which is not supported; export the file without it")]
    Unsupported(String),
    /// A vertex does not have 3 numbers, 4 with a weight, or 6 or 7 with a colour.
    #[error("a vertex has {0} numbers; write `v x y z`, optionally with a weight or a colour")]
    VertexLength(usize),
    /// A coordinate is not a number.
    #[error("`{0}` is not a number; write a decimal number such as `-1.25` or `3e-4`")]
    NotANumber(String),
    /// A coordinate is NaN or infinite.
    #[error("the coordinate `{0}` is not finite; remove the vertex and its faces, or export the file again")]
    NotFinite(String),
    /// A coordinate exceeds [`MAX_COORDINATE`].
    #[error(
        "the coordinate `{0}` is beyond the supported range of +-{MAX_COORDINATE:e}; scale the model down"
    )]
    OutOfRange(String),
    /// The weight of a vertex is zero.
    #[error("the weight of a vertex is zero, which puts it at infinity; write `v x y z`")]
    ZeroWeight,
    /// A face has no corner.
    #[error("a face has no corner; remove it, or export the file again")]
    EmptyFace,
    /// A vertex index is not an integer.
    #[error("`{0}` is not a vertex index; write integers such as `7`, `7/1`, `7//2` or `-1`")]
    BadIndex(String),
    /// A vertex index is zero.
    #[error("vertex index 0; indices start at 1, or at -1 for the latest vertex")]
    ZeroIndex,
    /// A vertex index is beyond the vertices of the file.
    #[error("vertex index {index} is out of range, there are {vertices} vertices; export the file again")]
    IndexOutOfRange {
        /// The index as written.
        index: i64,
        /// Vertices in the file, or before the line for a negative index.
        vertices: u64,
    },
    /// A polygon that is not convex has too many corners.
    #[error("a polygon of {0} corners that is not convex; split those of more than {most} into triangles", most = super::polygons::MOST_CORNERS)]
    LargePolygon(usize),
    /// The file has no triangle.
    #[error("the file has no triangle; name a file with faces")]
    NoTriangle,
    /// The file has more than [`MAX_TRIANGLES`] triangles.
    #[error("more than {MAX_TRIANGLES} triangles; split the model into several files")]
    TooManyTriangles,
    /// The parser refuses what the check let through.
    #[error("the parser rejects the file ({0}); export the file again")]
    Rejected(tobj::LoadError),
}

impl FormatErrorKind {
    /// What an error of the reading itself means.
    pub(super) fn reading(error: io::Error) -> Self {
        match error.get_ref().and_then(|inner| inner.downcast_ref::<Limit>()) {
            Some(Limit::Expands) => return Self::Expands,
            Some(Limit::XzMemory) => return Self::XzMemory,
            Some(Limit::Line) => return Self::NotText("more than 64 MiB"),
            Some(Limit::Bytes(_)) => return Self::TooManyBytes,
            None => {}
        }
        match error.kind() {
            io::ErrorKind::UnexpectedEof => Self::Truncated("inside the compressed stream".to_owned()),
            io::ErrorKind::InvalidData | io::ErrorKind::InvalidInput => Self::Damaged(error),
            _ => Self::Read(error),
        }
    }

    /// This fault at `place` of the file `path`.
    pub(super) fn at(self, path: &std::path::Path, place: Place) -> FormatError {
        FormatError { path: path.to_owned(), place, kind: self }
    }
}

/// Refuses a coordinate that is not finite or too large; `text` names it.
pub(super) fn check_range(value: f32, text: impl FnOnce() -> String) -> Result<(), FormatErrorKind> {
    if value.abs() <= MAX_COORDINATE {
        return Ok(());
    }
    let text = text();
    if value.is_nan() || text.to_ascii_lowercase().contains("inf") {
        Err(FormatErrorKind::NotFinite(text))
    } else {
        Err(FormatErrorKind::OutOfRange(text))
    }
}
