//! Wrong programs and wrong operations are noticed.

use super::*;
use crate::description::{Bytes, MachineDescription, NodeLayout};
use costs::{Pipeline, PipelineCost, Unit};
use fp::Format;
use golden::Aabb;
use golden::build::{BinaryTree, BuildOptions, Quality, build};
use golden::bvh::BoxStep;
use golden::dst::Step;
use golden::precision::Precision;
use golden::ray::PlaneRay;
use golden::structure::{StructureKind, pack_triangles};
use golden::triangle::TriangleHit;
use render::Test;
use std::sync::LazyLock;

static PREPARED: LazyLock<(Scene, BinaryTree)> = LazyLock::new(|| {
    let scene = scenes::procedural::build("courtyard", 0.001, 0).unwrap();
    let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
    (scene, tree)
});

fn options() -> RenderOptions {
    RenderOptions::new(Test::Path, 8, 6)
}

fn structure(of: MachineStructure) -> Structure {
    let (scene, tree) = &*PREPARED;
    Structure::convert(of.kind(), tree, &pack_triangles(&scene.mesh, tree)).unwrap()
}

fn machine(of: MachineStructure) -> FrameMachine {
    let cost = PipelineCost {
        area_um2: 1.0,
        energy_pj: 1.0,
        glue_area_um2: 0.0,
        glue_energy_pj: 0.0,
        source: String::new(),
    };
    let pipeline = |name: &str| Pipeline {
        name: name.to_owned(),
        units: [(Unit::FpAdd, 1)].into(),
        latency_cycles: 8,
        cost: cost.clone(),
    };
    let trax = MachineDescription::load("trax", &[]).unwrap();
    FrameMachine::new(&trax, of, pipeline).unwrap()
}

/// The program for packed nodes.
fn listing(of: MachineStructure) -> &'static str {
    of.listing(NodeLayout::default())
}

/// Golden's operations, for the frame of these tests.
fn operations<'a>() -> Operations<'a> {
    Operations {
        seed: 0,
        narrow: None,
        checker: None,
        checked: AtomicU64::new(0),
        differences: AtomicU64::new(0),
    }
}

/// Executes all pixels by the program in `listing` and `special`; the counts of all runs.
fn execute<S: Special>(
    machine: &FrameMachine,
    structure: &Structure,
    listing: &str,
    special: S,
) -> Result<(Arc<Program>, Vec<u64>), FrameError> {
    let program = Program::new("test", listing, &machine.description, 8)?;
    let (scene, _) = &*PREPARED;
    let traced = Traced::Wide(structure);
    let mut work = FrameWork::with_operations(machine, program, scene, traced, &options(), special)?;
    let mut counts = vec![0; work.program.code.runs.len()];
    let mut words = vec![];
    work.start(&mut Tape::new(&mut words, &mut counts)).map_err(SimulationError::from)?;
    let (first, later) = work.entries().expect("it takes items");
    for item in 0..=work.items() {
        words.clear();
        let entry = if item == 0 { first } else { later };
        let mut tape = Tape::new(&mut words, &mut counts);
        work.record(item, entry, &mut tape).map_err(SimulationError::from)?;
    }
    work.executor.check().map_err(SimulationError::from)?;
    Ok((Arc::clone(&work.program), counts))
}

/// Lines of `program` that were executed, from 1.
fn executed_lines(program: &Program, counts: &[u64]) -> Vec<usize> {
    let mut lines: Vec<usize> = vec![];
    for (route, count) in program.graph.routes.iter().zip(counts) {
        if *count > 0 {
            lines.extend(route.instructions.iter().map(|at| program.lines[*at] as usize));
        }
    }
    lines.sort_unstable();
    lines.dedup();
    lines
}

