//! Files of rays and of the hits that were found for them.
//!
//! Both formats are the project's own, and little-endian. A file may be compressed with xz or gzip: reading recognises that
//! by the content, within the limits of [`base::input`], and writing compresses by xz if the name ends in `.xz`.
//!
//! | rays, `DSTRAYS1` | | hits, `DSTHITS1` | |
//! |---|---|---|---|
//! | 8 bytes | `DSTRAYS1` | 8 bytes | `DSTHITS1` |
//! | u32 | number of rays, n | u32 | number of rays, n |
//! | u32 | how many of them are primary; these come first | n x 8 bytes | u32 triangle, f32 t |
//! | n x 32 bytes | f32 origin x, y, z, t_min, direction x, y, z, t_max | | |
//! | optional | classes of the rays | | |
//!
//! The triangle of a ray that misses is [`MISS`] and its t infinite. The classes are the 8 bytes `DSTWAVES`, the u32
//! number of waves, and for each wave a u32 class and the u32 number of its rays, which sum to n: class 0 is
//! primary, 1 other secondary rays, `0x100 + i` shadow rays from vertex i of a path, `0x200 + i` diffuse bounce i. A
//! reader that does not know classes may stop after the rays.

mod input;

use crate::{RayClass, RayStream};
use base::input::unpacked;
use base::output::{WriteError, write_file};
use golden::Ray;
use input::Input;
use liblzma::write::XzEncoder;
use std::io::{self, BufReader, Write};
use std::path::{Path, PathBuf};

/// The triangle of a ray that misses.
pub const MISS: u32 = u32::MAX;

const RAYS_MAGIC: &[u8; 8] = b"DSTRAYS1";
const HITS_MAGIC: &[u8; 8] = b"DSTHITS1";
const WAVES_MAGIC: &[u8; 8] = b"DSTWAVES";
/// xz preset; higher ones are several times slower for a few percent.
const XZ_LEVEL: u32 = 1;

const CLASS_SECONDARY: u32 = 1;
const CLASS_SHADOW: u32 = 0x100;
const CLASS_DIFFUSE: u32 = 0x200;

/// What a ray has hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FileHit {
    /// Index of the triangle.
    pub triangle: u32,
    /// Distance in units of the ray direction's length.
    pub t: f32,
}

/// A rejected file. Its message is `FILE: what is wrong; what to do`.
#[derive(Debug, thiserror::Error)]
#[error("{}: {kind}", path.display())]
pub struct RayFileError {
    /// The file as it was named by the caller.
    pub path: PathBuf,
    /// What is wrong.
    pub kind: RayFileErrorKind,
}

/// The reasons for which a file is rejected. Offsets are in bytes of the uncompressed file.
#[derive(Debug, thiserror::Error)]
pub enum RayFileErrorKind {
    /// The file cannot be opened.
    #[error("cannot open the file ({0}); check its name and permissions")]
    Open(io::Error),
    /// The file cannot be read on, its compressed stream is damaged, or it unpacks to too much.
    #[error("offset {offset}: cannot read on ({source}); copy the file again")]
    Read {
        /// Where.
        offset: u64,
        /// Why.
        source: io::Error,
    },
    /// The file is of another kind.
    #[error("offset 0: begins with {found:?} instead of {expected}; name a file of that format")]
    Magic {
        /// What was found.
        found: String,
        /// What the format begins with.
        expected: &'static str,
    },
    /// The file ends inside `part`.
    #[error("offset {offset}: the file ends inside {part}; it is truncated, copy or write it again")]
    Truncated {
        /// Where it ends.
        offset: u64,
        /// What is incomplete.
        part: String,
    },
    /// More primary rays than rays.
    #[error("offset 12: {primary} primary rays of {rays} rays; the file is damaged, write it again")]
    Primary {
        /// Primary rays, as stored.
        primary: u32,
        /// Rays, as stored.
        rays: u32,
    },
    /// The classes are not those of the rays.
    #[error("offset {offset}: the table of classes {what}; the file is damaged, write it again")]
    Classes {
        /// Where.
        offset: u64,
        /// What is wrong with it.
        what: String,
    },
    /// Something follows the end.
    #[error("offset {offset}: there is more after the end; the file is damaged, write it again")]
    TrailingBytes {
        /// Where the end should be.
        offset: u64,
    },
}

/// Reads the rays in `path`. If the file has no classes, all rays after the primary ones are [`RayClass::Secondary`].
///
/// # Errors
/// [`RayFileError`] names the file, the offset and the remedy.
pub fn read_rays(path: impl AsRef<Path>) -> Result<RayStream, RayFileError> {
    let path = path.as_ref();
    with_file(path, |input| {
        input.magic(RAYS_MAGIC, "DSTRAYS1")?;
        let [rays, primary] = [input.u32("the header")?, input.u32("the header")?];
        if primary > rays {
            return Err(RayFileErrorKind::Primary { primary, rays });
        }
        let mut stream = RayStream::default();
        input.elements(rays, "ray", |x: [f32; 8]| {
            let [ox, oy, oz, t_min, dx, dy, dz, t_max] = x;
            stream.rays.push(Ray { origin: [ox, oy, oz], direction: [dx, dy, dz], t_min, t_max });
        })?;
        stream.waves = input.waves(rays, primary)?;
        Ok(stream)
    })
}

