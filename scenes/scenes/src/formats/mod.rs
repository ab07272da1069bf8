//! Files of geometry: which formats there are, and how a file's format is found.
//!
//! A new format is a module with a function `fn(Input) -> Result<FileMesh, FormatError>` and an entry in `FORMATS`. What a reader
//! has to keep: no panic, memory in proportion to the bytes that it is given, and errors that name the line or the element.

pub mod error;
mod gltf;
mod lines;
pub mod obj;
mod ply;
pub(crate) mod polygons;
pub(crate) mod report;
mod stl;
mod write;

use std::ffi::OsStr;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

pub use write::{SaveError, save, written_format};

use crate::mesh::Mesh;
use base::input as source;
use error::{FormatError, FormatErrorKind, Place};
use report::FileReport;

/// A format that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// Stanford PLY, as text or binary.
    Ply,
    /// Stereolithography, as text or binary.
    Stl,
    /// glTF 2.0, as JSON or binary.
    Gltf,
}

struct Entry {
    format: Format,
    /// On the command line.
    name: &'static str,
    extensions: &'static [&'static str],
    read: fn(Input<'_>) -> Result<FileMesh, FormatError>,
}

const FORMATS: [Entry; 4] = [
    Entry { format: Format::Obj, name: "obj", extensions: &["obj"], read: obj::read_input },
    Entry { format: Format::Ply, name: "ply", extensions: &["ply"], read: ply::read },
    Entry { format: Format::Stl, name: "stl", extensions: &["stl"], read: stl::read },
    Entry { format: Format::Gltf, name: "gltf", extensions: &["gltf", "glb"], read: gltf::read },
];

/// Extensions of formats that are not read, with the names of these formats.
const NOT_READ: [(&str, &str); 16] = [
    ("fbx", "FBX"),
    ("blend", "Blender"),
    ("usd", "USD"),
    ("usda", "USD"),
    ("usdc", "USD"),
    ("usdz", "USD"),
    ("dae", "COLLADA"),
    ("3ds", "3DS"),
    ("max", "3ds Max"),
    ("3mf", "3MF"),
    ("abc", "Alembic"),
    ("x3d", "X3D"),
    ("wrl", "VRML"),
    ("off", "OFF"),
    ("pbrt", "pbrt"),
    ("vrm", "VRM"),
];

/// How files begin that are not read, with the names of their formats.
const FOREIGN_STARTS: [(&[u8], &str); 5] = [
    (b"Kaydara FBX Binary", "FBX"),
    (b"BLENDER", "Blender"),
    (b"PXR-USDC", "USD"),
    (b"PK\x03\x04", "zip"),
    (b"<?xml", "XML"),
];

/// Extensions of compressed files.
const COMPRESSIONS: [&str; 2] = ["xz", "gz"];

/// The name that stands for standard input.
pub const STDIN: &str = "-";

/// Most bytes of a file that is read as a whole: those of the largest scene as binary STL, and some more.
pub(crate) const MOST_BYTES: u64 = 1 << 32;

const BUFFER_BYTES: usize = 1 << 16;
/// Bytes that are looked at to recognise a format.
const SNIFFED_BYTES: usize = 512;

/// What a reader is given.
pub(crate) struct Input<'a> {
    /// The unpacked bytes.
    pub(crate) source: &'a mut dyn BufRead,
    /// The file as errors name it.
    pub(crate) name: &'a Path,
    /// The folder of files that this one refers to; `None` if there is none.
    pub(crate) folder: Option<&'a Path>,
}

/// The mesh of a file, and what else the file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct FileMesh {
    /// The triangles.
    pub mesh: Mesh,
    /// What else was found.
    pub report: FileReport,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; FORMATS.len()] = {
        let mut all = [Self::Obj; FORMATS.len()];
        let mut i = 0;
        while i < FORMATS.len() {
            all[i] = FORMATS[i].format;
            i += 1;
        }
        all
    };

    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    fn entry(self) -> &'static Entry {
        const { &FORMATS }.iter().find(|entry| entry.format == self).expect("the list has each format")
    }

    /// The format that the extension of `path` says, below the extension of a compressed file.
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        let extension = extension(path)?;
        FORMATS.iter().find(|entry| entry.extensions.contains(&&*extension)).map(|entry| entry.format)
    }

    /// The format of a file that begins with `start`, if no file of another format does.
    fn certain(start: &[u8]) -> Option<Self> {
        match Self::of_content(start) {
            Some(Self::Gltf) if !start.starts_with(b"glTF") => None,
            format => format.filter(|format| matches!(format, Self::Ply | Self::Gltf)),
        }
    }

    /// The format of a file that begins with `start`.
    fn of_content(start: &[u8]) -> Option<Self> {
        let text = start.strip_prefix("\u{feff}".as_bytes()).unwrap_or(start).trim_ascii_start();
        if start.starts_with(b"ply\n") || start.starts_with(b"ply\r") {
            Some(Self::Ply)
        } else if start.starts_with(b"glTF") || text.starts_with(b"{") {
            Some(Self::Gltf)
        } else if text.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid")) {
            Some(Self::Stl)
        } else {
            let statement = |line: &[u8]| {
                let word = line.split(u8::is_ascii_whitespace).find(|word| !word.is_empty());
                word.is_some_and(|word| matches!(word, b"v" | b"vn" | b"vt" | b"f" | b"o" | b"g" | b"mtllib"))
            };
            let is_obj =
                !start.contains(&0) && text.split(|&byte| byte == b'\n' || byte == b'\r').any(statement);
            is_obj.then_some(Self::Obj)
        }
    }
}