/// The line with one mistake in it, if it is of a kind that mistakes are made in here.
fn mistaken(line: &str) -> Option<String> {
    let (mnemonic, operands) = line.trim().split_once(' ')?;
    let other = match mnemonic {
        "add.s" => "sub.s",
        "sub.s" | "mul.s" => "add.s",
        "FPMIN" => "FPMAX",
        "FPMAX" => "FPMIN",
        "addu" => "subu",
        "bc1t" => "bc1f",
        "bc1f" => "bc1t",
        "beqz" => "bnez",
        "bnez" => "beqz",
        "bltz" => "bgez",
        "LOAD" | "STORE" => {
            let (registers, offset) = operands.rsplit_once(", ")?;
            let offset: u32 = offset.parse().ok()?;
            return Some(format!("{mnemonic} {registers}, {}", offset + 1));
        }
        _ => return None,
    };
    Some(format!("{other} {operands}"))
}

/// Whether a mistake in this line can leave the picture as it is: what is exact in the end does not depend on how tight a bound is.
fn only_bounds(line: &str) -> bool {
    ["FPMIN", "FPMAX"].iter().any(|mnemonic| line.trim().starts_with(mnemonic))
}

#[test]
fn a_mistake_in_an_instruction_is_noticed() {
    let of = MachineStructure::Dst;
    let (machine, structure) = (machine(of), structure(of));
    let (program, counts) = execute(&machine, &structure, listing(of), operations()).unwrap();
    let lines: Vec<&str> = listing(of).lines().collect();
    let (mut made, mut survivors) = (0, vec![]);
    for line in executed_lines(&program, &counts).into_iter().step_by(testing::cases(1, 4) as usize) {
        let Some(wrong) = mistaken(lines[line - 1]).filter(|_| !only_bounds(lines[line - 1])) else {
            continue;
        };
        made += 1;
        let mut text = lines.clone();
        text[line - 1] = &wrong;
        if execute(&machine, &structure, &text.join("\n"), operations()).is_ok() {
            survivors.push(format!("{line}: {} -> {wrong}", lines[line - 1].trim()));
        }
    }
    println!("{made} mistakes, {} of them not noticed:\n{}", survivors.len(), survivors.join("\n"));
    // Not noticed: the root's box is not tight here, a row is never corrected, and a rare branch computes what the common one does.
    assert!(survivors.len() * 14 <= made, "{made}");
    let decides = |survivor: &String| {
        let instruction = survivor.split(": ").nth(1).expect("the line and its instruction");
        ["STORE", "bnez", "bltz"].iter().any(|mnemonic| instruction.starts_with(mnemonic))
    };
    assert!(!survivors.iter().any(decides), "{survivors:?}");
}

#[test]
fn a_branch_to_another_place_is_noticed() {
    let of = MachineStructure::Bvh4;
    let (machine, structure) = (machine(of), structure(of));
    let (program, counts) = execute(&machine, &structure, listing(of), operations()).unwrap();
    let lines: Vec<&str> = listing(of).lines().collect();
    let labels: Vec<&str> = lines.iter().filter_map(|line| line.strip_suffix(':')).collect();
    let (mut made, mut noticed) = (0, 0);
    for line in executed_lines(&program, &counts).into_iter().step_by(testing::cases(1, 5) as usize) {
        let Some((branch, label)) =
            lines[line - 1].rsplit_once(' ').filter(|(_, label)| label.starts_with("$BB"))
        else {
            continue;
        };
        let next = labels.iter().position(|known| *known == label).unwrap() + 1;
        let wrong = format!("{branch} {}", labels.get(next).unwrap_or(&labels[0]));
        let mut text = lines.clone();
        text[line - 1] = &wrong;
        made += 1;
        noticed += u32::from(execute(&machine, &structure, &text.join("\n"), operations()).is_err());
    }
    println!("{noticed} of {made} wrong branches noticed");
    // The others are not taken here, or lead to the same place by another way.
    assert!(noticed * 10 >= made * 7, "{noticed} of {made}");
}

