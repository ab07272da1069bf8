//! Arguments of the commands about the hardware: checks, Verilog, waveforms, area and energy.

use super::shared::{LoadArgs, ModeArgs, QualityArgs};
use super::values::{format, unit};
use clap::Args;
use pipelines::catalogue::{StandardFormat, Top};
use std::ffi::OsString;
use std::path::PathBuf;
use studies::estimation::{Clock, Mapper};

#[derive(Args, Debug)]
pub struct CheckArgs {
    /// The unit or pipeline [default: all].
    #[arg(long, value_name = "UNIT", value_parser = unit())]
    pub unit: Option<Top>,
    /// Operations to compare for each unit, besides stalls and bubbles.
    #[arg(long, default_value_t = 10_000, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub vectors: u64,
    /// Put fault N of the unit's faults, counted from 0, into its netlist first, to see the check fail.
    #[arg(long, value_name = "N", requires = "unit", conflicts_with_all = ["exhaustive", "prove"])]
    pub mutate: Option<usize>,
    /// Compare all pairs of operands of a format of at most 16 bits instead, in every mode of the unit: add, sub, mul, min,
    /// max, lt, le or eq.
    #[arg(long, num_args = 2, value_names = ["FORMAT", "OP"], conflicts_with_all = ["unit", "vectors", "prove"])]
    pub exhaustive: Option<Vec<String>>,
    /// The file that holds the progress of an exhaustive check, from which the same command continues; the check removes it when
    /// it is complete [default: check-FORMAT-OP.json].
    #[arg(long, value_name = "FILE", requires = "exhaustive")]
    pub state: Option<PathBuf>,
    /// Instead, prove for all inputs and states that units and control equal independent references, and that the exported
    /// Verilog, read back by yosys if that is installed, equals the simulated graph.
    #[arg(long, conflicts_with = "vectors")]
    pub prove: bool,
}

#[derive(Args, Debug)]
pub struct ExportArgs {
    /// The folder to write; one that this command made before is written anew.
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// The number format of the modules.
    #[arg(long, default_value = "binary32", value_name = "FORMAT", value_parser = format())]
    pub format: StandardFormat,
    /// The unit or pipeline [default: all].
    #[arg(long, value_name = "UNIT", value_parser = unit())]
    pub unit: Option<Top>,
    /// Random cycles in each testbench beside the directed ones, at most 100,000: simulators hold them all in memory.
    #[arg(long, default_value_t = 1_000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub vectors: u32,
    /// Bits of the tag that travels with each operation.
    #[arg(long, default_value_t = 1, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=64))]
    pub tag_bits: u32,
    /// Also write dualsplit.v, which holds all modules that are written.
    #[arg(long)]
    pub one_file: bool,
    /// Leave out the reset port rst_ni; registers have initial values instead.
    #[arg(long)]
    pub no_reset: bool,
    /// Clock period of the timing constraint in nanoseconds.
    #[arg(long, default_value_t = 1.0, value_name = "NS")]
    pub period_ns: f64,
}

#[derive(Args, Debug)]
pub struct WaveArgs {
    /// The unit or pipeline; a single unit gets the inputs that it has inside the dual-split pipeline.
    #[arg(long, value_name = "UNIT", value_parser = unit())]
    pub unit: Top,
    /// A built-in scene (see `dualsplit scenes`), a file (OBJ, PLY, STL or glTF), or - for standard input.
    #[arg(long)]
    pub scene: OsString,
    #[command(flatten)]
    pub load: LoadArgs,
    /// Number of rays, from the camera towards vertices spread over the mesh.
    #[arg(long, default_value_t = 4, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub rays: u32,
    #[command(flatten)]
    pub mode: ModeArgs,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// The VCD file to write.
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

#[derive(Args, Debug)]
pub struct EstimateArgs {
    /// A liberty file of the standard cells to map to, which may be gzip-compressed; repeat it if a library has several files
    /// [default: the embedded library].
    #[arg(long, value_name = "FILE")]
    pub liberty: Vec<PathBuf>,
    /// Map for a clock, such as 1GHz, 500ps, 2ns or 40fo4 (delays of an inverter that drives four of its kind), with the least
    /// area, or for the fastest: gates are restructured, mapped for delay, buffered and sized, and proved equal to their source.
    /// Exit code 1 if a pipeline misses the clock [default: map for area, then size for speed].
    #[arg(long, value_name = "CLOCK")]
    pub clock: Option<Clock>,
    /// Who maps for the clock: `own`, which needs no other program, or `abc`, the best of three scripts of ABC, which has to be
    /// installed and reads --liberty. With `abc`, the difference to our own mapper is printed.
    #[arg(long, value_name = "MAPPER", default_value = "own")]
    pub mapper: Mapper,
    /// Also map both pipelines for five clocks, and write area and energy against the clock as curve.csv, curve-area.svg and
    /// curve-energy.svg, beside the best of ABC's scripts where ABC is installed and --liberty is given. This takes minutes.
    #[arg(long, requires = "out")]
    pub curve: bool,
    /// Also synthesise the exported Verilog with yosys and ABC, which takes minutes, and print both results.
    #[arg(long)]
    pub synth: bool,
    /// The scene whose rays make the nets change: a built-in one or a file (OBJ, PLY, STL or glTF). May be given
    /// several times: the first is the one of all tables, the energy in the others is a table of its own.
    #[arg(long, default_value = "courtyard")]
    pub scene: Vec<OsString>,
    #[command(flatten)]
    pub load: LoadArgs,
    #[command(flatten)]
    pub quality: QualityArgs,
    /// A folder for the report as text, CSV, JSON and HTML; one that this command made before is written anew.
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}
