//! Trees with planes in a narrow format, and their traversal.

use super::{NarrowArithmetic, NarrowRay, Precision, Scale, Variant};
use crate::Aabb;
use crate::build::MAX_DEPTH;
use crate::bvh::{Bvh, BvhNode, INDEX, LEAF, box_step};
use crate::dst::header::{Header, LEAF_WORDS, NODE_WORDS};
use crate::dst::{Dst, Step, step};
use crate::ray::{Hit, TraversalRay};
use crate::structure::Structure;
use crate::traverse::query::Query;
use crate::traverse::stack::Stack;
use crate::traverse::{Tests, Trace, Traversal, dst_steps};
use fp::Rounding;

/// A structure `T` whose planes are numbers of a narrow format, in the format's units.
///
/// Rays have to be prepared in the mode of [`Variant::mode`]. Nodes keep the size and the addresses that they have in binary32.
#[derive(Clone, Debug)]
pub struct Narrow<T> {
    /// The structure; its planes are stored as binary32 numbers, which hold those of every format.
    pub structure: T,
    /// Format and rounding.
    pub precision: Precision,
    /// What planes have been multiplied by.
    pub scale: Scale,
    arithmetic: NarrowArithmetic,
}

/// A dual-split tree in a narrow format.
pub type NarrowDst = Narrow<Dst>;
/// A hierarchy of boxes in a narrow format.
pub type NarrowBvh<const N: usize> = Narrow<Bvh<N>>;

/// How planes become narrow.
#[derive(Clone, Copy)]
pub(super) struct Planes {
    pub arithmetic: NarrowArithmetic,
    pub scale: Scale,
    pub variant: Variant,
}

impl Planes {
    /// A plane on the min or max side of a box. Adding +0 keeps planes from being -0.
    pub fn plane(&self, plane: f32, is_min: bool) -> f32 {
        let rounding = match (self.variant, is_min) {
            (Variant::Naive, _) => Rounding::NearestEven,
            (Variant::Conservative, true) => Rounding::Down,
            (Variant::Conservative, false) => Rounding::Up,
        };
        self.arithmetic.round(self.scale.scaled(plane), rounding) + 0.0
    }

    fn aabb(&self, aabb: &Aabb) -> Aabb {
        Aabb { min: aabb.min.map(|p| self.plane(p, true)), max: aabb.max.map(|p| self.plane(p, false)) }
    }

    fn new(precision: Precision, root_box: &Aabb) -> Self {
        let arithmetic = NarrowArithmetic::new(precision.format, precision.subnormals);
        Self { arithmetic, scale: Scale::of_scene(root_box, precision.format), variant: precision.variant }
    }

    fn narrow<T>(&self, structure: T, precision: Precision) -> Narrow<T> {
        Narrow { structure, precision, scale: self.scale, arithmetic: self.arithmetic }
    }
}

impl<T> Narrow<T> {
    /// `ray` in this structure's format.
    #[must_use]
    pub fn ray(&self, ray: &TraversalRay) -> NarrowRay {
        NarrowRay::new(ray, self.arithmetic, self.scale, self.precision.variant)
    }

    /// A box of the scene as this structure would hold it.
    #[must_use]
    pub fn aabb(&self, bounds: &Aabb) -> Aabb {
        Planes { arithmetic: self.arithmetic, scale: self.scale, variant: self.precision.variant }
            .aabb(bounds)
    }
}

impl NarrowDst {
    /// Converts `dst`; the same nodes at the same offsets.
    #[must_use]
    pub fn new(dst: &Dst, precision: Precision) -> Self {
        let planes = Planes::new(precision, &dst.root_box);
        let mut words = dst.words().to_vec();
        let mut at = 0;
        while at < words.len() {
            let is_min = match Header::decode(words[at]) {
                Some(Header::Leaf { .. }) => {
                    at += LEAF_WORDS as usize;
                    continue;
                }
                Some(Header::CarveDual { is_min, .. }) => is_min,
                Some(Header::Split { .. } | Header::CarveSingle { .. }) | None => [false, true],
            };
            for (word, is_min) in words[at + 1..].iter_mut().zip(is_min) {
                *word = planes.plane(f32::from_bits(*word), is_min).to_bits();
            }
            at += NODE_WORDS as usize;
        }
        planes.narrow(Dst::new(planes.aabb(&dst.root_box), words, dst.triangles.clone()), precision)
    }

