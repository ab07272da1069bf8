//! All leaves that a ray reaches, by the specification's steps and without early termination.

use crate::ray::TraversalRay;

/// A leaf, with the interval in which the ray is in its box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Leaf {
    /// Slot of its first triangle.
    pub first_triangle: u32,
    /// Where the ray enters its box.
    pub t_entry: f32,
    /// Where the ray leaves its box.
    pub t_exit: f32,
}

/// A structure whose leaves can be enumerated.
pub trait Leaves {
    /// Every leaf whose box, and all of whose ancestors' boxes, `ray` meets; in ascending order of first triangle.
    fn leaves(&self, ray: &TraversalRay) -> Vec<Leaf>;
}
