//! What the commands start from: scenes, trees, views, and names of files to write.

use crate::cli::{Global, SceneArgs, StructureArgs, ViewArgs, quality_name};
use crate::console;
use anyhow::{Context, bail, ensure};
use golden::build::{BinaryTree, BuildError, BuildOptions, Quality, build};
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::tree_file;
use golden::triangle::Triangle;
use scenes::Scene;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// Irradiance at the target of a light that was moved.
const IRRADIANCE_AT_TARGET: f64 = 4.0;

/// Loads or makes the scene that `args` names.
pub fn scene(args: &SceneArgs, global: &Global) -> anyhow::Result<Scene> {
    let progress = console::spinner(format!("loading {}", args.scene));
    let scene = Scene::load(&args.scene, args.detail.detail, global.seed)?;
    progress.finish_and_clear();
    Ok(scene)
}

/// A binary hierarchy and all that is converted from it.
pub struct Built {
    pub tree: BinaryTree,
    pub triangles: Arc<[Triangle]>,
    pub build_ms: f64,
}

impl Built {
    /// Builds the hierarchy over `scene`.
    pub fn new(scene: &Scene, quality: Quality) -> anyhow::Result<Self> {
        let progress = console::spinner(format!("building over {}", scene.name));
        let built = Self::with(scene, || build(&scene.mesh, &BuildOptions::new(quality)))?;
        progress.finish_and_clear();
        Ok(built)
    }

    /// Takes the hierarchy over `scene` that `build` makes.
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

    /// Converts the hierarchy, and says how many milliseconds that took.
    pub fn convert(&self, kind: StructureKind) -> anyhow::Result<(Structure, f64)> {
        let start = Instant::now();
        let structure = Structure::convert(kind, &self.tree, &self.triangles)?;
        Ok((structure, milliseconds(start)))
    }
}

/// The structure that rays are traced through, and the preset that it was built with; none is known of one from a file.
pub fn structure(scene: &Scene, args: &StructureArgs) -> anyhow::Result<(Structure, Option<&'static str>)> {
    let Some(path) = &args.tree else {
        let quality = args.quality.quality;
        let (structure, _) = Built::new(scene, quality)?.convert(args.structure)?;
        return Ok((structure, Some(quality_name(quality))));
    };
    let progress = console::spinner(format!("loading {}", path.display()));
    let structure = tree_file::load(path)?;
    structure.check_over(&scene.mesh).with_context(|| {
        format!("{}: not a tree over {}; save one of this scene", path.display(), scene.name)
    })?;
    progress.finish_and_clear();
    Ok((structure, None))
}

/// Milliseconds since `start`.
pub fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

/// Changes camera and light of `scene` as `args` say.
pub fn set_view(scene: &mut Scene, args: &ViewArgs) -> anyhow::Result<()> {
    let camera = &mut scene.camera;
    camera.eye = args.eye.unwrap_or(camera.eye);
    camera.target = args.target.unwrap_or(camera.target);
    camera.up = args.up.unwrap_or(camera.up);
    camera.fov_y_degrees = args.fov.unwrap_or(camera.fov_y_degrees);
    if let Some(light) = args.light {
        let squared: f64 =
            light.iter().zip(camera.target).map(|(a, b)| (f64::from(*a) - f64::from(b)).powi(2)).sum();
        ensure!(squared > 0.0, "--light {light:?} is at the target: move one of them");
        let intensity =
            (IRRADIANCE_AT_TARGET * squared).clamp(f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX));
        scene.light = scenes::PointLight { position: light, intensity: [intensity as f32; 3] };
    }
    Ok(())
}

/// `path` as result files name it; what is not Unicode in it is replaced.
pub fn display(path: &Path) -> String {
    path.display().to_string()
}

/// Refuses early what writing `path` would refuse after all the work: no folder, or a file that is to be kept.
pub fn check_writable(option: &str, path: &Path, force: bool) -> anyhow::Result<()> {
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
    if !force && path.symlink_metadata().is_ok() {
        return Err(base::output::WriteError::Exists(path.to_owned())).context(option.to_owned());
    }
    Ok(())
}
