//! Wavefront OBJ files.
//!
//! Only geometry counts. The reader joins objects and groups in file order, ignores materials, normals and texture
//! coordinates, and turns polygons into triangles. Triangles have the order of their faces in the file. Vertices are numbered in
//! the order in which faces first name them; a vertex that no face names is dropped.

mod clean;
mod statement;

use std::io::{BufRead, BufReader};
use std::path::Path;

use super::error::{FormatError, FormatErrorKind, Place};
use super::polygons::Triangulator;
use super::report::FileReport;
pub use super::write::{save, write_obj as write};
use super::{FileMesh, Format, Input, source};
use crate::mesh::Mesh;
use clean::CleanReader;

/// Loads the OBJ file `path`, and recognises compression by the content.
///
/// # Errors
/// [`FormatError`] names the file, the line and the remedy.
pub fn load(path: impl AsRef<Path>) -> Result<Mesh, FormatError> {
    let path = path.as_ref();
    let file = source::open(path).map_err(|e| FormatErrorKind::Open(e).at(path, Place::File))?;
    read(BufReader::new(file), path)
}

/// Reads an OBJ file, plain or compressed, from `source`; `name` stands for it in errors.
///
/// # Errors
/// [`FormatError`] names the file, the line and the remedy.
pub fn read(source: impl BufRead, name: impl AsRef<Path>) -> Result<Mesh, FormatError> {
    let name = name.as_ref();
    let mut source = source::unpacked(source).map_err(|e| FormatErrorKind::Read(e).at(name, Place::File))?;
    Ok(read_input(Input { source: &mut *source, name, folder: None })?.mesh)
}

/// Reads plain OBJ text.
pub(super) fn read_input(input: Input<'_>) -> Result<FileMesh, FormatError> {
    let Input { source, name, .. } = input;
    let options = tobj::LoadOptions { triangulate: false, single_index: true, ..Default::default() };
    let mut text = CleanReader::new(source, name);
    let parsed = tobj::load_obj_buf(&mut text, &options, |_| Err(tobj::LoadError::GenericFailure));
    let mut report = FileReport::new(Format::Obj);
    text.finish(&mut report)?;
    let error = |kind: FormatErrorKind, place| kind.at(name, place);
    let (models, _materials) = parsed.map_err(|e| error(FormatErrorKind::Rejected(e), Place::File))?;
    // The cleaned text has no objects and groups, hence one model with all faces in file order.
    let mesh = models.into_iter().next().ok_or_else(|| error(FormatErrorKind::NoTriangle, Place::File))?.mesh;
    let positions = mesh.positions.as_chunks().0.to_vec();
    if mesh.face_arities.is_empty() {
        return Ok(FileMesh {
            mesh: Mesh { positions, triangles: mesh.indices.as_chunks().0.to_vec() },
            report,
        });
    }
    let mut triangulator = Triangulator::new();
    let mut triangles = Vec::with_capacity(mesh.face_arities.len());
    let mut rest = mesh.indices.as_slice();
    for (face, &corners) in mesh.face_arities.iter().enumerate() {
        let (polygon, others) = rest.split_at(corners as usize);
        triangulator
            .push(&positions, polygon, &mut triangles)
            .map_err(|kind| error(kind, Place::Element(format!("face {}", face + 1))))?;
        rest = others;
    }
    report.polygons = triangulator.counts;
    Ok(FileMesh { mesh: Mesh { positions, triangles }, report })
}

#[cfg(test)]
mod polygon_tests;
#[cfg(test)]
mod tests;
