//! Writes one top as Verilog with testbench, vectors and scripts:
//! `cargo run -p dualsplit-pipelines --example export -- fp_add out 10000`.

use std::error::Error;
use std::path::Path;

use base::split_mix;
use netlist::verilog::{PackageOptions, package, write_files};
use pipelines::catalogue::{StandardFormat, Top};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let top: Top = arguments.next().unwrap_or_else(|| "fp_add".into()).parse()?;
    let folder = arguments.next().unwrap_or_else(|| "out".into());
    let vectors: u64 = arguments.next().unwrap_or_else(|| "1000".into()).parse()?;

    let design = top.design(StandardFormat::Binary32)?;
    let inputs = &design.top().inputs;
    let stimulus: Vec<Vec<u128>> =
        (0..vectors).map(|cycle| (0u64..).zip(inputs).map(|(i, _)| random(cycle, i)).collect()).collect();
    let options = PackageOptions { description: "An example export.", period_ns: 1.0 };
    for path in write_files(Path::new(&folder), &package(&design, &options, &stimulus)?)? {
        println!("{}", path.display());
    }
    Ok(())
}

/// 128 random bits; every input takes as many as it has.
fn random(cycle: u64, input: u64) -> u128 {
    let mut state = split_mix::hash(cycle) ^ input;
    u128::from(split_mix::next(&mut state)) << 64 | u128::from(split_mix::next(&mut state))
}
