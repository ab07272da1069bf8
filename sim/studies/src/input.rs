//! The inputs of the studies: scenes, trees, views, and names of files to write.

use crate::progress::{Part, Progress};
use anyhow::{Context, bail, ensure};
use base::guard;
use base::output::{WriteError, is_special, target};
use golden::build::{BinaryTree, BuildError, BuildOptions, Quality, build};
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::tree_file;
use golden::triangle::Triangle;
use scenes::{Format, LoadReport, Loaded, Scene};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// Irradiance of a moved light at the view's target.
const IRRADIANCE_AT_TARGET: f64 = 4.0;

/// A scene that is named on the command line.
#[derive(Clone, Debug)]
pub struct SceneSource {
    /// A built-in scene, a file of geometry, or `-` for standard input.
    pub name: OsString,
    /// The format of the file; `None` to recognise it.
    pub format: Option<Format>,
    /// Fraction of a built-in scene's full number of triangles, above 0 and at most 1.
    pub detail: f64,
    /// Seed of a built-in scene.
    pub seed: u64,
}

impl SceneSource {
    /// The name as the path of a file that is read; a built-in scene has none.
    pub fn path(&self) -> Option<&Path> {
        let built_in = self.name.to_str().is_some_and(|name| scenes::procedural::find(name).is_some());
        (!built_in).then(|| Path::new(&self.name))
    }

    /// Loads or makes the scene, and notes what may surprise in a file.
    ///
    /// # Errors
    /// There is no such scene or file, or the file holds no scene.
    pub fn load(&self, progress: &dyn Progress) -> anyhow::Result<Scene> {
        let name = self.name.display();
        let part = Part::endless(progress, &format!("loading {name}"));
        let Loaded { scene, report } = scenes::load(&self.name, self.format, self.detail, self.seed)?;
        drop(part);
        for note in report.iter().flat_map(LoadReport::notes) {
            progress.note(&format!("{name}: {note}"));
        }
        Ok(scene)
    }
}

/// The preset's name on the command line and in result files.
pub fn quality_name(quality: Quality) -> &'static str {
    match quality {
        Quality::Fast => "fast",
        Quality::Medium => "medium",
        Quality::High => "high",
    }
}

/// A binary hierarchy, from which structures are converted.
pub struct Built {
    /// The hierarchy.
    pub tree: BinaryTree,
    /// The triangles in the order of the hierarchy's leaves.
    pub triangles: Arc<[Triangle]>,
    /// Milliseconds that building took.
    pub build_ms: f64,
}

impl Built {
    /// Builds the hierarchy over `scene`.
    ///
    /// # Errors
    /// The errors of the builder, with the name of the scene.
    pub fn new(scene: &Scene, quality: Quality, progress: &dyn Progress) -> anyhow::Result<Self> {
        let _part = Part::endless(progress, &format!("building over {}", scene.name));
        Self::with(scene, || build(&scene.mesh, &BuildOptions::new(quality)))
    }

    /// Takes the hierarchy over `scene` that `build` makes.
    ///
    /// # Errors
    /// The errors of `build`, with the name of the scene.
    pub fn with(
        scene: &Scene,
        build: impl FnOnce() -> Result<BinaryTree, BuildError>,
    ) -> anyhow::Result<Self> {
        let start = Instant::now();
        let tree = build().with_context(|| scene.name.clone())?;
        let build_ms = milliseconds(start);
        let triangles = pack_triangles(&scene.mesh, &tree);
        Ok(Self { tree, triangles, build_ms })
    }

    /// The hierarchy converted to a structure of `kind`, and the milliseconds that the conversion took.
    ///
    /// # Errors
    /// The structure cannot hold so many nodes or triangles.
    pub fn convert(&self, kind: StructureKind) -> anyhow::Result<(Structure, f64)> {
        let start = Instant::now();
        let structure = Structure::convert(kind, &self.tree, &self.triangles)?;
        Ok((structure, milliseconds(start)))
    }
}

/// The structure that rays are traced through: built, or loaded from a file.
#[derive(Clone, Debug)]
pub struct StructureSource {
    /// The kind of structure that is built.
    pub kind: StructureKind,
    /// How the structure is built.
    pub quality: Quality,
    /// The file that the structure is loaded from, instead of being built.
    pub file: Option<PathBuf>,
}

impl StructureSource {
    /// The structure over `scene`.
    ///
    /// # Errors
    /// Building fails, or the file holds no structure over this scene.
    pub fn load(&self, scene: &Scene, progress: &dyn Progress) -> anyhow::Result<Structure> {
        let Some(path) = &self.file else {
            return Ok(Built::new(scene, self.quality, progress)?.convert(self.kind)?.0);
        };
        let _part = Part::endless(progress, &format!("loading {}", path.display()));
        let structure = tree_file::load(path)?;
        structure.check_over(&scene.mesh).with_context(|| {
            format!("{}: not a tree over {}; save one of this scene", path.display(), scene.name)
        })?;
        Ok(structure)
    }

