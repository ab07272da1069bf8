//! What happens during a traversal, for whoever wants to know: one stream of events for all structures.
//!
//! Statistics, heat maps, explanations and the needs of a cache are observers of it.

/// Receives the events of a traversal in order; every method does nothing by default and costs nothing when unused.
///
/// Distances are along the ray's scaled direction.
pub trait Observer {
    /// False where nothing is observed.
    const ACTIVE: bool = true;

    /// A node is read and tested.
    #[inline(always)]
    fn node(&mut self, _node: &Node) {}

    /// The triangle in `slot` of the structure's triangle array is read and tested; it is hit at `t`, if it is.
    #[inline(always)]
    fn triangle(&mut self, _slot: u32, _t: Option<f32>) {}

    /// The triangle tested last is the best hit so far.
    #[inline(always)]
    fn hit(&mut self, _slot: u32, _t: f32) {}

    /// What the ray enters at `t_entry` is put on the stack, which then holds `depth` entries.
    #[inline(always)]
    fn push(&mut self, _target: Target, _t_entry: f32, _depth: u32) {}

    /// An entry is taken from the stack; `discarded` if it begins beyond the hit found so far.
    #[inline(always)]
    fn pop(&mut self, _target: Target, _discarded: bool) {}
}

/// A node that a ray visits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Bytes from the start of the structure.
    pub address: u64,
    /// Bytes that are read.
    pub bytes: u32,
    /// What is tested.
    pub tests: Tests,
    /// Where the ray enters the node's box, as far as the node and its ancestors tell.
    pub t_min: f32,
    /// Where the ray leaves it, or its best hit; below `t_min` if the box is missed.
    pub t_max: f32,
    /// What the ray may hit inside.
    pub outcome: Outcome,
}

/// What is left to visit below a node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// Nothing inside is met.
    Nothing,
    /// One part.
    One(Part),
    /// Two parts, the nearer first.
    Two(Part, Part),
}

/// What lies below a node, with the part of the ray that lies in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Where it is.
    pub target: Target,
    /// Where the ray enters it.
    pub t_min: f32,
    /// Where the ray leaves it.
    pub t_max: f32,
}

/// A place in a structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// A node, or the first of siblings that are tested together; bytes from the start of the structure.
    Node(u64),
    /// A leaf, by the slot of its first triangle.
    Leaf(u32),
}

/// The tests that a node costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tests {
    /// A box: six planes.
    Box,
    /// A split or carve node: two planes.
    Planes,
    /// A bare leaf: none.
    None,
}

/// Observes nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoObserver;

impl Observer for NoObserver {
    const ACTIVE: bool = false;
}

/// Sums of all events, of one ray or of many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// Nodes read.
    pub node_visits: u64,
    /// Planes that a ray was intersected with, six to a box.
    pub plane_tests: u64,
    /// Boxes tested.
    pub box_tests: u64,
    /// Triangles tested.
    pub triangle_tests: u64,
    /// Bytes of nodes and triangles read, each as often as it was read.
    pub bytes: u64,
    /// Stack entries written.
    pub pushes: u64,
    /// The largest number of entries that the stack held.
    pub stack_depth: u32,
}

impl Counters {
    /// Adds the events of `other`.
    pub fn merge(&mut self, other: &Counters) {
        self.node_visits += other.node_visits;
        self.plane_tests += other.plane_tests;
        self.box_tests += other.box_tests;
        self.triangle_tests += other.triangle_tests;
        self.bytes += other.bytes;
        self.pushes += other.pushes;
        self.stack_depth = self.stack_depth.max(other.stack_depth);
    }
}

impl Observer for Counters {
    #[inline(always)]
    fn node(&mut self, node: &Node) {
        self.node_visits += 1;
        self.bytes += u64::from(node.bytes);
        match node.tests {
            Tests::Box => {
                self.box_tests += 1;
                self.plane_tests += 6;
            }
            Tests::Planes => self.plane_tests += 2,
            Tests::None => {}
        }
    }

    #[inline(always)]
    fn triangle(&mut self, _slot: u32, _t: Option<f32>) {
        self.triangle_tests += 1;
        self.bytes += u64::from(crate::triangle::Triangle::WORDS) * 4;
    }

    #[inline(always)]
    fn push(&mut self, _target: Target, _t_entry: f32, depth: u32) {
        self.pushes += 1;
        self.stack_depth = self.stack_depth.max(depth);
    }
}
