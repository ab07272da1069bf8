//! The walk is the kernels' own: same nodes, triangles and stack operations in the same order.

use super::*;
use golden::build::{BuildOptions, Quality, build};
use golden::bvh::BvhNode;
use golden::structure::pack_triangles;
use golden::traverse::{Tests, Trace, Traversal};
use golden::{Mode, Ray};
use render::CameraRays;
use scenes::Scene;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Event {
    Node(u32),
    Triangle(u32),
    Push(u32),
    Pop(bool),
}

#[derive(Default)]
struct Recorder(Vec<Event>);

impl Traversal for Recorder {
    fn node(&mut self, word_address: u32, _: u32, _: Tests) {
        self.0.push(Event::Node(word_address));
    }

    fn triangle(&mut self, slot: u32) {
        self.0.push(Event::Triangle(slot));
    }

    fn push(&mut self, depth: u32) {
        self.0.push(Event::Push(depth));
    }

    fn pop(&mut self, discarded: bool) {
        self.0.push(Event::Pop(discarded));
    }
}

fn events(walk: &Walk) -> Vec<Event> {
    let event = |step: &Step| match step {
        Step::Root { .. } => None,
        Step::Node { offset, .. } => Some(Event::Node(*offset)),
        Step::Box { node, .. } => Some(Event::Node(node * BvhNode::WORDS)),
        Step::Push { depth, .. } => Some(Event::Push(*depth)),
        Step::Pop { discarded, .. } => Some(Event::Pop(*discarded)),
        Step::Triangle { slot, .. } => Some(Event::Triangle(*slot)),
    };
    walk.steps.iter().filter_map(event).collect()
}

#[test]
fn walks_are_the_kernels() {
    let scene = Scene::load("hairball", 0.001, 0).unwrap();
    let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
    let triangles = pack_triangles(&scene.mesh, &tree);
    let dst = Dst::convert(&tree, triangles.clone()).unwrap();
    let bvh = Bvh2::encode(&tree, triangles);
    let camera = CameraRays::new(&scene.camera, 24, 24).unwrap();
    let rays = (0..576).map(|i| camera.ray(f64::from(i % 24) + 0.5, f64::from(i / 24) + 0.5));
    let scaled = Ray { direction: [3.0, -2.0, -1.5], ..camera.ray(12.0, 12.0) };
    let mut hits = 0;
    for ray in rays.chain([scaled]) {
        for mode in [Mode::Fast, Mode::Robust] {
            let prepared = TraversalRay::new(&ray, mode).unwrap();
            for (walk, (kernel, hit)) in [
                (walk_dst(&dst, &prepared), observed(&dst, &prepared)),
                (walk_bvh2(&bvh, &prepared), observed(&bvh, &prepared)),
            ] {
                assert_eq!(walk.hit, hit);
                assert_eq!(events(&walk), kernel);
                hits += u32::from(hit.is_some());
            }
        }
    }
    assert!(hits > 400, "{hits}");
}

fn observed(structure: &impl Trace, ray: &TraversalRay) -> (Vec<Event>, Option<Hit>) {
    let mut recorder = Recorder::default();
    let hit = structure.closest_prepared(ray, &mut recorder);
    (recorder.0, hit)
}
