//! Triangle meshes, cameras and lights: everything that a tree is built over and a picture is made of.
//!
//! Coordinates are right-handed with y up. Nothing in this crate depends on the platform's mathematics library, so a scene is
//! bit-identical on every machine.
//!
//! | module | what it holds |
//! |---|---|
//! | [`obj`] | Wavefront OBJ files, plain or compressed with xz |
//! | [`procedural`] | the built-in scenes |
//!
//! [`Scene::load`] takes the name of a built-in scene or the path of an OBJ file. [`MeshReport`] counts what may surprise in a mesh.
//!
//! ```
//! use scenes::{Scene, obj};
//!
//! let courtyard = Scene::load("courtyard", 0.001, 0)?;
//! assert!(courtyard.mesh.triangles.len() > 1000);
//!
//! let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
//! let mesh = obj::read(text.as_bytes(), "triangle.obj")?;
//! assert_eq!(mesh.triangles, [[0, 1, 2]]);
//!
//! let error = obj::read("v 0 0 0\nf 1 2 3\n".as_bytes(), "broken.obj").unwrap_err();
//! assert!(error.to_string().contains("broken.obj"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

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
