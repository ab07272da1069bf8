//! Structures on disk.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `DSTREE` and two decimal digits of the version, `01` |
//! | 4 | the structure's code (see [`crate::structure`]) |
//! | 4 | word 0 of the root of a hierarchy of boxes, else 0 |
//! | 24 | the root box: minimum, maximum |
//! | 8, 8 | number of 32-bit words of the nodes, number of triangles |
//! | | the nodes, then the triangles, as they lie in memory |
//! | 4 | CRC-32 of all bytes before |
//!
//! All numbers are little-endian. A file is loaded only if the checksum holds and the structure validates, so that damage
//! and forgery end in an error and never in a traversal.

use crate::Aabb;
use crate::structure::{Memory, Structure, StructureKind};
use crate::triangle::Triangle;
use base::output::{WriteError, write_file};
use std::error::Error;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

const MAGIC: &[u8; 6] = b"DSTREE";
const VERSION: &[u8; 2] = b"01";
const HEADER_BYTES: usize = 8 + 4 + 4 + 24 + 8 + 8;
const CHECKSUM_BYTES: usize = 4;

/// Why a tree file cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum TreeFileError {
    /// The file system refuses.
    #[error("{}: cannot read ({source})", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// The contents are not a tree file of this version, or are damaged.
    #[error("{}: {reason}; save the tree again with this version", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: Damage,
    },
}

/// What is wrong with a file's contents.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Damage {
    /// The first bytes are not those of a tree file.
    #[error("not a dual-split tree file")]
    Magic,
    /// The file is of another version.
    #[error("version {0:?} is not \"01\"")]
    Version(String),
    /// There are more or fewer bytes than the header says.
    #[error("{found} bytes, the header says {expected}")]
    Length {
        /// Bytes in the file.
        found: usize,
        /// Bytes that the header's counts give.
        expected: u128,
    },
    /// The checksum does not fit the contents.
    #[error("the checksum is {found:08x}, the contents give {expected:08x}")]
    Checksum {
        /// The stored one.
        found: u32,
        /// The computed one.
        expected: u32,
    },
    /// There is no such structure.
    #[error("structure code {0} is none of {codes}", codes = codes())]
    Kind(u32),
    /// The nodes are none of the structure that they should be; the structure's own defect in words.
    #[error("{0}")]
    Nodes(String),
    /// A triangle has a corner that is infinite or not a number, or a word that is none.
    #[error("triangle {0} is not one")]
    Triangle(usize),
}

impl Damage {
    /// A structure's defect, as what is wrong with the file.
    pub(crate) fn nodes(defect: impl Error) -> Self {
        Self::Nodes(defect.to_string())
    }
}

/// The codes of all structures in ascending order, for messages.
fn codes() -> String {
    let mut codes = StructureKind::ALL.map(StructureKind::code);
    codes.sort_unstable();
    codes.map(|code| code.to_string()).join(", ")
}

/// Writes `structure` to `path`, whole or not at all; an existing file is replaced only if `force` is set.
///
/// # Errors
/// See [`WriteError`].
pub fn save(structure: &Structure, path: &Path, force: bool) -> Result<(), WriteError> {
    write_file(path, force, |out| out.write_all(&to_bytes(structure)))
}

/// Reads the structure in `path`.
///
/// # Errors
/// [`TreeFileError`], naming the file.
pub fn load(path: &Path) -> Result<Structure, TreeFileError> {
    let io = |source| TreeFileError::Io { path: path.to_owned(), source };
    let damaged = |reason| TreeFileError::Damaged { path: path.to_owned(), reason };
    let mut file = base::input::open(path).map_err(io)?;
    let mut bytes = vec![];
    file.by_ref().take(HEADER_BYTES as u64).read_to_end(&mut bytes).map_err(io)?;
    // What follows the header is read as far as the header says, and a byte more to notice what should not be there.
    let rest = expected_bytes(&bytes).map_err(damaged)? - bytes.len() as u128;
    file.take(u64::try_from(rest).unwrap_or(u64::MAX).saturating_add(1))
        .read_to_end(&mut bytes)
        .map_err(io)?;
    from_bytes(&bytes).map_err(damaged)
}

/// The bytes of the file that begins with `bytes`, as its header says.
fn expected_bytes(bytes: &[u8]) -> Result<u128, Damage> {
    if bytes.len() < HEADER_BYTES || &bytes[..MAGIC.len()] != MAGIC {
        return Err(Damage::Magic);
    }
    if &bytes[MAGIC.len()..8] != VERSION {
        return Err(Damage::Version(String::from_utf8_lossy(&bytes[MAGIC.len()..8]).into_owned()));
    }
    let [node_words, triangles] = counts(bytes);
    Ok((HEADER_BYTES + CHECKSUM_BYTES) as u128
        + 4 * (u128::from(node_words) + u128::from(triangles) * u128::from(Triangle::WORDS)))
}

/// The numbers of node words and of triangles in a header.
fn counts(header: &[u8]) -> [u64; 2] {
    [HEADER_BYTES - 16, HEADER_BYTES - 8]
        .map(|at| u64::from_le_bytes(header[at..at + 8].try_into().expect("eight bytes")))
}

