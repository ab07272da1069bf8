//! Triangle meshes, cameras and lights: everything that a tree is built over and a picture is made of.
//!
//! Coordinates are right-handed with y up. Nothing in this crate depends on the platform's mathematics library, so a scene is
//! bit-identical on every machine.
//!
//! | module | what it holds |
//! |---|---|
//! | [`formats`] | files: OBJ, PLY, STL and glTF, plain or compressed with xz or gzip |
//! | [`procedural`] | the built-in scenes |
//!
//! [`Scene::load`] takes the name of a built-in scene or the path of a file. [`load`] also tells what it found: [`LoadReport`]
//! counts what may surprise. A file `NAME.view.toml` beside a mesh `NAME.obj` holds its camera.
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

pub mod formats;
mod frame;
mod load;
mod mesh;
pub mod procedural;
mod report;
mod view;

pub use formats::polygons::PolygonCounts;
pub use formats::report::{FileReport, Skip, Skipped};
pub use formats::{Format, obj};
pub use frame::frame;
pub use load::{Loaded, SceneError, load};
pub use mesh::{Bounds, Camera, MAX_COORDINATE, MAX_TRIANGLES, Mesh, PointLight, Scene};
pub use report::{LoadReport, MeshReport};
pub use view::ViewError;
