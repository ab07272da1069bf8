//! Sends one ray through the dual-split pipeline, node by node, and prints what every stage holds:
//! `cargo run -p dualsplit-pipelines --example trace_ray`.

use equivalence::Ports;
use equivalence::cases::visited_nodes;
use golden::build::{BuildOptions, build};
use golden::dst::Dst;
use golden::structure::pack_triangles;
use golden::{Mode, Ray, TraversalRay};
use netlist::{Evaluator, Flat, flatten};
use pipelines::catalogue::{StandardFormat, Top};
use pipelines::words::{node_type, return_value};

/// Instance and signal at the end of each stage, and what it holds.
const STAGES: [(u32, &str, &str, &str); 8] = [
    (1, "select", "plane_0", "plane 0"),
    (1, "select", "plane_1", "plane 1"),
    (3, "subtract$0", "result", "plane 0 - origin"),
    (3, "subtract$1", "result", "plane 1 - origin"),
    (5, "multiply$0", "result", "distance of plane 0"),
    (5, "multiply$1", "result", "distance of plane 1"),
    (7, "fold.fold_entry", "result", "latest entry"),
    (7, "fold.fold_exit", "result", "earliest exit"),
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = scenes::procedural::build("statue", 1e-4, 0)?;
    let tree = build(&scene.mesh, &BuildOptions::default())?;
    let dst = Dst::convert(&tree, pack_triangles(&scene.mesh, &tree))?;
    let (eye, target) = (scene.camera.eye, scene.camera.target);
    let ray = Ray::new(eye, std::array::from_fn(|axis| target[axis] - eye[axis]));
    let ray = TraversalRay::new(&ray, Mode::Robust).ok_or("the camera looks nowhere")?;

    let netlist = flatten(&Top::DualSplit.design(StandardFormat::Binary32)?)?;
    let ports = Ports::new(&netlist);
    let mut pipeline = Evaluator::new(&netlist);
    for (position, case) in visited_nodes(&dst, [&ray]).iter().enumerate() {
        println!("node {position}: {} {:08x}", node_type(case.words[0].into()), case.words[0]);
        let mut inputs = vec![0; netlist.inputs.len()];
        ports.node().drive(&mut inputs, case);
        (inputs[ports.input("en_i")], inputs[ports.input("valid_i")]) = (1, 1);
        for cycle in 0..=8 {
            inputs.iter().enumerate().for_each(|(input, &value)| pipeline.set_input(input, value));
            pipeline.settle();
            for (_, instance, signal, meaning) in STAGES.iter().filter(|stage| stage.0 == cycle) {
                let value = f32::from_bits(value(&netlist, &pipeline, instance, signal) as u32);
                println!("  after cycle {cycle}: {meaning:<20} {value}");
            }
            if cycle == 8 {
                println!("  after cycle 8: {}", return_value(pipeline.output(ports.output("code_o"))));
            }
            pipeline.clock();
        }
    }
    Ok(())
}

/// The present value of a named signal of the instance with this path.
fn value(netlist: &Flat, simulation: &Evaluator, instance: &str, signal: &str) -> u128 {
    let named = netlist
        .names
        .iter()
        .find(|named| netlist.scopes[named.scope as usize].path == instance && named.name == signal);
    simulation.value(named.unwrap_or_else(|| panic!("no signal {instance}.{signal}")).node)
}
