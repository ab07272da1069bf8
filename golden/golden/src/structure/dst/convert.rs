//! From a binary hierarchy to the dual-split tree with the same boxes.
//!
//! For every inner node and each axis, the child whose centre is lower becomes the left one, and the split stores the left
//! child's max and the right child's min plane. Each half is cut down to its child's box by a chain of at most three
//! carve nodes, two planes each: a half shares at least one of its six planes with the child. Among all axes that need
//! the fewest carve nodes, pairings of the missing planes and orders of the chain, the cheapest is taken:
//!
//! ```text
//! cost = area(parent) + sum over the carve nodes of both chains of area(what is left when it is visited)
//! ```
//!
//! which is the expected number of node visits of a ray that meets the parent, as for every other node of the tree.
//! Ties go to the lower axis and to the pairing that is enumerated first.

use super::Dst;
use super::header::{Header, LEAF_WORDS, NODE_WORDS, OFFSET, OFFSET_LIMIT};
use crate::Aabb;
use crate::build::{BinaryTree, Content};
use crate::structure::TooLarge;
use crate::triangle::Triangle;
use std::sync::Arc;

/// The most carve nodes between a split and its child: five planes, two to a node.
pub const MAX_CARVES: usize = 3;

/// One side of a box that a carve moves: the axis, and whether it is the min side.
type Side = (usize, bool);

/// A carve node's two sides.
#[derive(Clone, Copy)]
struct Carve(Side, Side);

#[derive(Clone, Copy)]
struct Chain {
    carves: [Carve; MAX_CARVES],
    len: usize,
    cost: f64,
}

impl Dst {
    /// Converts `tree`; `triangles` are its primitives in order.
    ///
    /// # Errors
    /// [`TooLarge`] if an offset or a triangle index exceeds 26 bits.
    pub fn convert(tree: &BinaryTree, triangles: Arc<[Triangle]>) -> Result<Self, TooLarge> {
        if triangles.len() > OFFSET_LIMIT as usize {
            return Err(too_large(triangles.len() as u64));
        }
        let root = &tree.nodes[0];
        // Two words of planes to a split, about two carves to a split, are 18 words to an inner node.
        let mut writer = Writer { tree, words: Vec::with_capacity(tree.nodes.len() * 5 + 1) };
        let record = Record { chain: None, region: root.aabb, node: 0 };
        let at = writer.reserve(&record);
        writer.write(record, at)?;
        Ok(Dst::new(root.aabb, writer.words, triangles))
    }
}

/// What lies at a child's place: a chain of carves, a split or a leaf.
struct Record {
    chain: Option<Chain>,
    /// The box that the ray is known to be in on arrival.
    region: Aabb,
    node: usize,
}

struct Writer<'a> {
    tree: &'a BinaryTree,
    words: Vec<u32>,
}

impl Writer<'_> {
    /// Makes room for the first node of `record` and returns its offset.
    fn reserve(&mut self, record: &Record) -> usize {
        let at = self.words.len();
        self.words.resize(at + self.record_words(record) as usize, 0);
        at
    }

    fn record_words(&self, record: &Record) -> u32 {
        let is_leaf = matches!(self.tree.nodes[record.node].content, Content::Leaf { .. });
        if record.chain.is_none() && is_leaf { LEAF_WORDS } else { NODE_WORDS }
    }

    /// Writes `record` at offset `at` and all that is below it after the end.
    fn write(&mut self, record: Record, at: usize) -> Result<(), TooLarge> {
        let node = &self.tree.nodes[record.node];
        let mut at = at;
        let mut region = record.region;
        let chain = record.chain.as_ref().map_or(&[][..], |chain| &chain.carves[..chain.len]);
        for (i, carve) in chain.iter().enumerate() {
            let planes = carve.apply(&mut region, &node.aabb);
            if let (Content::Leaf { first_primitive, .. }, true) = (node.content, i + 1 == chain.len()) {
                self.put(at, carve.header(true, first_primitive), planes);
                return Ok(());
            }
            let child = self.words.len();
            self.words.resize(child + NODE_WORDS as usize, 0);
            self.put(at, carve.header(false, checked_offset(child, 0)?), planes);
            at = child;
        }
        match node.content {
            Content::Leaf { first_primitive, .. } => {
                self.words[at] = Header::Leaf { first_triangle: first_primitive }.encode();
                Ok(())
            }
            Content::Inner { first_child, .. } => self.write_split(&node.aabb, first_child as usize, at),
        }
    }

    fn write_split(&mut self, parent: &Aabb, first_child: usize, at: usize) -> Result<(), TooLarge> {
        let boxes = [self.tree.nodes[first_child].aabb, self.tree.nodes[first_child + 1].aabb];
        let plan = Plan::best(parent, &boxes);
        let [left, right] = plan.order;
        let regions = halves(parent, plan.axis, &boxes[left], &boxes[right]);
        let record = |child: usize, side: usize| Record {
            chain: (plan.chains[side].len > 0).then_some(plan.chains[side]),
            region: regions[side],
            node: first_child + child,
        };
        let (left_record, right_record) = (record(left, 0), record(right, 1));
        let left_words = self.record_words(&left_record);
        let left_at = self.reserve(&left_record);
        let right_at = self.reserve(&right_record);
        let offset = checked_offset(left_at, left_words)?;
        let header = Header::Split { axis: plan.axis as u32, left_words, offset };
        self.put(at, header, [boxes[left].max[plan.axis], boxes[right].min[plan.axis]]);
        self.write(left_record, left_at)?;
        self.write(right_record, right_at)
    }

    fn put(&mut self, at: usize, header: Header, planes: [f32; 2]) {
        self.words[at] = header.encode();
        self.words[at + 1] = planes[0].to_bits();
        self.words[at + 2] = planes[1].to_bits();
    }
}