    /// The preset that the structure is built with; `None` for a structure from a file.
    pub fn quality_name(&self) -> Option<&'static str> {
        self.file.is_none().then(|| quality_name(self.quality))
    }
}

/// Milliseconds since `start`.
pub fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

/// Camera and light of a view. The scene's own value replaces each that is absent.
#[derive(Clone, Copy, Debug, Default)]
pub struct View {
    /// Position of the camera.
    pub eye: Option<[f32; 3]>,
    /// Point in the centre of the image.
    pub target: Option<[f32; 3]>,
    /// Direction that appears upwards.
    pub up: Option<[f32; 3]>,
    /// Vertical field of view in degrees.
    pub fov_y_degrees: Option<f32>,
    /// Position of the point light, whose brightness is then adapted to its distance from the target.
    pub light: Option<[f32; 3]>,
}

impl View {
    /// Changes camera and light of `scene`.
    ///
    /// # Errors
    /// The light is at the target.
    pub fn apply(&self, scene: &mut Scene) -> anyhow::Result<()> {
        let camera = &mut scene.camera;
        camera.eye = self.eye.unwrap_or(camera.eye);
        camera.target = self.target.unwrap_or(camera.target);
        camera.up = self.up.unwrap_or(camera.up);
        camera.fov_y_degrees = self.fov_y_degrees.unwrap_or(camera.fov_y_degrees);
        if let Some(light) = self.light {
            let squared: f64 =
                light.iter().zip(camera.target).map(|(a, b)| (f64::from(*a) - f64::from(b)).powi(2)).sum();
            ensure!(squared > 0.0, "--light {light:?} is at the target: move one of them");
            scene.light =
                scenes::PointLight { position: light, intensity: [IRRADIANCE_AT_TARGET * squared; 3] };
        }
        Ok(())
    }
}

/// `path` as result files name it, with characters that are not Unicode replaced.
pub fn display(path: &Path) -> String {
    path.display().to_string()
}

/// `paths` as result files name them.
pub fn display_all<P: AsRef<Path>>(paths: impl IntoIterator<Item = P>) -> Vec<String> {
    paths.into_iter().map(|path| display(path.as_ref())).collect()
}

/// Checks before the work that all `outputs` that are given can be written after it, each named by its option, and announces them:
/// none may be another output, nor a file that is read (see [`guard`]).
///
/// # Errors
/// The message names the option.
pub fn check_outputs(outputs: &[(&str, Option<&Path>)], force: bool) -> anyhow::Result<()> {
    for (option, path) in outputs.iter().filter_map(|(option, path)| path.map(|path| (*option, path))) {
        check_writable(option, path, force)?;
        if !is_special(path) {
            guard::will_write(option, path).with_context(|| format!("{option} {}", path.display()))?;
        }
    }
    Ok(())
}

/// Checks before the work that `path` can be written after it: that its folder exists and takes files, and that it names no file to
/// be kept.
///
/// # Errors
/// The path cannot be written. The message begins with `option`, which the path was given for.
fn check_writable(option: &str, path: &Path, force: bool) -> anyhow::Result<()> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
        bail!(
            "{option} {}: there is no folder {}; make it, or name another",
            path.display(),
            folder.display()
        );
    }
    if path.is_dir() {
        bail!("{option} {}: this is a folder; name a file", path.display());
    }
    if is_stdout(path) {
        bail!("{option} {}: standard output gets what the command prints; name a file", path.display());
    }
    if is_special(path) {
        return Ok(());
    }
    if !force && path.exists() {
        return Err(WriteError::Exists(path.to_owned())).context(option.to_owned());
    }
    // Links are followed to the folder into which they lead.
    let target = target(path).with_context(|| format!("{option} {}", path.display()))?;
    try_folder(target.parent().unwrap_or(Path::new("."))).context(option.to_owned())
}

/// Finds out before the work whether files can be made in `folder`, by making one without a name.
///
/// # Errors
/// [`WriteError::Io`], which names the folder.
pub(crate) fn try_folder(folder: &Path) -> Result<(), WriteError> {
    let failed = |source| WriteError::Io { path: folder.to_owned(), source };
    tempfile::tempfile_in(folder).map(drop).map_err(failed)
}

/// Whether `path` leads to standard output, where what is written would be mixed with, or replaced by, what is printed. A terminal
/// and the null device take both.
#[cfg(unix)]
fn is_stdout(path: &Path) -> bool {
    use std::os::fd::AsFd;
    use std::os::unix::fs::{FileTypeExt, MetadataExt};
    let Ok(stdout) = std::io::stdout().as_fd().try_clone_to_owned() else { return false };
    let (Ok(stdout), Ok(file)) = (std::fs::File::from(stdout).metadata(), path.metadata()) else {
        return false;
    };
    !file.file_type().is_char_device() && (stdout.dev(), stdout.ino()) == (file.dev(), file.ino())
}

/// Such paths are known of Unix only.
#[cfg(not(unix))]
fn is_stdout(_path: &Path) -> bool {
    false
}
