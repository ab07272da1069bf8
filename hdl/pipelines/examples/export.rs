//! Writes one top as Verilog with testbench, vectors and scripts:
//! `cargo run -p dualsplit-pipelines --example export -- fp_add out 1000 binary16`.

use std::error::Error;
use std::path::Path;

use equivalence::testbench;
use netlist::flatten;
use netlist::verilog::{Form, PackageOptions, package, shared_files, write_files};
use pipelines::catalogue::{StandardFormat, Top, sources};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let top: Top = arguments.next().unwrap_or_else(|| "fp_add".into()).parse()?;
    let folder = arguments.next().unwrap_or_else(|| "out".into());
    let vectors: u32 = arguments.next().unwrap_or_else(|| "1000".into()).parse()?;
    let format: StandardFormat = arguments.next().unwrap_or_else(|| "binary32".into()).parse()?;

    let design = top.design(format)?;
    let stimulus = testbench(top, format, &flatten(&design)?, vectors, 0);
    let sources = sources();
    let options = top.package_options(format, Form { reset: true, sources: &sources });
    let options = PackageOptions { description: "An example export.", ..options };
    let mut files = package(&design, &options, &stimulus)?;
    files.extend(shared_files(&design.top().name, options.period_ns));
    for path in write_files(Path::new(&folder), &files)? {
        println!("{}", path.display());
    }
    Ok(())
}
