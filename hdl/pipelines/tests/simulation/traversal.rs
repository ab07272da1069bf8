//! Whole traversals in which the dual-split pipeline executes every step: the node streams of rays through the
//! built-in scenes, several rays in flight, one node per cycle.

use crate::pipelines::DualSplit;
use crate::support::harness::{Pipeline, latency_cycles};
use crate::support::steps::{NodeCase, RayWords};
use fp::Format;
use fp::operands::Operands;
use golden::build::{BuildOptions, build};
use golden::bvh::box_step;
use golden::dst::{Code, Dst};
use golden::structure::pack_triangles;
use golden::traverse::{Leaf, Leaves};
use golden::{Mode, Ray, TraversalRay};
use scenes::{Scene, procedural};
use std::collections::VecDeque;

const RAYS: usize = 24;
/// Fraction of a scene's triangles; the generators stop at some thousand.
const DETAIL: f64 = 1e-4;

/// A node that a ray still has to visit.
#[derive(Clone, Copy)]
struct Visit {
    ray: usize,
    offset: u32,
    t_min: u32,
    t_max: u32,
}

/// From the camera towards vertices, every third ray along an axis.
fn rays(scene: &Scene) -> Vec<TraversalRay> {
    let mut stream = Operands::new(Format::BINARY32, 41);
    let positions = &scene.mesh.positions;
    let draw = |i: usize| {
        let target = positions[stream.bits() as usize % positions.len()];
        let mut origin = scene.camera.eye;
        if i.is_multiple_of(3) {
            origin = target;
            origin[i % 9 / 3] -= 1.0;
        }
        let direction = std::array::from_fn(|axis| target[axis] - origin[axis]);
        let mode = if i.is_multiple_of(2) { Mode::Robust } else { Mode::Fast };
        TraversalRay::new(&Ray::new(origin, direction), mode).expect("a valid ray")
    };
    (0..RAYS).map(draw).collect()
}

/// The leaves of each ray as the pipeline finds them, in ascending order, and the number of nodes visited.
fn traverse(dst: &Dst, rays: &[TraversalRay]) -> (Vec<Vec<Leaf>>, usize) {
    let mut pipeline = DualSplit::default();
    let mut waiting: Vec<Visit> = Vec::new();
    for (ray, words) in rays.iter().enumerate() {
        let root = box_step(&dst.root_box, words, words.t_min, words.t_max);
        if root.hit {
            waiting.push(Visit {
                ray,
                offset: 0,
                t_min: root.t_entry.to_bits(),
                t_max: root.t_exit.to_bits(),
            });
        }
    }
    let mut leaves = vec![Vec::new(); rays.len()];
    let mut in_flight = VecDeque::from(vec![None; latency_cycles(DualSplit::TOP)]);
    let mut visits = 0;
    while !waiting.is_empty() || in_flight.iter().any(Option::is_some) {
        let next = waiting.pop();
        pipeline.handshake(true, next.is_some(), 0);
        if let Some(Visit { ray, offset, t_min, t_max }) = next {
            let ray = RayWords::new(&rays[ray], f32::from_bits(t_min), f32::from_bits(t_max));
            pipeline.drive(&NodeCase { words: dst.node(offset), ray });
            visits += 1;
        }
        pipeline.tick();
        in_flight.pop_front();
        in_flight.push_back(next.map(|visit| visit.ray));
        let outcome = pipeline.output();
        assert_eq!(outcome.is_some(), in_flight[0].is_some());
        let (Some(ray), Some((_, (code, near, far)))) = (in_flight[0], outcome) else { continue };
        for (offset, t_min, t_max) in [far, near].into_iter().flatten() {
            if code == Code::Leaf as u8 {
                let (t_entry, t_exit) = (f32::from_bits(t_min), f32::from_bits(t_max));
                leaves[ray].push(Leaf { first_triangle: offset, t_entry, t_exit });
            } else {
                waiting.push(Visit { ray, offset, t_min, t_max });
            }
        }
    }
    leaves.iter_mut().for_each(|list: &mut Vec<Leaf>| list.sort_by_key(|leaf| leaf.first_triangle));
    (leaves, visits)
}

#[test]
fn every_scene_gives_goldens_leaves_and_intervals() {
    for entry in procedural::CATALOGUE {
        let scene = procedural::build(entry.name, DETAIL, 0).expect("a built-in scene");
        let tree = build(&scene.mesh, &BuildOptions::default()).expect("a sound mesh");
        let dst = Dst::convert(&tree, pack_triangles(&scene.mesh, &tree)).expect("a small tree");
        let rays = rays(&scene);
        let (leaves, visits) = traverse(&dst, &rays);
        for (ray, seen) in rays.iter().zip(&leaves) {
            assert_eq!(*seen, dst.leaves(ray), "{}: {ray:?}", entry.name);
        }
        let found: usize = leaves.iter().map(Vec::len).sum();
        assert!(found >= RAYS && visits > 4 * RAYS, "{}: {found} leaves, {visits} nodes", entry.name);
    }
}
