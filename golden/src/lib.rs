//! The specification: what a tree is, what its nodes mean bit for bit, and what a ray finds in it.
pub mod aabb;
pub mod build;
pub mod fp;
