//! What every other crate stands on: random bits that are the same on every machine, and files that appear whole or not
//! at all.

pub mod output;
pub mod split_mix;
