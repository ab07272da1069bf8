//! Inputs made to break ray traversal, and the exact answers to them: for tests, and for `dualsplit stress`.
//!
//! | module | what it holds |
//! |---|---|
//! | [`cases`] | 33 ways in which ray libraries are known to lose hits |
//! | [`aimed`] | endless rays of which one hit is known by construction |
//! | [`oracle`] | the exact nearest triangles of a ray |
//! | [`shapes`] | meshes |

pub mod aimed;
pub mod cases;
pub mod oracle;
pub mod shapes;

#[cfg(test)]
#[path = "../../golden/tests/support/strategies.rs"]
mod strategies;
