//! What is found out with the crates of dualsplit: precision, stability, needs and fidelity.
//!
//! What the tool does, each of its commands, is a function here, which takes plain options and returns what was found;
//! [`progress`] says how far it is.

pub mod artifacts;
pub mod charts;
pub mod check;
pub mod compare;
pub mod drive;
pub mod estimation;
pub mod explain;
pub mod export;
pub mod fidelity;
pub mod input;
pub mod needs;
pub mod picture;
pub mod progress;
pub mod prove;
pub mod reproduce;
pub mod simulate;
pub mod stress;
pub mod study;
pub mod table;
pub mod trace;
pub mod trees;
pub mod walk;
pub mod wave;
pub mod work;
