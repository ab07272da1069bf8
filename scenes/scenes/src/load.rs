//! Loads the scene that a user names.

use std::ffi::OsStr;
use std::path::Path;

use thiserror::Error;

use crate::formats::error::FormatError;
use crate::formats::{self, FileMesh, Format, STDIN};
use crate::frame::frame;
use crate::mesh::Scene;
use crate::procedural::{self, BuildError};
use crate::report::{LoadReport, MeshReport};
use crate::view::{self, ViewError};

/// Why a scene cannot be loaded.
#[derive(Debug, Error)]
pub enum SceneError {
    /// The file of geometry is not usable.
    #[error(transparent)]
    File(#[from] FormatError),
    /// The file with the view is not usable.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The built-in scene cannot be made.
    #[error(transparent)]
    Procedural(#[from] BuildError),
    /// The argument is neither a built-in scene nor a file.
    #[error(
        "`{name}` is neither a built-in scene nor a file; the built-in scenes are {built_in}, and the formats of files {formats}",
        built_in = procedural::names(),
        formats = formats::names()
    )]
    Unknown {
        /// The argument, in which U+FFFD stands for what is not Unicode.
        name: String,
    },
}

/// A scene, and what was found when it was loaded from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// What was found; `None` for a built-in scene.
    pub report: Option<LoadReport>,
}

/// Loads the built-in scene called `scene`, at `detail` in (0, 1] with `seed`. If no built-in scene has that name, loads the file
/// at the path `scene`, or standard input for `-`. Detail and seed do not apply to a file.
///
/// The format of a file is `format`, or else the one that its content or its name says; it may be compressed with xz or gzip. The
/// view is the one in the file `NAME.view.toml` beside it, where that exists. What that does not say, or all if there is no such
/// file, comes from a view of the whole mesh.
///
/// # Errors
/// [`SceneError`] says what to do about it.
pub fn load(scene: &OsStr, format: Option<Format>, detail: f64, seed: u64) -> Result<Loaded, SceneError> {
    if let Some(entry) = scene.to_str().and_then(procedural::find) {
        return Ok(Loaded { scene: procedural::build(entry.name, detail, seed)?, report: None });
    }
    let path = Path::new(scene);
    let from_stdin = scene == STDIN;
    if !from_stdin && path.components().count() <= 1 && path.extension().is_none() && !path.exists() {
        return Err(SceneError::Unknown { name: scene.to_string_lossy().into_owned() });
    }
    let FileMesh { mesh, report } = formats::load(path, format)?;
    let report = LoadReport { file: report, mesh: MeshReport::new(&mesh) };
    let bounds = report.mesh.bounds.expect("a loaded mesh has a triangle");
    let (mut camera, light) = frame(&bounds);
    let name = if from_stdin { "stdin".into() } else { formats::stem(path) };
    if !from_stdin {
        view::apply(&path.with_file_name(view::file_name(&name)), &mut camera)?;
    }
    let name = name.to_string_lossy().into_owned();
    Ok(Loaded { scene: Scene { name, mesh, camera, light }, report: Some(report) })
}

impl Scene {
    /// The scene of [`load`], in a format that content or name say.
    ///
    /// # Errors
    /// [`SceneError`] says what to do about it.
    pub fn load(scene: impl AsRef<OsStr>, detail: f64, seed: u64) -> Result<Self, SceneError> {
        Ok(load(scene.as_ref(), None, detail, seed)?.scene)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_names_list_the_known_ones() {
        for name in ["sponza", ""] {
            let error = Scene::load(name, 1.0, 0).unwrap_err();
            assert!(matches!(error, SceneError::Unknown { .. }));
            let message = error.to_string();
            assert!(procedural::CATALOGUE.iter().all(|entry| message.contains(entry.name)), "{message}");
            assert!(message.contains("gltf"), "{message}");
        }
    }

    #[test]
    fn missing_files_are_named() {
        for name in ["dir/sponza", "sponza.obj", "sponza.obj.xz", "sponza.fbx"] {
            let error = Scene::load(name, 1.0, 0).unwrap_err();
            assert!(matches!(error, SceneError::File(_)));
            assert!(error.to_string().starts_with(name), "{error}");
        }
    }

    #[test]
    fn detail_out_of_range() {
        for detail in [0.0, -1.0, 1.1, f64::NAN, f64::INFINITY] {
            let error = Scene::load("hairball", detail, 0).unwrap_err();
            assert!(matches!(error, SceneError::Procedural(BuildError::Detail(_))), "{error}");
        }
    }

    #[test]
    fn a_file_gets_its_stem_as_name_and_a_view() {
        let folder = tempfile::tempdir().unwrap();
        let scene = procedural::build("hairball", 1e-3, 0).unwrap();
        for name in ["my.model.obj.xz", "my.model.PLY.gz", "my.model.ply"] {
            let path = folder.path().join(name);
            formats::save(&path, "hairball", &scene.mesh, false).unwrap();
            let loaded = Scene::load(&path, 0.5, 3).unwrap();
            assert_eq!(loaded.name, "my.model");
            assert_eq!(loaded.mesh, scene.mesh);
            assert_eq!((loaded.camera, loaded.light), frame(&scene.mesh.bounds().unwrap()));
        }
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_path_need_not_be_unicode() {
        use std::os::unix::ffi::OsStrExt;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(OsStr::from_bytes(b"caf\xe9.obj"));
        std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        std::fs::write(folder.path().join(OsStr::from_bytes(b"caf\xe9.view.toml")), "fov = 30").unwrap();
        let loaded = Scene::load(&path, 1.0, 0).unwrap();
        assert_eq!(loaded.name, "caf\u{fffd}");
        assert_eq!(loaded.camera.fov_y_degrees, 30.0);
    }
}
