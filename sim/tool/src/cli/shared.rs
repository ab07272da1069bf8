//! Arguments that all or several commands have: a scene, a view, a structure, a machine.

use super::values::{
    PipelineCostMethod, mode, pipeline_cost, quality, scene_format, size, structure, vector,
};
use anyhow::ensure;
use clap::Args;
use golden::Mode;
use golden::build::Quality;
use golden::structure::StructureKind;
use scenes::Format;
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;
use studies::input::{SceneSource, StructureSource, View};

/// The heading of [`Global`] in help texts.
const OF_ALL: &str = "Options of all commands";

#[derive(Args, Clone, Debug)]
pub struct Global {
    /// Print one JSON document instead of tables.
    #[arg(long, global = true, help_heading = OF_ALL)]
    pub json: bool,
    /// Print neither progress nor notes, only results and errors.
    #[arg(long, short, global = true, help_heading = OF_ALL)]
    pub quiet: bool,
    /// Seed of the built-in scenes, of the renderer's samples and of the checks' stimulus [default: 0].
    #[arg(long, global = true, value_name = "N", help_heading = OF_ALL)]
    pub seed: Option<u64>,
    /// Number of threads; results do not depend on it [default: all processors].
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), help_heading = OF_ALL)]
    pub threads: Option<u16>,
    /// Replace files that exist.
    #[arg(long, global = true, help_heading = OF_ALL)]
    pub force: bool,
    /// The words of the command line, for the record.
    #[arg(skip)]
    pub words: Vec<OsString>,
}

impl Global {
    /// The seed.
    pub fn seed(&self) -> u64 {
        self.seed.unwrap_or(0)
    }

    /// Checks that no seed is given to `what`.
    ///
    /// # Errors
    /// One is.
    pub fn without_seed(&self, what: &str) -> anyhow::Result<()> {
        ensure!(self.seed.is_none(), "--seed: {what} draws nothing at random; leave it away");
        Ok(())
    }
}

/// What a command draws at random, by the seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drawn {
    /// Built-in scenes alone.
    Scenes,
    /// Samples or a choice of rays as well.
    Samples,
}

/// The scene.
#[derive(Args, Clone, Debug)]
pub struct SceneArgs {
    /// A built-in scene (see `dualsplit scenes`), a file (OBJ, PLY, STL or glTF, which xz or gzip may compress), or - for
    /// standard input.
    pub scene: OsString,
    #[command(flatten)]
    pub load: LoadArgs,
}

impl SceneArgs {
    /// The scene.
    ///
    /// # Errors
    /// An option that does not apply to it.
    pub fn source(&self, drawn: Drawn, global: &Global) -> anyhow::Result<SceneSource> {
        self.load.source(&self.scene, drawn, global)
    }
}

/// How a scene is loaded.
#[derive(Args, Clone, Copy, Debug)]
pub struct LoadArgs {
    #[command(flatten)]
    pub detail: DetailArgs,
    /// Format of a scene's file [default: as its content and name say].
    #[arg(long, value_name = "FORMAT", value_parser = scene_format())]
    pub format: Option<Format>,
}

impl LoadArgs {
    /// The scene `name`, loaded like this.
    ///
    /// # Errors
    /// Those of [`LoadArgs::sources`].
    pub fn source(self, name: &OsStr, drawn: Drawn, global: &Global) -> anyhow::Result<SceneSource> {
        Ok(self.sources(&[name], drawn, global)?.remove(0))
    }

    /// The scenes `names`, loaded like this.
    ///
    /// # Errors
    /// An option that applies to none of them.
    pub fn sources(
        self,
        names: &[impl AsRef<OsStr>],
        drawn: Drawn,
        global: &Global,
    ) -> anyhow::Result<Vec<SceneSource>> {
        let source = |name: &OsStr| SceneSource {
            name: name.to_owned(),
            format: self.format,
            detail: self.detail.value(),
            seed: global.seed(),
        };
        let sources: Vec<SceneSource> = names.iter().map(|name| source(name.as_ref())).collect();
        let files = sources.iter().filter(|source| source.path().is_some()).count();
        ensure!(
            self.detail.detail.is_none() || files < sources.len(),
            "--detail scales built-in scenes, and a file is taken as it is; leave it away"
        );
        ensure!(
            self.format.is_none() || files > 0,
            "--format is that of a file, and a built-in scene has none; leave it away"
        );
        if drawn == Drawn::Scenes && files == sources.len() {
            global.without_seed("the command, with a scene from a file,")?;
        }
        Ok(sources)
    }
}

