//! What the checks across the crates share: netlists of the catalogue, and scenes with their trees.
//!
//! ```
//! use cross::netlist;
//! use equivalence::check;
//! use pipelines::catalogue::{StandardFormat, Top};
//!
//! let adder = netlist(Top::IntAdd);
//! assert_eq!(check(&adder, Top::IntAdd, StandardFormat::Binary32, 200, 1).mismatches, 0);
//! ```

use golden::build::{BuildOptions, build};
use golden::dst::Dst;
use golden::structure::pack_triangles;
use netlist::{Flat, flatten};
use pipelines::catalogue::{StandardFormat, Top};
use scenes::{Scene, procedural};

/// The flattened binary32 netlist of `top`.
///
/// # Panics
/// If it does not elaborate.
#[must_use]
pub fn netlist(top: Top) -> Flat {
    netlist_in(top, StandardFormat::Binary32)
}

/// The flattened netlist of `top` in `format`.
///
/// # Panics
/// If it does not elaborate.
#[must_use]
pub fn netlist_in(top: Top, format: StandardFormat) -> Flat {
    let design = top.design(format).unwrap_or_else(|error| panic!("{top} {format}: {error}"));
    flatten(&design).unwrap_or_else(|error| panic!("{top} {format}: {error}"))
}

/// A built-in scene with its dual-split tree.
///
/// # Panics
/// If the scene does not exist.
#[must_use]
pub fn scene(name: &str, detail: f64) -> (Scene, Dst) {
    let scene = procedural::build(name, detail, 0).expect("a built-in scene");
    let tree = build(&scene.mesh, &BuildOptions::default()).expect("a sound mesh");
    let dst = Dst::convert(&tree, pack_triangles(&scene.mesh, &tree)).expect("a small tree");
    (scene, dst)
}
