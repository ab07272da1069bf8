//! Wavefront OBJ files, plain or xz-compressed.
//!
//! Only geometry counts. The reader joins objects and groups in file order, ignores materials, normals, texture
//! coordinates, lines and points, and turns polygons into fans. Triangle `i` of the mesh is the `i`-th triangle of
//! the file. Vertices are numbered in the order in which faces first name them; a vertex that no face names is
//! dropped.

mod check;
mod error;
mod write;

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

use liblzma::bufread::XzDecoder;

use crate::mesh::Mesh;
use check::CheckedReader;
pub use error::{ObjError, ObjErrorKind};
pub use write::{save, write};

const XZ_MAGIC: &[u8] = b"\xfd7zXZ\0";
const BUFFER_BYTES: usize = 1 << 16;

/// Loads the file `path`, and recognises xz compression by the content.
///
/// # Errors
/// [`ObjError`] names the file, the line and the remedy.
pub fn load(path: impl AsRef<Path>) -> Result<Mesh, ObjError> {
    let path = path.as_ref();
    let open = |e| ObjError { path: path.to_owned(), line: None, kind: ObjErrorKind::Open(e) };
    let file = File::open(path).map_err(open)?;
    read(BufReader::with_capacity(BUFFER_BYTES, file), path)
}

/// Reads an OBJ file, plain or xz-compressed, from `source`; `name` stands for it in errors.
///
/// # Errors
/// [`ObjError`] names the file, the line and the remedy.
pub fn read(mut source: impl BufRead, name: impl AsRef<Path>) -> Result<Mesh, ObjError> {
    let name = name.as_ref();
    let error = |kind| ObjError { path: name.to_owned(), line: None, kind };
    let start = source.fill_buf().map_err(|e| error(ObjErrorKind::Read(e)))?;
    if start.starts_with(XZ_MAGIC) {
        let decoder = XzDecoder::new_multi_decoder(source);
        read_text(BufReader::with_capacity(BUFFER_BYTES, decoder), name)
    } else {
        read_text(source, name)
    }
}

fn read_text(source: impl BufRead, name: &Path) -> Result<Mesh, ObjError> {
    let options = tobj::LoadOptions { triangulate: true, single_index: true, ..Default::default() };
    let mut text = CheckedReader::new(source, name);
    let parsed = tobj::load_obj_buf(&mut text, &options, |_| Err(tobj::LoadError::GenericFailure));
    if let Some(fault) = text.into_fault() {
        return Err(fault);
    }
    let error = |kind| ObjError { path: name.to_owned(), line: None, kind };
    let (models, _materials) = parsed.map_err(|e| error(ObjErrorKind::Rejected(e)))?;
    // The checked text has no objects and groups, hence one model with all faces in file order.
    let model = models.into_iter().next().ok_or_else(|| error(ObjErrorKind::NoTriangle))?;
    Ok(Mesh {
        positions: model.mesh.positions.as_chunks().0.to_vec(),
        triangles: model.mesh.indices.as_chunks().0.to_vec(),
    })
}

#[cfg(test)]
mod tests;