/// `offset` as a header's field; the right child at `offset + left_words` has to fit too.
fn checked_offset(offset: usize, left_words: u32) -> Result<u32, TooLarge> {
    let end = offset as u64 + u64::from(left_words);
    if end < u64::from(OFFSET_LIMIT) { Ok(offset as u32) } else { Err(too_large(end)) }
}

fn too_large(words: u64) -> TooLarge {
    TooLarge { structure: "dual-split tree", words, bits: OFFSET.width as u32 }
}

/// The halves of `parent` left of the left child's max plane and right of the right child's min plane.
fn halves(parent: &Aabb, axis: usize, left: &Aabb, right: &Aabb) -> [Aabb; 2] {
    let mut halves = [*parent; 2];
    halves[0].max[axis] = left.max[axis];
    halves[1].min[axis] = right.min[axis];
    halves
}

/// How a node is split and its halves carved.
pub(super) struct Plan {
    axis: usize,
    /// Which child is the left one, which the right one.
    order: [usize; 2],
    chains: [Chain; 2],
}

impl Plan {
    /// Expected visits of carve nodes, times the area of the parent.
    pub(super) fn cost(&self) -> f64 {
        self.chains[0].cost + self.chains[1].cost
    }

    pub(super) fn best(parent: &Aabb, boxes: &[Aabb; 2]) -> Plan {
        let carves = carves_by_axis(parent, boxes);
        let fewest = carves[0].min(carves[1]).min(carves[2]);
        let mut best: Option<(f64, Plan)> = None;
        for axis in (0..3).filter(|axis| carves[*axis] == fewest) {
            let order = left_to_right(boxes, axis);
            let regions = halves(parent, axis, &boxes[order[0]], &boxes[order[1]]);
            let left = Chain::best(&regions[0], &boxes[order[0]]);
            let right = Chain::best(&regions[1], &boxes[order[1]]);
            let cost = left.cost + right.cost;
            if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                best = Some((cost, Plan { axis, order, chains: [left, right] }));
            }
        }
        best.expect("one has the fewest").1
    }
}

/// The fewest carve nodes with which the halves of `parent` are cut down to `boxes`, over all split axes.
pub(crate) fn fewest_carves(parent: &Aabb, boxes: &[Aabb; 2]) -> u32 {
    let [x, y, z] = carves_by_axis(parent, boxes);
    x.min(y).min(z)
}

/// The number of carve nodes for each split axis: half as many as sides that neither the parent nor the split gives.
fn carves_by_axis(parent: &Aabb, boxes: &[Aabb; 2]) -> [u32; 3] {
    let differs = |a: [f32; 3], b: [f32; 3]| [0, 1, 2].map(|i| u32::from(a[i].to_bits() != b[i].to_bits()));
    let min = boxes.map(|b| differs(b.min, parent.min));
    let max = boxes.map(|b| differs(b.max, parent.max));
    let sides = [0, 1].map(|i| min[i].iter().sum::<u32>() + max[i].iter().sum::<u32>());
    [0, 1, 2].map(|axis| {
        let [left, right] = left_to_right(boxes, axis);
        (sides[left] - max[left][axis]).div_ceil(2) + (sides[right] - min[right][axis]).div_ceil(2)
    })
}

/// The indices of the children with the lower and the higher centre on `axis`; equal ones stay in order.
fn left_to_right(boxes: &[Aabb; 2], axis: usize) -> [usize; 2] {
    let centre = |b: &Aabb| f64::from(b.min[axis]) + f64::from(b.max[axis]);
    if centre(&boxes[0]) <= centre(&boxes[1]) { [0, 1] } else { [1, 0] }
}

impl Chain {
    const EMPTY: Chain = Chain { carves: [Carve((0, false), (0, true)); MAX_CARVES], len: 0, cost: 0.0 };

