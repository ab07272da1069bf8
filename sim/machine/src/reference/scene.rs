//! Files of the reference runs: the memory image of a tree, rays and hits, in little-endian 32-bit words.

use serde::Deserialize;
use std::path::{Path, PathBuf};

/// Why a reference set cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ReferenceError {
    /// A file cannot be read.
    #[error("{}: {error}", .file.display())]
    Read {
        /// The file.
        file: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// A file does not hold what it should.
    #[error("{}: {message}", .file.display())]
    Content {
        /// The file.
        file: PathBuf,
        /// What is wrong.
        message: String,
    },
}

/// Words of a node: minimum, maximum, number of triangles or -1, first child or triangle.
pub const NODE_WORDS: u32 = 8;
/// Words of a triangle: three corners, object and material.
pub const TRIANGLE_WORDS: u32 = 11;
/// Words of a ray.
pub const RAY_WORDS: u32 = 8;
/// Words of a result.
pub const RESULT_WORDS: u32 = 2;

#[derive(Deserialize)]
struct Header {
    num_nodes: u32,
    num_tris: u32,
    start_nodes_word: u32,
    start_tris_word: u32,
}

/// A tree as it lies in memory.
#[derive(Clone, Debug)]
pub struct ReferenceScene {
    /// Nodes, then triangles.
    pub words: Vec<u32>,
    /// Number of nodes.
    pub nodes: u32,
    /// Word address of the nodes.
    pub nodes_at: u32,
    /// Word address of the triangles.
    pub triangles_at: u32,
}

/// Rays in the order of the counter, with the results that they are known to have.
#[derive(Clone, Debug)]
pub struct RaySet {
    /// Origin, least distance, direction, greatest distance.
    pub rays: Vec<[f32; RAY_WORDS as usize]>,
    /// Bits of the distance, and triangle or -1.
    pub hits: Vec<(u32, i32)>,
    /// Word address of the rays.
    pub rays_at: u32,
    /// Word address of the results.
    pub results_at: u32,
}

/// Most bytes of a file of a reference run.
const MOST_BYTES: u64 = 1 << 30;

fn read(file: &Path) -> Result<Vec<u8>, ReferenceError> {
    base::input::read_file(file, MOST_BYTES)
        .map_err(|error| ReferenceError::Read { file: file.to_owned(), error })
}

fn words(file: &Path, multiple: u32) -> Result<Vec<u32>, ReferenceError> {
    let bytes = read(file)?;
    if bytes.is_empty() || bytes.len() % (4 * multiple as usize) != 0 {
        let message = format!("{} bytes are not a multiple of {multiple} words", bytes.len());
        return Err(ReferenceError::Content { file: file.to_owned(), message });
    }
    let word = |chunk: &[u8]| u32::from_le_bytes(chunk.try_into().expect("four bytes"));
    Ok(bytes.chunks_exact(4).map(word).collect())
}

impl ReferenceScene {
    /// Reads `NAME.bvh` and `NAME.bvh.json` in `folder`.
    ///
    /// # Errors
    /// If a file is missing or is not a tree: children in ascending order, leaves within the triangles.
    pub fn read(folder: &Path, name: &str) -> Result<Self, ReferenceError> {
        let header_file = folder.join(format!("{name}.bvh.json"));
        let header: Header = serde_json::from_slice(&read(&header_file)?)
            .map_err(|error| ReferenceError::Content { file: header_file, message: error.to_string() })?;
        let file = folder.join(format!("{name}.bvh"));
        let fail = |message: String| ReferenceError::Content { file: file.clone(), message };
        let words = words(&file, 1)?;
        let expected = u64::from(header.num_nodes) * u64::from(NODE_WORDS)
            + u64::from(header.num_tris) * u64::from(TRIANGLE_WORDS);
        if words.len() as u64 != expected || header.num_nodes == 0 {
            return Err(fail(format!("{} words, but the header says {expected}", words.len())));
        }
        let scene = Self {
            words,
            nodes: header.num_nodes,
            nodes_at: header.start_nodes_word,
            triangles_at: header.start_tris_word,
        };
        for node in 0..scene.nodes {
            let (count, child) = scene.node(node);
            let last_triangle = child.checked_sub(scene.triangles_at).map(|at| at / TRIANGLE_WORDS);
            let valid = if count < 0 {
                child > node && child < scene.nodes - 1
            } else {
                count > 0
                    && last_triangle
                        .is_some_and(|t| u64::from(t) + count as u64 <= u64::from(header.num_tris))
            };
            if !valid {
                return Err(fail(format!("node {node} has count {count} and child {child}")));
            }
        }
        Ok(scene)
    }

    /// Number of triangles, negative if inner, and first child or word address of the first triangle.
    #[inline(always)]
    pub fn node(&self, node: u32) -> (i32, u32) {
        let at = (node * NODE_WORDS) as usize;
        (self.words[at + 6] as i32, self.words[at + 7])
    }

    /// The words of nodes and of triangles.
    #[must_use]
    pub fn parts(&self) -> (&[u32], &[u32]) {
        self.words.split_at((self.nodes * NODE_WORDS) as usize)
    }

    /// The number of the triangle at a word address, if one begins there.
    #[must_use]
    pub fn triangle_at(&self, address: u32) -> Option<u32> {
        let offset = address.checked_sub(self.triangles_at)?;
        (offset % TRIANGLE_WORDS == 0).then_some(offset / TRIANGLE_WORDS)
    }
}

impl RaySet {
    /// Reads `NAME.rays` and `NAME.hits` in `folder`, which lie at these word addresses in memory.
    ///
    /// # Errors
    /// If a file is missing or the numbers of rays and hits differ.
    pub fn read(folder: &Path, name: &str, rays_at: u32, results_at: u32) -> Result<Self, ReferenceError> {
        let rays = words(&folder.join(format!("{name}.rays")), RAY_WORDS)?;
        let file = folder.join(format!("{name}.hits"));
        let hits = words(&file, RESULT_WORDS)?;
        let rays: Vec<_> = rays
            .chunks_exact(RAY_WORDS as usize)
            .map(|ray| std::array::from_fn(|k| f32::from_bits(ray[k])))
            .collect();
        let hits: Vec<_> = hits.chunks_exact(2).map(|hit| (hit[0], hit[1] as i32)).collect();
        if rays.len() != hits.len() {
            let message = format!("{} hits for {} rays", hits.len(), rays.len());
            return Err(ReferenceError::Content { file, message });
        }
        Ok(Self { rays, hits, rays_at, results_at })
    }
}
