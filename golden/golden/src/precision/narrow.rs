//! Structures with planes in a narrow format.

use super::{NarrowArithmetic, NarrowRay, Precision, Scale, Variant};
use crate::Aabb;
use crate::dst::{Child, Dst, Step, step};
use crate::ray::{Hit, PlaneRay, TraversalRay};
use crate::structure::StructureFormat;
use crate::traverse::query::Query;
use crate::traverse::{Observer, Trace};
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

/// How planes become narrow.
#[derive(Clone, Copy)]
pub struct Planes {
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

    /// A box with its planes rounded outward, or to nearest.
    pub fn aabb(&self, aabb: &Aabb) -> Aabb {
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
    /// The box of everything in scene units.
    #[must_use]
    pub fn scene_box(&self) -> Aabb {
        let unscaled = |x: f32| self.scale.unscaled(x) as f32;
        let Aabb { min, max } = self.structure.root_box;
        Aabb { min: min.map(unscaled), max: max.map(unscaled) }
    }

    /// The step of this format's pipeline, where everything around it is in binary32 and in scene units: the node's `words` hold
    /// planes of this format, `ray` and the interval become narrow on the way in.
    #[must_use]
    pub fn step(&self, words: [u32; 3], ray: &PlaneRay, [t_min, t_max]: [f32; 2]) -> Step {
        let ray = NarrowRay::of_planes(ray, self.arithmetic, self.scale, self.precision.variant);
        let step = step(words, &ray, ray.bound(t_min), ray.limit(t_max));
        let unscaled = |t: f32| self.scale.unscaled(t) as f32;
        let child =
            |child: Child| Child { t_min: unscaled(child.t_min), t_max: unscaled(child.t_max), ..child };
        Step { near: child(step.near), far: child(step.far), ..step }
    }
}

impl<T: StructureFormat> Narrow<T> {
    /// Converts `structure`; the same nodes in the same places.
    #[must_use]
    pub fn new(structure: &T, precision: Precision) -> Self {
        let planes = Planes::new(precision, structure.memory().root_box);
        planes.narrow(structure.rounded(&planes), precision)
    }
}

impl<T: StructureFormat> Trace for Narrow<T> {
    fn closest_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> Option<Hit> {
        let mut query = Query::<false>::new(ray, self.structure.memory().triangles);
        T::traverse_narrow(self, &mut query, observer);
        query.hit()
    }

    fn occluded_prepared<O: Observer>(&self, ray: &TraversalRay, observer: &mut O) -> bool {
        let mut query = Query::<true>::new(ray, self.structure.memory().triangles);
        T::traverse_narrow(self, &mut query, observer)
    }
}
