//! Triangle meshes, cameras and lights: everything that a tree is built over and a picture is made of.
//!
//! Coordinates are right-handed with y up. Nothing in this crate depends on the platform's mathematics
//! library, so that a scene is bit-identical on every machine.

mod mesh;

pub use mesh::{Camera, Mesh, PointLight, Scene};
