//! What can be wrong with an OBJ file, where it is, and what to do about it.

use std::fmt;
use std::io;
use std::path::PathBuf;

use thiserror::Error;

use crate::mesh::{MAX_COORDINATE, MAX_TRIANGLES};

/// A rejected OBJ file. Its message is `FILE:LINE: what is wrong; what to do`.
#[derive(Debug, Error)]
#[error("{}{}: {kind}", path.display(), LineSuffix(*line))]
pub struct ObjError {
    /// The file as it was named by the caller.
    pub path: PathBuf,
    /// The line at fault, from 1. A statement that continues over several lines has the number of its last line.
    /// Absent where no single line is at fault.
    pub line: Option<u64>,
    /// What is wrong.
    pub kind: ObjErrorKind,
}

/// The reasons for which an OBJ file is rejected.
#[derive(Debug, Error)]
pub enum ObjErrorKind {
    /// The file cannot be opened.
    #[error("cannot open the file ({0}); check its name and permissions")]
    Open(io::Error),
    /// The file cannot be read to its end.
    #[error("cannot read on ({0}); check the disk, or copy the file again")]
    Read(io::Error),
    /// The file ends inside the compressed stream or inside a statement.
    #[error("the file ends too early ({0}); it is truncated: copy or export it again")]
    Truncated(String),
    /// The compressed stream is damaged.
    #[error("the xz stream is damaged ({0}); copy or compress the file again")]
    Damaged(io::Error),
    /// A line is not UTF-8 text.
    #[error("the line is not UTF-8 text; an OBJ file is text: convert it, or name another file")]
    NotUtf8,
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
    /// A face has fewer than three corners.
    #[error("a face has {0} corners and needs 3 or more; write a line as `l`, or export the file again")]
    FaceLength(usize),
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
    /// The file has no triangle.
    #[error("the file has no triangle; name an OBJ file with `f` statements")]
    NoTriangle,
    /// The file has more than [`MAX_TRIANGLES`] triangles.
    #[error("more than {MAX_TRIANGLES} triangles; split the model into several files")]
    TooManyTriangles,
    /// The parser refuses what the check let through.
    #[error("the parser rejects the file ({0}); export the file again")]
    Rejected(tobj::LoadError),
}

struct LineSuffix(Option<u64>);

impl fmt::Display for LineSuffix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |line| write!(f, ":{line}"))
    }
}
