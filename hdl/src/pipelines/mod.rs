//! The traversal pipelines, each 8 cycles deep with one operation per cycle.
//!
//! | module | operation | INTADD | FPADD | FPMUL | FPMIN/MAX | FPCMP |
//! |---|---|---|---|---|---|---|
//! | [`DualSplitPipeline`], `C = 2` | dual-split step | 1 | 2 | 2 | 3 | 4 |
//! | [`DualSplitPipeline`], `C = 0` | the same, without redundant comparisons | 1 | 2 | 2 | 3 | 2 |
//! | [`RayBoxPipeline`], `C = 2` | ray-box test | | 6 | 6 | 12 | 2 |
//! | [`RayBoxPipeline`], `C = 1` | the same, without the redundant comparison | | 6 | 6 | 12 | 1 |

mod dual_split;
mod dual_split_fold;
mod dual_split_select;
mod node_header;
mod ray_box;
mod ray_box_fold;
mod ray_box_select;
mod ray_select;

pub use dual_split::DualSplitPipeline;
pub use ray_box::RayBoxPipeline;