/// Golden's operations but for one.
struct Corrupted {
    operations: Operations<'static>,
    which: usize,
}

/// Names of the operations that can be corrupted.
const CORRUPTED: [&str; 9] =
    ["RAND", "FPMIN", "FPMAX", "FPINVSQRT", "SIN", "COS", "DSTSTEP", "BOXTEST", "EXACT"];

impl Corrupted {
    fn float(&self, which: usize, value: f32) -> f32 {
        if self.which == which { f32::from_bits(value.to_bits() ^ 1 << 12) } else { value }
    }
}

impl Special for Corrupted {
    fn random(&self, item: u32, dimension: u32) -> f32 {
        self.float(0, self.operations.random(item, dimension))
    }

    fn minimum(&self, a: f32, b: f32) -> f32 {
        self.float(1, self.operations.minimum(a, b))
    }

    fn maximum(&self, a: f32, b: f32) -> f32 {
        self.float(2, self.operations.maximum(a, b))
    }

    fn inverse_square_root(&self, a: f32) -> f32 {
        self.float(3, self.operations.inverse_square_root(a))
    }

    fn sine(&self, a: f32) -> f32 {
        self.float(4, self.operations.sine(a))
    }

    fn cosine(&self, a: f32) -> f32 {
        self.float(5, self.operations.cosine(a))
    }

    fn step(&self, words: [u32; 3], ray: &PlaneRay, interval: [f32; 2]) -> Step {
        let mut step = self.operations.step(words, ray, interval);
        if self.which == 6 {
            step.near.t_max *= 0.5;
        }
        step
    }

    fn box_test(&self, bounds: &Aabb, ray: &PlaneRay, t_max: f32) -> BoxStep {
        let test = self.operations.box_test(bounds, ray, t_max);
        BoxStep { hit: test.hit && self.which != 7, ..test }
    }

    fn exact(&self, origin: [f32; 3], direction: [f32; 3], corners: &[[f32; 3]; 3]) -> Option<TriangleHit> {
        let hit = self.operations.exact(origin, direction, corners);
        if self.which == 8 { None } else { hit }
    }
}

#[test]
fn a_wrong_operation_changes_the_picture() {
    for (which, name) in CORRUPTED.iter().enumerate().filter(|(_, name)| **name != "EXACT") {
        let of = if *name == "BOXTEST" { MachineStructure::Bvh4Plus } else { MachineStructure::Dst };
        let special = Corrupted { operations: operations(), which };
        let outcome = execute(&machine(of), &structure(of), listing(of), special);
        let error = outcome.err().unwrap_or_else(|| panic!("{name} is wrong, and the picture is right"));
        assert!(matches!(error, FrameError::Simulation(SimulationError::Fault(_))), "{name}: {error}");
    }
}

#[test]
fn a_wrong_exact_decision_changes_the_picture() {
    // So near that no test is decided in single precision.
    let mut scene = PREPARED.0.clone();
    let scale = 2f32.powi(-50);
    let scaled = |point: &mut [f32; 3]| point.iter_mut().for_each(|x| *x *= scale);
    scene.mesh.positions.iter_mut().for_each(scaled);
    [&mut scene.camera.eye, &mut scene.camera.target, &mut scene.light.position].into_iter().for_each(scaled);
    scene.light.intensity = scene.light.intensity.map(|x| x * f64::from(scale).powi(2));
    let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
    let structure =
        Structure::convert(MachineStructure::Dst.kind(), &tree, &pack_triangles(&scene.mesh, &tree)).unwrap();
    let machine = machine(MachineStructure::Dst);
    let run = |which| {
        let special = Corrupted { operations: operations(), which };
        let program = machine.program().unwrap();
        let traced = Traced::Wide(&structure);
        let work = FrameWork::with_operations(&machine, program, &scene, traced, &options(), special)?;
        let (_, later) = work.entries().expect("it takes items");
        for item in 0..work.items() {
            let mut counts = vec![0; work.program.code.runs.len()];
            let mut words = vec![];
            let mut tape = Tape::new(&mut words, &mut counts);
            work.record(item, later, &mut tape).map_err(SimulationError::from)?;
        }
        let totals = work.done.into_inner().unwrap().totals;
        Ok::<_, FrameError>((totals.exact_tests, totals.triangle_tests))
    };
    let (exact, all) = run(CORRUPTED.len()).unwrap();
    assert_eq!(exact, all);
    assert!(run(8).is_err());
}

