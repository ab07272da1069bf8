//! The waveform of a unit that processes a scene's rays.

use crate::drive::{self, Traversals};
use crate::input::{Built, SceneSource, check_outputs, display};
use crate::progress::Progress;
use anyhow::{bail, ensure};
use base::output::write_file;
use golden::build::Quality;
use golden::{Mode, Ray, TraversalRay};
use netlist::flatten;
use pipelines::catalogue::{StandardFormat, Top};
use scenes::Scene;
use serde::Serialize;
use std::path::PathBuf;

/// The unit, the rays, and the file of the waveform.
#[derive(Clone, Debug)]
pub struct Options {
    /// The unit or pipeline. A single unit gets the inputs that it has inside the dual-split pipeline.
    pub unit: Top,
    /// The scene.
    pub scene: SceneSource,
    /// Number of rays, from the camera towards vertices spread over the mesh.
    pub rays: u32,
    /// How plane distances are rounded.
    pub mode: Mode,
    /// How the tree is built.
    pub quality: Quality,
    /// The VCD file that the waveform is written to.
    pub out: PathBuf,
    /// Replaces `out` if it exists.
    pub force: bool,
}

/// Facts about the waveform written.
#[derive(Debug, Serialize)]
#[allow(missing_docs, reason = "keys of result files")]
pub struct Wave {
    pub unit: &'static str,
    pub scene: String,
    pub rays: usize,
    pub operations: usize,
    pub cycles: usize,
    #[serde(skip)]
    pub path: String,
}

/// Writes the waveform.
///
/// # Errors
/// The scene cannot be loaded, no ray has a direction, or the file cannot be written.
pub fn run(args: &Options, progress: &dyn Progress) -> anyhow::Result<Wave> {
    let is_fst = args.out.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("fst"));
    ensure!(!is_fst, "--out {}: waveforms are VCD files; end the name in .vcd", args.out.display());
    check_outputs(&[("--out", Some(&args.out))], args.force)?;
    let scene = args.scene.load(progress)?;
    let built = Built::new(&scene, args.quality, progress)?;
    let rays: Vec<TraversalRay> =
        camera_rays(&scene, args.rays).iter().filter_map(|ray| TraversalRay::new(ray, args.mode)).collect();
    if rays.is_empty() {
        bail!("{}: no ray of the camera has a direction", scene.name);
    }
    let netlist = flatten(&args.unit.design(StandardFormat::Binary32)?)?;
    let traversals = Traversals { tree: &built.tree, triangles: &built.triangles, rays: &rays };
    let (cycles, operations) = drive::cycles(args.unit, &netlist, &traversals)?;
    let wave = Wave {
        unit: args.unit.name(),
        scene: scene.name,
        rays: rays.len(),
        operations,
        cycles: cycles.len(),
        path: display(&args.out),
    };
    write_file(&args.out, args.force, |out| {
        netlist::wave::write(&netlist, cycles, pipelines::words::decoder, out)
    })?;
    Ok(wave)
}

/// Rays towards vertices that are spread over the mesh.
fn camera_rays(scene: &Scene, count: u32) -> Vec<Ray> {
    let positions = &scene.mesh.positions;
    let eye = scene.camera.eye;
    let towards = |i: u32| {
        let target = positions[(i as usize * positions.len()) / count as usize];
        Ray::new(eye, std::array::from_fn(|axis| target[axis] - eye[axis]))
    };
    (0..count).map(towards).collect()
}