/// The contents of the file of `structure`.
#[must_use]
pub fn to_bytes(structure: &Structure) -> Vec<u8> {
    let Memory { root_box, root, words, triangles } = structure.memory();
    let mut bytes = vec![];
    bytes.extend(MAGIC);
    bytes.extend(VERSION);
    let triangle_words: &[u32] = bytemuck::cast_slice(triangles);
    for word in [structure.kind().code(), root].into_iter().chain(root_box.to_bits()) {
        bytes.extend(word.to_le_bytes());
    }
    for count in [words.len(), triangles.len()] {
        bytes.extend((count as u64).to_le_bytes());
    }
    for word in words.iter().chain(triangle_words) {
        bytes.extend(word.to_le_bytes());
    }
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    bytes
}

/// The structure in a file's contents.
///
/// # Errors
/// [`Damage`].
pub fn from_bytes(bytes: &[u8]) -> Result<Structure, Damage> {
    let expected = expected_bytes(bytes)?;
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
    if bytes.len() as u128 != expected {
        return Err(Damage::Length { found: bytes.len(), expected });
    }
    let (found, expected) =
        (word(bytes.len() - CHECKSUM_BYTES), crc32fast::hash(&bytes[..bytes.len() - CHECKSUM_BYTES]));
    if found != expected {
        return Err(Damage::Checksum { found, expected });
    }

    let (code, root) = (word(8), word(12));
    let side = |at: usize| std::array::from_fn(|k| f32::from_bits(word(at + 4 * k)));
    let root_box = Aabb { min: side(16), max: side(28) };
    let nodes_end = HEADER_BYTES + 4 * counts(bytes)[0] as usize;
    let words: Vec<u32> = (HEADER_BYTES..nodes_end).step_by(4).map(word).collect();
    let triangle_words: Vec<u32> = (nodes_end..bytes.len() - CHECKSUM_BYTES).step_by(4).map(word).collect();
    let triangles: Arc<[Triangle]> = bytemuck::cast_slice(&triangle_words).into();
    if let Some(slot) = triangles.iter().position(|triangle| !triangle.is_valid()) {
        return Err(Damage::Triangle(slot));
    }
    let kind = StructureKind::from_code(code).ok_or(Damage::Kind(code))?;
    Structure::from_memory(kind, root_box, root, words, triangles)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::{BuildOptions, build};
    use crate::structure::pack_triangles;
    use scenes::Mesh;

    fn structures() -> Vec<Structure> {
        let positions = (0..300).map(|i| {
            let x = i as f32;
            [x * 0.37 % 5.0, x * 1.71 % 7.0, x * 2.93 % 3.0]
        });
        let triangles = (0..100).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
        let mesh = Mesh { positions: positions.collect(), triangles: triangles.collect() };
        let tree = build(&mesh, &BuildOptions::default()).unwrap();
        let triangles = pack_triangles(&mesh, &tree);
        StructureKind::ALL.iter().map(|kind| Structure::convert(*kind, &tree, &triangles).unwrap()).collect()
    }

    fn with_checksum(mut bytes: Vec<u8>) -> Vec<u8> {
        let end = bytes.len() - CHECKSUM_BYTES;
        let crc = crc32fast::hash(&bytes[..end]);
        bytes[end..].copy_from_slice(&crc.to_le_bytes());
        bytes
    }

    #[test]
    fn what_is_saved_is_loaded() {
        let folder = tempfile::tempdir().unwrap();
        for structure in structures() {
            let path = folder.path().join(structure.kind().name());
            save(&structure, &path, false).unwrap();
            assert!(matches!(save(&structure, &path, false), Err(WriteError::Exists(_))));
            save(&structure, &path, true).unwrap();
            let loaded = load(&path).unwrap();
            assert_eq!(to_bytes(&loaded), to_bytes(&structure));
        }
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), StructureKind::ALL.len());
    }

    #[test]
    fn every_flipped_bit_and_every_cut_is_noticed() {
        for structure in structures() {
            let bytes = to_bytes(&structure);
            for bit in (0..8 * bytes.len()).step_by(5) {
                let mut damaged = bytes.clone();
                damaged[bit / 8] ^= 1 << (bit % 8);
                assert!(from_bytes(&damaged).is_err(), "bit {bit}");
            }
            for length in (0..bytes.len()).step_by(7) {
                assert!(from_bytes(&bytes[..length]).is_err(), "{length} bytes");
            }
        }
    }

    #[test]
    fn forged_nodes_never_get_as_far_as_a_traversal() {
        use crate::traverse::Trace;
        use crate::{Mode, Ray};
        let ray = Ray::new([-1.0, 2.0, 1.0], [1.0, 0.3, 0.2]);
        for structure in structures() {
            let bytes = to_bytes(&structure);
            let nodes = structure.node_bytes();
            for bit in (8 * HEADER_BYTES..8 * (HEADER_BYTES + nodes)).step_by(3) {
                let mut forged = bytes.clone();
                forged[bit / 8] ^= 1 << (bit % 8);
                // A split's plane that a carve repeats may move: what validates still is a tree over the triangles.
                if let Ok(forged) = from_bytes(&with_checksum(forged)) {
                    assert_eq!(forged.closest(&ray, Mode::Robust), structure.closest(&ray, Mode::Robust));
                }
            }
        }
    }

    #[test]
    fn errors_name_the_file_and_the_damage() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("tree");
        assert!(matches!(load(&path).unwrap_err(), TreeFileError::Io { .. }));
        let mut bytes = to_bytes(&structures()[0]);
        bytes[7] = b'9';
        std::fs::write(&path, &bytes).unwrap();
        let message = load(&path).unwrap_err().to_string();
        assert!(message.contains("tree") && message.contains("version"), "{message}");
    }
}
