//! Every module in rust-hdl's own simulator, which executes the kernels' text, against golden and outside oracles.

mod narrow_pipelines;
mod one_cycle_units;
mod pipelines;
mod shared_units;
mod structure;
mod testfloat;
mod traversal;
mod two_cycle_units;

mod support {
    pub mod harness;
    pub mod oracles;
    pub use equivalence::cases as steps;
}
