//! glTF 2.0, as JSON or binary.
//!
//! The `gltf` crate reads the document and the container. The reader takes the triangles of the default scene's meshes, moved as
//! their nodes say. It reads accessors itself, because that crate's own iterators panic where an accessor reaches beyond its
//! buffer. Skins and morph targets are ignored, which gives the pose that the file was made in.

mod accessor;
mod buffers;

use std::path::Path;

use glam::{DMat4, DQuat, DVec3};
use gltf::json::validation::{Error as Invalid, Validate};
use gltf::mesh::Mode;
use gltf::scene::{Node, Transform};
use gltf::{Document, Primitive, Semantic};

use super::error::{FormatError, FormatErrorKind, Place, check_range};
use super::report::{FileReport, Skip};
use super::whole;
use super::{FileMesh, Format, Input};
use crate::mesh::{MAX_TRIANGLES, Mesh};
use base::input::{FREE_BYTES, RATIO};
use buffers::Buffers;

const MAGIC: &[u8] = b"glTF";
const HEADER_BYTES: usize = 12;
/// Beginnings of the names of extensions that change no geometry, or whose data this module reads.
const HARMLESS: [&str; 9] = [
    "KHR_materials_",
    "KHR_texture_",
    "KHR_lights_",
    "KHR_xmp",
    "KHR_animation_",
    "EXT_texture_",
    "MSFT_texture_",
    "KHR_node_",
    "KHR_mesh_quantization",
];
/// Extensions that put geometry elsewhere.
const INSTANCING: &str = "EXT_mesh_gpu_instancing";
/// Bytes for which a use of a primitive counts besides its vertices and triangles.
const PRIMITIVE_BYTES: u64 = 64;

/// Reads a glTF file and the buffers that it refers to.
pub(super) fn read(input: Input<'_>) -> Result<FileMesh, FormatError> {
    let Input { source, name, folder } = input;
    let at_file = |kind: FormatErrorKind| kind.at(name, Place::File);
    let bytes = whole(source).map_err(|e| at_file(FormatErrorKind::reading(e)))?;
    check_container(&bytes).map_err(at_file)?;
    let mut parsed = gltf::Gltf::from_slice_without_validation(&bytes)
        .map_err(|e| at_file(FormatErrorKind::Invalid(parse_error(&e))))?;
    check_document(&parsed.document, name)?;
    let buffers = Buffers::new(parsed.blob.take().map(Into::into), folder, bytes.len() as u64);
    drop(bytes);
    let mut reader =
        Reader { buffers, mesh: Mesh::default(), report: FileReport::new(Format::Gltf), made_bytes: 0 };
    if parsed.document.extensions_used().any(|extension| extension == INSTANCING) {
        reader.report.skip(INSTANCING, Skip::Geometry, 0);
    }
    reader.scene(&parsed.document).map_err(|(place, kind)| kind.at(name, place))?;
    let Reader { mesh, report, .. } = reader;
    if mesh.triangles.is_empty() {
        return Err(at_file(FormatErrorKind::NoTriangle));
    }
    Ok(FileMesh { mesh, report })
}

/// Refuses a binary file whose length the parser would compute with.
fn check_container(bytes: &[u8]) -> Result<(), FormatErrorKind> {
    if !bytes.starts_with(MAGIC) {
        return Ok(());
    }
    let word = |at: usize| {
        bytes.get(at..at + 4).map(|word| u32::from_le_bytes(word.try_into().expect("four bytes")))
    };
    let (Some(version), Some(length)) = (word(4), word(8)) else {
        return Err(FormatErrorKind::Truncated(format!("the header has {HEADER_BYTES} bytes")));
    };
    if version != 2 {
        return Err(FormatErrorKind::Unsupported(format!("this is glTF {version}")));
    }
    let length = length as usize;
    if length > bytes.len() {
        let what = format!("it declares {length} bytes and has {}", bytes.len());
        return Err(FormatErrorKind::Truncated(what));
    }
    if length < HEADER_BYTES {
        return Err(FormatErrorKind::Invalid(format!(
            "the header declares {length} bytes for the whole file"
        )));
    }
    Ok(())
}

fn parse_error(error: &gltf::Error) -> String {
    match error {
        gltf::Error::Deserialize(error) => {
            format!("the JSON text does not describe a glTF document ({error})")
        }
        other => format!("the binary container is damaged ({other})"),
    }
}

