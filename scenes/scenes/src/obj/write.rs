//! Writes meshes so that every coordinate comes back bit for bit.

use std::io::{self, Write};
use std::path::Path;

use liblzma::write::XzEncoder;

use crate::mesh::Mesh;
use base::output::{WriteError, write_file};

/// xz preset; higher ones are several times slower for a few percent.
const XZ_LEVEL: u32 = 1;

/// Writes `mesh` to the file `path`, xz-compressed if its extension is `xz`.
///
/// The bytes depend on the mesh and on `name` alone. The file appears when it is complete.
///
/// # Errors
/// [`WriteError::Exists`] if there is such a file and `force` is false, [`WriteError::Io`] otherwise.
pub fn save(path: impl AsRef<Path>, name: &str, mesh: &Mesh, force: bool) -> Result<(), WriteError> {
    let path = path.as_ref();
    let compressed = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("xz"));
    write_file(path, force, |out| {
        if compressed {
            let mut encoder = XzEncoder::new(out, XZ_LEVEL);
            write(&mut encoder, name, mesh)?;
            encoder.finish().map(|_| ())
        } else {
            write(out, name, mesh)
        }
    })
}

/// Writes `mesh` as an object called `name`, with the shortest decimals that read back to the same `f32`.
///
/// Reading gives back the same triangles with the same corners in the same order; vertices too keep their
/// numbers if triangles first name them in ascending order, as in all meshes of this crate.
///
/// # Errors
/// Those of `out`.
pub fn write(mut out: impl Write, name: &str, mesh: &Mesh) -> io::Result<()> {
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
