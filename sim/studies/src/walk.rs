//! The traversal of one ray as a list of steps.

use golden::bvh::box_step;
use golden::structure::{NodeWords, Structure};
use golden::traverse::{Node, Observer, Outcome, Part, Target, Trace};
use golden::{Hit, TraversalRay};
use serde::Serialize;

/// An event of a traversal. Distances are along the ray's scaled direction.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "step", rename_all = "snake_case")]
pub enum Step {
    /// The root's box is tested.
    Root {
        /// Whether the ray meets it.
        hit: bool,
        /// Where the ray enters it.
        t_entry: f32,
        /// Where the ray leaves it.
        t_exit: f32,
    },
    /// The ray visits a node whose planes cut the box of its parent.
    Node {
        /// Word offset of the node.
        offset: u32,
        /// The decoded header.
        header: String,
        /// The planes that it tests.
        planes: Vec<f32>,
        /// Where the ray's part begins on arrival.
        t_min: f32,
        /// Where the ray's part ends.
        t_max: f32,
        /// The children that the ray goes on to.
        outcome: String,
    },
    /// A node's own box is tested.
    Box {
        /// Number of the node in memory.
        node: u32,
        /// Whether it is a leaf.
        leaf: bool,
        /// Whether the ray meets it.
        hit: bool,
        /// Where the ray enters it.
        t_entry: f32,
        /// Where the ray leaves it, or the best hit if that is nearer.
        t_exit: f32,
    },
    /// A node is put on the stack.
    Push {
        /// Word offset, or number of the first child or triangle.
        offset: u32,
        /// Where the ray enters it.
        t_min: f32,
        /// Entries on the stack.
        depth: u32,
    },
    /// A node is taken from the stack.
    Pop {
        /// Word offset, or number of the first child or triangle.
        offset: u32,
        /// Whether it is discarded, because it begins beyond the best hit.
        discarded: bool,
    },
    /// A triangle is tested.
    Triangle {
        /// Index in the structure's array of triangles.
        slot: u32,
        /// Index in the mesh.
        triangle: u32,
        /// Distance, if it is hit.
        t: Option<f32>,
        /// Whether it is the best hit so far.
        best: bool,
    },
}

/// A traversal for the closest hit.
#[derive(Clone, Debug, PartialEq)]
pub struct Walk {
    /// The events in order.
    pub steps: Vec<Step>,
    /// The nearest hit.
    pub hit: Option<Hit>,
}

/// Traces `ray` through `structure` and records the steps.
///
/// # Panics
/// If the structure is not valid.
#[must_use]
pub fn walk(structure: &Structure, ray: &TraversalRay) -> Walk {
    let root = box_step(structure.memory().root_box, ray, ray.t_min, ray.t_max);
    let root = Step::Root { hit: root.hit, t_entry: root.t_entry, t_exit: root.t_exit };
    let mut log = Log { structure, steps: vec![root] };
    let hit = structure.closest_prepared(ray, &mut log);
    Walk { steps: log.steps, hit }
}

/// Records the events of a traversal as steps.
struct Log<'a> {
    structure: &'a Structure,
    steps: Vec<Step>,
}

impl Log<'_> {
    /// The number by which the structure refers to the node `address` bytes from its start.
    fn offset(&self, address: u64) -> u32 {
        (address / u64::from(self.structure.address_bytes())) as u32
    }

    fn place(&self, target: Target) -> u32 {
        match target {
            Target::Node(address) => self.offset(address),
            Target::Leaf(slot) => slot,
        }
    }

    fn outcome(&self, outcome: &Outcome) -> String {
        let part = |part: &Part| {
            let Part { target, t_min, t_max } = *part;
            let kind = if matches!(target, Target::Leaf(_)) { "leaf at " } else { "@" };
            format!("{kind}{} [{t_min}, {t_max}]", self.place(target))
        };
        match outcome {
            Outcome::Nothing => "nothing".to_owned(),
            Outcome::One(only) => part(only),
            Outcome::Two(near, far) => format!("{} then {}", part(near), part(far)),
        }
    }
}

impl Observer for Log<'_> {
    fn node(&mut self, node: &Node) {
        let &Node { address, t_min, t_max, outcome, .. } = node;
        let offset = self.offset(address);
        self.steps.push(match self.structure.node_words(address) {
            NodeWords::Box { leaf } => {
                let hit = outcome != Outcome::Nothing;
                Step::Box { node: offset, leaf, hit, t_entry: t_min, t_exit: t_max }
            }
            NodeWords::Planes { header, planes } => {
                Step::Node { offset, header, planes, t_min, t_max, outcome: self.outcome(&outcome) }
            }
        });
    }

    fn triangle(&mut self, slot: u32, t: Option<f32>) {
        let triangle = self.structure.triangles()[slot as usize].index();
        self.steps.push(Step::Triangle { slot, triangle, t, best: false });
    }

    fn hit(&mut self, _slot: u32, _t: f32) {
        if let Some(Step::Triangle { best, .. }) = self.steps.last_mut() {
            *best = true;
        }
    }

    fn push(&mut self, target: Target, t_entry: f32, depth: u32) {
        self.steps.push(Step::Push { offset: self.place(target), t_min: t_entry, depth });
    }

    fn pop(&mut self, target: Target, discarded: bool) {
        self.steps.push(Step::Pop { offset: self.place(target), discarded });
    }
}

#[cfg(test)]
mod tests;
