//! A ray in a narrow format.

use super::{NarrowArithmetic, Scale, Variant};
use crate::ray::{PlaneDistances, PlaneRay, TraversalRay};
use fp::Rounding;

/// A ray as the pipelines of a narrow format see it; coordinates and distances in the format's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NarrowRay {
    arithmetic: NarrowArithmetic,
    scale: Scale,
    variant: Variant,
    /// What is subtracted from the planes of entry: the bound of the origin that makes distances least.
    pub origin_entry: [f32; 3],
    /// What is subtracted from the planes of exit.
    pub origin_exit: [f32; 3],
    /// Reciprocals for planes where the ray enters; their sign bits say which side of a box is entered first.
    pub inv_entry: [f32; 3],
    /// Reciprocals for planes where the ray leaves.
    pub inv_exit: [f32; 3],
    /// Least distance.
    pub t_min: f32,
    /// Greatest distance.
    pub t_max: f32,
}

impl NarrowRay {
    /// `ray` in the format of `arithmetic`; `ray` is prepared in [`Variant::mode`].
    #[must_use]
    pub fn new(ray: &TraversalRay, arithmetic: NarrowArithmetic, scale: Scale, variant: Variant) -> Self {
        let planes = Self::of_planes(&ray.planes(), arithmetic, scale, variant);
        // Doubles hold 1/d closely enough: it is no 25-bit number unless d is a power of two, and then it is exact.
        let reciprocal = |k: usize| f64::from(ray.inv_entry[k]).signum() / f64::from(ray.direction[k].abs());
        let rounding = by(variant, Rounding::TowardZero);
        let inv_entry = std::array::from_fn(|k| arithmetic.round(reciprocal(k), rounding));
        Self {
            inv_entry,
            inv_exit: if variant == Variant::Naive { inv_entry } else { planes.inv_exit },
            t_min: planes.bound(ray.t_min),
            t_max: planes.limit(ray.t_max),
            ..planes
        }
    }

    /// A ray of which only what the pipelines get is known, without distances. A reciprocal for planes of entry may be off by its
    /// rounding to binary32, so the conservative variant takes the next one towards zero.
    #[must_use]
    pub fn of_planes(ray: &PlaneRay, arithmetic: NarrowArithmetic, scale: Scale, variant: Variant) -> Self {
        let keep = Rounding::NearestEven;
        let negative = |k: usize| ray.inv_entry[k].is_sign_negative();
        let round = |x: f32, r: Rounding| arithmetic.round(f64::from(x), by(variant, r));
        let inv_entry = |k: usize| match (variant, ray.inv_entry[k]) {
            (Variant::Naive, inv) => arithmetic.round(f64::from(inv), keep),
            (Variant::Conservative, inv) if inv.is_finite() => {
                round(f32::from_bits(inv.to_bits() - 1), Rounding::TowardZero)
            }
            (Variant::Conservative, inv) => inv,
        };
        let inv_exit =
            |k: usize| round(ray.inv_exit[k], if negative(k) { Rounding::Down } else { Rounding::Up });
        let origin = |k: usize, exit: bool| {
            let rounding = against(difference_rounding(negative(k), exit));
            arithmetic.round(scale.scaled(ray.origin[k]), by(variant, rounding))
        };
        Self {
            arithmetic,
            scale,
            variant,
            origin_entry: std::array::from_fn(|k| origin(k, false)),
            origin_exit: std::array::from_fn(|k| origin(k, true)),
            inv_entry: std::array::from_fn(inv_entry),
            inv_exit: std::array::from_fn(inv_exit),
            t_min: 0.0,
            t_max: f32::INFINITY,
        }
    }

    /// A distance in scene units that nothing before can be farther than, in the format's units.
    #[inline]
    #[must_use]
    pub fn bound(&self, t: f32) -> f32 {
        self.arithmetic.round(self.scale.scaled(t), by(self.variant, Rounding::Down))
    }

    /// A distance in scene units that nothing beyond can be nearer than, in the format's units.
    #[inline]
    #[must_use]
    pub fn limit(&self, t: f32) -> f32 {
        self.arithmetic.round(self.scale.scaled(t), by(self.variant, Rounding::Up))
    }

    #[inline(always)]
    fn distance(&self, difference: f32, inv: f32, rounding: Rounding) -> f32 {
        self.arithmetic.multiply(difference, inv, by(self.variant, rounding))
    }
}

impl PlaneDistances for NarrowRay {
    #[inline(always)]
    fn is_negative(&self, axis: usize) -> bool {
        self.inv_entry[axis].is_sign_negative()
    }

    #[inline]
    fn entry(&self, plane: f32, axis: usize) -> f32 {
        let rounding = by(self.variant, difference_rounding(self.is_negative(axis), false));
        let difference = self.arithmetic.subtract(plane, self.origin_entry[axis], rounding);
        self.distance(difference, self.inv_entry[axis], Rounding::Down)
    }

    #[inline]
    fn exit(&self, plane: f32, axis: usize) -> f32 {
        let rounding = by(self.variant, difference_rounding(self.is_negative(axis), true));
        let difference = self.arithmetic.subtract(plane, self.origin_exit[axis], rounding);
        self.distance(difference, self.inv_exit[axis], Rounding::Up)
    }
}

/// The direction in which `plane - origin` is rounded: down for a min plane, up for a max plane.
#[inline(always)]
fn difference_rounding(negative: bool, exit: bool) -> Rounding {
    if negative == exit { Rounding::Down } else { Rounding::Up }
}

/// What is subtracted is rounded against the difference.
fn against(rounding: Rounding) -> Rounding {
    if rounding == Rounding::Down { Rounding::Up } else { Rounding::Down }
}

/// `directed` for bounds, to nearest for the naive variant.
#[inline(always)]
fn by(variant: Variant, directed: Rounding) -> Rounding {
    match variant {
        Variant::Naive => Rounding::NearestEven,
        Variant::Conservative => directed,
    }
}
