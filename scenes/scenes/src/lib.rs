//! Triangle meshes, cameras and lights: everything that a tree is built over and a picture is made of.
//!
//! Coordinates are right-handed with y up. Nothing in this crate depends on the platform's mathematics
//! library, so that a scene is bit-identical on every machine.

mod frame;
mod load;
mod mesh;
pub mod obj;
pub mod procedural;
mod report;

pub use frame::frame;
pub use load::SceneError;
pub use mesh::{Bounds, Camera, MAX_COORDINATE, MAX_TRIANGLES, Mesh, PointLight, Scene};
pub use report::MeshReport;