/// The names of all formats, separated by commas.
#[must_use]
pub fn names() -> String {
    FORMATS.map(|entry| entry.name).join(", ")
}

/// The name of `path` without the extensions of a format and of compression.
#[must_use]
pub fn stem(path: &Path) -> PathBuf {
    let mut stem = PathBuf::from(path.file_name().unwrap_or_default());
    if is_compressed(&stem) {
        stem.set_extension("");
    }
    if Format::of_path(&stem).is_some() {
        stem.set_extension("");
    }
    stem
}

fn is_compressed(path: &Path) -> bool {
    lower_extension(path).is_some_and(|extension| COMPRESSIONS.contains(&&*extension))
}

fn lower_extension(path: &Path) -> Option<String> {
    Some(path.extension()?.to_str()?.to_ascii_lowercase())
}

/// The extension that says the format, in lower case.
fn extension(path: &Path) -> Option<String> {
    if is_compressed(path) { lower_extension(Path::new(path.file_stem()?)) } else { lower_extension(path) }
}

/// Loads the file `path`, or standard input if that is [`STDIN`]. Its format is `format`, or else the one that its content or its
/// name says. Compression by xz and gzip is recognised by the content.
///
/// # Errors
/// [`FormatError`] names the file, the line or element, and the remedy.
pub fn load(path: &Path, format: Option<Format>) -> Result<FileMesh, FormatError> {
    let at_file = |kind: FormatErrorKind| kind.at(path, Place::File);
    if path.as_os_str() == OsStr::new(STDIN) {
        return read(std::io::stdin().lock(), Path::new("standard input"), None, format);
    }
    if format.is_none()
        && let Some((_, name)) =
            NOT_READ.iter().find(|(not_read, _)| extension(path).as_deref() == Some(not_read))
        && path.exists()
    {
        return Err(at_file(FormatErrorKind::NotRead(name)));
    }
    let file = source::open(path).map_err(|e| at_file(FormatErrorKind::Open(e)))?;
    let folder = path.parent().unwrap_or(Path::new(""));
    read(BufReader::with_capacity(BUFFER_BYTES, file), path, Some(folder), format)
}

/// Reads a file from `source`; `name` stands for it in errors. Files that it refers to are looked for in `folder`.
///
/// # Errors
/// [`FormatError`] names the file, the line or element, and the remedy.
pub fn read(
    source: impl BufRead,
    name: &Path,
    folder: Option<&Path>,
    format: Option<Format>,
) -> Result<FileMesh, FormatError> {
    let at_start = |kind: FormatErrorKind| kind.at(name, Place::File);
    let failed = |e| at_start(FormatErrorKind::reading(e));
    let source = source::unpacked(source).map_err(failed)?;
    let (start, mut source) = source::start(source, SNIFFED_BYTES).map_err(failed)?;
    let format = match format {
        Some(format) => match Format::certain(&start).filter(|certain| *certain != format) {
            Some(certain) => {
                return Err(at_start(FormatErrorKind::OtherFormat(format.name(), certain.name())));
            }
            None => format,
        },
        None => recognise(&start, name).map_err(at_start)?,
    };
    (format.entry().read)(Input { source: &mut source, name, folder })
}

/// All of `source`.
///
/// # Errors
/// Those of `source`, and the limit [`MOST_BYTES`].
fn whole(source: &mut dyn BufRead) -> io::Result<Vec<u8>> {
    source::at_most(source, MOST_BYTES)
}

/// The format of a file that begins with `start`: the name decides where the content may be of several.
fn recognise(start: &[u8], name: &Path) -> Result<Format, FormatErrorKind> {
    if let Some((_, foreign)) = FOREIGN_STARTS.iter().find(|(foreign, _)| start.starts_with(foreign)) {
        return Err(FormatErrorKind::NotRead(foreign));
    }
    let content = Format::of_content(start);
    if let Some(format) = Format::certain(start) {
        return Ok(format);
    }
    match (content, Format::of_path(name)) {
        (_, Some(format)) | (Some(format), None) => Ok(format),
        (None, None) => Err(FormatErrorKind::UnknownFormat),
    }
}

#[cfg(test)]
mod tests;
