//! Writes the simulations of the catalogue's tops in the formats that are compiled.

use codegen::Programs;
use pipelines::catalogue::{StandardFormat, Top};
use std::path::Path;

/// Formats whose tops are compiled; the interpreter takes the others.
const FORMATS: [StandardFormat; 2] = [StandardFormat::Binary32, StandardFormat::Binary16];

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let folder = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");

    let mut catalogue = Programs::default();
    for format in FORMATS {
        // The integer adder is the same in every format.
        let is_compiled = |top: &&Top| match top {
            Top::IntAdd => format == StandardFormat::Binary32,
            _ => top.formats().contains(&format),
        };
        for &top in Top::ALL.iter().filter(is_compiled) {
            let design = top.design(format).unwrap_or_else(|error| panic!("{top} {format}: {error}"));
            let flushed = format == StandardFormat::Binary32 && is_single_pipeline(top);
            catalogue.add(&design, &format!("(Top::{top:?}, StandardFormat::{format:?})"), flushed);
        }
    }
    catalogue.write(Path::new(&folder), "catalogue", "(Top, StandardFormat)");
}

/// The pipelines that are also used one vector at a time.
fn is_single_pipeline(top: Top) -> bool {
    matches!(top, Top::DualSplit | Top::DualSplitLean | Top::RayBox | Top::RayBoxLean)
}
