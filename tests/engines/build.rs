//! Writes the simulations of random designs and of faulty units.

#[path = "src/faults.rs"]
mod faults;
#[path = "src/random.rs"]
mod random;

use codegen::Programs;
use std::path::Path;

/// Random designs.
const RANDOM_DESIGNS: u64 = 12;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=src");
    let folder = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    let folder = Path::new(&folder);

    let mut randoms = Programs::default();
    for seed in 0..RANDOM_DESIGNS {
        randoms.add(&random::design(seed, 64), &seed.to_string(), false);
    }
    randoms.write(folder, "random", "u64");

    let mut faulty = Programs::default();
    for (position, fault) in faults::faults().into_iter().enumerate() {
        faulty.add(&faults::design(fault), &position.to_string(), false);
    }
    faulty.write(folder, "faults", "usize");
}