    /// The nearest hit with every node step executed by `step`: [`crate::dst::step()`], or hardware.
    pub fn closest_by_steps<O: Traversal>(
        &self,
        ray: &TraversalRay,
        observer: &mut O,
        step: impl FnMut([u32; 3], &NarrowRay, f32, f32) -> Step,
    ) -> Option<Hit> {
        let mut query = Query::<false>::new(ray, &self.structure.triangles);
        self.by_steps(&mut query, observer, step);
        query.hit()
    }

    fn traverse<const ANY: bool, O: Traversal>(&self, query: &mut Query<'_, ANY>, observer: &mut O) -> bool {
        self.by_steps(query, observer, step)
    }

    fn by_steps<const ANY: bool, O: Traversal>(
        &self,
        query: &mut Query<'_, ANY>,
        observer: &mut O,
        mut step: impl FnMut([u32; 3], &NarrowRay, f32, f32) -> Step,
    ) -> bool {
        let ray = self.ray(query.ray);
        let root = box_step(&self.structure.root_box, &ray, ray.t_min, ray.t_max);
        let step = |words, low, high| step(words, &ray, low, high);
        dst_steps::traverse(&self.structure, root, query, observer, step, |t| ray.limit(t))
    }
}

impl<const N: usize> NarrowBvh<N> {
    /// Converts `bvh`; the same nodes in the same order.
    #[must_use]
    pub fn new(bvh: &Bvh<N>, precision: Precision) -> Self {
        let planes = Planes::new(precision, &bvh.root_box);
        let nodes = bvh.nodes.iter().map(|n| BvhNode { word: n.word, aabb: planes.aabb(&n.aabb) }).collect();
        let root_box = planes.aabb(&bvh.root_box);
        let bvh = Bvh { root_box, root: bvh.root, nodes, triangles: bvh.triangles.clone() };
        planes.narrow(bvh, precision)
    }

    /// All children of a node are tested and visited in the order of their entries, equal ones in that of memory.
    fn traverse<const ANY: bool, O: Traversal>(&self, query: &mut Query<'_, ANY>, observer: &mut O) -> bool {
        let bvh = &self.structure;
        let ray = self.ray(query.ray);
        if !box_step(&bvh.root_box, &ray, ray.t_min, ray.t_max).hit {
            return false;
        }
        // A node leaves at most N - 1 siblings of each ancestor behind.
        let mut stack = Stack::<(u32, f32), { 7 * MAX_DEPTH as usize }>::new();
        let mut word = bvh.root;
        loop {
            let mut next = None;
            if LEAF.get(word) == 1 {
                if query.leaf(INDEX.get(word), observer) {
                    return true;
                }
            } else {
                let nearest = ray.limit(query.t_max);
                let mut hits = [(0u32, 0.0f32); N];
                let mut count = 0;
                for (i, child) in (INDEX.get(word)..).zip(bvh.children(word)) {
                    observer.node(i * BvhNode::WORDS, BvhNode::WORDS, Tests::Box);
                    let test = box_step(&child.aabb, &ray, ray.t_min, nearest);
                    if test.hit {
                        hits[count] = (child.word, test.t_entry);
                        count += 1;
                    }
                }
                // Farthest first, later in memory before earlier; entries are never NaN.
                hits[..count].reverse();
                hits[..count].sort_by(|a, b| b.1.total_cmp(&a.1));
                if let Some((nearest, others)) = hits[..count].split_last() {
                    for entry in others {
                        stack.push(*entry);
                        observer.push(stack.len());
                    }
                    next = Some(nearest.0);
                }
            }
            let nearest = ray.limit(query.t_max);
            while next.is_none() {
                let Some((other, t_entry)) = stack.pop() else {
                    return false;
                };
                observer.pop(t_entry > nearest);
                next = (t_entry <= nearest).then_some(other);
            }
            word = next.expect("the loop ends with a node");
        }
    }
}

