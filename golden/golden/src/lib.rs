//! The specification: what a tree is, what its nodes mean bit for bit, and what a ray finds in it.
//!
//! | module | what it holds |
//! |---|---|
//! | [`aabb`] | boxes, which are exact unions of what they enclose |
//! | [`mod@build`] | the binary hierarchy over a mesh, from which every structure is converted |
//! | [`bvh`], [`qbvh`], [`dst`] | nodes of bounding volume hierarchies and of dual-split trees: formats, one traversal step, validation |
//! | [`structure`] | all structures behind one name |
//! | [`ray`] | rays, robust and fast mode, and the proof that robust mode loses nothing |
//! | [`triangle`] | the exact triangle test |
//! | [`traverse`] | closest and any hit in every structure |
//! | [`precision`] | traversal in narrower formats |
//! | [`stats`], [`tree_file`] | sizes and costs of a structure; structures on disk |
//!
//! A dual-split tree over someone's triangles, and a ray through it:
//!
//! ```
//! use golden::build::{BuildOptions, build};
//! use golden::dst::Dst;
//! use golden::structure::pack_triangles;
//! use golden::traverse::Trace;
//! use golden::{Mode, Ray};
//! use scenes::Mesh;
//!
//! // A square of two triangles in the plane z = 2.
//! let mesh = Mesh {
//!     positions: vec![[0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [1.0, 1.0, 2.0], [0.0, 1.0, 2.0]],
//!     triangles: vec![[0, 1, 2], [0, 2, 3]],
//! };
//! let tree = build(&mesh, &BuildOptions::default())?;
//! let dst = Dst::convert(&tree, pack_triangles(&mesh, &tree))?;
//!
//! // The ray meets the edge that both triangles share: robust mode has no gap there, and the lower index wins.
//! let ray = Ray::new([0.5, 0.5, 0.0], [0.0, 0.0, 1.0]);
//! let hit = dst.closest(&ray, Mode::Robust).expect("the square is in the way");
//! assert_eq!((hit.t, hit.triangle), (2.0, 0));
//! assert!(!dst.occluded(&Ray { t_max: 1.5, ..ray }, Mode::Robust));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

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
pub use structure::{bvh, dst, qbvh};

/// The example in the README, which is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
pub struct Readme;
