//! The least hardware that a scene needs: bits, stack, addresses, carve levels, cache and multiprocessors.
//!
//! The number of bits comes from tracing the scene's rays in narrower formats ([`crate::charts::precision`]). The size of the
//! cache comes from the reuse distances of the lines that golden's traversal reads ([`reuse`]). The number of multiprocessors comes
//! from a bound on traffic ([`memory`]). A quantity without a sharp limit is read off at the knee of its curve ([`knee`]).

pub mod carves;
mod files;
pub mod knee;
pub mod memory;
pub mod reuse;
pub mod study;
