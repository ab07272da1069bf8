//! Random designs and faulty units with their compiled simulations, on which the tests compare the engines.
//!
//! ```
//! let design = engines::random::design(1, 64);
//! assert_eq!(design.modules.len(), 4);
//! assert_eq!(design, engines::random::design(1, 64));
//! assert!(netlist::flatten(&design).is_ok());
//! ```

pub mod faults;
pub mod random;

/// Compiled simulations of [`random::design`], by seed.
#[allow(missing_docs, reason = "the table is generated")]
pub mod compiled_random {
    lanes::include_programs!("random");

    /// The text of the functions without vector instructions.
    pub const TEXT: &str = include_str!(concat!(env!("OUT_DIR"), "/scalar_random.rs"));
}

/// Compiled simulations of [`faults::faults`], by position.
#[allow(missing_docs, reason = "the table is generated")]
pub mod compiled_faults {
    lanes::include_programs!("faults");
}
