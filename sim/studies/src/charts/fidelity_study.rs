//! The study of fidelity: the host's time against the error of the simulation.

use super::csv;
use super::fidelity::{FidelityPoint, charts, points, runs};
use crate::artifacts::Artifacts;
use crate::fidelity::Subject;
use crate::input::{Built, SceneSource, display};
use crate::progress::{Part, Progress};
use estimate::Method;
use golden::build::Quality;
use machine::description::MachineDescription;
use machine::frame::{FrameMachine, MachineStructure};
use render::{RenderOptions, Test};
use serde::Serialize;
use std::path::PathBuf;

/// The scene, the machine, the samples, and the folder of the results.
#[derive(Clone, Debug)]
pub struct Options {
    /// The scene, whose seed is also that of the samples.
    pub scene: SceneSource,
    /// The structure, with its program and its pipeline.
    pub structure: MachineStructure,
    /// The test: primary and shadow rays, or paths.
    pub test: Test,
    /// How the tree is built.
    pub quality: Quality,
    /// Width and height of the image in pixels.
    pub size: [u32; 2],
    /// Samples of each size.
    pub repeats: u32,
    /// Also simulates frames in which the netlist executes every pipeline operation.
    pub rtl: bool,
    /// A preset machine or a TOML file.
    pub machine: PathBuf,
    /// Changed keys of the machine.
    pub settings: Vec<String>,
    /// The folder that is written; if absent, `fidelity-` and the scene's name.
    pub out: Option<PathBuf>,
    /// Writes into the folder even if it holds files that the tool did not make.
    pub force: bool,
}

/// All levels and samples of one frame.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct FidelityChart {
    pub scene: String,
    pub triangles: usize,
    pub structure: &'static str,
    pub test: &'static str,
    pub machine: String,
    pub threads: u32,
    pub width: u32,
    pub height: u32,
    pub batches: u32,
    pub points: Vec<FidelityPoint>,
    /// The folder that was written.
    #[serde(skip)]
    pub folder: PathBuf,
    #[serde(skip)]
    pub artifacts: Vec<String>,
}

/// Simulates the frame at every level and on samples, and writes a table and charts to a folder.
///
/// # Errors
/// The scene or the machine cannot be loaded, a simulation fails, or a file cannot be written.
pub fn run(args: &Options, progress: &dyn Progress) -> anyhow::Result<FidelityChart> {
    let scene = args.scene.load(progress)?;
    let folder = args.out.clone().unwrap_or_else(|| format!("fidelity-{}", scene.name).into());
    let machine = MachineDescription::load(&args.machine, &args.settings)?;
    let set_up = FrameMachine::new(&machine, args.structure, estimate::by_name(Method::Published))?;
    let mut artifacts = Artifacts::create(&folder, args.force)?;
    let (structure, _) = Built::new(&scene, args.quality, progress)?.convert(args.structure.kind())?;
    let [width, height] = args.size;
    let options = RenderOptions { seed: args.scene.seed, ..RenderOptions::new(args.test, width, height) };
    let subject = Subject { machine: &set_up, scene: &scene, structure: &structure, options: &options };
    let part = Part::begin(progress, runs(&subject, args.rtl, args.repeats), "levels and samples");
    let points = points(&subject, args.rtl, args.repeats, args.scene.seed, || part.advance(1))?;
    drop(part);
    artifacts.write("fidelity.csv", &csv(&points)?)?;
    for (name, chart) in charts(&scene.name, &points) {
        artifacts.write(&format!("{name}.svg"), chart.svg().as_bytes())?;
    }
    Ok(FidelityChart {
        scene: scene.name.clone(),
        triangles: scene.mesh.triangles.len(),
        structure: args.structure.name(),
        test: args.test.name(),
        machine: machine.name.clone(),
        threads: subject.threads(),
        width,
        height,
        batches: subject.batches(1.0).count,
        points,
        folder,
        artifacts: artifacts.finish()?.iter().map(|path| display(path)).collect(),
    })
}