#[derive(Args, Clone, Copy, Debug)]
pub struct DetailArgs {
    /// Fraction of a built-in scene's full number of triangles, above 0 and at most 1 [default: 0.1].
    #[arg(long, value_name = "FRACTION")]
    pub detail: Option<f64>,
}

impl DetailArgs {
    /// The fraction.
    pub fn value(self) -> f64 {
        self.detail.unwrap_or(0.1)
    }
}

#[derive(Args, Clone, Copy, Debug)]
pub struct QualityArgs {
    /// Build time against tree quality: fast, medium or high.
    #[arg(long, default_value = "high", value_name = "PRESET", value_parser = quality(), hide_possible_values = true)]
    pub quality: Quality,
}

#[derive(Args, Clone, Copy, Debug)]
pub struct ModeArgs {
    /// Rounding of plane distances: robust never loses a hit of the triangle test, fast may at the edges of boxes.
    #[arg(long, default_value = "robust", value_parser = mode())]
    pub mode: Mode,
}

/// Where from and under which light; by default the scene's own, for a file its view file or a view of all of it.
#[derive(Args, Clone, Debug)]
pub struct ViewArgs {
    /// Position of the camera.
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub eye: Option<[f32; 3]>,
    /// Point in the centre of the image.
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub target: Option<[f32; 3]>,
    /// Direction that appears upwards.
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub up: Option<[f32; 3]>,
    /// Vertical field of view in degrees.
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true)]
    pub fov: Option<f32>,
    /// Position of the point light, whose brightness is then adapted to its distance from the target.
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub light: Option<[f32; 3]>,
    /// Width and height of the image in pixels.
    #[arg(long, default_value = "512x512", value_name = "WxH", value_parser = size)]
    pub size: [u32; 2],
}

impl ViewArgs {
    pub fn view(&self) -> View {
        let Self { eye, target, up, fov, light, size: _ } = *self;
        View { eye, target, up, fov_y_degrees: fov, light }
    }
}

/// The structure that rays are traced through: built, or loaded from a file.
#[derive(Args, Clone, Debug)]
pub struct StructureArgs {
    /// The structure that rays are traced through; all give the same hits.
    #[arg(long, default_value = "dst", value_parser = structure())]
    pub structure: StructureKind,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// Load the structure from this file instead of building it; `dualsplit tree SCENE --save FILE` writes such files.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["structure", "quality"])]
    pub tree: Option<PathBuf>,
}

impl StructureArgs {
    pub fn source(&self) -> StructureSource {
        StructureSource { kind: self.structure, quality: self.quality.quality, file: self.tree.clone() }
    }
}

/// The machine that is simulated if none is named.
pub const DEFAULT_MACHINE: &str = "trax";

#[derive(Args, Debug)]
pub struct MachineArgs {
    /// The machine: a preset (trax or simtrax-reference) or a TOML file.
    #[arg(long, default_value = DEFAULT_MACHINE, value_name = "MACHINE")]
    pub machine: PathBuf,
    /// Change a key of the machine, such as l1.size=64KiB; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub settings: Vec<String>,
}

/// Where area and energy of the pipelines come from.
#[derive(Args, Debug)]
pub struct CostArgs {
    /// Source of the pipelines' area and energy: published unit costs with our unit counts and glue; our netlist in the embedded
    /// library (130 nm); or that netlist scaled to 65 nm.
    #[arg(long, default_value = "published", value_name = "METHOD", value_parser = pipeline_cost())]
    pub pipeline_cost: PipelineCostMethod,
}
