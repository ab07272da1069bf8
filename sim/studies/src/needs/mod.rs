//! The least hardware that a scene needs: bits, stack, addresses, carve levels, cache and multiprocessors.
//!
//! Bits come from tracing the scene's rays in narrower formats ([`crate::charts::precision`]), the cache from the reuse
//! distances of what golden's traversal reads ([`reuse`]), the number of multiprocessors from a bound on traffic
//! ([`memory`]). A quantity with no sharp limit is read off at the knee of its curve ([`knee`]).

pub mod carves;
mod files;
pub mod knee;
pub mod memory;
pub mod reuse;
pub mod study;
