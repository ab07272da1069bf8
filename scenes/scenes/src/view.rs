//! Views beside meshes.
//!
//! The file `NAME.view.toml` holds the camera of `NAME.obj`, of `NAME.ply.gz`, and so on. It has up to five keys, those of the
//! tool's options: `eye` and `up`, `target` or `direction`, which are arrays of three numbers, and `fov`, the vertical field of
//! view in degrees.

use std::ffi::OsString;
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

use serde::Deserialize;
use thiserror::Error;
use toml::Spanned;

use crate::mesh::{Camera, MAX_COORDINATE};

const EXTENSION: &str = ".view.toml";
/// Most bytes of a view.
const MOST_BYTES: u64 = 1 << 16;

/// A rejected view. Its message is `FILE:LINE: what is wrong; what to do`.
#[derive(Debug, Error)]
#[error("{}{}: {what}; the keys are eye, target or direction, up, and fov", path.display(), line.map_or(String::new(), |line| format!(":{line}")))]
pub struct ViewError {
    /// The file.
    pub path: PathBuf,
    /// The line at fault, from 1, if a line is.
    pub line: Option<usize>,
    what: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct View {
    eye: Option<Spanned<[f32; 3]>>,
    target: Option<Spanned<[f32; 3]>>,
    direction: Option<Spanned<[f32; 3]>>,
    up: Option<Spanned<[f32; 3]>>,
    fov: Option<Spanned<f32>>,
}

/// The name of the file with the view of the mesh whose file has the name `stem` without its extensions.
pub(crate) fn file_name(stem: &Path) -> OsString {
    let mut name = stem.as_os_str().to_owned();
    name.push(EXTENSION);
    name
}

/// Changes `camera` as the file `path` says, if there is one.
///
/// # Errors
/// [`ViewError`] names the file, the line and the key.
pub(crate) fn apply(path: &Path, camera: &mut Camera) -> Result<(), ViewError> {
    let fault = |line, what: String| ViewError { path: path.to_owned(), line, what };
    let mut text = String::new();
    match base::input::open(path) {
        Err(e) if e.kind() == ErrorKind::NotFound => return Ok(()),
        // A device has no size that could be looked at.
        file => file.and_then(|file| file.take(MOST_BYTES + 1).read_to_string(&mut text)),
    }
    .map_err(|e| fault(None, format!("cannot read the view ({e})")))?;
    if text.len() as u64 > MOST_BYTES {
        return Err(fault(None, format!("the view has more than {MOST_BYTES} bytes")));
    }
    let line_of =
        |at: usize| text.as_bytes()[..at.min(text.len())].iter().filter(|&&byte| byte == b'\n').count() + 1;
    let view: View = base::toml_text::parse(&text).map_err(|e| {
        let line = e.span().map(|span| line_of(span.start));
        let key = line
            .and_then(|line| text.lines().nth(line - 1))
            .map_or(String::new(), |text| format!(" in `{}`", text.trim()));
        fault(line, format!("{}{key}", e.message().lines().next().unwrap_or_default()))
    })?;
    let at = |span: std::ops::Range<usize>, what: &str| fault(Some(line_of(span.start)), what.to_owned());
    let vector = |key: &str, value: Option<Spanned<[f32; 3]>>| match value {
        Some(value) if !value.get_ref().iter().all(|x| x.abs() <= MAX_COORDINATE) => Err(at(
            value.span(),
            &format!("`{key}` has a number that is not finite or beyond +-{MAX_COORDINATE:e}"),
        )),
        value => Ok(value),
    };
    let (eye, up) = (vector("eye", view.eye)?, vector("up", view.up)?);
    let (target, direction) = (vector("target", view.target)?, vector("direction", view.direction)?);
    if let (Some(_), Some(direction)) = (&target, &direction) {
        return Err(at(direction.span(), "`target` and `direction` exclude each other"));
    }
    if let Some(eye) = eye {
        camera.eye = eye.into_inner();
    }
    if let Some(target) = target {
        camera.target = *target.get_ref();
        if camera.target == camera.eye {
            return Err(at(target.span(), "`target` is the eye"));
        }
    }
    if let Some(direction) = direction {
        let towards = *direction.get_ref();
        camera.target = std::array::from_fn(|axis| camera.eye[axis] + towards[axis]);
        if camera.target == camera.eye {
            return Err(at(direction.span(), "`direction` is zero, or too short beside `eye`"));
        }
    }
    if let Some(up) = up {
        camera.up = *up.get_ref();
        let along: [f64; 3] =
            std::array::from_fn(|axis| f64::from(camera.target[axis]) - f64::from(camera.eye[axis]));
        let up_f64 = camera.up.map(f64::from);
        let sine = |a: usize, b: usize| along[a] * up_f64[b] == along[b] * up_f64[a];
        if sine(0, 1) && sine(1, 2) && sine(2, 0) {
            return Err(at(up.span(), "`up` is zero or lies along the view"));
        }
    }
    if let Some(fov) = view.fov {
        camera.fov_y_degrees = *fov.get_ref();
        if !(camera.fov_y_degrees > 0.0 && camera.fov_y_degrees < 180.0) {
            return Err(at(fov.span(), "`fov` is not between 0 and 180 degrees"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAMERA: Camera =
        Camera { eye: [0.0, 0.0, 5.0], target: [0.0; 3], up: [0.0, 1.0, 0.0], fov_y_degrees: 45.0 };

    fn applied(text: &str) -> Result<Camera, ViewError> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.view.toml");
        std::fs::write(&path, text).unwrap();
        let mut camera = CAMERA;
        apply(&path, &mut camera).map(|()| camera)
    }

    #[test]
    fn what_is_not_said_stays() {
        assert_eq!(applied("").unwrap(), CAMERA);
        let whole = applied("eye = [1, 2.5, 3]\ntarget = [4, 5, 6]\nup = [0, 0, 1]\nfov = 60\n").unwrap();
        let expected = Camera {
            eye: [1.0, 2.5, 3.0],
            target: [4.0, 5.0, 6.0],
            up: [0.0, 0.0, 1.0],
            fov_y_degrees: 60.0,
        };
        assert_eq!(whole, expected);
        let direction = applied("direction = [1, 0, 0]").unwrap();
        assert_eq!((direction.eye, direction.target), (CAMERA.eye, [1.0, 0.0, 5.0]));
        let mut camera = CAMERA;
        apply(Path::new("no/such.view.toml"), &mut camera).unwrap();
        assert_eq!(camera, CAMERA);
    }

    #[test]
    fn faults_name_the_file_the_key_and_the_line() {
        for (text, line, word) in [
            ("fov = 30\nzoom = 2\n", 2, "zoom"),
            ("\nfov = \"wide\"\n", 2, "fov"),
            ("fov = 180", 1, "`fov`"),
            ("fov = nan", 1, "`fov`"),
            ("eye = [1, 2]\n", 1, "eye"),
            ("\n\neye = [1, 2, inf]\n", 3, "`eye`"),
            ("target = [0, 0, 5]\n", 1, "`target`"),
            ("target = [0, 0, 1]\ndirection = [0, 0, 1]\n", 2, "`direction`"),
            ("direction = [0, 0, 0]", 1, "`direction`"),
            ("up = [0, 0, 2]", 1, "`up`"),
            ("eye = [1, 2, 3", 1, "eye"),
        ] {
            let error = applied(text).unwrap_err();
            let message = error.to_string();
            assert_eq!(error.line, Some(line), "{text}: {message}");
            assert!(
                message.contains(&format!("a.view.toml:{line}: ")) && message.contains(word),
                "{message}"
            );
        }
        assert!(applied(&"#".repeat(1 << 17)).unwrap_err().to_string().contains("bytes"));
    }
}
