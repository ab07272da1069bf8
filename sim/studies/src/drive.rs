//! The inputs that the traversal of a scene gives to each hardware unit, cycle by cycle, for waveforms.
//!
//! | unit | operations |
//! |---|---|
//! | dual-split pipelines | every node that the rays visit |
//! | ray-box pipelines | every box of the BVH2 that the rays visit, the scene's first |
//! | parallel forms | every node of the BVH with as many children, a lane for each child |
//! | single units | what they get inside the dual-split pipeline at the same nodes |
//! | shared units | the threads' additions and multiplications; then, routed as a pipeline, the nodes; then the boxes |
//!
//! Boxes are tested with the whole interval of the ray, because a unit does not know of hits that were found earlier.

use equivalence::Ports;
use equivalence::cases::{BoxCase, visited_nodes};
use golden::build::BinaryTree;
use golden::bvh::{Bvh, BvhNode};
use golden::dst::Dst;
use golden::structure::{StructureFormat, TooLarge};
use golden::traverse::{Node, Observer, Trace};
use golden::triangle::Triangle;
use golden::{Aabb, TraversalRay};
use netlist::{ElaborateError, Evaluator, Flat, NodeId, flatten, register_depths};
use pipelines::catalogue::{CatalogueError, StandardFormat, Top};
use std::sync::Arc;

/// Cycles after the last operation, until its result leaves the deepest unit.
pub const DRAIN_CYCLES: usize = 10;
/// The shared block's routings, in the order in which they are shown.
const ROUTINGS: [u128; 3] = [0, 2, 1];
/// Number of adders in the shared block, and of multipliers.
const SHARED_UNITS: usize = 8;

/// Why there are no inputs.
#[derive(Debug, thiserror::Error)]
pub enum DriveError {
    /// The scene is too large for a structure.
    #[error(transparent)]
    TooLarge(#[from] TooLarge),
    /// A unit does not elaborate.
    #[error(transparent)]
    Catalogue(#[from] CatalogueError),
    /// A unit has a combinational loop.
    #[error(transparent)]
    Elaborate(#[from] ElaborateError),
}

/// A scene's hierarchy and the rays through it.
#[derive(Clone, Copy, Debug)]
pub struct Traversals<'a> {
    /// The hierarchy that all structures are converted from.
    pub tree: &'a BinaryTree,
    /// Its triangles in order.
    pub triangles: &'a Arc<[Triangle]>,
    /// The rays, one after the other.
    pub rays: &'a [TraversalRay],
}

/// A unit's operations, each as the values of all inputs in one cycle, back to back, and the number of them.
///
/// # Errors
/// [`DriveError`]; none for the modules of crate `hdl` over a scene of up to 2^26 words.
pub fn cycles(
    unit: Top,
    netlist: &Flat,
    traversals: &Traversals,
) -> Result<(Vec<Vec<u128>>, usize), DriveError> {
    let ports = Ports::new(netlist);
    let mut idle = vec![0; netlist.inputs.len()];
    idle[ports.input("en_i")] = 1;
    let mut cycles = match unit {
        Top::DualSplit | Top::DualSplitLean => traversals.nodes(&ports, &idle)?,
        Top::RayBox | Top::RayBoxLean => traversals.boxes::<2>(1, &ports, &idle)?,
        Top::RayBoxX2 => traversals.boxes::<2>(2, &ports, &idle)?,
        Top::RayBoxX4 => traversals.boxes::<4>(4, &ports, &idle)?,
        Top::RayBoxX8 => traversals.boxes::<8>(8, &ports, &idle)?,
        Top::SharedUnits => return traversals.routed(&ports, &idle),
        Top::IntAdd | Top::FpAdd | Top::FpMul | Top::FpMinMax | Top::FpCmp => {
            traversals.operands(unit, netlist)?
        }
    };
    let operations = cycles.len();
    cycles.extend(std::iter::repeat_n(idle, DRAIN_CYCLES));
    Ok((cycles, operations))
}

impl Traversals<'_> {
    fn nodes(&self, ports: &Ports<'_>, idle: &[u128]) -> Result<Vec<Vec<u128>>, DriveError> {
        let dst = Dst::convert(self.tree, Arc::clone(self.triangles))?;
        let node = ports.node();
        let drive = |case| {
            let mut inputs = idle.to_vec();
            inputs[ports.input("valid_i")] = 1;
            node.drive(&mut inputs, case);
            inputs
        };
        Ok(visited_nodes(&dst, self.rays).iter().map(drive).collect())
    }

    /// Boxes of the hierarchy with up to `N` children to a node, in groups of `lanes`. A lane without a child gets an empty box,
    /// which no ray meets.
    fn boxes<const N: usize>(
        &self,
        lanes: usize,
        ports: &Ports<'_>,
        idle: &[u128],
    ) -> Result<Vec<Vec<u128>>, DriveError> {
        let bvh = Bvh::<N>::convert(self.tree, Arc::clone(self.triangles))?;
        let lane = |i: usize| ports.bounds((lanes > 1).then_some(i));
        let lane_ports: Vec<_> = (0..lanes).map(lane).collect();
        let mut cycles = Vec::new();
        for ray in self.rays {
            for group in siblings(&bvh, ray) {
                for boxes in group.chunks(lanes) {
                    let mut inputs = idle.to_vec();
                    inputs[ports.input("valid_i")] = 1;
                    for (i, lane) in lane_ports.iter().enumerate() {
                        let bounds = boxes.get(i).copied().unwrap_or(Aabb::EMPTY);
                        lane.drive(&mut inputs, &BoxCase::new(&bounds, ray));
                    }
                    cycles.push(inputs);
                }
            }
        }
        Ok(cycles)
    }
}

/// The scene's box, and then the children of every inner node that the search for the closest hit visits.
fn siblings<const N: usize>(bvh: &Bvh<N>, ray: &TraversalRay) -> Vec<Vec<Aabb>> {
    let mut recorder = Recorder { bvh, groups: vec![vec![bvh.root_box]], missing: 0 };
    bvh.closest_prepared(ray, &mut recorder);
    recorder.groups
}

/// Collects the boxes that a traversal tests, with the boxes of siblings in one group.
struct Recorder<'b, const N: usize> {
    bvh: &'b Bvh<N>,
    groups: Vec<Vec<Aabb>>,
    /// Siblings of the last group that have not been tested yet.
    missing: u32,
}

