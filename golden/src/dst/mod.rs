//! Dual-split trees: node format, traversal step, construction.

pub mod header;
pub mod step;
