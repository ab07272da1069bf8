//! Loads the scene that a user names.

use std::path::Path;

use thiserror::Error;

use crate::frame::frame;
use crate::mesh::Scene;
use crate::obj::{self, ObjError};
use crate::procedural::{self, BuildError};

/// Why a scene cannot be loaded.
#[derive(Debug, Error)]
pub enum SceneError {
    /// The OBJ file is not usable.
    #[error(transparent)]
    Obj(#[from] ObjError),
    /// The built-in scene cannot be made.
    #[error(transparent)]
    Procedural(#[from] BuildError),
    /// The argument is neither a built-in scene nor a file.
    #[error("`{name}` is neither a built-in scene nor an OBJ file; the built-in scenes are {built_in}", built_in = procedural::names())]
    Unknown {
        /// The argument.
        name: String,
    },
}

impl Scene {
    /// Loads the built-in scene called `scene`, at `detail` in (0, 1] with `seed`. If no built-in scene has that
    /// name, loads the OBJ file at the path `scene`, plain or xz-compressed, with a view of all of it. Detail and
    /// seed do not apply to a file.
    ///
    /// # Errors
    /// [`SceneError`] says what to do about it.
    pub fn load(scene: &str, detail: f64, seed: u64) -> Result<Self, SceneError> {
        if procedural::find(scene).is_some() {
            return Ok(procedural::build(scene, detail, seed)?);
        }
        let path = Path::new(scene);
        if path.components().count() <= 1 && path.extension().is_none() && !path.exists() {
            return Err(SceneError::Unknown { name: scene.to_owned() });
        }
        let mesh = obj::load(path)?;
        let bounds = mesh.bounds().expect("a loaded mesh has a triangle");
        let (camera, light) = frame(&bounds);
        Ok(Self { name: stem(path), mesh, camera, light })
    }
}

/// The file name without `.obj` or `.obj.xz`.
fn stem(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let name = name.strip_suffix(".xz").unwrap_or(&name);
    name.strip_suffix(".obj").unwrap_or(name).to_owned()
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
        }
    }

    #[test]
    fn missing_files_are_named() {
        for name in ["dir/sponza", "sponza.obj", "sponza.obj.xz"] {
            let error = Scene::load(name, 1.0, 0).unwrap_err();
            assert!(matches!(error, SceneError::Obj(_)));
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
        let path = folder.path().join("my.model.obj.xz");
        let scene = procedural::build("hairball", 1e-3, 0).unwrap();
        obj::save(&path, "hairball", &scene.mesh, false).unwrap();
        let loaded = Scene::load(path.to_str().unwrap(), 0.5, 3).unwrap();
        assert_eq!(loaded.name, "my.model");
        assert_eq!(loaded.mesh, scene.mesh);
        assert_eq!((loaded.camera, loaded.light), frame(&scene.mesh.bounds().unwrap()));
    }
}