impl<const N: usize> Observer for Recorder<'_, N> {
    fn node(&mut self, node: &Node) {
        let node = &self.bvh.nodes[node.address as usize / size_of::<BvhNode>()];
        match self.groups.last_mut().filter(|_| self.missing > 0) {
            Some(group) => group.push(node.aabb),
            None => {
                self.missing = Bvh::<N>::SIBLINGS.get(node.word) + 1;
                self.groups.push(vec![node.aabb]);
            }
        }
        self.missing -= 1;
    }
}

/// Where an input of a unit comes from inside a pipeline.
#[derive(Clone, Copy)]
enum Source {
    Node(NodeId),
    Value(u128),
}

/// A unit inside a pipeline.
struct Instance {
    /// Cycles from the pipeline's inputs to the unit's.
    depth: usize,
    /// Sources of the unit's inputs, in its own order.
    inputs: Vec<Source>,
}

/// The instances of `unit` in the flattened pipeline `inside`.
fn instances(unit: Top, netlist: &Flat, pipeline: Top, inside: &Flat) -> Result<Vec<Instance>, DriveError> {
    let design = pipeline.design(StandardFormat::Binary32)?;
    let depths = register_depths(inside).unwrap_or_default();
    let mut found = Vec::new();
    for (scope, instance) in inside.scopes.iter().enumerate() {
        let module = design.module(instance.module);
        if module.kind != unit.name() {
            continue;
        }
        let source = |name: &str| {
            let named = inside.names.iter().find(|named| named.scope as usize == scope && named.name == name);
            let tied =
                module.parameters.iter().find(|parameter| parameter.is_tied_input && parameter.name == name);
            match (name, named, tied) {
                ("en_i" | "valid_i", ..) => Source::Value(1),
                ("tag_i", ..) => Source::Value(found.len() as u128 & 1),
                (_, Some(named), _) => Source::Node(named.node),
                (_, None, tied) => Source::Value(tied.map_or(0, |parameter| parameter.value)),
            }
        };
        let inputs: Vec<Source> = netlist.inputs.iter().map(|port| source(&port.name)).collect();
        let depth = |source: &Source| match source {
            Source::Node(node) => depths.get(node.index()).copied().flatten(),
            Source::Value(_) => None,
        };
        let depth = inputs.iter().filter_map(depth).map(|(least, _)| least as usize).min().unwrap_or(0);
        found.push(Instance { depth, inputs });
    }
    Ok(found)
}