    /// The cheapest chain that cuts `region` down to `target`.
    fn best(region: &Aabb, target: &Aabb) -> Chain {
        let mut sides = [(0, false); 6];
        let mut count = 0;
        for axis in 0..3 {
            for (is_min, differs) in [
                (true, region.min[axis].to_bits() != target.min[axis].to_bits()),
                (false, region.max[axis].to_bits() != target.max[axis].to_bits()),
            ] {
                if differs {
                    sides[count] = (axis, is_min);
                    count += 1;
                }
            }
        }
        Self::search(region, target, &sides[..count])
    }

    /// Tries every pair, or where an odd number is left every single side, as the first carve.
    fn search(region: &Aabb, target: &Aabb, sides: &[Side]) -> Chain {
        let cost = if sides.is_empty() { 0.0 } else { region.half_area() };
        match *sides {
            [] => Chain::EMPTY,
            [only] => Chain::one(Carve(only, (only.0, !only.1)), cost),
            [first, second] => Chain::one(Carve(first, second), cost),
            _ => {
                let mut best: Option<Chain> = None;
                let singles = sides.len() % 2 == 1;
                for i in 0..sides.len() {
                    let alone = singles.then_some(i);
                    for j in (i + 1..sides.len()).chain(alone) {
                        let carve = if i == j {
                            Carve(sides[i], (sides[i].0, !sides[i].1))
                        } else {
                            Carve(sides[i], sides[j])
                        };
                        let mut rest = [(0, false); 6];
                        let mut count = 0;
                        for (k, side) in sides.iter().enumerate() {
                            if k != i && k != j {
                                rest[count] = *side;
                                count += 1;
                            }
                        }
                        let mut inner = *region;
                        carve.apply(&mut inner, target);
                        let tail = Self::search(&inner, target, &rest[..count]);
                        let total = cost + tail.cost;
                        if best.as_ref().is_none_or(|b| total < b.cost) {
                            best = Some(tail.after(carve, total));
                        }
                    }
                }
                best.expect("there are sides")
            }
        }
    }

    fn one(carve: Carve, cost: f64) -> Chain {
        Chain { carves: [carve; MAX_CARVES], len: 1, cost }
    }

    fn after(mut self, first: Carve, cost: f64) -> Chain {
        self.carves.copy_within(..MAX_CARVES - 1, 1);
        self.carves[0] = first;
        Chain { carves: self.carves, len: self.len + 1, cost }
    }
}

impl Carve {
    /// Moves this carve's sides of `region` to those of `target`, and returns the two planes in storage order.
    ///
    /// Where only one side of an axis is to be cut, the other is in place already: it stores the parent's own plane.
    fn apply(self, region: &mut Aabb, target: &Aabb) -> [f32; 2] {
        self.stored().map(|(axis, is_min)| {
            if is_min {
                region.min[axis] = target.min[axis];
                target.min[axis]
            } else {
                region.max[axis] = target.max[axis];
                target.max[axis]
            }
        })
    }

    /// The sides in storage order: max before min on a single axis, the lower axis first otherwise.
    fn stored(self) -> [Side; 2] {
        let Carve(a, b) = self;
        let swap = if a.0 == b.0 { a.1 } else { a.0 > b.0 };
        if swap { [b, a] } else { [a, b] }
    }

    fn header(self, leaf: bool, offset: u32) -> Header {
        let [a, b] = self.stored();
        if a.0 == b.0 {
            Header::CarveSingle { axis: a.0 as u32, leaf, offset }
        } else {
            Header::CarveDual { axes: [a.0 as u32, b.0 as u32], is_min: [a.1, b.1], leaf, offset }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn aabb() -> impl Strategy<Value = Aabb> {
        prop::array::uniform2(prop::array::uniform3(-2i8..=2))
            .prop_map(|points| Aabb::of_points(&points.map(|p| p.map(f32::from))))
    }

    proptest! {
        #[test]
        fn plans_have_the_fewest_carves_and_give_both_boxes(boxes in [aabb(), aabb()]) {
            let parent = boxes[0].union(boxes[1]);
            let plan = Plan::best(&parent, &boxes);
            let carves: usize = plan.chains.iter().map(|chain| chain.len).sum();
            prop_assert_eq!(carves as u32, fewest_carves(&parent, &boxes));
            let [left, right] = plan.order.map(|child| boxes[child]);
            let regions = halves(&parent, plan.axis, &left, &right);
            for ((mut region, target), chain) in regions.into_iter().zip([left, right]).zip(plan.chains) {
                for carve in &chain.carves[..chain.len] {
                    carve.apply(&mut region, &target);
                }
                prop_assert_eq!(region.to_bits(), target.to_bits());
            }
            // No other order of the axes does better: the two planes of the split are the only ones that are free.
            let new = |b: &Aabb| b.to_bits().iter().zip(parent.to_bits()).filter(|(a, b)| **a != *b).count();
            let planes = new(&boxes[0]) + new(&boxes[1]);
            prop_assert!(2 * carves + 2 >= planes);
        }
    }
}
