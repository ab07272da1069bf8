//! `dualsplit wave`: what a unit does with a scene's rays, as a waveform.

use crate::cli::{Global, SceneArgs, WaveArgs};
use crate::console::Report;
use crate::input::{self, Built, check_writable};
use anyhow::bail;
use base::output::write_file;
use golden::{Ray, TraversalRay};
use netlist::flatten;
use pipelines::catalogue::StandardFormat;
use scenes::Scene;
use serde::Serialize;
use std::path::PathBuf;
use studies::drive::{self, Traversals};

#[derive(Serialize)]
struct Document {
    unit: &'static str,
    scene: String,
    rays: usize,
    operations: usize,
    cycles: usize,
    path: PathBuf,
}

pub fn run(args: &WaveArgs, global: &Global) -> anyhow::Result<Report> {
    check_writable("--out", &args.out, global.force)?;
    let scene = input::scene(&SceneArgs { scene: args.scene.clone(), detail: args.detail }, global)?;
    let built = Built::new(&scene, args.quality.quality)?;
    let rays: Vec<TraversalRay> = camera_rays(&scene, args.rays)
        .iter()
        .filter_map(|ray| TraversalRay::new(ray, args.mode.mode))
        .collect();
    if rays.is_empty() {
        bail!("{}: no ray of the camera has a direction", scene.name);
    }
    let netlist = flatten(&args.unit.design(StandardFormat::Binary32)?)?;
    let traversals = Traversals { tree: &built.tree, triangles: &built.triangles, rays: &rays };
    let (cycles, operations) = drive::cycles(args.unit, &netlist, &traversals)?;
    let document = Document {
        unit: args.unit.name(),
        scene: scene.name,
        rays: rays.len(),
        operations,
        cycles: cycles.len(),
        path: args.out.clone(),
    };
    write_file(&args.out, global.force, |out| {
        netlist::wave::write(&netlist, cycles, pipelines::words::decoder, out)
    })?;
    let text = format!(
        "{}: {} operations of {} rays in {} cycles",
        document.path.display(),
        document.operations,
        document.rays,
        document.cycles
    );
    Ok(Report::new(&document, text))
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
