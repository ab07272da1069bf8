//! The traversal of one ray step by step, as the specification's steps take it.

use golden::bvh::{Bvh2, INDEX, LEAF, box_step};
use golden::dst::header::{Header, OFFSET, SIZE};
use golden::dst::{Code, Dst, step};
use golden::triangle::{Triangle, TriangleTest};
use golden::{Hit, TraversalRay};
use serde::Serialize;

/// What happens; distances are along the ray's scaled direction.
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
    /// A dual-split node is visited.
    Node {
        /// Word offset of the node.
        offset: u32,
        /// The decoded header.
        header: String,
        /// The planes that it tests.
        planes: Vec<f32>,
        /// Where the ray's part begins on arrival.
        t_min: f32,
        /// Where it ends.
        t_max: f32,
        /// What survives.
        outcome: String,
    },
    /// A BVH node's box is tested.
    Box {
        /// Number of the node in memory.
        node: u32,
        /// Whether it is a leaf.
        leaf: bool,
        /// Whether the ray meets it.
        hit: bool,
        /// Where the ray enters it.
        t_entry: f32,
        /// Where the ray leaves it, or its best hit.
        t_exit: f32,
    },
    /// A node waits on the stack.
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
        /// Whether it begins beyond the best hit and is thrown away.
        discarded: bool,
    },
    /// A triangle is tested.
    Triangle {
        /// Place in the structure's triangle array.
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
    /// What happened, in order.
    pub steps: Vec<Step>,
    /// What was found.
    pub hit: Option<Hit>,
}

/// Walks through a dual-split tree.
///
/// # Panics
/// If the tree is not valid.
#[must_use]
pub fn walk_dst(dst: &Dst, ray: &TraversalRay) -> Walk {
    let mut log = Log::new(ray, &dst.triangles);
    let root = box_step(&dst.root_box, ray, ray.t_min, ray.t_max);
    log.steps.push(Step::Root { hit: root.hit, t_entry: root.t_entry, t_exit: root.t_exit });
    let mut stack = vec![];
    let mut next = root.hit.then_some((0, root.t_entry, root.t_exit));
    while let Some((offset, t_min, t_max)) = next {
        let words = dst.node(offset);
        let outcome = step(words, ray, t_min, t_max);
        let (near, far) = (outcome.near, outcome.far);
        let header = Header::decode(words[0]).expect("a valid tree");
        let planes = if matches!(header, Header::Leaf { .. }) { 0 } else { 2 };
        log.steps.push(Step::Node {
            offset,
            header: describe(header, words[0]),
            planes: words[1..1 + planes].iter().map(|word| f32::from_bits(*word)).collect(),
            t_min,
            t_max,
            outcome: match outcome.code {
                Code::Miss => "nothing".to_owned(),
                Code::One => format!("@{} [{}, {}]", near.offset, near.t_min, near.t_max),
                Code::Two => format!(
                    "@{} [{}, {}] then @{} [{}, {}]",
                    near.offset, near.t_min, near.t_max, far.offset, far.t_min, far.t_max
                ),
                Code::Leaf => format!("leaf at {} [{}, {}]", near.offset, near.t_min, near.t_max),
            },
        });
        next = match outcome.code {
            Code::One => Some((near.offset, near.t_min, near.t_max)),
            Code::Two => {
                stack.push((far.offset, far.t_min, far.t_max));
                log.steps.push(Step::Push {
                    offset: far.offset,
                    t_min: far.t_min,
                    depth: stack.len() as u32,
                });
                Some((near.offset, near.t_min, near.t_max))
            }
            Code::Leaf => {
                log.leaf(near.offset);
                None
            }
            Code::Miss => None,
        };
        while next.is_none() {
            let Some((offset, t_min, t_max)) = stack.pop() else { break };
            let discarded = t_min > log.t_max;
            log.steps.push(Step::Pop { offset, discarded });
            if !discarded {
                next = Some((offset, t_min, t_max.min(log.t_max)));
            }
        }
    }
    log.finish()
}

