//! `dualsplit wave`: what a pipeline does with a scene's rays, as a waveform.

use crate::cli::{Global, SceneArgs, WaveArgs};
use crate::console::Report;
use crate::input::{self, Built, check_writable};
use anyhow::{bail, ensure};
use golden::dst::Dst;
use golden::{Ray, TraversalRay};
use hdl::catalogue::{StandardFormat, Top};
use hdl::equivalence::Ports;
use hdl::equivalence::cases::{NodeCase, visited_nodes};
use hdl::netlist::{Flat, flatten};
use scenes::Scene;
use scenes::output::write_file;
use serde::Serialize;
use std::path::PathBuf;

/// Cycles after the last operation, until its result is out.
const DRAIN_CYCLES: usize = 10;

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
    ensure!(
        matches!(args.unit, Top::DualSplit | Top::DualSplitLean | Top::RayBox | Top::RayBoxLean),
        "--unit {}: rays go through dual_split, dual_split_lean, ray_box and ray_box_lean only",
        args.unit
    );
    check_writable("--out", &args.out, global.force)?;
    let scene = input::scene(&SceneArgs { scene: args.scene.clone(), detail: args.detail }, global)?;
    let built = Built::new(&scene, args.quality.quality)?;
    let dst = Dst::convert(&built.tree, built.triangles.clone())?;
    let rays: Vec<TraversalRay> = camera_rays(&scene, args.rays)
        .iter()
        .filter_map(|ray| TraversalRay::new(ray, args.mode.mode))
        .collect();
    if rays.is_empty() {
        bail!("{}: no ray of the camera has a direction", scene.name);
    }
    let netlist = flatten(&args.unit.design(StandardFormat::Binary32)?)?;
    let cycles = cycles(args.unit, &netlist, &dst, &rays);
    let document = Document {
        unit: args.unit.name(),
        scene: scene.name,
        rays: rays.len(),
        operations: cycles.len() - DRAIN_CYCLES,
        cycles: cycles.len(),
        path: args.out.clone(),
    };
    write_file(&args.out, global.force, |out| hdl::wave::write(&netlist, cycles, out))?;
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

/// The inputs of each cycle: every node that the rays visit, or its box test, one after the other.
fn cycles(unit: Top, netlist: &Flat, dst: &Dst, rays: &[TraversalRay]) -> Vec<Vec<u128>> {
    let ports = Ports::new(netlist);
    let mut idle = vec![0; netlist.inputs.len()];
    idle[ports.input("en_i")] = 1;
    let mut busy = idle.clone();
    busy[ports.input("valid_i")] = 1;
    let mut cycles = Vec::new();
    match unit {
        Top::DualSplit | Top::DualSplitLean => {
            let node = ports.node();
            cycles.extend(visited_nodes(dst, rays).iter().map(|case: &NodeCase| {
                let mut inputs = busy.clone();
                node.drive(&mut inputs, case);
                inputs
            }));
        }
        _ => {
            let bounds = ports.bounds(None);
            for ray in rays {
                let mut inputs = busy.clone();
                bounds.drive(&mut inputs, &hdl::equivalence::cases::BoxCase::new(&dst.root_box, ray));
                cycles.push(inputs);
            }
        }
    }
    cycles.extend(std::iter::repeat_n(idle, DRAIN_CYCLES));
    cycles
}
