//! The specification: what a tree is, what its nodes mean bit for bit, and what a ray finds in it.
pub mod dst;
pub mod fp;
pub mod ray;
mod simd;
pub mod triangle;

pub use ray::{Hit, Mode, Ray, TraversalRay};