/// Refuses documents of another version, with extensions that change the geometry, or with references to nothing.
fn check_document(document: &Document, name: &Path) -> Result<(), FormatError> {
    let root = document.as_json();
    let at_file = |kind: FormatErrorKind| Err(kind.at(name, Place::File));
    if !root.asset.version.starts_with("2.") {
        return at_file(FormatErrorKind::Unsupported(format!("this is glTF {}", root.asset.version)));
    }
    let unknown = |extension: &&String| !HARMLESS.iter().any(|harmless| extension.starts_with(harmless));
    if let Some(extension) = root.extensions_required.iter().find(unknown) {
        return at_file(FormatErrorKind::Unsupported(format!("the file requires the extension {extension}")));
    }
    // The crate's validation takes these indices for granted.
    let mut primitives = root.meshes.iter().flat_map(|mesh| &mesh.primitives);
    if primitives
        .any(|primitive| primitive.attributes.values().any(|index| index.value() >= root.accessors.len()))
    {
        return at_file(FormatErrorKind::Invalid("an attribute of a mesh refers to no accessor".to_owned()));
    }
    let mut fault = None;
    root.validate(root, gltf::json::Path::new, &mut |path, error| {
        // Some exporters leave out bounds, or write others. What is wrong with materials changes no geometry.
        let path = path().to_string();
        let geometry = ["accessors", "buffers", "bufferViews", "meshes", "nodes", "scene"];
        let bound = path.ends_with(".min") || path.ends_with(".max");
        if error != Invalid::Missing && !bound && geometry.iter().any(|part| path.starts_with(part)) {
            fault.get_or_insert((path, error));
        }
    });
    match fault {
        None => Ok(()),
        Some((path, error)) => {
            let what = match error {
                Invalid::IndexOutOfBounds => "refers to nothing",
                _ => "has a value that is not allowed",
            };
            Err(FormatErrorKind::Invalid(what.to_owned()).at(name, Place::Element(path)))
        }
    }
}

type Fault = (Place, FormatErrorKind);

/// What is wrong with a part of the document.
fn fault(part: impl Into<String>, kind: FormatErrorKind) -> Fault {
    (Place::Element(part.into()), kind)
}

struct Reader<'a> {
    buffers: Buffers<'a>,
    mesh: Mesh,
    report: FileReport,
    /// Bytes that were made of the file's.
    made_bytes: u64,
}

