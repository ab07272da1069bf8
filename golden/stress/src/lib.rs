//! Inputs made to break ray traversal, and the exact answers to them: for tests, and for `dualsplit stress`.
//!
//! | module | what it holds |
//! |---|---|
//! | [`cases`] | 33 ways in which ray libraries are known to lose hits |
//! | [`aimed`] | endless rays with one hit known by construction |
//! | [`oracle`] | the exact nearest triangles of a ray |
//! | [`shapes`] | meshes |
//!
//! ```
//! use golden::Mode;
//! use golden::build::{BuildOptions, build};
//! use golden::dst::Dst;
//! use golden::structure::pack_triangles;
//! use golden::traverse::Trace;
//! use stress::{cases, oracle::Oracle};
//!
//! let case = &cases::closed_spheres()[0];
//! let tree = build(&case.mesh, &BuildOptions::default())?;
//! let dst = Dst::convert(&tree, pack_triangles(&case.mesh, &tree))?;
//! let oracle = Oracle::new(&case.mesh, &tree);
//! for ray in case.rays.iter().take(20) {
//!     let hit = dst.closest(ray, Mode::Robust).expect("a ray from inside hits a closed sphere");
//!     assert!(oracle.nearest(ray).contains(&hit.triangle));
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod aimed;
pub mod cases;
pub mod oracle;
pub mod shapes;

#[cfg(test)]
#[path = "../../golden/tests/support/strategies.rs"]
mod strategies;