/// Scaled by a power of two at which squares of lengths leave binary32, all programs give the same picture.
#[test]
fn the_picture_does_not_depend_on_the_unit_of_length() {
    let picture = |of: MachineStructure, exponent: i32| {
        let mut scene = PREPARED.0.clone();
        let scale = 2f32.powi(exponent);
        let scaled = |point: &mut [f32; 3]| point.iter_mut().for_each(|x| *x *= scale);
        scene.mesh.positions.iter_mut().for_each(scaled);
        let (camera, light) = (&mut scene.camera, &mut scene.light);
        [&mut camera.eye, &mut camera.target, &mut light.position].into_iter().for_each(scaled);
        light.intensity = light.intensity.map(|x| x * f64::from(scale).powi(2));
        let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
        let structure = Structure::convert(of.kind(), &tree, &pack_triangles(&scene.mesh, &tree)).unwrap();
        let frame = frame(&machine(of), &scene, &structure, &options(), |_| ()).unwrap();
        frame.pixels.iter().map(|pixel| pixel.rgb.map(f32::to_bits)).collect::<Vec<_>>()
    };
    let first = picture(MachineStructure::Dst, 0);
    for of in MachineStructure::ALL {
        for exponent in [66, -70] {
            assert!(picture(of, exponent) == first, "{of}, 2^{exponent}");
        }
    }
}

#[test]
fn a_conservative_narrow_pipeline_gives_goldens_picture() {
    let machine = machine(MachineStructure::Dst);
    let Structure::Dst(dst) = structure(MachineStructure::Dst) else {
        unreachable!("what the machine is set up for")
    };
    for format in [Format::BINARY16, Format::BFLOAT16, Format::E5M2] {
        let narrow = NarrowDst::new(&dst, Precision::new(format, Variant::Conservative));
        let frame = narrow_frame(&machine, &PREPARED.0, &narrow, &options(), |_| ());
        assert!(frame.is_ok(), "{format}: {}", frame.err().unwrap());
    }
}

#[test]
fn the_message_names_the_first_pixel_that_differs() {
    let of = MachineStructure::Dst;
    let wrong = listing(of).replace("0x3f333333", "0x3f333334");
    let error = execute(&machine(of), &structure(of), &wrong, operations()).err().unwrap().to_string();
    assert!(error.contains("is not golden's: red is ") && error.contains("in item "), "{error}");
}

#[test]
fn the_picture_is_goldens_wherever_nodes_lie() {
    for of in MachineStructure::ALL {
        let (mut machine, structure) = (machine(of), structure(of));
        let packed = node_bytes(&structure, machine.description.layout).unwrap();
        assert_eq!(packed.0 as usize, structure.node_bytes());
        for bytes in [4, 32, 64, 256] {
            let layout = NodeLayout { alignment: Bytes(bytes) };
            machine.description.layout = layout;
            let padded = node_bytes(&structure, layout).unwrap();
            assert_eq!(padded > packed, bytes > 4, "{of}, {bytes} bytes: {padded:?}");
            execute(&machine, &structure, of.listing(layout), operations()).unwrap();
        }
        // The program for packed nodes looks for a box elsewhere.
        let other = execute(&machine, &structure, listing(of), operations());
        assert_eq!(other.is_err(), of.kind() != StructureKind::Dst, "{of}");
    }
}