impl Reader<'_> {
    /// Adds the meshes of the default scene, or of the first, or of all nodes without a parent where there is no scene.
    fn scene(&mut self, document: &Document) -> Result<(), Fault> {
        let mut visited = vec![false; document.nodes().len()];
        let scene = document.default_scene().or_else(|| document.scenes().next());
        let mut open: Vec<(Node<'_>, DMat4)> = match scene {
            Some(scene) => scene.nodes().map(|node| (node, DMat4::IDENTITY)).collect(),
            None => {
                let mut is_child = visited.clone();
                document
                    .nodes()
                    .flat_map(|node| node.children())
                    .for_each(|child| is_child[child.index()] = true);
                document
                    .nodes()
                    .filter(|node| !is_child[node.index()])
                    .map(|node| (node, DMat4::IDENTITY))
                    .collect()
            }
        };
        open.reverse();
        while let Some((node, above)) = open.pop() {
            let part = || format!("node {}", node.index());
            if std::mem::replace(&mut visited[node.index()], true) {
                let what = "it has two parents, or is its own ancestor".to_owned();
                return Err(fault(part(), FormatErrorKind::Invalid(what)));
            }
            let transform = above * local(&node);
            if let Some(mesh) = node.mesh() {
                if node.skin().is_some() {
                    self.report.skip("skins of meshes", Skip::Geometry, 0);
                }
                for primitive in mesh.primitives() {
                    let part = format!("mesh {}, primitive {}", mesh.index(), primitive.index());
                    self.primitive(&primitive, &transform, part)?;
                }
            }
            let first_child = open.len();
            open.extend(node.children().map(|child| (child, transform)));
            open[first_child..].reverse();
        }
        Ok(())
    }

    /// Adds the triangles of `primitive`, moved by `transform`.
    fn primitive(&mut self, primitive: &Primitive<'_>, transform: &DMat4, part: String) -> Result<(), Fault> {
        let mode = primitive.mode();
        if !matches!(mode, Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan) {
            self.made(PRIMITIVE_BYTES, &part)?;
            self.report.skip("points and lines", Skip::NoTriangle, 0);
            return Ok(());
        }
        if primitive.morph_targets().len() > 0 {
            self.report.skip("morph targets", Skip::Geometry, 0);
        }
        let Some(positions) = primitive.get(&Semantic::Positions) else {
            self.report.skip("primitives without positions", Skip::NoTriangle, 0);
            return self.made(PRIMITIVE_BYTES, &part);
        };
        let indices = primitive.indices();
        let corners = indices.as_ref().map_or(positions.count(), gltf::Accessor::count);
        let vertex_bytes = size_of::<[f32; 3]>() as u64;
        let made = (positions.count() as u64).saturating_add(corners as u64).saturating_mul(vertex_bytes);
        let first = self.mesh.positions.len();
        self.made(made.saturating_add(PRIMITIVE_BYTES), &part)?;
        self.buffers.read(&positions, 3, |position| {
            let position = moved(transform, [position[0], position[1], position[2]]);
            for x in position {
                check_range(x, || x.to_string())?;
            }
            self.mesh.positions.push(position);
            Ok(())
        })?;
        let vertices = self.mesh.positions.len() - first;
        let mut corners = Vec::new();
        match indices {
            None => corners.extend(0..vertices as u32),
            Some(indices) => self.buffers.read(&indices, 1, |index| {
                let index = index[0] as u32;
                if index as usize >= vertices {
                    return Err(FormatErrorKind::IndexOutOfRange {
                        index: index.into(),
                        vertices: vertices as u64,
                    });
                }
                corners.push(index);
                Ok(())
            })?,
        }
        // A mirrored mesh shows its inside, so the order of the corners changes too.
        let mirrored = transform.determinant() < 0.0;
        let mut push = |[a, b, c]: [u32; 3]| {
            let corners = if mirrored { [a, c, b] } else { [a, b, c] };
            self.mesh.triangles.push(corners.map(|corner| corner + first as u32));
        };
        match mode {
            Mode::TriangleStrip => {
                for (i, t) in corners.array_windows::<3>().enumerate() {
                    push(if i % 2 == 0 { *t } else { [t[1], t[0], t[2]] });
                }
            }
            Mode::TriangleFan => {
                corners.windows(2).skip(1).for_each(|side| push([corners[0], side[0], side[1]]))
            }
            _ => corners.as_chunks().0.iter().for_each(|triangle| push(*triangle)),
        }
        if self.mesh.triangles.len() > MAX_TRIANGLES {
            return Err(fault(part, FormatErrorKind::TooManyTriangles));
        }
        Ok(())
    }

    /// Refuses a file that uses its meshes so often that the whole does not fit its size.
    fn made(&mut self, bytes: u64, part: &str) -> Result<(), Fault> {
        self.made_bytes = self.made_bytes.saturating_add(bytes);
        if self.made_bytes > FREE_BYTES + RATIO.saturating_mul(self.buffers.read_bytes) {
            let what = format!(
                "with this use of a mesh, the scene is larger than {} MiB plus {RATIO} times the file",
                FREE_BYTES >> 20
            );
            return Err(fault(part, FormatErrorKind::Unsupported(what)));
        }
        Ok(())
    }
}

/// The transform of a node relative to its parent.
fn local(node: &Node<'_>) -> DMat4 {
    let wide = |v: [f32; 3]| DVec3::from(v.map(f64::from));
    match node.transform() {
        Transform::Matrix { matrix } => {
            DMat4::from_cols_array_2d(&matrix.map(|column| column.map(f64::from)))
        }
        Transform::Decomposed { translation, rotation, scale } => {
            let rotation = DQuat::from_array(rotation.map(f64::from));
            // Rounded quaternions are not quite of length 1.
            let rotation =
                if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY };
            DMat4::from_scale_rotation_translation(wide(scale), rotation, wide(translation))
        }
    }
}

/// `position` moved by `transform`, rounded once.
fn moved(transform: &DMat4, position: [f64; 3]) -> [f32; 3] {
    if *transform == DMat4::IDENTITY {
        return position.map(|x| x as f32);
    }
    transform.transform_point3(DVec3::from(position)).to_array().map(|x| x as f32)
}
