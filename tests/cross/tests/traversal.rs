//! Traversals whose every node step is executed by the netlist of the dual-split pipeline.

use cross::{netlist, scene};
use equivalence::cases::{NodeCase, RayWords, visited_nodes};
use equivalence::{Model, Ports, Stimulus, compare};
use golden::dst::{Child, Code, Dst, Step};
use golden::traverse::{NoObserver, Trace, closest_by_steps};
use golden::{Mode, TraversalRay};
use netlist::{Evaluator, Flat, latency_cycles};
use pipelines::catalogue::{StandardFormat, Top};
use render::CameraRays;
use scenes::{Scene, procedural};

/// Fraction of a scene's triangles; the generators stop at some thousand.
const DETAIL: f64 = 1e-4;

/// The pipeline as a step function: a node goes in, and its result comes out after the latency.
struct Hardware<'n> {
    ports: Ports<'n>,
    netlist: &'n Flat,
    simulation: Evaluator<'n>,
    latency_cycles: u32,
}

impl<'n> Hardware<'n> {
    fn new(netlist: &'n Flat) -> Self {
        let latency_cycles = latency_cycles(netlist).expect("a plain pipeline");
        Self { ports: Ports::new(netlist), netlist, simulation: Evaluator::new(netlist), latency_cycles }
    }

    fn step(&mut self, words: [u32; 3], ray: &TraversalRay, t_min: f32, t_max: f32) -> Step {
        let mut inputs = vec![0; self.netlist.inputs.len()];
        inputs[self.ports.input("en_i")] = 1;
        inputs[self.ports.input("valid_i")] = 1;
        self.ports.node().drive(&mut inputs, &NodeCase { words, ray: RayWords::new(ray, t_min, t_max) });
        self.simulation.cycle(&inputs);
        inputs[self.ports.input("valid_i")] = 0;
        for _ in 1..self.latency_cycles {
            self.simulation.cycle(&inputs);
        }
        let outputs = self.simulation.cycle(&inputs);
        let output = |name: &str| outputs[self.ports.output(name)] as u32;
        assert_eq!(output("valid_o"), 1);
        let slot = |which: &str| {
            let word = |what: &str| output(&format!("{which}_{what}_o"));
            let [t_min, t_max] = ["t_min", "t_max"].map(|what| f32::from_bits(word(what)));
            Child { offset: word("offset"), t_min, t_max }
        };
        let code = [Code::Miss, Code::One, Code::Two, Code::Leaf][output("code_o") as usize];
        Step { code, near: slot("near"), far: slot("far") }
    }
}

/// The camera's rays of a small image.
fn image_rays(scene: &Scene, size: u32, mode: Mode) -> Vec<TraversalRay> {
    let camera = CameraRays::new(&scene.camera, size, size).expect("a sound camera");
    let pixel = |i: u32| camera.ray((i % size) as f32 + 0.5, (i / size) as f32 + 0.5);
    (0..size * size).filter_map(|i| TraversalRay::new(&pixel(i), mode)).collect()
}

#[test]
fn an_image_traced_by_the_netlist_is_goldens() {
    const SIZE: u32 = 20;
    let (scene, dst) = scene("hairball", DETAIL);
    for top in [Top::DualSplit, Top::DualSplitLean] {
        let netlist = netlist(top);
        let mut hardware = Hardware::new(&netlist);
        let (mut hits, mut steps) = (0, 0);
        let rays = image_rays(&scene, SIZE, Mode::Robust);
        for ray in &rays {
            let found = closest_by_steps(&dst, ray, &mut NoObserver, |words, ray, t_min, t_max| {
                steps += 1;
                hardware.step(words, ray, t_min, t_max)
            });
            let expected = dst.closest_prepared(ray, &mut NoObserver);
            let bits = |hit: golden::Hit| (hit.t.to_bits(), hit.u.to_bits(), hit.v.to_bits(), hit.triangle);
            assert_eq!(found.map(bits), expected.map(bits), "{ray:?}");
            hits += u32::from(found.is_some());
        }
        println!("{top}: {} rays, {steps} steps, {hits} hits", rays.len());
        assert!(hits > SIZE * SIZE / 20 && hits < SIZE * SIZE, "{hits} hits");
    }
}

/// The nodes that golden visits, through the netlist in one stream with stalls and bubbles.
fn stream(netlist: &Flat, dst: &Dst, rays: &[TraversalRay]) -> (usize, equivalence::Outcome) {
    let nodes = visited_nodes(dst, rays);
    let count = nodes.len();
    let format = StandardFormat::Binary32;
    let mut stimulus = Stimulus::new(Top::DualSplit, format, netlist, 5).with_nodes(nodes);
    let mut left = 3 * latency_cycles(netlist).expect("a plain pipeline") as usize;
    let cycles = std::iter::from_fn(|| {
        left -= usize::from(stimulus.is_past_nodes());
        if left == 0 { None } else { stimulus.next() }
    });
    (count, compare(netlist, Model::new(Top::DualSplit, format, netlist), cycles, |_, _| ()))
}

#[test]
fn node_streams_of_every_scene_equal_golden() {
    let netlist = netlist(Top::DualSplit);
    for entry in procedural::CATALOGUE {
        let (scene, dst) = scene(entry.name, DETAIL);
        let mut rays = image_rays(&scene, 16, Mode::Robust);
        rays.extend(image_rays(&scene, 8, Mode::Fast));
        let (nodes, outcome) = stream(&netlist, &dst, &rays);
        println!("{}: {} rays, {nodes} nodes, {:?}", entry.name, rays.len(), outcome.classes);
        assert_eq!(outcome.mismatches, 0, "{}: {}", entry.name, outcome.first.unwrap());
        assert!(outcome.vectors >= nodes as u64 && nodes > 1000, "{}: {nodes} nodes", entry.name);
        assert!(outcome.classes.contains_key("split: two children"));
    }
}
