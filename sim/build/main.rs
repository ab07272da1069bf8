//! Writes the compiled simulation: Rust text for every top of the catalogue that it covers, and for random designs and
//! faulty units that the tests compare with the other engines.

mod emit;
#[path = "../src/logic/faults.rs"]
mod faults;
mod flush;
mod idioms;
mod program;
#[path = "../src/logic/random.rs"]
mod random;
mod reduce;
mod unit;

use hdl::catalogue::{StandardFormat, Top};
use program::Programs;
use std::path::Path;

/// Formats whose tops are compiled; the interpreter takes the others.
const FORMATS: [StandardFormat; 2] = [StandardFormat::Binary32, StandardFormat::Binary16];

/// Random designs for the tests.
const RANDOM_DESIGNS: u64 = 12;

fn main() {
    println!("cargo::rerun-if-changed=build");
    println!("cargo::rerun-if-changed=src/logic/faults.rs");
    println!("cargo::rerun-if-changed=src/logic/random.rs");
    let folder = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    let folder = Path::new(&folder);

    let mut catalogue = Programs::default();
    for format in FORMATS {
        for &top in Top::ALL {
            // The integer adder has no format.
            if top == Top::IntAdd && format != StandardFormat::Binary32 {
                continue;
            }
            let design = top.design(format).unwrap_or_else(|error| panic!("{top} {format}: {error}"));
            let flushed = format == StandardFormat::Binary32 && is_single_pipeline(top);
            catalogue.add(&design, &format!("(Top::{top:?}, StandardFormat::{format:?})"), flushed);
        }
    }
    catalogue.write(folder, "catalogue", "(Top, StandardFormat)");

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

/// The pipelines that are also used one vector at a time.
fn is_single_pipeline(top: Top) -> bool {
    matches!(top, Top::DualSplit | Top::DualSplitLean | Top::RayBox | Top::RayBoxLean)
}
