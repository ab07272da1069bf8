//! Operations of real traversals: nodes and boxes that the rays of a rendered scene meet.

use std::cell::RefCell;

use equivalence::Ports;
use equivalence::cases::{BoxCase, NodeCase, visited_nodes};
use golden::build::{BuildOptions, Quality, build};
use golden::bvh::{Bvh2, BvhNode};
use golden::dst::Dst;
use golden::dst::header::{AXIS, CARVE, LEAF, SINGLE};
use golden::structure::pack_triangles;
use golden::traverse::{Node, Observer, Trace};
use golden::{Mode, TraversalRay};
use pipelines::catalogue::Top;
use render::{RenderOptions, Test, render};
use scenes::Scene;
use serde::Serialize;

use super::{EstimateError, Implementation};

/// Width and height in pixels of the picture whose rays the workload consists of.
const PICTURE_SIZE: u32 = 12;
/// Operations that a workload keeps for each pipeline.
const OPERATIONS: usize = 64 * 250;
/// The scene of estimates that name no scene, and the fraction of its triangles.
const BUILT_IN: (&str, f64) = ("courtyard", 0.01);

/// The type of a dual-split node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum NodeType {
    /// Two children.
    Split,
    /// Two planes of one axis.
    SingleCarve,
    /// Two planes of two axes.
    DualCarve,
    /// A leaf without a carve node before it.
    Leaf,
}

impl NodeType {
    /// All types.
    pub const ALL: [Self; 4] = [Self::Split, Self::SingleCarve, Self::DualCarve, Self::Leaf];

    /// The type by a node's header.
    #[must_use]
    pub fn of(header: u32) -> Self {
        match (CARVE.get(header), LEAF.get(header), AXIS.get(header)) {
            (1, _, SINGLE) => Self::SingleCarve,
            (1, ..) => Self::DualCarve,
            (_, 1, _) => Self::Leaf,
            _ => Self::Split,
        }
    }

    /// The name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Split => "split",
            Self::SingleCarve => "single carve",
            Self::DualCarve => "dual carve",
            Self::Leaf => "leaf",
        }
    }
}

/// Operations of both pipelines.
#[derive(Clone, Debug)]
pub struct Workload {
    /// The scene.
    pub scene: String,
    /// Nodes of the dual-split tree, in the order of the rays.
    pub nodes: Vec<NodeCase>,
    /// Boxes of the binary hierarchy in the same order, each tested with the whole of its ray.
    pub boxes: Vec<BoxCase>,
}

/// Collects the boxes that a traversal tests.
struct Boxes<'a> {
    bvh: &'a Bvh2,
    ray: &'a TraversalRay,
    found: &'a RefCell<Vec<BoxCase>>,
}

impl Observer for Boxes<'_> {
    fn node(&mut self, node: &Node) {
        let node = &self.bvh.nodes[node.address as usize / size_of::<BvhNode>()];
        self.found.borrow_mut().push(BoxCase::new(&node.aabb, self.ray));
    }
}

impl Workload {
    /// The operations of path tracing a small picture of a scene, for an evenly spread sample of its rays.
    ///
    /// # Errors
    /// [`EstimateError::Scene`] when no tree can be built over the scene, or no ray meets a node.
    pub fn new(scene: &Scene, quality: Quality) -> Result<Self, EstimateError> {
        let failed = |error: &dyn std::fmt::Display| EstimateError::Scene(format!("{}: {error}", scene.name));
        let tree = build(&scene.mesh, &BuildOptions::new(quality)).map_err(|error| failed(&error))?;
        let triangles = pack_triangles(&scene.mesh, &tree);
        let dst = Dst::convert(&tree, triangles.clone()).map_err(|error| failed(&error))?;
        let bvh = Bvh2::encode(&tree, triangles);
        let mut options = RenderOptions::new(Test::Path, PICTURE_SIZE, PICTURE_SIZE);
        options.keep_rays = true;
        let rendering = render(&dst, scene, &options, |_| ()).map_err(|error| failed(&error))?;
        let rays: Vec<TraversalRay> = (rendering.rays.iter().flat_map(|stream| &stream.rays))
            .filter_map(|ray| TraversalRay::new(ray, Mode::default()))
            .collect();
        let boxes = RefCell::new(Vec::new());
        let mut nodes = Vec::new();
        // Each turn of the outer loop traces a sample of rays that is spread over all waves. Once there are enough
        // operations, the remaining rays are skipped.
        let step = (rays.len() / 400).max(1);
        for first in 0..step {
            for ray in rays.iter().skip(first).step_by(step) {
                if nodes.len() < OPERATIONS {
                    nodes.extend(visited_nodes(&dst, [ray]));
                }
                if boxes.borrow().len() < OPERATIONS {
                    bvh.closest_prepared(ray, &mut Boxes { bvh: &bvh, ray, found: &boxes });
                }
            }
        }
        let mut boxes = boxes.into_inner();
        nodes.truncate(OPERATIONS);
        boxes.truncate(OPERATIONS);
        if nodes.is_empty() || boxes.is_empty() {
            return Err(failed(
                &"no ray meets a node of both trees: a scene that is one leaf has none, and a view that misses the scene meets none; name a scene of more triangles, or give it a view file",
            ));
        }
        Ok(Self { scene: scene.name.clone(), nodes, boxes })
    }

    /// The operations of a built-in scene.
    ///
    /// # Errors
    /// The errors of [`Workload::new`]. A test shows that the built-in scene causes none.
    pub fn built_in() -> Result<Self, EstimateError> {
        let (name, detail) = BUILT_IN;
        let scene = Scene::load(name, detail, 0).map_err(|error| EstimateError::Scene(error.to_string()))?;
        Self::new(&scene, Quality::Fast)
    }

    /// The values of all inputs for each operation, back to back.
    ///
    /// # Errors
    /// [`EstimateError::NoPipeline`] if the workload has no operations for the pipeline.
    pub fn streams(&self, implementation: &Implementation) -> Result<Vec<Vec<u128>>, EstimateError> {
        Ok(match implementation.top {
            Top::RayBox | Top::RayBoxLean => {
                let ports = Ports::new(&implementation.flat).bounds(None);
                self.drive(implementation, &self.boxes, |inputs, case| ports.drive(inputs, case))
            }
            Top::DualSplit | Top::DualSplitLean => self.nodes_of(implementation, |_| true),
            other => return Err(EstimateError::NoPipeline(other)),
        })
    }

    /// The values of all inputs for each operation on a node of the `wanted` types, back to back.
    #[must_use]
    pub fn nodes_of(
        &self,
        implementation: &Implementation,
        wanted: impl Fn(NodeType) -> bool,
    ) -> Vec<Vec<u128>> {
        let ports = Ports::new(&implementation.flat).node();
        let chosen: Vec<NodeCase> =
            self.nodes.iter().filter(|case| wanted(NodeType::of(case.words[0]))).copied().collect();
        self.drive(implementation, &chosen, |inputs, case| ports.drive(inputs, case))
    }

    fn drive<C>(
        &self,
        implementation: &Implementation,
        cases: &[C],
        drive: impl Fn(&mut [u128], &C),
    ) -> Vec<Vec<u128>> {
        let ports = Ports::new(&implementation.flat);
        let mut busy = vec![0; implementation.flat.inputs.len()];
        busy[ports.input("en_i")] = 1;
        busy[ports.input("valid_i")] = 1;
        let cycle = |case: &C| {
            let mut inputs = busy.clone();
            drive(&mut inputs, case);
            inputs
        };
        cases.iter().map(cycle).collect()
    }
}
