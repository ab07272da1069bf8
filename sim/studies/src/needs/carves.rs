//! The lengths of the chains of carve nodes that rays pass through.

use golden::dst::header::{CARVE, LEAF, OFFSET};
use golden::dst::{Dst, MAX_CARVES};
use golden::traverse::{Node, Observer};

/// Counts visits of carve nodes by the node's place in its chain. The first place is 0.
#[derive(Clone, Debug)]
pub struct CarveLevels<'a> {
    dst: &'a Dst,
    /// Visits by place in the chain.
    pub visits: [u64; MAX_CARVES],
    /// The child of the carve node visited last, and the place of that carve node.
    previous: Option<(u32, usize)>,
}

impl<'a> CarveLevels<'a> {
    /// Counts visits of `dst`.
    #[must_use]
    pub fn new(dst: &'a Dst) -> Self {
        Self { dst, visits: [0; MAX_CARVES], previous: None }
    }
}

impl Observer for CarveLevels<'_> {
    fn node(&mut self, node: &Node) {
        let offset = (node.address / 4) as u32;
        let header = self.dst.node(offset)[0];
        let is_carve = CARVE.get(header) == 1;
        // Where a carve node leads to another, the ray visits the two one after the other, unless it misses the first.
        let place = match self.previous {
            Some((target, place)) if is_carve && target == offset => place + 1,
            _ => 0,
        };
        if is_carve {
            self.visits[place.min(MAX_CARVES - 1)] += 1;
        }
        self.previous = (is_carve && LEAF.get(header) == 0).then(|| (OFFSET.get(header), place));
    }
}
