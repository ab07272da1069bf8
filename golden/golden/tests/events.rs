//! The events of a traversal are those of a depth-first search, in every structure and number format.

mod support;

use fp::Format;
use golden::build::{BuildOptions, Quality, build};
use golden::precision::{NarrowStructure, Precision, Variant};
use golden::structure::{Structure, StructureKind, pack_triangles};
use golden::traverse::{NoObserver, Node, Observer, Outcome, Part, Target, Trace};
use golden::{Hit, Mode, TraversalRay};
use proptest::prelude::*;
use support::strategies::{mesh, ray};

/// Checks each event against those before.
struct Checker {
    node_bytes: u64,
    triangles: u32,
    stack: Vec<Target>,
    /// What was left to visit below the nodes read so far.
    announced: Vec<Target>,
    /// The triangle tested last, and its distance.
    tested: Option<(u32, Option<f32>)>,
    best: Option<(u32, f32)>,
}

impl Checker {
    fn new(structure: &Structure) -> Self {
        let triangles = structure.triangles().len() as u32;
        let node_bytes = structure.node_bytes() as u64;
        Self { node_bytes, triangles, stack: vec![], announced: vec![], tested: None, best: None }
    }

    fn announce(&mut self, part: Part) {
        assert!(part.t_min <= part.t_max, "{part:?}");
        self.announced.push(part.target);
    }
}

impl Observer for Checker {
    fn node(&mut self, node: &Node) {
        assert!(node.bytes > 0 && node.address + u64::from(node.bytes) <= self.node_bytes, "{node:?}");
        match node.outcome {
            Outcome::Nothing => {}
            Outcome::One(only) => self.announce(only),
            Outcome::Two(near, far) => {
                self.announce(near);
                self.announce(far);
            }
        }
    }

    fn triangle(&mut self, slot: u32, t: Option<f32>) {
        assert!(slot < self.triangles);
        let follows = self.tested.is_some_and(|(last, _)| last + 1 == slot);
        // The root may be a leaf, which no node announces.
        let is_root = self.announced.is_empty() && self.tested.is_none() && slot == 0;
        assert!(follows || is_root || self.announced.contains(&Target::Leaf(slot)), "slot {slot}");
        self.tested = Some((slot, t));
    }

    fn hit(&mut self, slot: u32, t: f32) {
        assert_eq!(self.tested, Some((slot, Some(t))));
        assert!(self.best.is_none_or(|(_, best)| t <= best));
        self.best = Some((slot, t));
    }

    fn push(&mut self, target: Target, _t_entry: f32, depth: u32) {
        assert!(self.announced.contains(&target), "{target:?}");
        self.stack.push(target);
        assert_eq!(self.stack.len(), depth as usize);
    }

    fn pop(&mut self, target: Target, discarded: bool) {
        assert_eq!(Some(target), self.stack.pop(), "what is popped was pushed last");
        assert!(!discarded || self.best.is_some(), "{target:?} begins beyond no hit");
    }
}

fn check(structure: &Structure, traced: &impl Trace, ray: &TraversalRay) {
    let mut checker = Checker::new(structure);
    let hit = traced.closest_prepared(ray, &mut checker);
    assert_eq!(hit, traced.closest_prepared(ray, &mut NoObserver), "observed or not");
    let best = checker.best.map(|(slot, t)| (structure.triangles()[slot as usize].index(), ray.given_t(t)));
    assert_eq!(best, hit.map(|Hit { triangle, t, .. }| (triangle, t)));
    assert!(checker.stack.is_empty(), "a search for the nearest hit ends with an empty stack");

    let mut checker = Checker::new(structure);
    assert_eq!(traced.occluded_prepared(ray, &mut checker), hit.is_some());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn events_are_those_of_a_depth_first_search(
        (mesh, rays) in mesh().prop_flat_map(|m| {
            let rays = prop::collection::vec(ray(&m), 8);
            (Just(m), rays)
        }),
        max_leaf_size in 1u32..5,
    ) {
        let tree = build(&mesh, &BuildOptions { quality: Quality::Fast, max_leaf_size }).unwrap();
        let triangles = pack_triangles(&mesh, &tree);
        for kind in StructureKind::ALL {
            let structure = Structure::convert(kind, &tree, &triangles).unwrap();
            let narrow = Variant::ALL
                .map(|variant| NarrowStructure::new(&structure, Precision::new(Format::BINARY16, variant)));
            for ray in &rays {
                for mode in [Mode::Fast, Mode::Robust] {
                    if let Some(ray) = TraversalRay::new(ray, mode) {
                        check(&structure, &structure, &ray);
                    }
                }
                for (narrow, variant) in narrow.iter().zip(Variant::ALL) {
                    if let Some(ray) = TraversalRay::new(ray, variant.mode()) {
                        check(&structure, narrow, &ray);
                    }
                }
            }
        }
    }
}
