//! Writes meshes so that every coordinate comes back bit for bit.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use base::output::{WriteError, write_file};
use flate2::write::GzEncoder;
use liblzma::write::XzEncoder;
use ply_rs_bw::ply::{
    Addable, ElementDef, Encoding, Header, PropertyAccess, PropertyDef, PropertyType, ScalarType, Version,
};
use ply_rs_bw::writer::Writer;
use thiserror::Error;

use super::{Format, extension, lower_extension};
use crate::mesh::Mesh;

/// xz preset; higher ones are several times slower for a few percent.
const XZ_LEVEL: u32 = 1;
/// gzip level, the usual one.
const GZIP_LEVEL: u32 = 6;

/// Why a mesh was not written.
#[derive(Debug, Error)]
pub enum SaveError {
    /// The file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// The name says no format that is written.
    #[error("{}: no format that is written; end the name in .obj, .ply or .stl, with .xz or .gz after it to compress", .0.display())]
    Format(PathBuf),
}

/// The format in which [`save`] writes a file of this name.
///
/// # Errors
/// [`SaveError::Format`] if it writes none.
pub fn written_format(path: &Path) -> Result<Format, SaveError> {
    // A `.glb` would be binary and a `.gltf` not, and neither is needed for meshes without materials.
    let format = Format::of_path(path).filter(|format| *format != Format::Gltf && extension(path).is_some());
    format.ok_or_else(|| SaveError::Format(path.to_owned()))
}

/// Writes `mesh` to the file `path` in the format and compression that the name says.
///
/// The bytes depend on the mesh, on `name` and on the format alone. The file appears when it is complete.
///
/// # Errors
/// [`SaveError::Format`] for a name that says no format, [`WriteError::Exists`] if there is such a file and `force` is false,
/// [`WriteError::Io`] otherwise.
pub fn save(path: impl AsRef<Path>, name: &str, mesh: &Mesh, force: bool) -> Result<(), SaveError> {
    let path = path.as_ref();
    let write = match written_format(path)? {
        Format::Ply => write_ply,
        Format::Stl => write_stl,
        Format::Obj | Format::Gltf => {
            |out: &mut dyn Write, name: &str, mesh: &Mesh| write_obj(out, name, mesh)
        }
    };
    let written = write_file(path, force, |out| match lower_extension(path).as_deref() {
        Some("xz") => {
            let mut encoder = XzEncoder::new(out, XZ_LEVEL);
            write(&mut encoder, name, mesh)?;
            encoder.finish().map(|_| ())
        }
        Some("gz") => {
            let mut encoder = GzEncoder::new(out, flate2::Compression::new(GZIP_LEVEL));
            write(&mut encoder, name, mesh)?;
            encoder.finish().map(|_| ())
        }
        _ => write(out, name, mesh),
    });
    Ok(written?)
}

/// Writes `mesh` as an OBJ object called `name`, with the shortest decimals that read back to the same `f32`.
///
/// Reading gives back the same triangles with the same corners in the same order; vertices too keep their
/// numbers if triangles first name them in ascending order, as in all meshes of this crate.
///
/// # Errors
/// Those of `out`.
pub fn write_obj(mut out: impl Write, name: &str, mesh: &Mesh) -> io::Result<()> {
    let word: String =
        name.chars().map(|c| if c.is_whitespace() || c.is_control() { '_' } else { c }).collect();
    writeln!(out, "# {} triangles, {} vertices", mesh.triangles.len(), mesh.positions.len())?;
    writeln!(out, "o {word}")?;
    for [x, y, z] in &mesh.positions {
        writeln!(out, "v {x:?} {y:?} {z:?}")?;
    }
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|index| u64::from(index) + 1);
        writeln!(out, "f {a} {b} {c}")?;
    }
    Ok(())
}

/// Writes `mesh` as little-endian PLY, with all vertices in their order.
fn write_ply(mut out: &mut dyn Write, name: &str, mesh: &Mesh) -> io::Result<()> {
    let element = |name: &str, count, properties: Vec<PropertyDef>| {
        let mut element = ElementDef::new(name.to_owned());
        element.count = count;
        properties.into_iter().for_each(|property| element.properties.add(property));
        element
    };
    let axis = |name: &str| PropertyDef::new(name.to_owned(), PropertyType::Scalar(ScalarType::Float));
    let corners = PropertyType::List(ScalarType::UChar, ScalarType::Int);
    let vertex = element("vertex", mesh.positions.len(), vec![axis("x"), axis("y"), axis("z")]);
    let indices = vec![PropertyDef::new("vertex_indices".to_owned(), corners)];
    let face = element("face", mesh.triangles.len(), indices);
    let mut header = Header::new();
    header.encoding = Encoding::BinaryLittleEndian;
    header.version = Version { major: 1, minor: 0 };
    header.comments.push(name.chars().map(|c| if c.is_control() { '_' } else { c }).collect());
    header.elements.add(vertex.clone());
    header.elements.add(face.clone());
    Writer::<Corner>::new().write_header(&mut out, &header)?;
    for &position in &mesh.positions {
        Writer::new().write_little_endian_element(&mut out, &Corner(position), &vertex)?;
    }
    for triangle in &mesh.triangles {
        let mut corners = [0; 3];
        for (corner, &index) in corners.iter_mut().zip(triangle) {
            *corner = i32::try_from(index).map_err(io::Error::other)?;
        }
        Writer::new().write_little_endian_element(&mut out, &Side(corners), &face)?;
    }
    Ok(())
}

/// A vertex of a PLY file.
struct Corner([f32; 3]);

impl PropertyAccess for Corner {
    fn new() -> Self {
        Self([0.0; 3])
    }

    fn get_float(&self, name: &str) -> Option<f32> {
        ["x", "y", "z"].iter().position(|axis| *axis == name).map(|axis| self.0[axis])
    }
}

/// A face of a PLY file.
struct Side([i32; 3]);

impl PropertyAccess for Side {
    fn new() -> Self {
        Self([0; 3])
    }

    fn get_list_int(&self, _: &str) -> Option<&[i32]> {
        Some(&self.0)
    }
}

/// Writes `mesh` as binary STL, which holds three corners for each triangle and says nothing of shared vertices. The normals are
/// zero, so that readers compute them.
fn write_stl(mut out: &mut dyn Write, _: &str, mesh: &Mesh) -> io::Result<()> {
    let facet = |triangle| stl_io::Triangle {
        normal: stl_io::Normal::new([0.0; 3]),
        vertices: mesh.corners(triangle).map(stl_io::Vertex::new),
    };
    stl_io::write_stl(&mut out, (0..mesh.triangles.len()).map(facet))
}
