//! The specification: what a tree is, what its nodes mean bit for bit, and what a ray finds in it.
pub mod aabb;
pub mod build;
pub mod precision;
pub mod ray;
mod simd;
pub mod stats;
pub mod structure;
pub mod traverse;
pub mod tree_file;
pub mod triangle;

pub use aabb::Aabb;
pub use ray::{Hit, Mode, Ray, TraversalRay};
pub use structure::{bvh, dst};