/// Writes `stream` to `path`, with its classes; an existing file only with `force`.
///
/// # Errors
/// See [`WriteError`].
///
/// # Panics
/// If `stream` has 2^32 rays or more.
pub fn write_rays(path: impl AsRef<Path>, stream: &RayStream, force: bool) -> Result<(), WriteError> {
    let count = u32::try_from(stream.rays.len()).expect("fewer than 2^32 rays");
    write_compressed(path.as_ref(), force, |out| {
        out.write_all(RAYS_MAGIC)?;
        out.write_all(&count.to_le_bytes())?;
        out.write_all(&stream.primary_rays().to_le_bytes())?;
        for Ray { origin: [ox, oy, oz], direction: [dx, dy, dz], t_min, t_max } in &stream.rays {
            for x in [ox, oy, oz, t_min, dx, dy, dz, t_max] {
                out.write_all(&x.to_le_bytes())?;
            }
        }
        out.write_all(WAVES_MAGIC)?;
        out.write_all(&(stream.waves.len() as u32).to_le_bytes())?;
        for wave in &stream.waves {
            out.write_all(&class_code(wave.class).to_le_bytes())?;
            out.write_all(&wave.rays.to_le_bytes())?;
        }
        Ok(())
    })
}

/// Reads the hits in `path`, one for each ray.
///
/// # Errors
/// [`RayFileError`] names the file, the offset and the remedy.
pub fn read_hits(path: impl AsRef<Path>) -> Result<Vec<Option<FileHit>>, RayFileError> {
    with_file(path.as_ref(), |input| {
        input.magic(HITS_MAGIC, "DSTHITS1")?;
        let count = input.u32("the header")?;
        let mut hits = vec![];
        input.elements(count, "hit", |[triangle, t]: [u32; 2]| {
            hits.push((triangle != MISS).then_some(FileHit { triangle, t: f32::from_bits(t) }));
        })?;
        input.end()?;
        Ok(hits)
    })
}

/// Writes `hits` to `path`; an existing file only with `force`.
///
/// # Errors
/// See [`WriteError`].
///
/// # Panics
/// If there are 2^32 hits or more.
pub fn write_hits(path: impl AsRef<Path>, hits: &[Option<FileHit>], force: bool) -> Result<(), WriteError> {
    let count = u32::try_from(hits.len()).expect("fewer than 2^32 hits");
    write_compressed(path.as_ref(), force, |out| {
        out.write_all(HITS_MAGIC)?;
        out.write_all(&count.to_le_bytes())?;
        for hit in hits {
            let FileHit { triangle, t } = hit.unwrap_or(FileHit { triangle: MISS, t: f32::INFINITY });
            out.write_all(&triangle.to_le_bytes())?;
            out.write_all(&t.to_le_bytes())?;
        }
        Ok(())
    })
}

fn class_code(class: RayClass) -> u32 {
    match class {
        RayClass::Primary => 0,
        RayClass::Secondary => CLASS_SECONDARY,
        RayClass::Shadow { vertex } => CLASS_SHADOW + u32::from(vertex),
        RayClass::Diffuse { bounce } => CLASS_DIFFUSE + u32::from(bounce),
    }
}

fn class_of_code(code: u32) -> Option<RayClass> {
    let low = code as u8;
    match code & !0xff {
        0 if code == 0 => Some(RayClass::Primary),
        0 if code == CLASS_SECONDARY => Some(RayClass::Secondary),
        CLASS_SHADOW => Some(RayClass::Shadow { vertex: low }),
        CLASS_DIFFUSE => Some(RayClass::Diffuse { bounce: low }),
        _ => None,
    }
}

fn write_compressed(
    path: &Path,
    force: bool,
    contents: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), WriteError> {
    let compressed = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("xz"));
    write_file(path, force, |out| {
        if compressed {
            let mut encoder = XzEncoder::new(out, XZ_LEVEL);
            contents(&mut encoder)?;
            encoder.finish().map(|_| ())
        } else {
            contents(out)
        }
    })
}

fn with_file<T>(
    path: &Path,
    read: impl FnOnce(&mut Input) -> Result<T, RayFileErrorKind>,
) -> Result<T, RayFileError> {
    let open = || unpacked(BufReader::new(base::input::open(path)?));
    open()
        .map_err(RayFileErrorKind::Open)
        .and_then(|source| read(&mut Input::new(source)))
        .map_err(|kind| RayFileError { path: path.to_owned(), kind })
}

#[cfg(test)]
mod tests;
