//! The hardware as gates against the word graph it comes from.

mod mapping;
mod proofs;
mod simulation;
