//! What happens during a traversal, for whoever wants to know.

/// Receives the events of a traversal; every method does nothing by default and costs nothing when unused.
pub trait Traversal {
    /// False where nothing is observed.
    const ACTIVE: bool = true;

    /// A node is read: its address in 32-bit words from the start of the structure, its size and its tests.
    #[inline(always)]
    fn node(&mut self, _word_address: u32, _words: u32, _tests: Tests) {}

    /// The triangle in `slot` of the structure's triangle array is read and tested.
    #[inline(always)]
    fn triangle(&mut self, _slot: u32) {}

    /// A node is put on the stack, which then holds `depth` entries.
    #[inline(always)]
    fn push(&mut self, _depth: u32) {}

    /// An entry is taken from the stack; `discarded` if it begins beyond the hit found so far.
    #[inline(always)]
    fn pop(&mut self, _discarded: bool) {}
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

impl Traversal for NoObserver {
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

impl Traversal for Counters {
    #[inline(always)]
    fn node(&mut self, _word_address: u32, words: u32, tests: Tests) {
        self.node_visits += 1;
        self.bytes += u64::from(words) * 4;
        match tests {
            Tests::Box => {
                self.box_tests += 1;
                self.plane_tests += 6;
            }
            Tests::Planes => self.plane_tests += 2,
            Tests::None => {}
        }
    }

    #[inline(always)]
    fn triangle(&mut self, _slot: u32) {
        self.triangle_tests += 1;
        self.bytes += u64::from(crate::triangle::Triangle::WORDS) * 4;
    }

    #[inline(always)]
    fn push(&mut self, depth: u32) {
        self.pushes += 1;
        self.stack_depth = self.stack_depth.max(depth);
    }
}