impl Traversals<'_> {
    /// The inputs that the instances of `unit` in the dual-split pipeline get, one instance after the other in each cycle.
    fn operands(&self, unit: Top, netlist: &Flat) -> Result<Vec<Vec<u128>>, DriveError> {
        let inside = flatten(&Top::DualSplit.design(StandardFormat::Binary32)?)?;
        let instances = instances(unit, netlist, Top::DualSplit, &inside)?;
        let (nodes, operations) = cycles(Top::DualSplit, &inside, self)?;
        let mut simulation = Evaluator::new(&inside);
        let mut operands = Vec::new();
        for (cycle, inputs) in nodes.iter().enumerate() {
            inputs.iter().enumerate().for_each(|(input, &value)| simulation.set_input(input, value));
            simulation.settle();
            for instance in &instances {
                if (instance.depth..instance.depth + operations).contains(&cycle) {
                    let value = |source: &Source| match *source {
                        Source::Node(node) => simulation.value(node),
                        Source::Value(value) => value,
                    };
                    operands.push(instance.inputs.iter().map(value).collect());
                }
            }
            simulation.clock();
        }
        Ok(operands)
    }

    /// The shared block in all three routings, emptied before each change.
    fn routed(&self, ports: &Ports<'_>, idle: &[u128]) -> Result<(Vec<Vec<u128>>, usize), DriveError> {
        let mode = ports.input("mode_i");
        let (mut all, mut operations) = (Vec::new(), 0);
        for routing in ROUTINGS {
            let mut idle = idle.to_vec();
            idle[mode] = routing;
            let cycles = match routing {
                2 => self.nodes(ports, &idle)?,
                1 => self.boxes::<2>(1, ports, &idle)?,
                _ => self.threads(ports, &idle)?,
            };
            operations += cycles.len();
            all.extend(cycles);
            all.extend(std::iter::repeat_n(idle, DRAIN_CYCLES));
        }
        Ok((all, operations))
    }

    /// The additions and multiplications of the dual-split steps, eight of each in a cycle.
    fn threads(&self, ports: &Ports<'_>, idle: &[u128]) -> Result<Vec<Vec<u128>>, DriveError> {
        let mut cycles: Vec<Vec<u128>> = Vec::new();
        for (unit, prefix) in [(Top::FpAdd, "add"), (Top::FpMul, "mul")] {
            let netlist = flatten(&unit.design(StandardFormat::Binary32)?)?;
            let own = Ports::new(&netlist);
            for (cycle, operations) in self.operands(unit, &netlist)?.chunks(SHARED_UNITS).enumerate() {
                if cycle == cycles.len() {
                    cycles.push(idle.to_vec());
                }
                for (i, operation) in operations.iter().enumerate() {
                    let mut drive = |name: &str| {
                        cycles[cycle][ports.input(&format!("{prefix}_{name}_i${i}"))] =
                            operation[own.input(&format!("{name}_i"))];
                    };
                    ["valid", "tag", "a", "b"].into_iter().for_each(&mut drive);
                    if unit == Top::FpAdd {
                        drive("subtract");
                    }
                }
            }
        }
        Ok(cycles)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use equivalence::{Model, compare};
    use golden::build::{BuildOptions, build};
    use golden::structure::pack_triangles;
    use golden::{Mode, Ray};

    /// Each unit gets operations of its own, and its results for them are golden's.
    #[test]
    fn every_unit_is_driven_with_valid_operations() {
        let scene = scenes::procedural::build("hairball", 1e-4, 0).unwrap();
        let tree = build(&scene.mesh, &BuildOptions::default()).unwrap();
        let triangles = pack_triangles(&scene.mesh, &tree);
        let (eye, target) = (scene.camera.eye, scene.mesh.positions[0]);
        let ray = Ray::new(eye, std::array::from_fn(|axis| target[axis] - eye[axis]));
        let rays = [TraversalRay::new(&ray, Mode::Robust).unwrap()];
        let traversals = Traversals { tree: &tree, triangles: &triangles, rays: &rays };
        let mut operations_of = std::collections::BTreeMap::new();
        for &unit in Top::ALL {
            let netlist = flatten(&unit.design(StandardFormat::Binary32).unwrap()).unwrap();
            let (cycles, operations) = cycles(unit, &netlist, &traversals).unwrap();
            let model = Model::new(unit, StandardFormat::Binary32, &netlist);
            let outcome = compare(&netlist, model, cycles, |_, _| ());
            assert_eq!((outcome.mismatches, outcome.vectors), (0, operations as u64), "{unit}");
            operations_of.insert(unit, operations);
        }
        // The dual-split pipeline has 1 integer adder, 2 adders, 2 multipliers, 3 minimum/maximum units and 4 comparisons.
        let nodes = operations_of[&Top::DualSplit];
        assert_eq!(nodes, 104);
        let units =
            [Top::IntAdd, Top::FpAdd, Top::FpMul, Top::FpMinMax, Top::FpCmp].map(|unit| operations_of[&unit]);
        assert_eq!(units, [1, 2, 2, 3, 4].map(|count| count * nodes));
        // Siblings are tested together: the wider the node, the fewer tests.
        let boxes =
            [Top::RayBox, Top::RayBoxX2, Top::RayBoxX4, Top::RayBoxX8].map(|unit| operations_of[&unit]);
        assert!(boxes.is_sorted_by(|more, fewer| more > fewer), "{boxes:?}");
        assert_eq!(boxes[0], 2 * boxes[1] - 1, "two boxes to a node but for the scene's own");
    }
}