macro_rules! trace {
    (impl [$($generics:tt)*] $type:ty) => {
        impl<$($generics)*> Trace for $type {
            fn closest_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
                let mut query = Query::<false>::new(ray, &self.structure.triangles);
                self.traverse(&mut query, observer);
                query.hit()
            }

            fn occluded_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
                let mut query = Query::<true>::new(ray, &self.structure.triangles);
                self.traverse(&mut query, observer)
            }
        }
    };
}

trace!(impl [] NarrowDst);
trace!(impl [const N: usize] NarrowBvh<N>);

/// A structure of any kind in a narrow format.
#[derive(Clone, Debug)]
pub enum NarrowStructure {
    /// Binary hierarchy of boxes.
    Bvh2(NarrowBvh<2>),
    /// Hierarchy of up to four boxes to a node.
    Bvh4(NarrowBvh<4>),
    /// Hierarchy of up to eight boxes to a node.
    Bvh8(NarrowBvh<8>),
    /// Dual-split tree.
    Dst(NarrowDst),
}

impl NarrowStructure {
    /// Converts `structure`; the same nodes in the same places.
    #[must_use]
    pub fn new(structure: &Structure, precision: Precision) -> Self {
        match structure {
            Structure::Bvh2(bvh) => Self::Bvh2(NarrowBvh::new(bvh, precision)),
            Structure::Bvh4(bvh) => Self::Bvh4(NarrowBvh::new(bvh, precision)),
            Structure::Bvh8(bvh) => Self::Bvh8(NarrowBvh::new(bvh, precision)),
            Structure::Dst(dst) => Self::Dst(NarrowDst::new(dst, precision)),
        }
    }

    /// A box of the scene and a ray as this structure would hold them.
    #[must_use]
    pub fn narrow(&self, bounds: &Aabb, ray: &TraversalRay) -> (Aabb, NarrowRay) {
        match self {
            Self::Bvh2(bvh) => (bvh.aabb(bounds), bvh.ray(ray)),
            Self::Bvh4(bvh) => (bvh.aabb(bounds), bvh.ray(ray)),
            Self::Bvh8(bvh) => (bvh.aabb(bounds), bvh.ray(ray)),
            Self::Dst(dst) => (dst.aabb(bounds), dst.ray(ray)),
        }
    }

    /// What planes have been multiplied by.
    #[must_use]
    pub fn scale(&self) -> Scale {
        match self {
            Self::Bvh2(bvh) => bvh.scale,
            Self::Bvh4(bvh) => bvh.scale,
            Self::Bvh8(bvh) => bvh.scale,
            Self::Dst(dst) => dst.scale,
        }
    }
}

impl Trace for NarrowStructure {
    fn closest_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
        match self {
            Self::Bvh2(bvh) => bvh.closest_prepared(ray, observer),
            Self::Bvh4(bvh) => bvh.closest_prepared(ray, observer),
            Self::Bvh8(bvh) => bvh.closest_prepared(ray, observer),
            Self::Dst(dst) => dst.closest_prepared(ray, observer),
        }
    }

    fn occluded_prepared<O: Traversal>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
        match self {
            Self::Bvh2(bvh) => bvh.occluded_prepared(ray, observer),
            Self::Bvh4(bvh) => bvh.occluded_prepared(ray, observer),
            Self::Bvh8(bvh) => bvh.occluded_prepared(ray, observer),
            Self::Dst(dst) => dst.occluded_prepared(ray, observer),
        }
    }
}
