//! The hardware as Verilog, with testbench, constraints and README for each module.

use crate::artifacts::Artifacts;
use crate::progress::{Part, Progress};
use anyhow::ensure;
use equivalence::testbench;
use netlist::flatten;
use netlist::verilog::{Form, PackageOptions, package, shared_files};
use pipelines::catalogue::{StandardFormat, Top};
use std::path::PathBuf;

/// Which modules are written, and where.
#[derive(Clone, Debug)]
pub struct Options {
    /// The folder that is written.
    pub out: PathBuf,
    /// The number format of the modules.
    pub format: StandardFormat,
    /// The unit or pipeline that is written; if absent, all that exist in the format.
    pub unit: Option<Top>,
    /// Random cycles in each testbench, beside the directed ones.
    pub vectors: u32,
    /// Bits of the tag that travels with each operation.
    pub tag_bits: u32,
    /// Also writes one file that holds all of them.
    pub one_file: bool,
    /// Leaves out the reset port; registers have initial values instead.
    pub no_reset: bool,
    /// Clock period of the timing constraint in nanoseconds.
    pub period_ns: f64,
    /// Seed of the stimulus.
    pub seed: u64,
    /// Writes into the folder even if it holds files that the tool did not make.
    pub force: bool,
}

/// Writes the modules, and returns the paths of the files.
///
/// # Errors
/// The clock period is not positive, a unit does not exist in the format, or a file cannot be written.
pub fn run(args: &Options, progress: &dyn Progress) -> anyhow::Result<Vec<PathBuf>> {
    ensure!(
        args.period_ns.is_finite() && args.period_ns > 0.0,
        "--period-ns {}: a clock period is a positive number of nanoseconds",
        args.period_ns
    );
    let tops = match args.unit {
        Some(top) => vec![top],
        None => Top::ALL.iter().copied().filter(|top| top.formats().contains(&args.format)).collect(),
    };
    // The designs come first, so that a unit that does not exist leaves no folder behind.
    let designs = tops
        .iter()
        .map(|top| top.design_with_tag(args.format, args.tag_bits))
        .collect::<Result<Vec<_>, _>>()?;
    let mut artifacts = Artifacts::create(&args.out, args.force)?;
    let part = Part::begin(progress, tops.len() as u64, "writing Verilog");
    let sources = pipelines::catalogue::sources();
    let form = Form { reset: !args.no_reset, sources: &sources };
    for (top, design) in tops.iter().zip(&designs) {
        let vectors = testbench(*top, args.format, &flatten(design)?, args.vectors, args.seed);
        let options = PackageOptions {
            description: description(*top),
            period_ns: args.period_ns,
            ..top.package_options(args.format, form)
        };
        for file in package(design, &options, &vectors)? {
            artifacts.write(&file.name, file.contents.as_bytes())?;
        }
        part.advance(1);
    }
    for file in shared_files(&designs[0].top().name, args.period_ns) {
        artifacts.write(&file.name, file.contents.as_bytes())?;
    }
    if args.one_file {
        let name = match args.format {
            StandardFormat::Binary32 => "dualsplit".to_owned(),
            format => format!("dualsplit_{format}"),
        };
        let all: Vec<_> = designs.iter().collect();
        artifacts.write(&format!("{name}.v"), form.text(&all, &name).as_bytes())?;
    }
    artifacts.finish()
}

/// What a top does, for its README.
fn description(top: Top) -> &'static str {
    match top {
        Top::IntAdd => "Adds two unsigned words modulo 2^32.",
        Top::FpAdd => {
            "Adds or subtracts two floating-point numbers as IEEE 754 says, in five rounding directions."
        }
        Top::FpMul => "Multiplies two floating-point numbers as IEEE 754 says, in five rounding directions.",
        Top::FpMinMax => "Minimum or maximum of two floating-point numbers; NaN is dropped or propagated.",
        Top::FpCmp => "Compares two floating-point numbers; NaN is unordered.",
        Top::DualSplit => "One step of dual-split-tree traversal per cycle, with the published units.",
        Top::DualSplitLean => {
            "One step of dual-split-tree traversal per cycle, without redundant comparators."
        }
        Top::RayBox => "One ray-box intersection test per cycle, with the published units.",
        Top::RayBoxLean => "One ray-box intersection test per cycle, without the redundant comparator.",
        Top::RayBoxX2 => "Intersection tests of one ray with two boxes per cycle.",
        Top::RayBoxX4 => "Intersection tests of one ray with four boxes per cycle.",
        Top::RayBoxX8 => "Intersection tests of one ray with eight boxes per cycle.",
        Top::SharedUnits => {
            "Eight adders and multipliers, singly or routed into one of the traversal pipelines."
        }
    }
}