/// Walks through a binary hierarchy of boxes.
///
/// # Panics
/// If the hierarchy is not valid.
#[must_use]
pub fn walk_bvh2(bvh: &Bvh2, ray: &TraversalRay) -> Walk {
    let mut log = Log::new(ray, &bvh.triangles);
    let root = box_step(&bvh.root_box, ray, ray.t_min, ray.t_max);
    log.steps.push(Step::Root { hit: root.hit, t_entry: root.t_entry, t_exit: root.t_exit });
    let mut stack: Vec<(u32, f32)> = vec![];
    let mut next = root.hit.then_some(bvh.root);
    while let Some(word) = next.take() {
        if LEAF.get(word) == 1 {
            log.leaf(INDEX.get(word));
        } else {
            let mut hit = vec![];
            for (node, child) in (INDEX.get(word)..).zip(bvh.children(word)) {
                let test = box_step(&child.aabb, ray, ray.t_min, log.t_max);
                let (t_entry, t_exit) = (test.t_entry, test.t_exit);
                let leaf = LEAF.get(child.word) == 1;
                log.steps.push(Step::Box { node, leaf, hit: test.hit, t_entry, t_exit });
                if test.hit {
                    hit.push((child.word, t_entry));
                }
            }
            // Stable: children at equal distance are visited in the order of memory.
            hit.sort_by(|a, b| a.1.total_cmp(&b.1));
            for &(word, t_min) in hit.iter().skip(1).rev() {
                stack.push((word, t_min));
                let depth = stack.len() as u32;
                log.steps.push(Step::Push { offset: INDEX.get(word), t_min, depth });
            }
            next = hit.first().map(|(word, _)| *word);
        }
        while next.is_none() {
            let Some((word, t_min)) = stack.pop() else { break };
            let discarded = t_min > log.t_max;
            log.steps.push(Step::Pop { offset: INDEX.get(word), discarded });
            if !discarded {
                next = Some(word);
            }
        }
    }
    log.finish()
}

fn describe(header: Header, word: u32) -> String {
    let axis = |axis: u32| ["x", "y", "z"][axis as usize];
    let end = |leaf: bool, offset: u32| {
        if leaf { format!("leaf at {offset}") } else { format!("child @{offset}") }
    };
    match header {
        Header::Split { axis: a, .. } => {
            let left = OFFSET.get(word);
            format!("split {}, left @{left}, right @{}", axis(a), left + SIZE.get(word))
        }
        Header::CarveSingle { axis: a, leaf, offset } => {
            format!("carve {0} max, {0} min, {1}", axis(a), end(leaf, offset))
        }
        Header::CarveDual { axes, is_min, leaf, offset } => {
            let side = |i: usize| if is_min[i] { "min" } else { "max" };
            let (first, second) = (axis(axes[0]), axis(axes[1]));
            format!("carve {first} {}, {second} {}, {}", side(0), side(1), end(leaf, offset))
        }
        Header::Leaf { first_triangle } => end(true, first_triangle),
    }
}

struct Log<'a> {
    ray: &'a TraversalRay,
    test: TriangleTest,
    triangles: &'a [Triangle],
    steps: Vec<Step>,
    /// Distance of the best hit, at first the end of the ray.
    t_max: f32,
    best: Option<Hit>,
}

impl<'a> Log<'a> {
    fn new(ray: &'a TraversalRay, triangles: &'a [Triangle]) -> Self {
        Self { ray, test: TriangleTest::new(ray), triangles, steps: vec![], t_max: ray.t_max, best: None }
    }

    fn leaf(&mut self, first: u32) {
        for (slot, packed) in (first..).zip(&self.triangles[first as usize..]) {
            let triangle = packed.index();
            let found = self.test.intersect(self.ray, packed, self.t_max);
            let best = found.filter(|hit| self.best.is_none_or(|b| hit.t < b.t || triangle < b.triangle));
            self.steps.push(Step::Triangle {
                slot,
                triangle,
                t: found.map(|hit| hit.t),
                best: best.is_some(),
            });
            if let Some(hit) = best {
                self.t_max = hit.t;
                self.best = Some(Hit { t: hit.t, u: hit.u, v: hit.v, triangle });
            }
            if packed.is_last() {
                break;
            }
        }
    }

    fn finish(self) -> Walk {
        let given = |hit: Hit| Hit { t: self.ray.given_t(hit.t), ..hit };
        Walk { hit: self.best.map(given), steps: self.steps }
    }
}

#[cfg(test)]
mod tests;
