//! The traversal pipelines. Each is 8 cycles deep and takes one operation per cycle.
//!
//! | module | operation | INTADD | FPADD | FPMUL | FPMIN/MAX | FPCMP |
//! |---|---|---|---|---|---|---|
//! | [`DualSplitPipeline`], `C = 2` | dual-split step | 1 | 2 | 2 | 3 | 4 |
//! | [`DualSplitPipeline`], `C = 0` | the same, without redundant comparisons | 1 | 2 | 2 | 3 | 2 |
//! | [`RayBoxPipeline`], `C = 2` | ray-box test | | 6 | 6 | 12 | 2 |
//! | [`RayBoxPipeline`], `C = 1` | the same, without the redundant comparison | | 6 | 6 | 12 | 1 |
//! | [`RayBoxParallel`] | `K` ray-box tests | | 6 K | 6 K | 12 K | 2 K |
//! | [`SharedUnits`] | eight adders and multipliers, or one of the two | 1 | 8 | 8 | 15 | 6 |
//!
//! [`catalogue`] has every unit and pipeline by name. [`mod@formats`] has their types in each format, and [`words`] the words of
//! headers and return values.
//!
//! ```
//! use netlist::inventory;
//! use pipelines::catalogue::{StandardFormat, Top};
//!
//! let design = Top::DualSplit.design(StandardFormat::Binary32)?;
//! let inventory = inventory(&design)?;
//! assert_eq!(inventory.latency_cycles, Some(8));
//! assert_eq!((inventory.units["fp_add"], inventory.units["fp_mul"]), (2, 2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod catalogue;
mod dual_split;
mod dual_split_fold;
mod dual_split_select;
pub mod formats;
pub mod measured;
mod node_header;
mod notes;
pub mod ports;
mod ray_box;
mod ray_box_fold;
mod ray_box_parallel;
mod ray_box_select;
mod ray_select;
mod shared_units;
pub mod words;

pub use dual_split::DualSplitPipeline;
pub use ray_box::RayBoxPipeline;
pub use ray_box_parallel::RayBoxParallel;
pub use shared_units::SharedUnits;
#[doc(hidden)]
pub use units::in_format;

/// The source file of each kind of module, for what is exported with its comments.
pub const SOURCES: &[(&str, &str)] = &[
    ("dual_split", include_str!("dual_split.rs")),
    ("dual_split_fold", include_str!("dual_split_fold.rs")),
    ("dual_split_select", include_str!("dual_split_select.rs")),
    ("node_header", include_str!("node_header.rs")),
    ("ray_box", include_str!("ray_box.rs")),
    ("ray_box_fold", include_str!("ray_box_fold.rs")),
    ("ray_box_parallel", include_str!("ray_box_parallel.rs")),
    ("ray_box_select", include_str!("ray_box_select.rs")),
    ("ray_select", include_str!("ray_select.rs")),
    ("shared_units", include_str!("shared_units.rs")),
];

units::clocked! {
    DualSplitPipeline<E, S, W, X, R, N, P, C, T>,
    RayBoxPipeline<E, S, W, X, R, N, P, C, T>,
    RayBoxParallel<E, S, W, X, R, N, P, K, C, T>,
    SharedUnits<E, S, W, X, R, N, P, T>,
}
